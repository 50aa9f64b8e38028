//! The columns of the table of samples: everything that a run records of an instant, listed once.
//!
//! Trace, spectra, figures, page, studies and the keys `channels` of a scenario ask here for name, unit and value.

use std::borrow::Cow;
use std::fmt;

use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};
use serde::{Deserialize, Deserializer, Serialize, Serializer, de};

use crate::rotor::{FREEDOMS, MOST_HOUSINGS, Sample};

/// A column of the table of samples.
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
    Displacement(usize),
    /// Its time derivative.
    Velocity(usize),
    /// Its second time derivative.
    Acceleration(usize),
    /// Force of the bearings on the shaft along freedom 0 … 4.
    Force(usize),
    /// Largest load on a ball of any bearing.
    LargestBallLoad,
    /// Number of balls in contact, all bearings together.
    BallsLoaded,
    /// A term of the energy balance: kinetic, stored, then the works of `rotor::Works::values`.
    Energy(usize),
    /// Motion of the housing of a bearing, from 0, along axis 0 … 2.
    Housing {
        /// Bearing.
        bearing: usize,
        /// Which quantity.
        quantity: HousingQuantity,
        /// x, y or z.
        axis: usize,
    },
    /// A quantity of a driven shaft: moments of drive, load, friction and vibration, twist.
    Drive(usize),
}

/// A quantity of a housing.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum HousingQuantity {
    /// Displacement.
    Displacement,
    /// Velocity.
    Velocity,
    /// Acceleration.
    Acceleration,
}

/// What is known of a column.
struct Definition {
    channel: Channel,
    name: &'static str,
    unit: &'static str,
    /// Value in a sample; none where it was not observed.
    value: fn(&Sample) -> Option<f64>,
}

const fn column(
    channel: Channel,
    name: &'static str,
    unit: &'static str,
    value: fn(&Sample) -> Option<f64>,
) -> Definition {
    Definition {
        channel,
        name,
        unit,
        value,
    }
}

/// Columns of one housing.
const HOUSING_COLUMNS: usize = 9;

