//! Static equilibrium of a shaft on its bearings, and of one bearing by itself.

use nalgebra::DMatrix;

use super::point::Attachment;
use super::static_search::{Balance, StaticCoordinate, StaticSearch};
use super::structure::{Structure, UnbalancedPoint};
use super::{FREEDOMS, Freedoms, RotorDefinition, RotorError, build_supports};
use crate::bearing::{
    Bearing, BearingState, Facing, Geometry, Matrix5, MountedBearing, Support, Vector5,
};
use crate::keys;

/// Names of the five freedoms, as they appear in messages and column headers.
pub const FREEDOM_NAMES: [&str; FREEDOMS] = keys::AXES;

/// Why a load has no static equilibrium.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum EquilibriumError {
    /// The shaft moves away without meeting resistance.
    #[error(
        "no static equilibrium: the shaft gives way along {freedom} by {displacement:.3e} (m or rad) and {residual:.3e} (N \
         or N m) stay unbalanced; {}",
        not_carried(*load)
    )]
    NotCarried {
        /// Freedom with the largest unbalanced force.
        freedom: String,
        /// Where it went, m or rad.
        displacement: f64,
        /// Unbalanced force, N or N m.
        residual: f64,
        /// External load along this freedom, N or N m.
        load: f64,
    },
    /// A load or a displacement that is not a number.
    #[error("the load or the start of the search is not finite: {value} along {freedom}")]
    NotFinite {
        /// Freedom.
        freedom: String,
        /// The value.
        value: f64,
    },
}

/// Why a freedom gives way that has such a load of its own, and what helps.
fn not_carried(load: f64) -> String {
    if load == 0.0 {
        return "no load acts there, so what pushes is a preload or spring that no other bearing faces, or a load elsewhere: \
                add a bearing that holds the shaft that way or faces the other way, or hold this freedom"
            .to_owned();
    }
    format!(
        "nothing carries the load {load:.3e} there: hold this freedom, add a bearing or a preload, or change the load"
    )
}

/// A static problem: what is given of load and displacement.
#[derive(Debug, Clone, Copy)]
pub struct StaticProblem<'a> {
    /// Bearings that carry the shaft.
    pub supports: &'a [Support],
    /// External load, N and N m; of held freedoms it does not matter.
    pub load: Vector5,
    /// Which freedoms find their own position; the others stay at `start`.
    pub free: [bool; 5],
    /// Where the search starts, and where held freedoms stay.
    pub start: Vector5,
    /// Shaft speed, rad/s.
    pub speed: f64,
}

/// A static equilibrium.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct Equilibrium {
    /// Displacement, m and rad.
    pub displacement: Vector5,
    /// Force of the shaft onto the bearings, N and N m.
    pub force: Vector5,
    /// K = ∂F/∂q, 5×5.
    pub stiffness: Matrix5,
    /// Largest unbalanced force relative to the forces in play, moments by their arm.
    pub residual: f64,
    /// Length of the Newton step that is left, m, tilts by their arm: the error of the displacement.
    pub displacement_error: f64,
    /// Newton steps taken.
    pub newton_steps: usize,
}

