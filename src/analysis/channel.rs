//! The quantities of a trace that spectra are taken of.

use std::fmt;

use serde::Serializer;

use crate::rotor::{FREEDOMS, Sample};

const DISPLACEMENT_NAMES: [&str; FREEDOMS] = ["x", "y", "z", "tilt_x", "tilt_y"];
const VELOCITY_NAMES: [&str; FREEDOMS] = [
    "x_velocity",
    "y_velocity",
    "z_velocity",
    "tilt_x_velocity",
    "tilt_y_velocity",
];
const ACCELERATION_NAMES: [&str; FREEDOMS] = [
    "x_acceleration",
    "y_acceleration",
    "z_acceleration",
    "tilt_x_acceleration",
    "tilt_y_acceleration",
];
const FORCE_NAMES: [&str; FREEDOMS] = ["force_x", "force_y", "force_z", "moment_x", "moment_y"];

/// Number of freedoms that are lengths; the rest are angles.
const LENGTHS: usize = 3;

/// A quantity of the trace that a spectrum is taken of.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Channel {
    /// Displacement or tilt of freedom 0 … 4: x, y, z in m, θx, θy in rad.
    Displacement(usize),
    /// Its time derivative, m/s or rad/s.
    Velocity(usize),
    /// Its second time derivative, m/s² or rad/s².
    Acceleration(usize),
    /// Force of the bearings on the shaft along freedom 0 … 4, N or N m.
    Force(usize),
}

impl Channel {
    /// Displacements, then forces, of the first `freedoms` of x, y, z, θx, θy.
    pub fn of_freedoms(freedoms: usize) -> Vec<Self> {
        let freedoms = freedoms.min(FREEDOMS);
        let displacements = (0..freedoms).map(Self::Displacement);
        displacements
            .chain((0..freedoms).map(Self::Force))
            .collect()
    }

    /// Name as in the columns of the files: `x`, `tilt_x`, `x_velocity`, `force_x`, `moment_x` ….
    pub fn name(self) -> &'static str {
        match self {
            Self::Displacement(freedom) => DISPLACEMENT_NAMES[freedom],
            Self::Velocity(freedom) => VELOCITY_NAMES[freedom],
            Self::Acceleration(freedom) => ACCELERATION_NAMES[freedom],
            Self::Force(freedom) => FORCE_NAMES[freedom],
        }
    }

    /// Name and unit, as in the columns of the files: `x_m`, `moment_x_N_m`.
    pub(crate) fn column(self) -> String {
        format!("{self}_{}", self.unit().replace(' ', "_"))
    }

    /// Name and unit as a value of a result.
    pub(crate) fn serialize_with_unit<S: Serializer>(
        &self,
        serializer: S,
    ) -> Result<S::Ok, S::Error> {
        serializer.serialize_str(&self.column())
    }

    /// Freedom 0 … 4 that it belongs to: x, y, z, θx, θy.
    pub fn freedom(self) -> usize {
        match self {
            Self::Displacement(freedom)
            | Self::Velocity(freedom)
            | Self::Acceleration(freedom)
            | Self::Force(freedom) => freedom,
        }
    }

    /// Unit: `m`, `rad`, `m/s`, `rad/s`, `m/s^2`, `rad/s^2`, `N` or `N m`.
    pub fn unit(self) -> &'static str {
        let is_length = self.freedom() < LENGTHS;
        let [of_length, of_angle] = match self {
            Self::Displacement(_) => ["m", "rad"],
            Self::Velocity(_) => ["m/s", "rad/s"],
            Self::Acceleration(_) => ["m/s^2", "rad/s^2"],
            Self::Force(_) => ["N", "N m"],
        };
        if is_length { of_length } else { of_angle }
    }

    /// Value of this quantity in a sample; none of an acceleration, which a sample does not carry.
    pub fn of(self, sample: &Sample) -> Option<f64> {
        match self {
            Self::Displacement(freedom) => Some(sample.displacement[freedom]),
            Self::Velocity(freedom) => Some(sample.velocity[freedom]),
            Self::Acceleration(_) => None,
            Self::Force(freedom) => Some(sample.force_on_shaft[freedom]),
        }
    }
}

impl fmt::Display for Channel {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(self.name())
    }
}