/// Every column, in the order in which the tables show them.
#[rustfmt::skip]
const COLUMNS: [Definition; 41 + HOUSING_COLUMNS * MOST_HOUSINGS] = [
    column(Channel::Time, "t", "s", |s| Some(s.time)),
    column(Channel::Angle, "angle", "rad", |s| Some(s.angle)),
    column(Channel::Speed, "speed", "rad/s", |s| Some(s.speed)),
    column(Channel::Displacement(0), "x", "m", |s| Some(s.displacement[0])),
    column(Channel::Displacement(1), "y", "m", |s| Some(s.displacement[1])),
    column(Channel::Displacement(2), "z", "m", |s| Some(s.displacement[2])),
    column(Channel::Displacement(3), "tilt_x", "rad", |s| Some(s.displacement[3])),
    column(Channel::Displacement(4), "tilt_y", "rad", |s| Some(s.displacement[4])),
    column(Channel::Velocity(0), "x_velocity", "m/s", |s| Some(s.velocity[0])),
    column(Channel::Velocity(1), "y_velocity", "m/s", |s| Some(s.velocity[1])),
    column(Channel::Velocity(2), "z_velocity", "m/s", |s| Some(s.velocity[2])),
    column(Channel::Velocity(3), "tilt_x_velocity", "rad/s", |s| Some(s.velocity[3])),
    column(Channel::Velocity(4), "tilt_y_velocity", "rad/s", |s| Some(s.velocity[4])),
    column(Channel::Acceleration(0), "x_acceleration", "m/s^2", |s| Some(s.acceleration?[0])),
    column(Channel::Acceleration(1), "y_acceleration", "m/s^2", |s| Some(s.acceleration?[1])),
    column(Channel::Acceleration(2), "z_acceleration", "m/s^2", |s| Some(s.acceleration?[2])),
    column(Channel::Acceleration(3), "tilt_x_acceleration", "rad/s^2", |s| Some(s.acceleration?[3])),
    column(Channel::Acceleration(4), "tilt_y_acceleration", "rad/s^2", |s| Some(s.acceleration?[4])),
    column(Channel::Force(0), "force_x", "N", |s| Some(s.force_on_shaft?[0])),
    column(Channel::Force(1), "force_y", "N", |s| Some(s.force_on_shaft?[1])),
    column(Channel::Force(2), "force_z", "N", |s| Some(s.force_on_shaft?[2])),
    column(Channel::Force(3), "moment_x", "N m", |s| Some(s.force_on_shaft?[3])),
    column(Channel::Force(4), "moment_y", "N m", |s| Some(s.force_on_shaft?[4])),
    column(Channel::LargestBallLoad, "largest_ball_load", "N", |s| s.largest_ball_load),
    column(Channel::BallsLoaded, "balls_loaded", "", |s| s.balls_loaded.map(f64::from)),
    column(Channel::KINETIC_ENERGY, "kinetic", "J", |s| Some(s.energy?.kinetic)),
    column(Channel::STORED_ENERGY, "stored", "J", |s| Some(s.energy?.stored)),
    column(Channel::Energy(2), "loads", "J", |s| Some(s.energy?.works.loads)),
    column(Channel::Energy(3), "unbalance", "J", |s| Some(s.energy?.works.unbalance)),
    column(Channel::Energy(4), "rotation", "J", |s| Some(s.energy?.works.rotation)),
    column(Channel::Energy(5), "viscous_damping", "J", |s| Some(s.energy?.works.viscous)),
    column(Channel::Energy(6), "contact_damping", "J", |s| Some(s.energy?.works.contact)),
    column(Channel::Energy(7), "bearings", "J", |s| Some(s.energy?.works.bearings)),
    column(Channel::Energy(8), "drive", "J", |s| Some(s.energy?.works.drive)),
    column(Channel::Energy(9), "load_torque", "J", |s| Some(s.energy?.works.load_torque)),
    column(Channel::Energy(10), "bearing_friction", "J", |s| Some(s.energy?.works.friction)),
    column(Channel::Drive(0), "drive_torque", "N m", |s| Some(s.drive?.drive)),
    column(Channel::Drive(1), "load_torque", "N m", |s| Some(s.drive?.load)),
    column(Channel::Drive(2), "friction_moment", "N m", |s| Some(s.drive?.friction)),
    column(Channel::Drive(3), "vibration_torque", "N m", |s| Some(s.drive?.vibration)),
    column(Channel::Drive(4), "twist", "rad", |s| Some(s.drive?.twist)),
    column(Channel::Housing { bearing: 0, quantity: HousingQuantity::Displacement, axis: 0 }, "housing1_x", "m", |s| Some(s.housings?[0].displacement[0])),
    column(Channel::Housing { bearing: 0, quantity: HousingQuantity::Displacement, axis: 1 }, "housing1_y", "m", |s| Some(s.housings?[0].displacement[1])),
    column(Channel::Housing { bearing: 0, quantity: HousingQuantity::Displacement, axis: 2 }, "housing1_z", "m", |s| Some(s.housings?[0].displacement[2])),
    column(Channel::Housing { bearing: 0, quantity: HousingQuantity::Velocity, axis: 0 }, "housing1_x_velocity", "m/s", |s| Some(s.housings?[0].velocity[0])),
    column(Channel::Housing { bearing: 0, quantity: HousingQuantity::Velocity, axis: 1 }, "housing1_y_velocity", "m/s", |s| Some(s.housings?[0].velocity[1])),
    column(Channel::Housing { bearing: 0, quantity: HousingQuantity::Velocity, axis: 2 }, "housing1_z_velocity", "m/s", |s| Some(s.housings?[0].velocity[2])),
    column(Channel::Housing { bearing: 0, quantity: HousingQuantity::Acceleration, axis: 0 }, "housing1_x_acceleration", "m/s^2", |s| Some(s.housings?[0].acceleration?[0])),
    column(Channel::Housing { bearing: 0, quantity: HousingQuantity::Acceleration, axis: 1 }, "housing1_y_acceleration", "m/s^2", |s| Some(s.housings?[0].acceleration?[1])),
    column(Channel::Housing { bearing: 0, quantity: HousingQuantity::Acceleration, axis: 2 }, "housing1_z_acceleration", "m/s^2", |s| Some(s.housings?[0].acceleration?[2])),
    column(Channel::Housing { bearing: 1, quantity: HousingQuantity::Displacement, axis: 0 }, "housing2_x", "m", |s| Some(s.housings?[1].displacement[0])),
    column(Channel::Housing { bearing: 1, quantity: HousingQuantity::Displacement, axis: 1 }, "housing2_y", "m", |s| Some(s.housings?[1].displacement[1])),
    column(Channel::Housing { bearing: 1, quantity: HousingQuantity::Displacement, axis: 2 }, "housing2_z", "m", |s| Some(s.housings?[1].displacement[2])),
    column(Channel::Housing { bearing: 1, quantity: HousingQuantity::Velocity, axis: 0 }, "housing2_x_velocity", "m/s", |s| Some(s.housings?[1].velocity[0])),
    column(Channel::Housing { bearing: 1, quantity: HousingQuantity::Velocity, axis: 1 }, "housing2_y_velocity", "m/s", |s| Some(s.housings?[1].velocity[1])),
    column(Channel::Housing { bearing: 1, quantity: HousingQuantity::Velocity, axis: 2 }, "housing2_z_velocity", "m/s", |s| Some(s.housings?[1].velocity[2])),
    column(Channel::Housing { bearing: 1, quantity: HousingQuantity::Acceleration, axis: 0 }, "housing2_x_acceleration", "m/s^2", |s| Some(s.housings?[1].acceleration?[0])),
    column(Channel::Housing { bearing: 1, quantity: HousingQuantity::Acceleration, axis: 1 }, "housing2_y_acceleration", "m/s^2", |s| Some(s.housings?[1].acceleration?[1])),
    column(Channel::Housing { bearing: 1, quantity: HousingQuantity::Acceleration, axis: 2 }, "housing2_z_acceleration", "m/s^2", |s| Some(s.housings?[1].acceleration?[2])),
    column(Channel::Housing { bearing: 2, quantity: HousingQuantity::Displacement, axis: 0 }, "housing3_x", "m", |s| Some(s.housings?[2].displacement[0])),
    column(Channel::Housing { bearing: 2, quantity: HousingQuantity::Displacement, axis: 1 }, "housing3_y", "m", |s| Some(s.housings?[2].displacement[1])),
    column(Channel::Housing { bearing: 2, quantity: HousingQuantity::Displacement, axis: 2 }, "housing3_z", "m", |s| Some(s.housings?[2].displacement[2])),
    column(Channel::Housing { bearing: 2, quantity: HousingQuantity::Velocity, axis: 0 }, "housing3_x_velocity", "m/s", |s| Some(s.housings?[2].velocity[0])),
    column(Channel::Housing { bearing: 2, quantity: HousingQuantity::Velocity, axis: 1 }, "housing3_y_velocity", "m/s", |s| Some(s.housings?[2].velocity[1])),
    column(Channel::Housing { bearing: 2, quantity: HousingQuantity::Velocity, axis: 2 }, "housing3_z_velocity", "m/s", |s| Some(s.housings?[2].velocity[2])),
    column(Channel::Housing { bearing: 2, quantity: HousingQuantity::Acceleration, axis: 0 }, "housing3_x_acceleration", "m/s^2", |s| Some(s.housings?[2].acceleration?[0])),
    column(Channel::Housing { bearing: 2, quantity: HousingQuantity::Acceleration, axis: 1 }, "housing3_y_acceleration", "m/s^2", |s| Some(s.housings?[2].acceleration?[1])),
    column(Channel::Housing { bearing: 2, quantity: HousingQuantity::Acceleration, axis: 2 }, "housing3_z_acceleration", "m/s^2", |s| Some(s.housings?[2].acceleration?[2])),
    column(Channel::Housing { bearing: 3, quantity: HousingQuantity::Displacement, axis: 0 }, "housing4_x", "m", |s| Some(s.housings?[3].displacement[0])),
    column(Channel::Housing { bearing: 3, quantity: HousingQuantity::Displacement, axis: 1 }, "housing4_y", "m", |s| Some(s.housings?[3].displacement[1])),
    column(Channel::Housing { bearing: 3, quantity: HousingQuantity::Displacement, axis: 2 }, "housing4_z", "m", |s| Some(s.housings?[3].displacement[2])),
    column(Channel::Housing { bearing: 3, quantity: HousingQuantity::Velocity, axis: 0 }, "housing4_x_velocity", "m/s", |s| Some(s.housings?[3].velocity[0])),
    column(Channel::Housing { bearing: 3, quantity: HousingQuantity::Velocity, axis: 1 }, "housing4_y_velocity", "m/s", |s| Some(s.housings?[3].velocity[1])),
    column(Channel::Housing { bearing: 3, quantity: HousingQuantity::Velocity, axis: 2 }, "housing4_z_velocity", "m/s", |s| Some(s.housings?[3].velocity[2])),
    column(Channel::Housing { bearing: 3, quantity: HousingQuantity::Acceleration, axis: 0 }, "housing4_x_acceleration", "m/s^2", |s| Some(s.housings?[3].acceleration?[0])),
    column(Channel::Housing { bearing: 3, quantity: HousingQuantity::Acceleration, axis: 1 }, "housing4_y_acceleration", "m/s^2", |s| Some(s.housings?[3].acceleration?[1])),
    column(Channel::Housing { bearing: 3, quantity: HousingQuantity::Acceleration, axis: 2 }, "housing4_z_acceleration", "m/s^2", |s| Some(s.housings?[3].acceleration?[2])),
];

