//! The columns of the table of samples: everything that a run records of an instant, listed once.
//!
//! Trace, spectra, figures, page, studies and the keys `channels` of a scenario ask here for name, unit and value.

use std::sync::{LazyLock, Mutex, PoisonError};

use crate::keys::{DISPLACEMENT, FORCE};
use crate::rotor::{Body, DriveMoments, EnergyBalance, FREEDOMS, Freedoms, MOST_BEARINGS, Sample};
use crate::table::{Column, ColumnKind, Named};

/// What acts on the shaft or on a housing, each kind counted from 0.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Part {
    /// A bearing.
    Bearing(usize),
    /// An element.
    Element(usize),
}

/// A column of the table of samples, found by its name: [`Channel::from_name`], or among [`Channel::all`].
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
#[non_exhaustive]
pub enum Channel {
    /// Time.
    Time,
    /// Shaft angle.
    Angle,
    /// Angular speed of the shaft.
    Speed,
    /// Displacement or tilt of freedom 0 … 4: x, y, z, θx, θy.
    #[non_exhaustive]
    Displacement(usize),
    /// Its time derivative.
    #[non_exhaustive]
    Velocity(usize),
    /// Its second time derivative.
    #[non_exhaustive]
    Acceleration(usize),
    /// Force of the bearings on the shaft along freedom 0 … 4.
    #[non_exhaustive]
    Force(usize),
    /// Largest load on a ball of any bearing.
    LargestBallLoad,
    /// Number of balls in contact, all bearings together.
    BallsLoaded,
    /// A term of the energy balance: kinetic, stored, then the works.
    #[non_exhaustive]
    Energy(usize),
    /// Motion of a housing, or of what vibrates on it, along axis 0 … 2.
    #[non_exhaustive]
    Body {
        /// Which.
        body: Body,
        /// Which quantity.
        quantity: BodyQuantity,
        /// x, y or z.
        axis: usize,
    },
    /// Force of a bearing or an element on the shaft, or on the housing that it holds, along freedom 0 … 4, moments about
    /// the point of the total.
    #[non_exhaustive]
    PartForce {
        /// Which.
        part: Part,
        /// x, y, z, θx or θy.
        freedom: usize,
    },
    /// A quantity of a driven shaft: moments of drive, load, friction and vibration, twist.
    #[non_exhaustive]
    Drive(usize),
    /// What a sensor measured, which no simulation has.
    Measured(&'static Column),
}

/// A quantity of a body besides the shaft.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum BodyQuantity {
    /// Displacement.
    Displacement,
    /// Velocity.
    Velocity,
    /// Acceleration.
    Acceleration,
}

impl BodyQuantity {
    const ALL: [Self; 3] = [Self::Displacement, Self::Velocity, Self::Acceleration];

    /// Its time derivative, where that is known.
    pub(super) fn rate(self) -> Option<Self> {
        match self {
            Self::Displacement => Some(Self::Velocity),
            Self::Velocity => Some(Self::Acceleration),
            Self::Acceleration => None,
        }
    }
}

/// The terms of the energy balance.
const ENERGY: [Named<EnergyBalance>; 11] = [
    ("kinetic", "J", |energy| energy.kinetic),
    ("stored", "J", |energy| energy.stored),
    ("loads", "J", |energy| energy.works.loads),
    ("unbalance", "J", |energy| energy.works.unbalance),
    ("rotation", "J", |energy| energy.works.rotation),
    ("viscous_damping", "J", |energy| energy.works.viscous),
    ("contact_damping", "J", |energy| energy.works.contact),
    ("bearings", "J", |energy| energy.works.bearings),
    ("drive", "J", |energy| energy.works.drive),
    ("load_torque", "J", |energy| energy.works.load_torque),
    ("bearing_friction", "J", |energy| energy.works.friction),
];

/// The quantities of a driven shaft.
const DRIVE: [Named<DriveMoments>; 5] = [
    ("drive_torque", "N m", |drive| drive.drive),
    ("load_torque", "N m", |drive| drive.load),
    ("friction_moment", "N m", |drive| drive.friction),
    ("vibration_torque", "N m", |drive| drive.vibration),
    ("twist", "rad", |drive| drive.twist),
];

