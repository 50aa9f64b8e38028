//! Numbers of balls side by side, kept in registers.

use fearless_simd::{Simd, SimdBase};

use crate::bearing::{LANES, Lanes};

/// Adding and taking it away rounds to a whole number, which then stands in the lowest bits.
pub(super) const ROUNDING: f64 = 6_755_399_441_055_744.0;

/// The whole numbers to which [`ROUNDING`] was added.
#[inline(always)]
pub(super) fn whole<S: Simd>(rounded: Lanes<S>) -> [u32; LANES] {
    let low = |x: f64| x.to_bits() as u32;
    let [a, b, c, d] = *rounded;
    [low(a), low(b), low(c), low(d)]
}

/// Columns of four rows. Halves first: what then crosses them is nothing.
#[inline(always)]
pub(super) fn transposed<S: Simd>([a, b, c, d]: [Lanes<S>; LANES]) -> [Lanes<S>; LANES] {
    let simd = a.witness();
    let halves = |row| simd.split_f64x4(row);
    let ((a_low, a_high), (b_low, b_high)) = (halves(a), halves(b));
    let ((c_low, c_high), (d_low, d_high)) = (halves(c), halves(d));
    let columns = |a, b, c, d| {
        let (ac, bd) = (simd.combine_f64x2(a, c), simd.combine_f64x2(b, d));
        let (ab, cd) = simd.interleave_f64x4(ac, bd);
        let ((ab_low, ab_high), (cd_low, cd_high)) = (halves(ab), halves(cd));
        let even = simd.combine_f64x2(ab_low, cd_low);
        (even, simd.combine_f64x2(ab_high, cd_high))
    };
    let (first, second) = columns(a_low, b_low, c_low, d_low);
    let (third, fourth) = columns(a_high, b_high, c_high, d_high);
    [first, second, third, fourth]
}

#[cfg(test)]
mod tests {
    use fearless_simd::{Level, dispatch};

    use super::*;

    #[test]
    fn rows_become_columns_and_numbers_whole_at_every_level() {
        for level in [Level::new(), Level::baseline()] {
            dispatch!(level, simd => {
                let row = |first: f64| simd.load_array_f64x4([first, first + 1.0, first + 2.0, first + 3.0]);
                let columns = transposed([row(0.0), row(10.0), row(20.0), row(30.0)]);
                for (place, column) in columns.into_iter().enumerate() {
                    let expected = [0.0, 10.0, 20.0, 30.0].map(|first| first + place as f64);
                    assert_eq!(*column, expected);
                }
                let rounded = simd.load_array_f64x4([0.0, 0.6, 4095.4, 16_383.49]) + ROUNDING;
                assert_eq!(whole(rounded), [0, 1, 4095, 16_383]);
            });
        }
    }
}