impl Channel {
    /// Kinetic energy of the shaft.
    pub(crate) const KINETIC_ENERGY: Self = Self::Energy(0);
    /// Energy stored in the bearings.
    pub(crate) const STORED_ENERGY: Self = Self::Energy(1);

    /// Displacements, then forces, of the first `freedoms` of x, y, z, θx, θy.
    pub fn of_freedoms(freedoms: usize) -> Vec<Self> {
        let freedoms = freedoms.min(FREEDOMS);
        let displacements = (0..freedoms).map(Self::Displacement);
        displacements
            .chain((0..freedoms).map(Self::Force))
            .collect()
    }

    /// Whether it moves or pushes along the axis of the shaft.
    pub(super) fn is_axial(self) -> bool {
        matches!(
            self,
            Self::Displacement(2)
                | Self::Velocity(2)
                | Self::Acceleration(2)
                | Self::Force(2)
                | Self::Housing { axis: 2, .. }
        )
    }

    /// All columns, in the order in which the tables show them.
    pub fn all() -> impl Iterator<Item = Self> {
        COLUMNS.iter().map(|column| column.channel)
    }

    /// The columns of the table `trace`, where no others are asked for.
    pub(crate) fn of_trace() -> impl Iterator<Item = Self> {
        let elsewhere = |channel: &Self| {
            matches!(
                channel,
                Self::Acceleration(_) | Self::Energy(_) | Self::Drive(_) | Self::Housing { .. }
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

    /// The columns that a trace can show beside the time, in the order in which the tables show them.
    pub(crate) fn selectable() -> impl Iterator<Item = Self> {
        let beside =
            |channel: &Self| !matches!(channel, Self::Time | Self::Energy(_) | Self::Drive(_));
        Self::all().filter(beside)
    }

    /// Place in [`COLUMNS`].
    const fn index(self) -> usize {
        match self {
            Self::Time => 0,
            Self::Angle => 1,
            Self::Speed => 2,
            Self::Displacement(freedom) => 3 + freedom,
            Self::Velocity(freedom) => 8 + freedom,
            Self::Acceleration(freedom) => 13 + freedom,
            Self::Force(freedom) => 18 + freedom,
            Self::LargestBallLoad => 23,
            Self::BallsLoaded => 24,
            Self::Energy(term) => 25 + term,
            Self::Drive(quantity) => 36 + quantity,
            Self::Housing {
                bearing,
                quantity,
                axis,
            } => 41 + HOUSING_COLUMNS * bearing + 3 * quantity as usize + axis,
        }
    }

    /// Name as in the files: `x`, `tilt_x`, `x_velocity`, `force_x`, `moment_x` ….
    pub fn name(self) -> &'static str {
        COLUMNS[self.index()].name
    }

    /// Unit: `m`, `rad/s^2`, `N m` …; empty of a number.
    pub fn unit(self) -> &'static str {
        COLUMNS[self.index()].unit
    }

    /// Value in a sample; none where it was not observed.
    pub fn of(self, sample: &Sample) -> Option<f64> {
        (COLUMNS[self.index()].value)(sample)
    }

    /// Name of the column in the files: quantity and unit, valid as a name in MATLAB and pandas, as `x_m`,
    /// `force_x_N`, `x_velocity_m_s`, `balls_loaded`.
    pub fn column(self) -> String {
        match column_unit(self.unit()).as_str() {
            "" => self.name().to_owned(),
            unit => format!("{}_{unit}", self.name()),
        }
    }

    /// The quantity of a column of a trace or of a spectrum by its name, as `x_m` or `x_amplitude_m`.
    pub(crate) fn of_column(name: &str) -> Option<Self> {
        const SCALINGS: [&str; 3] = ["_amplitude_", "_peak_", "_rms_"];
        let is_of = |channel: &Self| {
            let rest = name.strip_prefix(channel.name());
            let of_spectrum = |rest: &str| SCALINGS.iter().any(|scaling| rest.starts_with(scaling));
            *name == channel.column() || rest.is_some_and(of_spectrum)
        };
        Self::all().find(is_of)
    }

    /// Name and unit as a value of a result.
    pub(crate) fn serialize_with_unit<S: Serializer>(
        &self,
        serializer: S,
    ) -> Result<S::Ok, S::Error> {
        serializer.serialize_str(&self.column())
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
        use HousingQuantity::Acceleration;
        match self {
            Self::Acceleration(_) => true,
            Self::Housing { quantity, .. } => quantity == Acceleration,
            _ => false,
        }
    }

    /// Columns of the housing of a bearing, from 0, that moves along the first `axes` of x, y, z.
    pub(crate) fn of_housing(bearing: usize, axes: usize) -> impl Iterator<Item = Self> {
        Self::all().filter(move |channel| {
            matches!(channel, Self::Housing { bearing: own, axis, .. } if *own == bearing && *axis < axes)
        })
    }

    /// Whether its values are whole numbers.
    pub(crate) fn is_count(self) -> bool {
        self == Self::BallsLoaded
    }
}

/// A unit such as `rad/s` or `kg m^2` as the end of a column name: `rad_s`, `kg_m2`.
pub fn column_unit(unit: &str) -> String {
    unit.replace('^', "").replace([' ', '/', '.'], "_")
}

/// The name.
impl fmt::Display for Channel {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(self.name())
    }
}