impl StaticProblem<'_> {
    /// Finds the displacement whose force is the load: `F(q) = load` in the free freedoms, to round-off.
    ///
    /// # Errors
    /// [`EquilibriumError`] names the freedom that nothing carries.
    pub fn solve(&self) -> Result<Equilibrium, EquilibriumError> {
        let mut structure = Structure::rigid([0.0; FREEDOMS], Freedoms::All);
        let definitions = self.supports.iter().map(Support::definition);
        let attachments =
            definitions.map(|own| Attachment::on_rigid_shaft(own.position, own.facing));
        structure.attachments = attachments.collect();
        let mut load = vec![0.0; FREEDOMS];
        structure.shaft.add_force(1.0, &self.load, &mut load);
        Ok(self.on(&structure, &load)?.equilibrium(&structure))
    }

    /// Finds the equilibrium of a structure with more coordinates than those of its shaft, under loads on all of them;
    /// those that are not of its observed point are free.
    pub(super) fn on(
        &self,
        structure: &Structure,
        load: &[f64],
    ) -> Result<Balance, EquilibriumError> {
        let arm = self.arm(structure);
        let coordinates = structure.coordinates.iter().enumerate();
        let coordinates = coordinates.map(|(index, coordinate)| {
            let axis = structure.shaft.axis_of(index);
            StaticCoordinate {
                name: coordinate.name.clone(),
                length: coordinate.length(arm),
                load: load[index],
                free: axis.is_none_or(|axis| self.free[axis]),
                start: axis.map_or(0.0, |axis| self.start[axis]),
            }
        });
        StaticSearch {
            coordinates: coordinates.collect(),
            length_scale: Support::largest(self.supports, Geometry::length_scale),
            restoring: &|position| structure.restoring(self.supports, position, self.speed, arm),
        }
        .solve()
    }

    /// Length that makes tilts comparable to displacements: the farthest groove from the centre.
    fn arm(&self, structure: &Structure) -> f64 {
        let pairs = self.supports.iter().zip(&structure.attachments);
        let arms = pairs.map(|(support, attachment)| {
            let geometry = &support.definition().bearing.geometry;
            attachment.inner.arm.abs() + geometry.lever()
        });
        arms.reduce(f64::max)
            .unwrap_or_else(|| Support::largest(self.supports, Geometry::lever))
    }
}

impl Balance {
    /// What of it concerns the shaft: the displacement of its observed point, the force of the whole shaft onto what holds
    /// it, and the stiffness that a force at the observed point meets.
    pub(super) fn equilibrium(&self, structure: &Structure) -> Equilibrium {
        let indices = structure.shaft.coordinates;
        let stiffness = &self.restoring.stiffness;
        let motions = &structure.rigid_motions;
        Equilibrium {
            displacement: indices.map(|index| self.displacement[index]),
            // what is elastic inside the shaft does no work as it moves as a rigid body
            force: std::array::from_fn(|axis| motions[axis].dot(&self.restoring.force)),
            stiffness: if structure.bending.is_some() {
                condensed(stiffness, indices)
            } else {
                Matrix5::from_fn(|row, column| stiffness[(indices[row], indices[column])])
            },
            residual: self.relative_residual(),
            displacement_error: self.displacement_error(),
            newton_steps: self.newton_steps,
        }
    }
}

/// Stiffness of some coordinates with all others yielding: `K_oo − K_oe K_ee⁻¹ K_eo`. Where the others have
/// no stiffness of their own, that with them held.
fn condensed(stiffness: &DMatrix<f64>, kept: [usize; FREEDOMS]) -> Matrix5 {
    let all = 0..stiffness.nrows();
    let yielding: Vec<usize> = all.filter(|index| !kept.contains(index)).collect();
    let block =
        |rows: &[usize], columns: &[usize]| stiffness.select_rows(rows).select_columns(columns);
    let mut own = block(&kept, &kept);
    let inner = block(&yielding, &yielding).lu();
    // K_oo − K_oe (K_ee⁻¹ K_eo)
    if let Some(followed) = inner.solve(&block(&yielding, &kept)) {
        own -= block(&kept, &yielding) * followed;
    }
    Matrix5::from_fn(|row, column| own[(row, column)])
}

/// A static equilibrium of a shaft.
pub(crate) struct StaticPlace {
    /// Which of its freedoms found their own position.
    pub free: [bool; FREEDOMS],
    pub(super) structure: Structure,
    /// Position of all its coordinates, m and rad.
    pub(super) coordinates: Vec<f64>,
    /// K of all its coordinates.
    pub(super) stiffness: DMatrix<f64>,
    pub equilibrium: Equilibrium,
    /// Force in N by which z is held, where the axial forces of several bearings balance nowhere.
    pub axial_hold: Option<f64>,
    /// Axial displacement of every bearing where the shaft rests without load, [`Structure::unloaded_axial`]; zero where
    /// its axial place is held.
    pub(super) unloaded: Vec<f64>,
}

impl StaticPlace {
    /// What is known of every bearing of a definition there.
    pub fn bearing_states(
        &self,
        definition: &RotorDefinition,
        supports: &[Support],
    ) -> Vec<BearingState> {
        let pairs = supports.iter().zip(&self.structure.attachments);
        let state = |((support, attachment), &unloaded): ((&Support, &Attachment), &f64)| {
            let place = attachment.displacement(&self.coordinates, &[]);
            support.state(&place, unloaded, definition.speed, definition.cage)
        };
        pairs.zip(&self.unloaded).map(state).collect()
    }
}

