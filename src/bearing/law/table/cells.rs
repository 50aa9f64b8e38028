//! Polynomials in the cells of a table.

use fearless_simd::{Simd, SimdBase, f64x2};

use super::grid::InCells;
use crate::bearing::number::{LANES, Lanes};

/// Powers of x, along the approach, in a cell.
pub(super) const ROOT_TERMS: usize = 6;
/// Powers of t, along |A1|, in a cell: an even number.
pub(super) const AXIAL_TERMS: usize = 4;
/// Pairs of them.
const PAIRS: usize = AXIAL_TERMS / 2;

/// Coefficients of two polynomials P and R in x and t: for every power of x the pairs (P, R) of (t⁰, t¹), (t², t³) …
/// Whole lines of the cache: none is read in halves.
#[derive(Debug, Clone, Copy)]
#[repr(align(64))]
pub(super) struct Cell(pub(super) [[[f64; 4]; PAIRS]; ROOT_TERMS]);

impl Cell {
    /// From the coefficients of x^k t^l of both.
    pub(super) fn new(terms: &[[[f64; 2]; AXIAL_TERMS]; ROOT_TERMS]) -> Self {
        Self(terms.map(|row| {
            std::array::from_fn(|pair| {
                let ([p0, r0], [p1, r1]) = (row[2 * pair], row[2 * pair + 1]);
                [p0, r0, p1, r1]
            })
        }))
    }

    /// Whether both polynomials vanish.
    pub(super) fn is_zero(&self) -> bool {
        self.0
            .as_flattened()
            .as_flattened()
            .iter()
            .all(|c| *c == 0.0)
    }

    /// Value, and slopes by x and t, of the first polynomial or the second.
    pub(super) fn with_slopes(&self, which: usize, x: f64, t: f64) -> [f64; 3] {
        let [mut value, mut by_x, mut by_t] = [0.0; 3];
        for row in self.0.iter().rev() {
            let [mut of_row, mut row_rate] = [0.0; 2];
            for power in (0..AXIAL_TERMS).rev() {
                row_rate = row_rate * t + of_row;
                of_row = of_row * t + row[power / 2][2 * (power % 2) + which];
            }
            by_x = by_x * x + value;
            value = value * x + of_row;
            by_t = by_t * x + row_rate;
        }
        [value, by_x, by_t]
    }
}

/// Both polynomials at places in cells of a table.
#[inline(always)]
pub(super) fn values<S: Simd>(table: &[Cell], place: &InCells<S>) -> [Lanes<S>; 2] {
    let InCells { cells, x, t } = *place;
    let simd = x.witness();
    let square = t * t;
    let mut rows = [Lanes::splat(simd, 0.0); LANES];
    for ball in 0..LANES {
        let cell = &table[cells[ball]].0;
        let x = Lanes::splat(simd, x[ball]);
        let square = Lanes::splat(simd, square[ball]);
        // Σ x^k of every pair, then Σ t^2l of the pairs
        let mut pairs = [Lanes::splat(simd, 0.0); PAIRS];
        for pair in 0..PAIRS {
            pairs[pair] = simd.load_array_ref_f64x4(&cell[ROOT_TERMS - 1][pair]);
        }
        for power in (0..ROOT_TERMS - 1).rev() {
            for pair in 0..PAIRS {
                pairs[pair] = pairs[pair] * x + simd.load_array_ref_f64x4(&cell[power][pair]);
            }
        }
        rows[ball] = pairs[PAIRS - 1];
        for pair in (0..PAIRS - 1).rev() {
            rows[ball] = rows[ball] * square + pairs[pair];
        }
    }
    let [p0, r0, p1, r1] = transposed(rows);
    [p0 + t * p1, r0 + t * r1]
}

/// Columns of four rows. Halves first: what then crosses them is nothing. No closures: these are not always compiled
/// for wide registers.
#[inline(always)]
fn transposed<S: Simd>([a, b, c, d]: [Lanes<S>; LANES]) -> [Lanes<S>; LANES] {
    let simd = a.witness();
    let ((a_low, a_high), (b_low, b_high)) = (simd.split_f64x4(a), simd.split_f64x4(b));
    let ((c_low, c_high), (d_low, d_high)) = (simd.split_f64x4(c), simd.split_f64x4(d));
    let [first, second] = columns(simd, [a_low, b_low, c_low, d_low]);
    let [third, fourth] = columns(simd, [a_high, b_high, c_high, d_high]);
    [first, second, third, fourth]
}

/// Columns of four halves of rows.
#[inline(always)]
fn columns<S: Simd>(simd: S, [a, b, c, d]: [f64x2<S>; LANES]) -> [Lanes<S>; 2] {
    let (ac, bd) = (simd.combine_f64x2(a, c), simd.combine_f64x2(b, d));
    let (ab, cd) = simd.interleave_f64x4(ac, bd);
    let ((ab_low, ab_high), (cd_low, cd_high)) = (simd.split_f64x4(ab), simd.split_f64x4(cd));
    [
        simd.combine_f64x2(ab_low, cd_low),
        simd.combine_f64x2(ab_high, cd_high),
    ]
}

#[cfg(test)]
mod tests {
    use fearless_simd::{Level, dispatch};

    use super::*;

    /// Coefficients that are all different.
    fn term(cell: usize, k: usize, l: usize) -> [f64; 2] {
        let number = (1 + cell + 3 * k + 7 * l) as f64;
        [number.sin(), number.cos()]
    }

    #[test]
    fn balls_side_by_side_have_the_polynomials_of_their_own_cells() {
        let terms =
            |cell: usize| std::array::from_fn(|k| std::array::from_fn(|l| term(cell, k, l)));
        let table: Vec<Cell> = (0..9).map(|cell| Cell::new(&terms(cell))).collect();
        let (cells, x, t) = ([3, 0, 8, 3], [0.1, -0.5, 0.3, 0.4], [-0.2, 0.5, 0.0, 0.35]);
        for level in [Level::new(), Level::baseline()] {
            let own = dispatch!(level, simd => {
                let place = InCells {
                    cells,
                    x: simd.load_array_f64x4(x),
                    t: simd.load_array_f64x4(t),
                };
                values(&table, &place).map(|lanes| *lanes)
            });
            for ball in 0..LANES {
                for (which, own) in own.iter().enumerate() {
                    let [value, ..] = table[cells[ball]].with_slopes(which, x[ball], t[ball]);
                    let mut expected = 0.0;
                    for (k, l) in
                        (0..ROOT_TERMS * AXIAL_TERMS).map(|i| (i / AXIAL_TERMS, i % AXIAL_TERMS))
                    {
                        let power = x[ball].powi(k as i32) * t[ball].powi(l as i32);
                        expected += term(cells[ball], k, l)[which] * power;
                    }
                    assert!((own[ball] - expected).abs() < 1e-14);
                    assert!((value - expected).abs() < 1e-14);
                }
            }
        }
    }

    #[test]
    fn slopes_are_the_derivatives() {
        let cell = Cell::new(&std::array::from_fn(|k| {
            std::array::from_fn(|l| term(0, k, l))
        }));
        let (x, t, step) = (0.21, -0.37, 1e-6);
        for which in 0..2 {
            let value = |x, t| cell.with_slopes(which, x, t)[0];
            let [_, by_x, by_t] = cell.with_slopes(which, x, t);
            let along_x = (value(x + step, t) - value(x - step, t)) / (2.0 * step);
            let along_t = (value(x, t + step) - value(x, t - step)) / (2.0 * step);
            assert!((along_x - by_x).abs() < 1e-8 && (along_t - by_t).abs() < 1e-8);
        }
    }
}
