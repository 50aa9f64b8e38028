//! The coordinates of a structure, its matrices, and the points that bearings, loads and sensors know it by.

use nalgebra::{DMatrix, DVector};

use super::bodies::BodyPoint;
use super::coordinate::Coordinate;
use super::element::{Element, ElementMotion};
use super::flexible::Bending;
use super::force_law::ForceLaw;
use super::matrices::Matrices;
use super::point::{Attachment, Place, Point};
use super::static_search::Restoring;
use super::{Body, FREEDOMS, ForceElement, Freedoms, PlaneUnbalance, RotorDefinition, ShaftError};
use crate::bearing::{BearingRotation, Facing, Support, Vector5};

/// An unbalance at a point of the shaft.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct UnbalancedPoint {
    pub point: Point,
    pub unbalance: PlaneUnbalance,
}

/// What moves, and where bearings and loads act on it.
#[derive(Debug, Clone)]
pub(super) struct Structure {
    /// Degrees of freedom first, behind them what is held, and last what has no mass and follows.
    pub coordinates: Vec<Coordinate>,
    /// Number of degrees of freedom.
    pub dofs: usize,
    /// Freedoms of the shaft that move.
    pub freedoms: Freedoms,
    /// Mass of the shaft, kg.
    pub shaft_mass: f64,
    pub matrices: Matrices,
    /// The point of the shaft that is observed; of a rigid one its centre of mass.
    pub shaft: Point,
    /// Where the shaft bends: all of it.
    pub bending: Option<Bending>,
    /// Coordinates of the shaft when it moves by one along x, y, z, or about X and Y through its observed point.
    pub rigid_motions: [DVector<f64>; FREEDOMS],
    /// Displacement of the last coordinates, which have no mass, by that of the degrees of freedom: `−K_ss⁻¹ K_sd`.
    pub followers: DMatrix<f64>,
    /// Masses on the ground that bearings sit in, and what vibrates on them.
    pub bodies: Vec<BodyPoint>,
    /// Where the ball bearings sit; with all below, a rotor takes it over into its elements and its excitation.
    pub attachments: Vec<Attachment>,
    /// The elements besides them, and where they sit.
    pub elements: Vec<(Attachment, Element)>,
    /// Where each of the loads acts; accelerations of the base act on all masses.
    pub load_places: Vec<Place>,
    pub unbalances: Vec<UnbalancedPoint>,
}

impl Structure {
    /// A rigid shaft on nothing yet, with its mass or moment of inertia along each of x, y, z, θx, θy.
    pub fn rigid(masses: Vector5, freedoms: Freedoms) -> Self {
        let shaft = match freedoms {
            Freedoms::Lateral => Point::WITHOUT_Z,
            _ => Point::RIGID_SHAFT,
        };
        let axis_of = |index| shaft.axis_of(index).unwrap_or(index);
        let shaft_mass = masses[0];
        let unit = |axis: usize| {
            let own = shaft.coordinates[axis];
            DVector::from_fn(FREEDOMS, |row, _| f64::from(u8::from(row == own)))
        };
        let masses = DVector::from_fn(FREEDOMS, |row, _| masses[axis_of(row)]);
        Self {
            coordinates: (0..FREEDOMS)
                .map(|index| Coordinate::from_axis(axis_of(index), ""))
                .collect(),
            dofs: freedoms.axes().len(),
            freedoms,
            shaft_mass,
            matrices: Matrices::from_masses(&masses),
            shaft,
            bending: None,
            rigid_motions: std::array::from_fn(unit),
            followers: DMatrix::zeros(0, 0),
            bodies: Vec::new(),
            attachments: Vec::new(),
            elements: Vec::new(),
            load_places: Vec::new(),
            unbalances: Vec::new(),
        }
    }

    /// The structure of a definition: its shaft, rigid or one that bends, with housings and what vibrates on them.
    ///
    /// # Errors
    /// [`ShaftError`] where a shaft that bends cannot be built.
    pub fn from_definition(definition: &RotorDefinition) -> Result<Self, ShaftError> {
        let shaft = match &definition.flexible {
            Some(flexible) => Self::bending(flexible, definition)?,
            None => Self::rigid_shaft(definition),
        };
        let bends = shaft.bending.is_some();
        let massless = |index: &usize| bends && shaft.matrices.mass[(*index, *index)] == 0.0;
        let massless: Vec<_> = (0..shaft.dofs).filter(massless).collect();
        let axes = definition.shaft.freedoms.lengths();
        let room = axes * definition.bodies().len();
        let mut structure = shaft.arranged(room, &massless);
        structure.add_bodies(definition, axes);
        structure.attach(definition);
        if !massless.is_empty() {
            structure.followers =
                structure
                    .followers_by_stiffness(massless.len())
                    .ok_or(ShaftError::Singular {
                        points: structure.coordinates.len() - massless.len(),
                    })?;
        }
        Ok(structure)
    }

