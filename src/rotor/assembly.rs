//! From a definition to a rotor that can move: equilibrium, held freedoms, damping, linear laws.

use fearless_simd::Level;

use super::damping::DampingMatrix;
use super::unbalance::Unbalance;
use super::{
    Drive, FREEDOMS, Freedoms, InitialPosition, Rotor, RotorDefinition, STANDARD_GRAVITY,
    SpeedProfile,
};
use crate::bearing::equilibrium::{Equilibrium, EquilibriumError, StaticProblem};
use crate::bearing::{BearingError, Facing, Support, Vector5};

/// Why a rotor cannot be assembled.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum RotorError {
    /// A bearing cannot be built.
    #[error("bearing {number}: {source}")]
    Bearing {
        /// Number of the bearing, counted from 1.
        number: usize,
        /// What is wrong with it.
        source: BearingError,
    },
    /// The shaft has no static equilibrium.
    #[error(transparent)]
    Equilibrium(#[from] EquilibriumError),
    /// A quantity is outside its range.
    #[error("{name} is {value}; it must be {rule}")]
    Range {
        /// Name of the quantity.
        name: &'static str,
        /// Value as given, SI.
        value: f64,
        /// What it must be.
        rule: &'static str,
    },
    /// The times of a speed profile do not rise.
    #[error("speed point {number} stands at {time} s; it must come after {before} s")]
    SpeedTimes {
        /// Number of the point after the start, counted from 1.
        number: usize,
        /// Its time, s.
        time: f64,
        /// Time of the point before it, s.
        before: f64,
    },
    /// No bearing was given.
    #[error("the shaft has no bearing; give at least one")]
    NoBearing,
}

impl Rotor {
    /// Builds the supports, finds the static equilibrium and fixes everything that follows from it.
    ///
    /// # Errors
    /// [`RotorError`] where a bearing cannot be built, nothing carries the load, or a number is
    /// outside its range.
    pub fn assemble(definition: &RotorDefinition) -> Result<Self, RotorError> {
        check_inertia(definition)?;
        let mut supports = build_supports(definition)?;
        let speed = definition.speed_profile()?;
        let equilibrium = find_equilibrium(definition, &supports, definition.static_load())?;
        for support in &mut supports {
            support.freeze(&equilibrium.displacement, definition.speed);
        }
        let shaft = &definition.shaft;
        let mass = [
            shaft.mass,
            shaft.mass,
            shaft.mass,
            shaft.inertia_transverse,
            shaft.inertia_transverse,
        ];
        let kept = shaft.freedoms.count();
        Ok(Self {
            level: Level::new(),
            kept,
            mass,
            inverse_mass: std::array::from_fn(
                |axis| if axis < kept { 1.0 / mass[axis] } else { 0.0 },
            ),
            inertia_polar: shaft.inertia_polar,
            speed,
            drive: definition.drive,
            cage: definition.cage,
            unbalance: Unbalance::new(shaft.mass, shaft.eccentricity),
            energy: false,
            load: definition.constant_load(),
            weight: definition.weight(),
            loads: definition.loads.clone(),
            damping: DampingMatrix::new(&definition.damping, &equilibrium.stiffness, &mass),
            contacts_damped: supports.iter().any(Support::is_damped),
            balls_that_lift_off: supports.iter().map(Support::balls_that_lift_off).sum(),
            leading_ratio: definition.cage.ratio(&supports[0]),
            supports,
            initial: initial_state(definition, &equilibrium),
            equilibrium,
        })
    }
}

/// What only a motion needs.
fn check_inertia(definition: &RotorDefinition) -> Result<(), RotorError> {
    let shaft = &definition.shaft;
    let polar = "the polar moment of inertia in kg m²";
    if shaft.freedoms == Freedoms::All {
        positive(
            "the transverse moment of inertia in kg m²",
            shaft.inertia_transverse,
        )?;
    }
    if let Some(drive) = &definition.drive {
        positive(polar, shaft.inertia_polar)?;
        check_drive(drive)?;
    }
    not_negative(polar, shaft.inertia_polar)
}

fn check_drive(drive: &Drive) -> Result<(), RotorError> {
    if let Some(speed) = drive.no_load_speed {
        positive("the no-load speed of the drive in rad/s", speed)?;
    }
    not_negative("the torque of the drive in N m", drive.torque)?;
    not_negative("the load torque in N m", drive.load_torque)?;
    not_negative("the torsional compliance in rad/(N m)", drive.compliance)
}

fn check_ranges(definition: &RotorDefinition) -> Result<(), RotorError> {
    let shaft = &definition.shaft;
    positive("the mass in kg", shaft.mass)?;
    not_negative("the eccentricity in m", shaft.eccentricity)?;
    definition.speed_profile()?;
    if definition.bearings.is_empty() {
        return Err(RotorError::NoBearing);
    }
    Ok(())
}