/// Every quantity with its column, in the order in which the tables show them; after those of the shaft those of the
/// housings and the forces, bearing by bearing and element by element.
static ALL: LazyLock<Vec<(Channel, Column)>> = LazyLock::new(|| {
    use Channel::*;
    let of = |quantity: fn(usize) -> Channel| (0..FREEDOMS).map(quantity);
    let bodies = crate::rotor::Body::all().flat_map(|body| Channel::of_body(body, 3));
    let parts = [Part::Bearing, Part::Element].into_iter();
    let parts = parts.flat_map(|of| (0..MOST_BEARINGS).map(of));
    let forces =
        parts.flat_map(|part| (0..FREEDOMS).map(move |freedom| PartForce { part, freedom }));
    let all = [Time, Angle, Speed].into_iter();
    let all = all.chain(of(Displacement)).chain(of(Velocity));
    let all = all.chain(of(Acceleration)).chain(of(Force));
    let all = all.chain([LargestBallLoad, BallsLoaded]);
    let all = all.chain((0..ENERGY.len()).map(Energy));
    let all = all.chain((0..DRIVE.len()).map(Drive));
    let all = all.chain(bodies).chain(forces);
    all.map(|channel| (channel, channel.column())).collect()
});

/// The columns of all sensors so far: a channel is copied around, and its column stays.
static MEASURED: Mutex<Vec<&'static Column>> = Mutex::new(Vec::new());

impl Channel {
    /// The channel of what was measured: that of a simulation where it has this column, or else one of its own.
    pub(crate) fn of_measured(column: Column) -> Self {
        if let Some(channel) = Self::of_column(&column) {
            return channel;
        }
        let mut known = MEASURED.lock().unwrap_or_else(PoisonError::into_inner);
        let found = known.iter().copied().find(|known| **known == column);
        Self::Measured(found.unwrap_or_else(|| {
            let column: &'static Column = Box::leak(Box::new(column));
            known.push(column);
            column
        }))
    }

    /// Kinetic energy of the shaft.
    pub(crate) const KINETIC_ENERGY: Self = Self::Energy(0);
    /// Energy stored in the bearings.
    pub(crate) const STORED_ENERGY: Self = Self::Energy(1);

    /// Displacements, then forces, of the freedoms that move.
    #[doc(hidden)]
    pub fn of_freedoms(freedoms: Freedoms) -> Vec<Self> {
        let axes = || freedoms.axes().iter().copied();
        let displacements = axes().map(Self::Displacement);
        displacements.chain(axes().map(Self::Force)).collect()
    }

    /// Freedom 0 … 4 or axis 0 … 2 along which it moves or pushes.
    fn along(&mut self) -> Option<&mut usize> {
        match self {
            Self::Displacement(freedom)
            | Self::Velocity(freedom)
            | Self::Acceleration(freedom)
            | Self::Force(freedom)
            | Self::PartForce { freedom, .. }
            | Self::Body { axis: freedom, .. } => Some(freedom),
            _ => None,
        }
    }

    /// Whether it moves or pushes along the axis of the shaft.
    pub(super) fn is_axial(mut self) -> bool {
        self.along() == Some(&mut 2)
    }

    /// What turns together with it in a whirl: the y of an x, θy of θx.
    pub(crate) fn across(mut self) -> Option<Self> {
        let along = self.along().filter(|along| matches!(along, 0 | 3))?;
        *along += 1;
        Some(self)
    }

    /// All columns, in the order in which the tables show them.
    pub fn all() -> impl Iterator<Item = Self> {
        ALL.iter().map(|(channel, ..)| *channel)
    }

    /// The column of a simulation that has a name as in the files, without its unit.
    ///
    /// ```
    /// use jeffcott::analysis::Channel;
    /// let velocity = Channel::from_name("x_velocity").expect("a column of every run");
    /// assert_eq!(velocity.unit(), "m/s");
    /// assert_eq!(Channel::from_name("velocity_of_light"), None);
    /// ```
    pub fn from_name(name: &str) -> Option<Self> {
        Self::all().find(|channel| channel.name() == name)
    }

    /// The columns that the table `trace` has of every shaft.
    pub(crate) fn of_trace() -> impl Iterator<Item = Self> {
        let elsewhere = |channel: &Self| {
            matches!(
                channel,
                Self::Acceleration(_)
                    | Self::Energy(_)
                    | Self::Drive(_)
                    | Self::Body { .. }
                    | Self::PartForce { .. }
            )
        };
        Self::all().filter(move |channel| !elsewhere(channel))
    }

