//! Whether two results say the same: tables (trace, spectrum or events) or whole run folders.
//!
//! Columns are matched by name and rows by number. Two values a, b of a column agree where
//!
//! ```text
//! |a − b| ≤ absolute + relative · max|column|        (maximum over both tables)
//! ```
//!
//! so that a zero crossing needs no exception. NaN agrees with NaN only, ∞ with the same ∞ only.
//! A phase (`…_phase_rad` beside `…_amplitude_…`) is compared modulo 2π and may turn by as much as
//! moves its phasor within the allowance of the amplitude, on top of its own:
//!
//! ```text
//! |Δφ| ≤ absolute + relative · π + (allowance of the amplitude)/amplitude
//! ```
//!
//! Where the amplitude is within its allowance of zero, the phase says nothing and is not compared.
//!
//! Of a trace that was thinned while it was written, every row is compared with the one of the same
//! time. Spectra can be compared by their lines instead of row by row; events are compared with the
//! events of the same kind at the same ball.
//!
//! ```no_run
//! use jeffcott::report::compare::{Rules, Tolerance, Tolerances, compare};
//! let rules = Rules::new(Tolerances::uniform(Tolerance::new(1e-6, 0.0)?));
//! let comparison = compare("output/old".as_ref(), "output/new".as_ref(), &rules)?;
//! println!("{comparison}");
//! assert!(comparison.agrees());
//! # Ok::<(), jeffcott::report::compare::CompareError>(())
//! ```

mod assertion;
mod column;
mod difference;
mod error;
mod events;
mod figure;
mod json;
mod lines;
mod paths;
mod rows;
mod rule;
mod rules;
mod table;
mod text;
mod tolerance;

pub use assertion::{ComparedSpectrum, spectra_close};
pub use column::{ColumnComparison, Worst};
pub use difference::Difference;
pub use error::CompareError;
pub use figure::write_comparison_figure;
pub use paths::{Comparison, compare};
pub use rows::TableComparison;
pub use rules::Rules;

pub use tolerance::{Tolerance, Tolerances};
