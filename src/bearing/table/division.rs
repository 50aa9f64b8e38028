//! How the range of a table is divided into cells.

use fearless_simd::{Simd, mask64x4};

use super::even_strips::EvenStrips;
use super::strips::Strips;
use crate::bearing::{LANES, Lanes};

/// Keeps the ends of a range from being rounded into the strips or cells beyond them, of which the last digit of the
/// number of a cell is less.
pub(super) const INSIDE: f64 = 1.0 - 1e-11;

/// Strips of v, divided along |A1| into cells.
#[derive(Debug, Clone, PartialEq)]
pub(in crate::bearing) enum Division {
    /// All of a width, with as many cells each.
    Even(EvenStrips),
    /// Narrow where the law asks for it.
    Uneven(Strips),
}

/// Places of balls in their cells.
#[derive(Debug, Clone, Copy)]
pub(in crate::bearing) struct InCells<S: Simd> {
    pub(super) cells: [u32; LANES],
    /// Along the root of the approach, −½ … ½.
    pub(super) x: Lanes<S>,
    /// Along |A1|, −½ … ½.
    pub(super) t: Lanes<S>,
}

/// How the cells of balls side by side are found.
pub(in crate::bearing) trait Search {
    /// Whether v are in the range.
    fn contain<S: Simd>(&self, root: Lanes<S>) -> mask64x4<S>;

    /// The cells of v and τ, and the places in them.
    fn locate<S: Simd>(&self, root: Lanes<S>, along: Lanes<S>) -> InCells<S>;

    /// dx/dv and dt/dτ at v.
    fn rates<S: Simd>(&self, root: Lanes<S>) -> [Lanes<S>; 2];
}

/// Evaluates an expression for the division inside.
macro_rules! with_division {
    ($any:expr, $division:ident => $value:expr) => {
        match $any {
            Division::Even($division) => $value,
            Division::Uneven($division) => $value,
        }
    };
}
pub(super) use with_division;