    /// The columns of the table `energy`.
    pub(crate) fn of_energy() -> impl Iterator<Item = Self> {
        Self::all().filter(|channel| matches!(channel, Self::Time | Self::Energy(_)))
    }

    /// The columns of the table `drive`.
    pub(crate) fn of_drive() -> impl Iterator<Item = Self> {
        Self::all().filter(|channel| matches!(channel, Self::Time | Self::Speed | Self::Drive(_)))
    }

    /// Name as in the files: `x`, `tilt_x`, `x_velocity`, `force_x`, `moment_x` ….
    pub fn name(self) -> &'static str {
        &self.listed().quantity
    }

    /// Unit: `m`, `rad/s^2`, `N m` …; empty of a number.
    pub fn unit(self) -> &'static str {
        &self.listed().unit
    }

    fn listed(self) -> &'static Column {
        if let Self::Measured(column) = self {
            return column;
        }
        let mut all = ALL.iter();
        let found = all.find(|(channel, _)| *channel == self);
        &found.expect("every quantity is listed").1
    }

    /// Value in a sample; none where it was not observed.
    pub fn value(self, sample: &Sample) -> Option<f64> {
        Some(match self {
            Self::Time => sample.time,
            Self::Angle => sample.angle,
            Self::Speed => sample.speed,
            Self::Displacement(freedom) => sample.displacement[freedom],
            Self::Velocity(freedom) => sample.velocity[freedom],
            Self::Acceleration(freedom) => sample.acceleration?[freedom],
            Self::Force(freedom) => sample.force_on_shaft?[freedom],
            Self::PartForce { part, freedom } => {
                let place = match part {
                    // behind those of the bearings are those of the elements
                    Part::Bearing(bearing) if bearing >= sample.first_element => return None,
                    Part::Bearing(bearing) => bearing,
                    Part::Element(element) => sample.first_element + element,
                };
                sample.bearing_forces.get(place)?[freedom]
            }
            Self::LargestBallLoad => sample.largest_ball_load?,
            Self::BallsLoaded => f64::from(sample.balls_loaded?),
            Self::Energy(term) => (ENERGY[term].2)(&sample.energy?),
            Self::Drive(quantity) => (DRIVE[quantity].2)(&sample.drive?),
            Self::Measured(_) => return None,
            Self::Body {
                body,
                quantity,
                axis,
            } => {
                let motion = sample.bodies.get(body.index())?;
                match quantity {
                    BodyQuantity::Displacement => motion.displacement[axis],
                    BodyQuantity::Velocity => motion.velocity[axis],
                    BodyQuantity::Acceleration => motion.acceleration?[axis],
                }
            }
        })
    }

    /// Its column in the files, named `x_m`, `force_x_N`, `x_velocity_m_s`, `balls_loaded`.
    pub fn column(self) -> Column {
        let rate = |(quantity, unit), what, per| {
            Column::number(format!("{quantity}_{what}"), format!("{unit}/{per}"))
        };
        let (quantity, unit) = match self {
            Self::Time => ("t", "s"),
            Self::Angle => ("angle", "rad"),
            Self::Speed => ("speed", "rad/s"),
            Self::Displacement(freedom) => DISPLACEMENT[freedom],
            Self::Velocity(freedom) => return rate(DISPLACEMENT[freedom], "velocity", "s"),
            Self::Acceleration(freedom) => {
                return rate(DISPLACEMENT[freedom], "acceleration", "s^2");
            }
            Self::Force(freedom) => FORCE[freedom],
            Self::LargestBallLoad => ("largest_ball_load", "N"),
            Self::BallsLoaded => return Column::count("balls_loaded"),
            Self::Energy(term) => (ENERGY[term].0, ENERGY[term].1),
            Self::Drive(quantity) => (DRIVE[quantity].0, DRIVE[quantity].1),
            Self::Measured(column) => return column.clone(),
            Self::Body {
                body,
                quantity,
                axis,
            } => {
                let of_shaft = match quantity {
                    BodyQuantity::Displacement => Self::Displacement(axis),
                    BodyQuantity::Velocity => Self::Velocity(axis),
                    BodyQuantity::Acceleration => Self::Acceleration(axis),
                };
                return of_shaft.column().of_part(&body.name());
            }
            Self::PartForce { part, freedom } => {
                let total = Self::Force(freedom).column();
                return total.of_part(&match part {
                    Part::Bearing(bearing) => format!("bearing{}", bearing + 1),
                    Part::Element(element) => format!("element{}", element + 1),
                });
            }
        };
        Column::number(quantity, unit)
    }

    /// The column of a measure of how it moves, in its unit: `x_rms_m`.
    pub(crate) fn measure(self, what: &'static str) -> Column {
        Column::measure(self.name(), what, self.unit())
    }

    /// The columns of its lines in a spectrum, amplitude and phase: `x_amplitude_m`, `x_phase_rad`.
    pub(crate) fn lines(self) -> [Column; 2] {
        [self.measure("amplitude"), Column::phase(self.name())]
    }

    /// The quantity that a column of a trace or of a spectrum is of, in the unit of the quantity itself.
    pub(crate) fn of_column(column: &Column) -> Option<Self> {
        if !matches!(column.kind, ColumnKind::Number | ColumnKind::Count) && !column.has_lines() {
            return None;
        }
        let mut all = ALL.iter();
        let found =
            all.find(|(_, known)| known.quantity == column.quantity && known.unit == column.unit);
        found.map(|(channel, _)| *channel)
    }

    /// Freedom 0 … 4 that it belongs to: x, y, z, θx, θy; none of what belongs to the whole shaft.
    pub(crate) fn freedom(self) -> Option<usize> {
        match self {
            Self::Displacement(freedom)
            | Self::Velocity(freedom)
            | Self::Acceleration(freedom)
            | Self::Force(freedom) => Some(freedom),
            _ => None,
        }
    }

    /// Whether it needs the accelerations of a state.
    pub(crate) fn needs_acceleration(self) -> bool {
        use BodyQuantity::Acceleration;
        match self {
            Self::Acceleration(_) => true,
            Self::Body { quantity, .. } => quantity == Acceleration,
            _ => false,
        }
    }

    /// Whether it is the velocity of a housing, whose RMS is judged.
    pub(crate) fn is_housing_velocity(self) -> bool {
        use BodyQuantity::Velocity;
        matches!(
            self,
            Self::Body {
                body: Body::Housing(_),
                quantity: Velocity,
                ..
            }
        )
    }

    /// Columns of a body that moves along the first `axes` of x, y, z.
    pub(super) fn of_body(body: Body, axes: usize) -> impl Iterator<Item = Self> {
        BodyQuantity::ALL.into_iter().flat_map(move |quantity| {
            (0..axes).map(move |axis| Self::Body {
                body,
                quantity,
                axis,
            })
        })
    }

    /// Whether it is a force or a moment on the shaft.
    pub(crate) fn is_force(self) -> bool {
        matches!(self, Self::Force(_) | Self::PartForce { .. })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::rotor::{BodyMotion, MOST_HOUSINGS};

    #[test]
    fn every_column_has_a_value_in_a_sample_that_is_wholly_observed() {
        let motion = BodyMotion {
            acceleration: Some([0.0; 3]),
            ..BodyMotion::default()
        };
        let sample = Sample {
            acceleration: Some([0.0; FREEDOMS]),
            bodies: vec![motion; 2 * MOST_HOUSINGS],
            force_on_shaft: Some([0.0; FREEDOMS]),
            bearing_forces: vec![[0.0; FREEDOMS]; 2 * MOST_BEARINGS],
            first_element: MOST_BEARINGS,
            largest_ball_load: Some(0.0),
            balls_loaded: Some(0),
            energy: Some(EnergyBalance::default()),
            drive: Some(DriveMoments::default()),
            ..Sample::default()
        };
        for channel in Channel::all() {
            assert_eq!(channel.value(&sample), Some(0.0), "{channel}");
        }
        assert_eq!(
            Channel::all().count(),
            41 + 18 * MOST_HOUSINGS + 10 * MOST_BEARINGS
        );
    }

    #[test]
    fn names_are_unique_within_a_table() {
        let name = |channel: Channel| channel.column().name();
        let tables: [Vec<String>; 4] = [
            Channel::of_trace().map(name).collect(),
            Channel::selectable().map(name).collect(),
            Channel::of_energy().map(name).collect(),
            Channel::of_drive().map(name).collect(),
        ];
        for names in tables {
            let mut unique = names.clone();
            unique.sort();
            unique.dedup();
            assert_eq!(unique.len(), names.len(), "{names:?}");
        }
    }
}
