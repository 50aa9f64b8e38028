//! The quantities of a trace that spectra are taken of.

use std::fmt;

use crate::rotor::{FREEDOMS, Sample};

const DISPLACEMENT_NAMES: [&str; FREEDOMS] = ["x", "y", "z", "tilt_x", "tilt_y"];
const FORCE_NAMES: [&str; FREEDOMS] = ["force_x", "force_y", "force_z", "moment_x", "moment_y"];

/// Number of freedoms that are lengths; the rest are angles.
const LENGTHS: usize = 3;

/// A quantity of the trace that a spectrum is taken of.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Channel {
    /// Displacement or tilt of freedom 0 … 4: x, y, z in m, θx, θy in rad.
    Displacement(usize),
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

    /// Name as in the columns of the files: `x`, `tilt_x`, `force_x`, `moment_x` ….
    pub fn name(self) -> &'static str {
        match self {
            Self::Displacement(freedom) => DISPLACEMENT_NAMES[freedom],
            Self::Force(freedom) => FORCE_NAMES[freedom],
        }
    }

    /// Unit: `m`, `rad`, `N` or `N m`.
    pub fn unit(self) -> &'static str {
        match self {
            Self::Displacement(freedom) if freedom < LENGTHS => "m",
            Self::Displacement(_) => "rad",
            Self::Force(freedom) if freedom < LENGTHS => "N",
            Self::Force(_) => "N m",
        }
    }

    /// Value of this quantity in a sample.
    pub fn of(self, sample: &Sample) -> f64 {
        match self {
            Self::Displacement(freedom) => sample.displacement[freedom],
            Self::Force(freedom) => sample.force_on_shaft[freedom],
        }
    }
}

impl fmt::Display for Channel {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(self.name())
    }
}
