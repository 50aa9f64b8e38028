//! How two results are compared.

use super::{Tolerance, Tolerances};

/// How two results are compared.
#[derive(Debug, Clone, PartialEq)]
pub struct Rules {
    /// How far values may be apart.
    pub tolerances: Tolerances,
    /// Places that are told of every column, the worst first; at least one.
    pub worst: usize,
    /// Compares what both results have; otherwise a file, a column or every other row that only one of
    /// them has is a difference.
    pub common: bool,
    /// Compares spectra by this many of the strongest lines of every column, wherever they stand,
    /// instead of row by row; other tables are left out.
    pub lines: Option<usize>,
}

impl Rules {
    /// Row by row, everything, one place a column.
    pub fn new(tolerances: Tolerances) -> Self {
        Self {
            tolerances,
            worst: 1,
            common: false,
            lines: None,
        }
    }
}

impl Default for Rules {
    /// Within [`Tolerance::DEFAULT`] everywhere.
    fn default() -> Self {
        Self::new(Tolerances::uniform(Tolerance::DEFAULT))
    }
}
