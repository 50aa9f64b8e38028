//! What keeps two results from being compared value by value.

use std::fmt;
use std::path::PathBuf;

use super::text::short;

/// What keeps two results from being compared value by value.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub enum Difference {
    /// Only one of two run folders has a file.
    File {
        /// The file that exists.
        only: PathBuf,
    },
    /// Only one of two tables has a column.
    Column {
        /// Its name.
        name: String,
        /// The table that has it.
        only_in: PathBuf,
    },
    /// The tables have different numbers of rows; the common ones are compared.
    Rows {
        /// Rows of the first table.
        first: u64,
        /// Rows of the second table.
        second: u64,
    },
    /// One trace holds the first of every so many samples of the other, which are compared.
    Thinned {
        /// The trace with fewer samples.
        thinned: PathBuf,
        /// Samples of the other for one of it.
        every: u64,
    },
    /// Events without a partner.
    Events {
        /// Their kind.
        name: String,
        /// Number of them in either table.
        alone: [(PathBuf, usize); 2],
        /// Time and place of the earliest.
        earliest: String,
    },
    /// A line without a partner.
    Line {
        /// Column of the amplitude.
        column: String,
        /// Frequency, Hz.
        frequency: f64,
        /// Amplitude in the unit of the column.
        amplitude: f64,
        /// The spectrum that has it.
        only_in: PathBuf,
    },
    /// The times or frequencies differ, so that equal rows do not stand for equal places.
    Axis {
        /// Name of the first column.
        name: String,
    },
}

impl fmt::Display for Difference {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::File { only } => write!(f, "only one run has {}", only.display()),
            Self::Column { name, only_in } => {
                write!(f, "only {} has the column {name}", only_in.display())
            }
            Self::Rows { first, second } => {
                let common = first.min(second);
                write!(
                    f,
                    "{first} rows against {second}: the first {common} are compared"
                )
            }
            Self::Thinned { thinned, every } => write!(
                f,
                "{} holds one of every {every} samples: these are compared",
                thinned.display()
            ),
            Self::Events {
                name,
                alone: [(first, ones), (second, others)],
                earliest,
            } => write!(
                f,
                "{name}: {ones} of {} and {others} of {} have no partner, the earliest at {earliest}",
                first.display(),
                second.display()
            ),
            Self::Line {
                column,
                frequency,
                amplitude,
                only_in,
            } => write!(
                f,
                "{column}: only {} has the line at {} Hz, {amplitude:.4e}",
                only_in.display(),
                short(*frequency)
            ),
            Self::Axis { name } => write!(
                f,
                "the axes {name} differ: rows are matched by number and stand for different places"
            ),
        }
    }
}
