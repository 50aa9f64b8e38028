//! Tables of numbers in every language that they are written in.
//!
//! A row is a slice of numbers whatever the language; the kind of a column says what a number stands
//! for. Rows are written while the run goes on, in memory that does not grow with it.

mod column;
mod csv;
mod files;
mod mat;
mod mat_element;
#[cfg(feature = "parquet")]
mod parquet;
mod scratch;
mod whole;

pub use self::column::{Column, ColumnKind};
pub use self::csv::CsvTable;
pub use self::files::Origin;
pub(super) use self::files::TableFiles;
pub use self::mat::MatTable;
#[cfg(feature = "parquet")]
pub use self::parquet::ParquetTable;
pub(super) use self::whole::{Table, cell, number};
