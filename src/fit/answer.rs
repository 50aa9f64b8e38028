//! The answer to a question as numbers with names, and each with its error.

use std::f64::consts::{FRAC_PI_2, TAU};
use std::fmt;

use super::NoAnswer;
use crate::analysis::Channel;
use crate::steady::Orbit;
use crate::table::Column;

/// A number that was measured, and is looked for in an answer.
#[derive(Debug, Clone, PartialEq)]
pub enum Wanted {
    /// The number of a name.
    Number(String),
    /// The amplitude of a line.
    Amplitude {
        /// The quantity.
        channel: Channel,
        /// Name of its cause.
        line: String,
        /// Of which rate of the quantity it is: 1 of a velocity.
        rate: i32,
    },
    /// The phase of a line, rad.
    Phase {
        /// The quantity.
        channel: Channel,
        /// Name of its cause.
        line: String,
        /// Of which rate of the quantity it is.
        rate: i32,
    },
}

impl Wanted {
    /// The name of a number.
    pub fn name(&self) -> Option<&str> {
        match self {
            Self::Number(name) => Some(name),
            _ => None,
        }
    }
}

/// `stiffness_x_N_m`, `y BPFO`, `phase of y 1×`.
impl fmt::Display for Wanted {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Number(name) => f.write_str(name),
            Self::Amplitude { channel, line, .. } => write!(f, "{channel} {line}"),
            Self::Phase { channel, line, .. } => write!(f, "phase of {channel} {line}"),
        }
    }
}

/// A number of an answer.
#[derive(Debug, Clone, PartialEq)]
pub struct Number {
    /// What it is called: the name of its column, or channel and line.
    pub name: String,
    /// Its unit.
    pub unit: String,
    /// The number, in its unit.
    pub value: f64,
    /// How far it may be off, as far as that was measured; else NaN.
    pub error: f64,
}

/// A line of a motion with its cause.
#[derive(Debug, Clone, PartialEq)]
pub struct NamedLine {
    /// The quantity.
    pub channel: Channel,
    /// What causes it, as in the tables of spectra.
    pub name: String,
    /// Frequency, Hz.
    pub frequency: f64,
    /// Peak value, in the unit of the channel.
    pub amplitude: f64,
    /// Phase of `cos(2πft + phase)`, rad; NaN of a run.
    pub phase: f64,
    /// Error of the amplitude.
    pub error: f64,
}

/// The answer to a question.
#[derive(Debug, Clone, Default)]
pub struct Answer {
    /// Its numbers.
    pub numbers: Vec<Number>,
    /// Lines of a motion whose causes are known.
    pub lines: Vec<NamedLine>,
    /// The motion, for the search of a neighbouring one.
    pub orbit: Option<Orbit>,
}

impl Number {
    /// The number of a column.
    pub(super) fn new(column: &Column, value: f64, error: f64) -> Self {
        Self {
            name: column.name(),
            unit: column.unit.clone().into_owned(),
            value,
            error,
        }
    }
}

impl Answer {
    /// A number that is looked for.
    ///
    /// # Errors
    /// [`NoAnswer::Failed`] where the answer does not have it; of a line with the names of those that there are.
    pub fn number(&self, wanted: &Wanted) -> Result<Number, NoAnswer> {
        let missing = |known: Vec<&str>| {
            let message = format!(
                "nothing here causes `{wanted}`; there are {}",
                known.join(", ")
            );
            NoAnswer::Failed(message)
        };
        let (channel, name, rate) = match wanted {
            Wanted::Number(name) => {
                let found = self.numbers.iter().find(|own| own.name == *name);
                let found = found.filter(|own| own.value.is_finite());
                let known = || self.numbers.iter().map(|own| &*own.name).collect();
                return found.cloned().ok_or_else(|| missing(known()));
            }
            Wanted::Amplitude {
                channel,
                line,
                rate,
            }
            | Wanted::Phase {
                channel,
                line,
                rate,
            } => (channel, line, *rate),
        };
        let mut own = self.lines.iter().filter(|line| line.channel == *channel);
        let known = || {
            let lines = self.lines.iter().filter(|line| line.channel == *channel);
            lines.map(|line| &*line.name).collect()
        };
        let line = own
            .find(|line| line.name == *name)
            .ok_or_else(|| missing(known()))?;
        let factor = (TAU * line.frequency).powi(rate);
        let (value, error) = match wanted {
            Wanted::Phase { .. } => (
                line.phase + f64::from(rate) * FRAC_PI_2,
                line.error / line.amplitude,
            ),
            _ => (factor * line.amplitude, factor * line.error),
        };
        Ok(Number {
            name: wanted.to_string(),
            unit: String::new(),
            value,
            error,
        })
    }
}
