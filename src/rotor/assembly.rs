//! From a definition to a rotor that can move: equilibrium, held freedoms, damping, linear laws.

use super::coefficients::{Coefficients, Mass};
use super::element::{AttachedElement, Element, Elements};
use super::equilibrium::{Equilibrium, StaticPlace, static_place_of};
use super::excitation::Excitation;
use super::linear_part::LinearPart;
use super::motion::Start;
use super::structure::Structure;
use super::unconstrained::FreeDirections;
use super::{
    Damping, FREEDOMS, InitialPosition, Rotor, RotorDefinition, RotorError, STANDARD_GRAVITY,
    SpeedProfile,
};
use crate::bearing::{Geometry, MountedBearing, Support, Vector5};
use nalgebra::DMatrix;

impl Rotor {
    /// Builds the supports, finds the static equilibrium and fixes everything that follows from it.
    ///
    /// # Errors
    /// [`RotorError`] where a bearing cannot be built, nothing carries the load, or a number is
    /// outside its range.
    pub(crate) fn assemble(definition: &RotorDefinition) -> Result<Self, RotorError> {
        let mut rotor = Self::from_structure(Structure::from_definition(definition)?, definition)?;
        rotor.damp_by_later_balls(definition);
        Ok(rotor)
    }

    /// Builds the rotor on a structure with the shaft of the definition, its damping as it follows from the stiffness at
    /// the start.
    pub(super) fn from_structure(
        structure: Structure,
        definition: &RotorDefinition,
    ) -> Result<Self, RotorError> {
        check_inertia(definition)?;
        let mut supports = build_supports(definition)?;
        check_eccentricity(definition.shaft.eccentricity, &supports)?;
        let speed = definition.speed_profile()?;
        let load = structure.static_load(definition);
        let StaticPlace {
            mut structure,
            coordinates: rest,
            stiffness: tangent,
            equilibrium,
            axial_hold,
            unloaded,
            ..
        } = static_place_of(structure, definition, &supports, &load, &[None; FREEDOMS])?;
        for (support, attachment) in supports.iter_mut().zip(&structure.attachments) {
            let place = attachment.displacement(&rest, &[]);
            support.roll(definition.cage, Some(&place), definition.speed);
            support.freeze(&place, definition.speed);
        }
        let tangent = structure.condensed(tangent);
        let constant_force = structure.constant_force(definition, &rest);
        let free = FreeDirections::find(&structure, definition, &supports, &tangent);
        let linear = LinearPart::assemble(&structure, definition, &tangent)?;
        let on_rigid_shaft = structure.is_rigid();
        let law_damping = structure.law_damping(&rest, definition.speed);
        let elements = structure.take_elements(supports);
        let elements = Elements::new(elements, definition.cage, on_rigid_shaft);
        check_walls(&elements, &rest)?;
        Ok(Self {
            elements,
            excitation: structure.take_excitation(definition, speed, constant_force),
            linear,
            start: Start {
                from: definition.initial.from,
                shaft: initial_state(definition, &equilibrium),
                damped_by_later_balls: false,
                equilibrium,
                rest,
                tangent,
                law_damping,
                unloaded,
                axial_hold,
                free,
            },
            structure,
            energy: false,
        })
    }
}

impl LinearPart {
    /// The linear part of a structure with its stiffness `tangent` at the static equilibrium, ball bearings included.
    fn assemble(
        structure: &Structure,
        definition: &RotorDefinition,
        tangent: &DMatrix<f64>,
    ) -> Result<Self, RotorError> {
        let (dofs, matrices) = (structure.dofs, &structure.matrices);
        let damping = &matrices.damping + definition.damping.matrix(structure, tangent);
        let by_rate = match definition.damping {
            Damping::Coefficients(_) => &damping,
            _ => &matrices.damping,
        };
        structure.check_followers(definition, by_rate)?;
        let mass = matrices.mass.view((0, 0), (dofs, dofs)).into_owned();
        let coefficients = |matrix: &DMatrix<f64>| Coefficients::new(matrix.clone(), dofs);
        let is_damped_inside = matrices.internal_damping.amax() > 0.0;
        Ok(Self {
            mass: Mass::new(mass).ok_or(RotorError::Mass)?,
            stiffness: Coefficients::new(structure.condensed(matrices.stiffness.clone()), dofs),
            damping: Coefficients::new(damping, dofs),
            // a stationary shaft has no gyroscopic moments
            gyroscopic: match definition.shaft_stands() {
                true => coefficients(&(&matrices.gyroscopic * 0.0)),
                false => coefficients(&matrices.gyroscopic),
            },
            circulatory: coefficients(&matrices.circulatory),
            internal_damping: is_damped_inside.then(|| coefficients(&matrices.internal_damping)),
            crosses: structure.elements.iter().any(|(_, own)| match own {
                Element::Linear(law) => law.crosses(),
                _ => false,
            }),
        })
    }
}