/// The name.
impl Serialize for Channel {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.serialize_str(self.name())
    }
}

/// By the name, of those that a trace can show.
impl<'de> Deserialize<'de> for Channel {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let name = Cow::<str>::deserialize(deserializer)?;
        let found = Self::selectable().find(|channel| channel.name() == name);
        found.ok_or_else(|| {
            let names: Vec<_> = Self::selectable().map(|one| format!("`{one}`")).collect();
            let names = names.join(", ");
            de::Error::custom(format!("unknown variant `{name}`, expected one of {names}"))
        })
    }
}

impl JsonSchema for Channel {
    fn inline_schema() -> bool {
        true
    }

    fn schema_name() -> Cow<'static, str> {
        "column".into()
    }

    fn json_schema(_: &mut SchemaGenerator) -> Schema {
        let column = |channel: Self| {
            let description = match channel.unit() {
                "" => "A number.".to_owned(),
                unit => format!("In {unit}."),
            };
            json_schema!({ "description": description, "type": "string", "const": channel.name() })
        };
        json_schema!({
            "description": "A column of the trace beside the time.",
            "oneOf": Self::selectable().map(column).collect::<Vec<_>>(),
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::keys;

    #[test]
    fn every_column_stands_at_its_index() {
        for (index, channel) in Channel::all().enumerate() {
            assert_eq!(channel.index(), index, "{channel}");
        }
    }

    #[test]
    fn keys_of_results_are_names_of_columns() {
        for freedom in 0..FREEDOMS {
            let names =
                [Channel::Displacement(freedom), Channel::Force(freedom)].map(Channel::column);
            assert_eq!(names, [keys::DISPLACEMENT[freedom], keys::FORCE[freedom]]);
        }
    }

    #[test]
    fn names_are_unique_within_a_table() {
        let tables: [Vec<String>; 4] = [
            Channel::of_trace().map(Channel::column).collect(),
            Channel::selectable().map(Channel::column).collect(),
            Channel::of_energy().map(Channel::column).collect(),
            Channel::of_drive().map(Channel::column).collect(),
        ];
        for names in tables {
            let mut unique = names.clone();
            unique.sort();
            unique.dedup();
            assert_eq!(unique.len(), names.len(), "{names:?}");
        }
    }
}
