//! Division of the root of the approach into strips that are all alike.

use fearless_simd::{Simd, SimdBase, SimdFloat, mask64x4};

use super::division::{INSIDE, InCells, Search};
use super::side_by_side::{ROUNDING, whole};
use crate::bearing::Lanes;

/// Half of the places among the strips that are in the range, over half of their number: the ends of it with what
/// rounding may add.
const REACH: f64 = 1.0 - 5e-12;

/// Strips of a width with as many cells each: where a ball is takes no look-up.
#[derive(Debug, Clone, PartialEq)]
pub(in crate::bearing) struct EvenStrips {
    /// Scale and shift that map v onto the strips.
    scale: f64,
    shift: f64,
    /// Half of the number of strips.
    half: f64,
    /// Number of cells along |A1|.
    across: f64,
    /// Scale and shift that map τ onto them.
    across_scale: f64,
    across_shift: f64,
}

impl EvenStrips {
    /// So many strips over a range of v, with so many cells each.
    pub(super) fn new([start, end]: [f64; 2], strips: usize, across: usize) -> Self {
        let (strips, across) = (strips as f64, across as f64);
        let scale = strips / (end - start) * INSIDE;
        Self {
            scale,
            shift: 0.5 * (strips - 1.0) - 0.5 * (start + end) * scale,
            half: 0.5 * strips,
            across,
            across_scale: 0.5 * across * INSIDE,
            across_shift: 0.5 * (across - 1.0),
        }
    }

    /// Places of v among the strips; strip 0 is from −½ to ½.
    #[inline(always)]
    fn among_strips<S: Simd>(&self, root: Lanes<S>) -> Lanes<S> {
        root * self.scale + self.shift
    }
}

impl Search for EvenStrips {
    #[inline(always)]
    fn contain<S: Simd>(&self, root: Lanes<S>) -> mask64x4<S> {
        let from_middle = self.among_strips(root) - (self.half - 0.5);
        from_middle.abs().simd_le(self.half * REACH)
    }

    #[inline(always)]
    fn locate<S: Simd>(&self, root: Lanes<S>, along: Lanes<S>) -> InCells<S> {
        let among = self.among_strips(root);
        let strip = (among + ROUNDING) - ROUNDING;
        let place = along * self.across_scale + self.across_shift;
        let column = place + ROUNDING;
        InCells {
            cells: whole(strip * self.across + column),
            x: among - strip,
            t: place - (column - ROUNDING),
        }
    }

    #[inline(always)]
    fn rates<S: Simd>(&self, root: Lanes<S>) -> [Lanes<S>; 2] {
        [self.scale, self.across_scale].map(|rate| Lanes::splat(root.witness(), rate))
    }
}

#[cfg(test)]
mod tests {
    use fearless_simd::{Level, SimdMask, dispatch};

    use super::*;

    #[test]
    fn ends_are_in_the_outermost_cells_and_borders_between_their_neighbours() {
        // a root that is rounded falls on either side of an end
        let range = [3.403_672_515_994_114e-3, 5.895_333_730_027_598e-3];
        for (strips, across) in [(1, 1), (512, 8), (2048, 4)] {
            let even = EvenStrips::new(range, strips, across);
            let cells = strips * across;
            dispatch!(Level::baseline(), simd => {
                let check = |root: f64, along: f64, cell: usize, [x, t]: [f64; 2]| {
                    let (root, along) = (Lanes::splat(simd, root), Lanes::splat(simd, along));
                    assert!(even.contain(root).all_true());
                    let place = even.locate(root, along);
                    assert_eq!(place.cells[0] as usize, cell);
                    let off = (place.x[0] - x).abs().max((place.t[0] - t).abs());
                    assert!(off < 1e-6, "{off:e}");
                };
                for (root, along, cell, place) in [
                    (range[0], -1.0 - 1e-13, 0, [-0.5, -0.5]),
                    (range[0], 1.0 + 1e-13, across - 1, [-0.5, 0.5]),
                    (range[1], -1.0 - 1e-13, cells - across, [0.5, -0.5]),
                    (range[1], 1.0 + 1e-13, cells - 1, [0.5, 0.5]),
                ] {
                    for root in [root.next_down(), root, root.next_up()] {
                        check(root, along, cell, place);
                    }
                }
                let width = (range[1] - range[0]) / strips as f64;
                let part = 0.25 * (strips - 1) as f64 + 0.5;
                let own = part.floor();
                let root = range[0] + width * part;
                check(root, -1.0 + 1.0 / across as f64, own as usize * across, [part - own - 0.5, 0.0]);
                for outside in [range[0] - 1e-7 * width, range[1] + 1e-7 * width] {
                    let outside = Lanes::splat(simd, outside);
                    assert!(!even.contain(outside).any_true());
                }
            });
        }
    }
}