    /// The structure of a rigid shaft, without housings.
    fn rigid_shaft(definition: &RotorDefinition) -> Self {
        let shaft = &definition.shaft;
        let (mass, inertia) = (shaft.mass, shaft.inertia_transverse);
        let mut structure = Self::rigid([mass, mass, mass, inertia, inertia], shaft.freedoms);
        let [.., tilt_x, tilt_y] = structure.shaft.coordinates;
        let gyroscopic = &mut structure.matrices.gyroscopic;
        gyroscopic[(tilt_x, tilt_y)] = shaft.inertia_polar;
        gyroscopic[(tilt_y, tilt_x)] = -shaft.inertia_polar;
        structure
    }

    /// With room for more degrees of freedom behind its own, that nothing belongs to yet, and some of its own, which have
    /// no mass, last.
    pub(super) fn arranged(mut self, room: usize, massless: &[usize]) -> Self {
        if room == 0 && massless.is_empty() {
            return self;
        }
        // the old index of each new coordinate
        let moving = (0..self.dofs).filter(|index| !massless.contains(index));
        let held = self.dofs..self.coordinates.len();
        let order: Vec<Option<usize>> = moving
            .map(Some)
            .chain(std::iter::repeat_n(None, room))
            .chain(held.map(Some))
            .chain(massless.iter().copied().map(Some))
            .collect();
        let mut places = vec![0; self.coordinates.len()];
        for (place, old) in order.iter().enumerate() {
            if let Some(old) = old {
                places[*old] = place;
            }
        }
        let size = order.len();
        for matrix in self.matrices.all_mut() {
            *matrix = DMatrix::from_fn(size, size, |row, column| {
                match (order[row], order[column]) {
                    (Some(row), Some(column)) => matrix[(row, column)],
                    _ => 0.0,
                }
            });
        }
        for motion in &mut self.rigid_motions {
            *motion = DVector::from_fn(size, |row, _| order[row].map_or(0.0, |old| motion[old]));
        }
        if let Some(bending) = &mut self.bending {
            bending.arrange(&order, &places);
        }
        self.shaft.coordinates = self.shaft.coordinates.map(|old| places[old]);
        self.coordinates = order
            .iter()
            .map(|old| match old {
                Some(old) => self.coordinates[*old].clone(),
                None => Coordinate::from_axis(0, ""),
            })
            .collect();
        self.dofs = self.dofs + room - massless.len();
        self
    }

    /// Places bearings, loads and unbalances on shaft and housings.
    fn attach(&mut self, definition: &RotorDefinition) {
        let bearings = definition.bearings.iter().enumerate();
        let bearings =
            bearings.map(|(number, own)| self.attachment(own.position, own.facing, number));
        self.attachments = bearings.collect();
        let (speed, kept) = (definition.speed, definition.keeps_its_speed());
        let elements = (definition.bearings.len()..).zip(&definition.elements);
        let elements = elements.map(|(number, own)| {
            let attachment = self.element_attachment(own, number);
            (attachment, own.law.element(speed, kept))
        });
        self.elements = elements.collect();
        for (attachment, element) in &self.elements {
            if let Element::Linear(law) = element {
                attachment.add_stiffness(&law.stiffness, &mut self.matrices.stiffness);
                attachment.add_stiffness(&law.damping, &mut self.matrices.damping);
            }
        }
        let loads = definition.loads.iter();
        self.load_places = loads.map(|load| self.place_at(load.position)).collect();
        self.unbalances = match &definition.flexible {
            None => vec![UnbalancedPoint {
                point: self.shaft,
                unbalance: definition.shaft.whole_unbalance(),
            }],
            Some(flexible) => {
                let unbalanced = flexible.unbalances.iter().map(|own| {
                    let Place { point, arm } = self.place_at(own.position);
                    UnbalancedPoint {
                        point,
                        unbalance: own.about(arm),
                    }
                });
                unbalanced.collect()
            }
        };
    }

    /// Where a bearing of the scene sits.
    fn attachment(&self, position: f64, facing: Facing, number: usize) -> Attachment {
        let observed = self.bending.as_ref().map_or(0.0, Bending::observed);
        let (inner, outer) = (self.place_at(position), self.housing(number));
        Attachment::new(inner, outer, facing, position - observed)
    }

    /// Where an element sits that is, or whose housing is, so far behind the bearings.
    fn element_attachment(&self, element: &ForceElement, number: usize) -> Attachment {
        let number = element.housing_of.unwrap_or(number);
        match (element.position, self.housing(number)) {
            (None, Some(housing)) => Attachment::beside_shaft(housing),
            (position, _) => self.attachment(position.unwrap_or(0.0), Facing::PlusZ, number),
        }
    }

