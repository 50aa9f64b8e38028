//! Why a rotor cannot be assembled.

use super::ShaftError;
use super::equilibrium::EquilibriumError;
use crate::bearing::BearingError;

/// Why a rotor cannot be assembled.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum RotorError {
    /// A shaft that bends cannot be built.
    #[error(transparent)]
    Shaft(#[from] ShaftError),
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
    /// The centre of mass lies outside every bearing.
    #[error(
        "the eccentricity is {:.4} mm, more than the pitch radius of the largest bearing, {:.4} mm: check its unit",
        1e3 * eccentricity, 1e3 * pitch_radius
    )]
    Eccentricity {
        /// The eccentricity, m.
        eccentricity: f64,
        /// The pitch radius, m.
        pitch_radius: f64,
    },
    /// At rest the shaft is where a squeeze film has no room for it.
    #[error(
        "at rest the ring of a squeeze film damper is {:.1} µm off its middle, and its clearance is {:.1} µm: hold it with \
         stiffer springs, or centre it by a preload",
        1e6 * distance, 1e6 * clearance
    )]
    FilmAtRest {
        /// Distance from the middle, m.
        distance: f64,
        /// Radial clearance, m.
        clearance: f64,
    },
    /// The times of a speed profile do not rise.
    #[error("speed point {number} is at {time} s; it must come after {before} s")]
    SpeedTimes {
        /// Number of the point after the start, counted from 1.
        number: usize,
        /// Its time, s.
        time: f64,
        /// Time of the point before it, s.
        before: f64,
    },
    /// Some motion has no inertia.
    #[error("the mass matrix is not positive definite: give every part that moves a mass")]
    Mass,
}