impl Structure {
    /// Takes its bearings as elements, and behind them its other elements.
    fn take_elements(&mut self, supports: Vec<Support>) -> Vec<AttachedElement> {
        let attachments = std::mem::take(&mut self.attachments);
        let bearings = attachments.into_iter().zip(supports);
        let bearings = bearings
            .map(|(attachment, support)| (attachment, Element::BallBearing(Box::new(support))));
        let all = bearings.chain(std::mem::take(&mut self.elements));
        let attached = all.map(|(attachment, element)| AttachedElement {
            attachment,
            element,
        });
        attached.collect()
    }

    /// C of the laws of force that are not linear, at rest in a place, as it meets the degrees of freedom.
    fn law_damping(&self, place: &[f64], speed: f64) -> DMatrix<f64> {
        let size = self.coordinates.len();
        let mut damping = DMatrix::zeros(size, size);
        for (attachment, law, motion) in self.laws_at_rest(place, speed) {
            attachment.add_stiffness(&law.slopes(&motion)[1], &mut damping);
        }
        damping
    }

    /// Takes what drives it from outside at a speed.
    fn take_excitation(
        &mut self,
        definition: &RotorDefinition,
        speed: SpeedProfile,
        constant_force: Vec<f64>,
    ) -> Excitation {
        let places = std::mem::take(&mut self.load_places);
        let (loads, load_places) = definition
            .loads
            .iter()
            .zip(places)
            .filter(|(load, _)| load.as_constant().is_none())
            .map(|(load, place)| (load.clone(), place))
            .unzip();
        let base_inertia = [0, 1, 2].map(|axis| {
            let inertia = self.inertia_along(axis);
            inertia.as_slice()[..self.dofs].to_vec()
        });
        Excitation {
            speed,
            drive: definition.drive,
            inertia_polar: definition.shaft.inertia_polar,
            unbalances: std::mem::take(&mut self.unbalances),
            loads,
            load_places,
            constant_force,
            gravity: match definition.shaft.gravity {
                true => STANDARD_GRAVITY,
                false => 0.0,
            },
            base_inertia,
        }
    }

    /// Constant loads and the weight on the degrees of freedom, less what springs press by coordinates that are held at
    /// `rest`.
    fn constant_force(&self, definition: &RotorDefinition, rest: &[f64]) -> Vec<f64> {
        let mut forces = self.carried(self.constant_load(definition));
        let followers = rest.len() - self.followers.nrows();
        for (row, force) in forces.iter_mut().enumerate() {
            let held = rest[..followers].iter().enumerate().skip(self.dofs);
            *force -= held
                .map(|(own, place)| self.matrices.stiffness[(row, own)] * place)
                .sum::<f64>();
        }
        forces
    }
}

/// No shaft has its centre of mass outside its bearings.
fn check_eccentricity(eccentricity: f64, supports: &[Support]) -> Result<(), RotorError> {
    let pitch_radius = 0.5 * Support::largest(supports, Geometry::pitch_diameter);
    if eccentricity > pitch_radius {
        return Err(RotorError::Eccentricity {
            eccentricity,
            pitch_radius,
        });
    }
    Ok(())
}

