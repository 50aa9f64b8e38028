//! Polynomials of the forces in the cells of a table.

use fearless_simd::{Simd, SimdBase};

use super::side_by_side::transposed;
use crate::bearing::{LANES, Lanes};

/// Powers of x, along the root of the approach, in a cell.
pub(super) const ROOT_TERMS: usize = 4;
/// Powers of t, along |A1|, in a cell.
pub(super) const AXIAL_TERMS: usize = 4;

/// Coefficients of F_a/f and F_r/f in a cell: for every power of x the pairs (F_a, F_r) of
/// (t⁰, t¹) and of (t², t³). Whole lines of the cache: none is read in halves.
#[derive(Debug, Clone, Copy)]
#[repr(align(64))]
pub(super) struct ForceCell(pub(super) [[[f64; 4]; 2]; ROOT_TERMS]);

/// Coefficients of couple/f in a cell: for every power of x those of t⁰ … t³.
#[derive(Debug, Clone, Copy)]
#[repr(align(64))]
pub(super) struct CoupleCell(pub(super) [[f64; AXIAL_TERMS]; ROOT_TERMS]);

/// F_a/f and F_r/f at x and t of cells.
#[inline(always)]
pub(super) fn cell_forces<S: Simd>(
    cells: [&ForceCell; LANES],
    x: Lanes<S>,
    t: Lanes<S>,
) -> [Lanes<S>; 2] {
    let simd = x.witness();
    let square = t * t;
    let mut rows = [Lanes::splat(simd, 0.0); LANES];
    for ball in 0..LANES {
        let cell = &cells[ball].0;
        let [even, odd] = &cell[ROOT_TERMS - 1];
        let mut low = simd.load_array_ref_f64x4(even);
        let mut high = simd.load_array_ref_f64x4(odd);
        let x = Lanes::splat(simd, x[ball]);
        for [even, odd] in cell[..ROOT_TERMS - 1].iter().rev() {
            low = low * x + simd.load_array_ref_f64x4(even);
            high = high * x + simd.load_array_ref_f64x4(odd);
        }
        rows[ball] = low + high * Lanes::splat(simd, square[ball]);
    }
    let [a0, r0, a1, r1] = transposed(rows);
    [a0 + t * a1, r0 + t * r1]
}

/// couple/f at x and t of cells.
#[inline(always)]
pub(super) fn cell_couples<S: Simd>(
    cells: [&CoupleCell; LANES],
    x: Lanes<S>,
    t: Lanes<S>,
) -> Lanes<S> {
    let simd = x.witness();
    let mut rows = [Lanes::splat(simd, 0.0); LANES];
    for ball in 0..LANES {
        let cell = &cells[ball].0;
        let x = Lanes::splat(simd, x[ball]);
        let mut sum = simd.load_array_ref_f64x4(&cell[ROOT_TERMS - 1]);
        for term in cell[..ROOT_TERMS - 1].iter().rev() {
            sum = sum * x + simd.load_array_ref_f64x4(term);
        }
        rows[ball] = sum;
    }
    let [c0, c1, c2, c3] = transposed(rows);
    (c0 + t * c1) + t * t * (c2 + t * c3)
}

/// Value, and slopes by x and t, of a polynomial.
pub(super) fn with_slopes(term: impl Fn(usize, usize) -> f64, x: f64, t: f64) -> [f64; 3] {
    let [mut value, mut by_x, mut by_t] = [0.0; 3];
    for k in (0..ROOT_TERMS).rev() {
        let [mut row, mut row_rate] = [0.0; 2];
        for l in (0..AXIAL_TERMS).rev() {
            row_rate = row_rate * t + row;
            row = row * t + term(k, l);
        }
        by_x = by_x * x + value;
        value = value * x + row;
        by_t = by_t * x + row_rate;
    }
    [value, by_x, by_t]
}