    /// The housing of a bearing, or of an element behind them; none where it sits on the ground.
    fn housing(&self, number: usize) -> Option<Place> {
        let mut bodies = self.bodies.iter();
        let housing = bodies.find(|own| own.body == Body::Housing(number))?;
        Some(Place {
            point: housing.point,
            arm: 0.0,
        })
    }

    /// The place of the shaft at a position along it, m: of a shaft that bends one of its points.
    pub fn place_at(&self, position: f64) -> Place {
        match &self.bending {
            None => Place {
                point: self.shaft,
                arm: position,
            },
            Some(bending) => bending.place_at(position),
        }
    }

    /// M t of a unit translation t of shaft and housings along an axis, kg.
    pub fn inertia_along(&self, axis: usize) -> DVector<f64> {
        let mut forces = self.shaft_inertia_along(axis);
        for BodyPoint { mass, point, .. } in &self.bodies {
            let unit = std::array::from_fn(|own| f64::from(u8::from(own == axis)));
            point.add_force(*mass, &unit, forces.as_mut_slice());
        }
        forces
    }

    /// M t of a unit translation t of the shaft alone along an axis, kg.
    pub fn shaft_inertia_along(&self, axis: usize) -> DVector<f64> {
        &self.matrices.mass * &self.rigid_motions[axis]
    }

    /// Whether it is nothing but a rigid shaft on bearings that sit on the ground.
    pub fn is_rigid(&self) -> bool {
        let grounded = |attachment: &Attachment| attachment.outer.is_none();
        self.coordinates.len() == FREEDOMS
            && self.shaft == Point::RIGID_SHAFT
            && self.attachments.iter().all(grounded)
            && self.laws().next().is_none()
            && self.matrices.stiffness.iter().all(|entry| *entry == 0.0)
    }

    /// Coordinates of the plane of x with those of the plane of y that a forward whirl has a quarter turn behind, times a
    /// sign.
    pub fn planes(&self) -> Vec<(usize, usize, f64)> {
        match &self.bending {
            Some(bending) => bending.planes.clone(),
            None => {
                let [x, y, _, tilt_x, tilt_y] = self.shaft.coordinates;
                vec![(x, y, 1.0), (tilt_x, tilt_y, 1.0)]
            }
        }
    }

    /// The laws of force that are not linear.
    pub fn laws(&self) -> impl Iterator<Item = (&Attachment, &dyn ForceLaw)> {
        let elements = self.elements.iter();
        elements.filter_map(|(attachment, element)| Some((attachment, element.law()?)))
    }

    /// They with their motions at rest in a place of all coordinates.
    pub fn laws_at_rest<'a>(
        &'a self,
        place: &'a [f64],
        speed: f64,
    ) -> impl Iterator<Item = (&'a Attachment, &'a dyn ForceLaw, ElementMotion)> {
        self.laws().map(move |(attachment, law)| {
            let motion = ElementMotion {
                displacement: attachment.displacement(place, &[]),
                rate: [0.0; FREEDOMS],
                rotation: BearingRotation::at_start(speed),
            };
            (attachment, law, motion)
        })
    }

    /// Force onto all that holds the structure, and its slope, with the cages where they start.
    pub fn restoring(
        &self,
        supports: &[Support],
        place: &[f64],
        speed: f64,
        arm: f64,
    ) -> Restoring {
        let size = self.coordinates.len();
        let mut force = DVector::zeros(size);
        let mut stiffness = self.matrices.stiffness.clone();
        force.gemv(1.0, &stiffness, &DVector::from_column_slice(place), 0.0);
        let mut largest_share: f64 = 0.0;
        let rotation = BearingRotation::at_start(speed);
        let bearings = supports.iter().zip(&self.attachments);
        let bearings = bearings.map(|(support, attachment)| {
            let displacement = attachment.displacement(place, &[]);
            let tangent = support.tangent(&displacement, &rotation);
            (attachment, tangent.force, tangent.stiffness)
        });
        let laws = self.laws_at_rest(place, speed);
        let laws = laws.map(|(attachment, law, motion)| {
            let [stiffness, _] = law.slopes(&motion);
            (attachment, law.force(&motion), stiffness)
        });
        for (attachment, own_force, own_stiffness) in bearings.chain(laws) {
            attachment.add_force(1.0, &own_force, force.as_mut_slice());
            attachment.add_stiffness(&own_stiffness, &mut stiffness);
            let share = attachment.at_inner_point(&own_force);
            for (axis, share) in share.iter().enumerate() {
                let length = if axis < 3 { 1.0 } else { arm };
                largest_share = largest_share.max((share / length).abs());
            }
        }
        Restoring {
            force,
            stiffness,
            largest_share,
        }
    }
}

#[cfg(test)]
#[path = "structure_tests.rs"]
mod tests;