impl RotorDefinition {
    /// The bearings as their balls go round; where the shaft has no equilibrium, as without load.
    ///
    /// # Errors
    /// [`RotorError`] where a bearing cannot be built.
    pub(crate) fn rolling_supports(&self) -> Result<Vec<Support>, RotorError> {
        let mut supports = build_supports(self)?;
        let found = static_place(self, &supports, false, &[None; FREEDOMS]).ok();
        for (index, support) in supports.iter_mut().enumerate() {
            let place = found.as_ref().map(|found| {
                let attachment = &found.structure.attachments[index];
                attachment.displacement(&found.coordinates, &[])
            });
            support.roll(self.cage, place.as_ref(), self.speed);
        }
        Ok(supports)
    }
}

/// The equilibrium of a shaft under its static loads, with the freedoms held whose displacement is given. The unbalance of
/// a shaft angle of zero may act besides.
///
/// # Errors
/// [`RotorError`] where the shaft cannot be built, or nothing carries the load.
pub(crate) fn static_place(
    definition: &RotorDefinition,
    supports: &[Support],
    unbalanced: bool,
    given: &[Option<f64>; FREEDOMS],
) -> Result<StaticPlace, RotorError> {
    let structure = Structure::from_definition(definition)?;
    let mut load = structure.static_load(definition);
    if unbalanced {
        for UnbalancedPoint { point, unbalance } in &structure.unbalances {
            let force = unbalance.phasor(definition.speed).map(|part| part.re);
            point.add_force(1.0, &force, &mut load);
        }
    }
    Ok(static_place_of(
        structure, definition, supports, &load, given,
    )?)
}

/// The equilibrium of a structure with the shaft of the definition.
pub(super) fn static_place_of(
    structure: Structure,
    definition: &RotorDefinition,
    supports: &[Support],
    load: &[f64],
    given: &[Option<f64>; FREEDOMS],
) -> Result<StaticPlace, EquilibriumError> {
    let [_, _, z, ..] = structure.shaft.coordinates;
    let solved = |axial: AxialPlace| {
        let (mut free, mut start) = static_start(definition, supports, axial);
        for (axis, given) in given.iter().enumerate() {
            if let Some(position) = *given {
                (free[axis], start[axis]) = (false, position);
            }
        }
        let problem = StaticProblem {
            supports,
            load: [0.0; FREEDOMS],
            free,
            start,
            speed: definition.speed,
        };
        Ok((free, problem.on(&structure, load)?))
    };
    let axial = match definition.shaft.freedoms.moves(2) {
        true => AxialPlace::Balanced,
        false => AxialPlace::find(&structure, supports, load[z]),
    };
    let (found, is_pushed) = match solved(axial) {
        Err(EquilibriumError::NotCarried { .. }) if axial == AxialPlace::BalancedOrHeld => {
            (solved(AxialPlace::Held)?, true)
        }
        found => (found?, false),
    };
    let (free, balance) = found;
    let equilibrium = balance.equilibrium(&structure);
    Ok(StaticPlace {
        free,
        axial_hold: is_pushed.then_some(equilibrium.force[2]),
        equilibrium,
        coordinates: balance.displacement.as_slice().to_vec(),
        stiffness: balance.restoring.stiffness,
        unloaded: match free[2] {
            true => structure.unloaded_axial(supports),
            false => vec![0.0; supports.len()],
        },
        structure,
    })
}

/// Warning of a hold along z that bears what the bearings do not balance, N.
pub(crate) fn axial_hold_warning(force: f64) -> String {
    format!(
        "the springs of the bearings push the shaft along z and nothing pushes back: z is held, against {force:.1} N; turn the `facing` of a bearing, or leave out a `spring_preload`"
    )
}

