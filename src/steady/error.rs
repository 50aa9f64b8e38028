//! Why there is no steady motion.

use crate::integrate::IntegrateError;
use crate::rotor::{RotorError, UnconstrainedError, Unrepeated};
use crate::shooting::{MapError, ShootingError};
use crate::simulate::BeyondContact;

/// Why no motion that repeats was found.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum SteadyError {
    /// The rotor cannot be assembled.
    #[error(transparent)]
    Rotor(#[from] RotorError),
    /// Nothing holds the shaft in a freedom, and the scene rests on what does.
    #[error(transparent)]
    Unconstrained(#[from] UnconstrainedError),
    /// A ball is pressed into its races by more than its radius.
    #[error(transparent)]
    BeyondContact(#[from] BeyondContact),
    /// The forcing does not repeat.
    #[error("there is no steady motion: {0}")]
    Unrepeated(#[from] Unrepeated),
    /// Nothing moves the shaft.
    #[error(
        "nothing keeps the shaft moving: no unbalance, no passing balls, no load that varies; it settles \
         at its static equilibrium, which `jeffcott bearing` finds"
    )]
    Rest,
    /// More than two independent frequencies.
    #[error(
        "the forcing has {} independent frequencies ({}), and motions of more than two are not found \
         directly: use `jeffcott run`, leave one out, or set cage = \"rolling\" in [model] where bearings of one kind differ by \
         the angles of their loaded balls",
        frequencies.len(), hertz(frequencies)
    )]
    Frequencies {
        /// The frequencies, Hz.
        frequencies: Vec<f64>,
    },
    /// A motion of no periods was asked for.
    #[error("a motion takes one period of the forcing, or more, and 0 were asked for")]
    NoPeriods,
    /// A motion of two frequencies has no multiple of its period.
    #[error(
        "the forcing has two frequencies without a common period ({}): the motion has no period to \
         take {multiple} times",
        hertz(frequencies)
    )]
    NoPeriod {
        /// The frequencies, Hz.
        frequencies: Vec<f64>,
        /// What was asked for.
        multiple: u32,
    },
    /// The closed curve of a motion of two frequencies is too rough.
    #[error(
        "the motion of two frequencies needs more than {harmonics} harmonics of the second one: its last \
         ones still have {tail:.1e} of the motion where {tolerance:.0e} are asked for; loosen the \
         tolerance, or use `jeffcott run`"
    )]
    Rough {
        /// Harmonics tried.
        harmonics: usize,
        /// Largest of the highest harmonics, relative to the motion.
        tail: f64,
        /// What is asked for.
        tolerance: f64,
    },
    /// The phase of the second frequency does not pass all around.
    #[error(
        "the two frequencies ({}) have almost a common period, and too few phases pass in {searched} periods; \
         change one of them a little so that they have one, or none",
        hertz(frequencies)
    )]
    NearlyCommon {
        /// The frequencies, Hz.
        frequencies: Vec<f64>,
        /// Periods of the first of them that were searched.
        searched: u64,
    },
    /// The two frequencies do not keep their ratio along the parameter.
    #[error(
        "the parameter changes the ratio of the two frequencies of the forcing, and a motion of two \
         frequencies is followed only at a constant ratio"
    )]
    RatioChanges,
    /// Nothing that repeats was found.
    #[error(
        "no motion of the period {period:.6e} s was found from the static equilibrium, nor after {waited} \
         periods of waiting: {source}; try another multiple with --period, or `jeffcott run`, whose \
         motion may never repeat"
    )]
    NotFound {
        /// The period, s.
        period: f64,
        /// Periods integrated before the last try.
        waited: u64,
        /// What the last try said.
        source: ShootingError,
    },
    /// The search failed.
    #[error(transparent)]
    Shooting(ShootingError),
    /// The integration cannot go on.
    #[error(transparent)]
    Integrate(#[from] IntegrateError),
    /// The scene does not exist at a value of the parameter.
    #[error("{0}")]
    Parameter(String),
}

impl From<MapError> for SteadyError {
    fn from(error: MapError) -> Self {
        match error {
            MapError::Integrate(error) => Self::Integrate(error),
            MapError::Parameter(reason) => Self::Parameter(reason),
        }
    }
}

impl From<ShootingError> for SteadyError {
    fn from(error: ShootingError) -> Self {
        match error {
            ShootingError::Map(error) => error.into(),
            other => Self::Shooting(other),
        }
    }
}

impl SteadyError {
    /// Whether somebody asked the search to stop.
    pub fn is_interrupted(&self) -> bool {
        matches!(self, Self::Integrate(IntegrateError::Interrupted { .. }))
    }
}

fn hertz(frequencies: &[f64]) -> String {
    let shown = frequencies
        .iter()
        .map(|frequency| format!("{frequency:.6} Hz"));
    shown.collect::<Vec<_>>().join(", ")
}