/// What only a motion needs.
fn check_inertia(definition: &RotorDefinition) -> Result<(), RotorError> {
    let shaft = &definition.shaft;
    let polar = "the polar moment of inertia in kg m²";
    if shaft.freedoms.tilts() && definition.flexible.is_none() {
        positive(
            "the transverse moment of inertia in kg m²",
            shaft.inertia_transverse,
        )?;
    }
    if definition.drive.is_some() {
        positive(polar, shaft.inertia_polar)?;
    }
    not_negative(polar, shaft.inertia_polar)
}

fn positive(name: &'static str, value: f64) -> Result<(), RotorError> {
    range(name, value, value > 0.0, "positive and finite")
}

pub(super) fn not_negative(name: &'static str, value: f64) -> Result<(), RotorError> {
    range(name, value, value >= 0.0, "zero or positive, finite")
}

fn range(name: &'static str, value: f64, fits: bool, rule: &'static str) -> Result<(), RotorError> {
    if fits && value.is_finite() {
        Ok(())
    } else {
        Err(RotorError::Range { name, value, rule })
    }
}

/// Refuses a static equilibrium at coordinates that a law of force cannot reach.
fn check_walls(elements: &Elements, rest: &[f64]) -> Result<(), RotorError> {
    for (attachment, law) in elements.laws() {
        let [x, y, ..] = attachment.displacement(rest, &[]);
        let distance = x.hypot(y);
        if let Some(clearance) = law.wall().filter(|wall| distance >= *wall) {
            return Err(RotorError::FilmAtRest {
                distance,
                clearance,
            });
        }
    }
    Ok(())
}

/// Checks a definition and builds its bearings.
pub(crate) fn build_supports(definition: &RotorDefinition) -> Result<Vec<Support>, RotorError> {
    positive("the mass in kg", definition.shaft.mass)?;
    let build = |(index, bearing): (usize, &MountedBearing)| {
        Support::new(bearing, definition.speed).map_err(|source| RotorError::Bearing {
            number: index + 1,
            source,
        })
    };
    definition.bearings.iter().enumerate().map(build).collect()
}

impl Structure {
    /// Constant loads and the weight on all coordinates.
    fn constant_load(&self, definition: &RotorDefinition) -> Vec<f64> {
        let mut sum = vec![0.0; self.coordinates.len()];
        for (load, place) in definition.loads.iter().zip(&self.load_places) {
            if let Some(constant) = load.as_constant() {
                place.add_force(1.0, constant, &mut sum);
            }
        }
        if definition.shaft.gravity {
            let inertia = self.shaft_inertia_along(1);
            for (sum, inertia) in sum.iter_mut().zip(inertia.iter()) {
                *sum -= STANDARD_GRAVITY * inertia;
            }
        }
        sum
    }

    /// What the static equilibrium carries: constant loads, the weight, and of every varying load its static part.
    pub(super) fn static_load(&self, definition: &RotorDefinition) -> Vec<f64> {
        let mut sum = self.constant_load(definition);
        for (load, place) in definition.loads.iter().zip(&self.load_places) {
            place.add_force(1.0, &load.kind.static_part(), &mut sum);
        }
        sum
    }
}

impl RotorDefinition {
    /// The speed from t = 0 on.
    ///
    /// # Errors
    /// [`RotorError`] where a speed is negative or not finite, or the times do not rise.
    pub(crate) fn speed_profile(&self) -> Result<SpeedProfile, RotorError> {
        SpeedProfile::new(self.speed, &self.speed_points)
    }
}

/// Displacement and velocity at t = 0.
fn initial_state(definition: &RotorDefinition, equilibrium: &Equilibrium) -> [Vector5; 2] {
    let freedoms = definition.shaft.freedoms;
    let initial = &definition.initial;
    let displacement = std::array::from_fn(|axis| {
        let rest = equilibrium.displacement[axis];
        if !freedoms.moves(axis) {
            return rest;
        }
        let from = match initial.from {
            InitialPosition::Origin => 0.0,
            InitialPosition::Equilibrium => rest,
        };
        initial.displacement[axis].unwrap_or(from)
    });
    let velocity = std::array::from_fn(|axis| {
        let given = initial.velocity[axis].filter(|_| freedoms.moves(axis));
        given.unwrap_or(0.0)
    });
    [displacement, velocity]
}