fn positive(name: &'static str, value: f64) -> Result<(), RotorError> {
    range(name, value, value > 0.0, "positive and finite")
}

fn not_negative(name: &'static str, value: f64) -> Result<(), RotorError> {
    range(name, value, value >= 0.0, "zero or positive, finite")
}

fn range(name: &'static str, value: f64, fits: bool, rule: &'static str) -> Result<(), RotorError> {
    if fits && value.is_finite() {
        Ok(())
    } else {
        Err(RotorError::Range { name, value, rule })
    }
}

/// Checks a definition and builds its bearings.
pub(crate) fn build_supports(definition: &RotorDefinition) -> Result<Vec<Support>, RotorError> {
    check_ranges(definition)?;
    let build = |(index, bearing)| {
        Support::new(bearing, definition.speed).map_err(|source| RotorError::Bearing {
            number: index + 1,
            source,
        })
    };
    definition.bearings.iter().enumerate().map(build).collect()
}

impl RotorDefinition {
    /// Constant loads and the weight, N and N m.
    fn constant_load(&self) -> Vector5 {
        let mut load = self.load;
        load[1] -= self.weight();
        load
    }

    /// The weight, N; zero where it does not act.
    fn weight(&self) -> f64 {
        if self.shaft.gravity {
            self.shaft.mass * STANDARD_GRAVITY
        } else {
            0.0
        }
    }

    /// What the static equilibrium carries, N and N m: constant loads, the weight, and of every
    /// varying load its static part.
    pub fn static_load(&self) -> Vector5 {
        let mut sum = self.constant_load();
        for load in &self.loads {
            for (sum, part) in sum.iter_mut().zip(load.static_part()) {
                *sum += part;
            }
        }
        sum
    }

    /// The speed from t = 0 on.
    ///
    /// # Errors
    /// [`RotorError`] where a speed is negative or not finite, or the times do not rise.
    pub fn speed_profile(&self) -> Result<SpeedProfile, RotorError> {
        SpeedProfile::new(self.speed, &self.speed_points)
    }

    /// Unbalance force m e ω² at t = 0, N.
    pub fn unbalance_force(&self) -> f64 {
        let [x, _] = Unbalance::new(self.shaft.mass, self.shaft.eccentricity).phasor(self.speed);
        x.re
    }
}

/// The static equilibrium under the constant loads, without unbalance.
fn find_equilibrium(
    definition: &RotorDefinition,
    supports: &[Support],
    load: Vector5,
) -> Result<Equilibrium, EquilibriumError> {
    let (free, start) = static_start(definition, supports, load[2]);
    let speed = definition.speed;
    StaticProblem {
        supports,
        load,
        free,
        start,
        speed,
    }
    .solve()
}

/// Which freedoms find their place, and where the search starts and the others stay.
pub(crate) fn static_start(
    definition: &RotorDefinition,
    supports: &[Support],
    axial_load: f64,
) -> ([bool; FREEDOMS], Vector5) {
    let kept = definition.shaft.freedoms.count();
    let mut free: [bool; FREEDOMS] = std::array::from_fn(|axis| axis < kept);
    let mut start = [0.0; FREEDOMS];
    for axis in (3..FREEDOMS).filter(|&axis| !free[axis]) {
        start[axis] = definition.shaft.held_tilt[axis - 3];
    }
    if !free[2] {
        match held_axial(supports, axial_load) {
            Some(place) => start[2] = place,
            None => free[2] = true,
        }
    }
    (free, start)
}

/// Where a radial scene holds the axial displacement; `None`: where the equilibrium puts it.
///
/// An axial load or two bearings that face each other fix it by equilibrium. A preset offset fixes
/// it by itself, at z = 0. A bearing with neither stands axially centred.
fn held_axial(supports: &[Support], axial_load: f64) -> Option<f64> {
    let faces = |facing| {
        supports
            .iter()
            .any(|support| support.definition().facing == facing)
    };
    if axial_load != 0.0 || (faces(Facing::PlusZ) && faces(Facing::MinusZ)) {
        return None;
    }
    if supports.iter().any(Support::is_preloaded) {
        return Some(0.0);
    }
    supports.first().map(Support::centred_axial)
}

/// Displacement and velocity at t = 0.
fn initial_state(definition: &RotorDefinition, equilibrium: &Equilibrium) -> [Vector5; 2] {
    let kept = definition.shaft.freedoms.count();
    let initial = &definition.initial;
    let displacement = std::array::from_fn(|axis| {
        let from = match initial.from {
            InitialPosition::Origin if axis < kept => 0.0,
            _ => equilibrium.displacement[axis],
        };
        if axis < kept {
            initial.displacement[axis].unwrap_or(from)
        } else {
            from
        }
    });
    let velocity = std::array::from_fn(|axis| {
        if axis < kept {
            initial.velocity[axis].unwrap_or(0.0)
        } else {
            0.0
        }
    });
    [displacement, velocity]
}