/// Which freedoms find their position, and where the search starts and the others stay.
fn static_start(
    definition: &RotorDefinition,
    supports: &[Support],
    axial: AxialPlace,
) -> ([bool; FREEDOMS], Vector5) {
    let freedoms = definition.shaft.freedoms;
    let bends = definition.flexible.is_some();
    let mut free: [bool; FREEDOMS] =
        std::array::from_fn(|axis| freedoms.moves(axis) || bends && axis != 2);
    let mut start = [0.0; FREEDOMS];
    for axis in (3..FREEDOMS).filter(|&axis| !free[axis]) {
        start[axis] = definition.shaft.held_tilt[axis - 3];
    }
    if !free[2] {
        free[2] = axial != AxialPlace::Held;
        start[2] = match axial {
            AxialPlace::Balanced => 0.0,
            AxialPlace::Held | AxialPlace::BalancedOrHeld => held_axial(supports),
        };
    }
    (free, start)
}

/// Where a shaft is along its axis.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum AxialPlace {
    /// Where its axial forces balance.
    Balanced,
    /// There, or where a single bearing holds it if they balance nowhere.
    BalancedOrHeld,
    /// Where a single bearing holds it.
    Held,
}

impl AxialPlace {
    /// An axial load and two bearings that face each other have their balance; so have several bearings that hold the shaft
    /// along its axis, unless springs press all of them one way. A single one is where it is mounted.
    fn find(structure: &Structure, supports: &[Support], axial_load: f64) -> Self {
        let faces = |facing| {
            supports
                .iter()
                .any(|support| support.definition().facing == facing)
        };
        if axial_load != 0.0 || (faces(Facing::PlusZ) && faces(Facing::MinusZ)) {
            return Self::Balanced;
        }
        let springs = structure.axial_stiffness() > 0.0;
        match holding(supports).count() + usize::from(springs) {
            0 | 1 => Self::Held,
            _ => Self::BalancedOrHeld,
        }
    }
}

/// The bearings that hold the shaft along its axis.
fn holding(supports: &[Support]) -> impl Iterator<Item = &Support> {
    let holds = |support: &&Support| support.definition().bearing.geometry.carries_axial_load();
    supports.iter().filter(holds)
}

/// Where the first bearing holds a shaft along its axis that no other one does: a preset offset fixes it by itself, at z = 0; a
/// bearing without one is axially centred.
fn held_axial(supports: &[Support]) -> f64 {
    if supports.iter().any(Support::is_preloaded) {
        return 0.0;
    }
    let first = holding(supports).next().or(supports.first());
    first.map_or(0.0, |first| {
        first.definition().facing.sign() * first.centred_axial()
    })
}

impl Bearing {
    /// Where the inner ring of the bearing at rest finds its position under a load on its centre: forces x, y, z in
    /// N, moments about X and Y in N m. Dry Hertz contacts, no preload; all five freedoms are free, a positive axial
    /// force loads an angular contact bearing.
    ///
    /// Films, ball inertia, several bearings and held freedoms: [`crate::quasi_static::quasi_static`].
    ///
    /// ```
    /// use jeffcott::bearing::Bearing;
    /// // 1 kN along the axis of a 7205C: its balls bear alike, and the ring moves by 32 µm
    /// let equilibrium = Bearing::catalogue("7205C")?.equilibrium([0.0, 0.0, 1000.0, 0.0, 0.0])?;
    /// assert!((equilibrium.displacement[2] - 31.9764e-6).abs() < 1e-10);
    /// let stiffness = equilibrium.stiffness();
    /// assert!((stiffness[(0, 0)] / stiffness[(1, 1)] - 1.0).abs() < 1e-9);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// [`RotorError`] where the contacts cannot be formed, or nothing carries the load.
    pub fn equilibrium(&self, load: Vector5) -> Result<Equilibrium, RotorError> {
        let mounted = MountedBearing::new(*self);
        let support = Support::new(&mounted, 0.0)
            .map_err(|source| RotorError::Bearing { number: 1, source })?;
        let problem = StaticProblem {
            supports: &[support],
            load,
            free: [true; 5],
            start: [0.0; 5],
            speed: 0.0,
        };
        Ok(problem.solve()?)
    }
}

impl Equilibrium {
    /// K = ∂F/∂q, rows and columns x, y, z, θx, θy; N/m, N/rad, N m/m, N m/rad.
    pub fn stiffness(&self) -> &Matrix5 {
        &self.stiffness
    }
}
