//! Division of the root of the approach into strips of unequal width, and of strips into cells.

use fearless_simd::{Simd, SimdBase, SimdFloat, mask64x4};

use super::division::{INSIDE, InCells, Search};
use super::side_by_side::{ROUNDING, transposed, whole};
use crate::bearing::Lanes;

/// Bins over the whole range: the narrowest strip is one of them.
pub(super) const BINS: usize = 4096;

/// Middle of the places among the bins.
const MIDDLE: f64 = 0.5 * (BINS - 1) as f64;

/// Half of the places among the bins that are in the range: the ends of it with what rounding may add.
const REACH: f64 = 0.5 * BINS as f64 - 1e-8;

/// One strip, as its bins have it, and its cells along |A1|, all of a width.
#[derive(Debug, Clone, Copy, PartialEq)]
#[repr(align(32))]
struct Strip {
    /// Scale and shift that map v onto x = −½ … ½, and τ onto the cells of the whole table:
    /// `x = v scale + shift`.
    maps: [f64; 4],
}

/// Strips over a range of v, each a whole number of bins.
#[derive(Debug, Clone, PartialEq)]
pub(in crate::bearing) struct Strips {
    /// Scale and shift that map v onto the bins.
    bin_scale: f64,
    bin_shift: f64,
    /// Strip of every bin.
    of_bin: Box<[Strip; BINS]>,
}

impl Strips {
    /// Strips that follow one another, each from its first bin on, with its number of cells.
    pub(super) fn new([start, end]: [f64; 2], first_bins: &[usize], cells: &[usize]) -> Self {
        let width = (end - start) / BINS as f64;
        let mut of_bin = Box::new([Strip { maps: [0.0; 4] }; BINS]);
        let mut first_cell = 0;
        for (strip, (&first, &cells)) in first_bins.iter().zip(cells).enumerate() {
            let next = first_bins.get(strip + 1).copied().unwrap_or(BINS);
            let [low, high] = [first, next].map(|bin| start + bin as f64 * width);
            let half = 0.5 * cells as f64;
            of_bin[first..next].fill(Strip {
                maps: [
                    1.0 / (high - low),
                    -0.5 * (high + low) / (high - low),
                    half * INSIDE,
                    first_cell as f64 + (half - 0.5),
                ],
            });
            first_cell += cells;
        }
        Self {
            bin_scale: INSIDE / width,
            bin_shift: MIDDLE - 0.5 * (start + end) * (INSIDE / width),
            of_bin,
        }
    }

    /// Places of v among the bins; bin 0 is from −½ to ½.
    #[inline(always)]
    fn among_bins<S: Simd>(&self, root: Lanes<S>) -> Lanes<S> {
        root * self.bin_scale + self.bin_shift
    }

    /// Maps of the strips at places among the bins: those of v in its first columns, those of τ in the others.
    #[inline(always)]
    fn maps<S: Simd>(&self, place: Lanes<S>) -> [Lanes<S>; 4] {
        let simd = place.witness();
        let [a, b, c, d] = whole(place + ROUNDING);
        let maps = |bin: u32| simd.load_array_ref_f64x4(&self.of_bin[bin as usize % BINS].maps);
        transposed([maps(a), maps(b), maps(c), maps(d)])
    }
}

impl Search for Strips {
    #[inline(always)]
    fn contain<S: Simd>(&self, root: Lanes<S>) -> mask64x4<S> {
        (self.among_bins(root) - MIDDLE).abs().simd_le(REACH)
    }

    #[inline(always)]
    fn locate<S: Simd>(&self, root: Lanes<S>, along: Lanes<S>) -> InCells<S> {
        let [root_scale, root_shift, scale, shift] = self.maps(self.among_bins(root));
        let place = along * scale + shift;
        let column = place + ROUNDING;
        InCells {
            cells: whole(column),
            x: root * root_scale + root_shift,
            t: place - (column - ROUNDING),
        }
    }

    #[inline(always)]
    fn rates<S: Simd>(&self, root: Lanes<S>) -> [Lanes<S>; 2] {
        let [root_scale, _, scale, _] = self.maps(self.among_bins(root));
        [root_scale, scale]
    }
}

#[cfg(test)]
mod tests {
    use fearless_simd::{Level, SimdMask, dispatch};

    use super::*;

    /// Cell, and x and t, of a single place.
    fn located(strips: &Strips, root: f64, along: f64) -> (usize, [f64; 2]) {
        dispatch!(Level::baseline(), simd => {
            let [root, along] = [root, along].map(|number| Lanes::splat(simd, number));
            assert!(strips.contain(root).all_true());
            let place = strips.locate(root, along);
            (place.cells[0] as usize, [place.x[0], place.t[0]])
        })
    }

    #[test]
    fn both_ends_are_in_the_outermost_cells_of_the_largest_table() {
        // a root that is rounded falls on either side of an end
        let range = [3.403_672_515_994_114e-3, 5.895_333_730_027_598e-3];
        let first_bins: Vec<usize> = (0..BINS).collect();
        for cells in [1, 4] {
            let strips = Strips::new(range, &first_bins, &vec![cells; BINS]);
            let last = cells * BINS - 1;
            for (root, along, cell) in [
                (range[0], -1.0 - 1e-13, 0),
                (range[0], 1.0 + 1e-13, cells - 1),
                (range[1], -1.0 - 1e-13, last + 1 - cells),
                (range[1], 1.0 + 1e-13, last),
            ] {
                for root in [root.next_down(), root, root.next_up()] {
                    let (own, [x, t]) = located(&strips, root, along);
                    assert_eq!(own, cell);
                    assert!((x.abs() - 0.5).abs() < 1e-6 && t.abs() <= 0.5, "{x}, {t}");
                }
            }
        }
    }

    #[test]
    fn strips_of_unequal_width_have_cells_of_their_own() {
        let strips = Strips::new([0.0, 1.0], &[0, BINS / 2, 3 * BINS / 4], &[2, 1, 4]);
        for (root, along, expected, x) in [
            (0.25, -0.5, 0, 0.0),
            (0.25, 0.5, 1, 0.0),
            (0.625, 0.0, 2, 0.0),
            (0.8125, -0.75, 3, -0.25),
            (0.9375, 0.75, 6, 0.25),
        ] {
            let (cell, [own, t]) = located(&strips, root, along);
            assert_eq!(cell, expected);
            assert!((own - x).abs() < 1e-9 && t.abs() < 1e-9, "{own}, {t}");
        }
    }
}
