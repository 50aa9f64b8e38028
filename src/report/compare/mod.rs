//! Whether two results say the same: tables (trace or spectrum) or whole run folders.
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
//! ```no_run
//! use jeffcott::report::compare::{Tolerance, Tolerances, compare};
//! let tolerances = Tolerances::uniform(Tolerance::new(1e-6, 0.0)?);
//! let comparison = compare("output/old".as_ref(), "output/new".as_ref(), &tolerances)?;
//! println!("{comparison}");
//! assert!(comparison.agrees());
//! # Ok::<(), jeffcott::report::compare::CompareError>(())
//! ```

mod error;
mod paths;
mod rows;
mod rule;
mod table;
mod text;
mod tolerance;

pub use error::CompareError;
pub use paths::{Comparison, compare};
pub use rows::{ColumnComparison, TableComparison, Worst};
pub use text::Difference;
pub use tolerance::{Tolerance, Tolerances};
