//! The even division of a table into cells.

use fearless_simd::{Simd, SimdBase, SimdFloat};

use crate::bearing::number::{LANES, Lanes};

/// Adding and taking it away rounds to a whole number, which then stands in the lowest bits.
const ROUNDING: f64 = 6_755_399_441_055_744.0;

/// Equal parts of a range of one coordinate.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Parts {
    /// Scale and shift that map the coordinate onto the parts, part 0 onto −½ … ½.
    pub(super) scale: f64,
    shift: f64,
    /// Number of the last part.
    last: f64,
}

impl Parts {
    /// So many parts of a range.
    pub(super) fn new([start, end]: [f64; 2], count: usize) -> Self {
        let count = count as f64;
        let scale = count / (end - start);
        Self {
            scale,
            shift: -0.5 - start * scale,
            last: count - 1.0,
        }
    }

    /// How many they are.
    pub(super) fn count(&self) -> usize {
        self.last as usize + 1
    }

    /// The coordinate at a place −½ … ½ in a part.
    pub(super) fn coordinate(&self, part: usize, place: f64) -> f64 {
        (part as f64 + place - self.shift) / self.scale
    }

    /// The coordinates at places −½ … ½ in all parts, rising, those at a border once.
    pub(super) fn nodes<const N: usize>(&self, places: &[f64; N]) -> Vec<f64> {
        let mut nodes = vec![self.coordinate(0, places[0])];
        for part in 0..self.count() {
            nodes.extend(
                places[1..]
                    .iter()
                    .map(|&place| self.coordinate(part, place)),
            );
        }
        nodes
    }

    /// Numbers of the parts and places −½ … ½ in them; beyond the range those of the last part on that side.
    #[inline(always)]
    fn locate<S: Simd>(&self, coordinate: Lanes<S>) -> [Lanes<S>; 2] {
        let simd = coordinate.witness();
        let among = coordinate * self.scale + self.shift;
        let last = Lanes::splat(simd, self.last);
        let part = among.max(Lanes::splat(simd, 0.0)).min(last);
        let part = (part + ROUNDING) - ROUNDING;
        [part, among - part]
    }
}

/// Equal parts of the approach v, each divided into equal cells along τ.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Grid {
    pub(super) root: Parts,
    pub(super) along: Parts,
}

/// Places of balls in their cells.
#[derive(Clone, Copy)]
pub(super) struct InCells<S: Simd> {
    pub(super) cells: [usize; LANES],
    /// Along v, −½ … ½.
    pub(super) x: Lanes<S>,
    /// Along τ, −½ … ½.
    pub(super) t: Lanes<S>,
}

impl Grid {
    /// The cells of v and τ, and the places in them.
    #[inline(always)]
    pub(super) fn locate<S: Simd>(&self, root: Lanes<S>, along: Lanes<S>) -> InCells<S> {
        let [strip, x] = self.root.locate(root);
        let [column, t] = self.along.locate(along);
        let rounded = strip * (self.along.last + 1.0) + (column + ROUNDING);
        let [a, b, c, d] = *rounded;
        let low = |number: f64| number.to_bits() as u32 as usize;
        InCells {
            cells: [low(a), low(b), low(c), low(d)],
            x,
            t,
        }
    }
}

#[cfg(test)]
mod tests {
    use fearless_simd::{Level, dispatch};

    use super::*;

    #[test]
    fn every_place_has_its_cell_and_places_beyond_the_ends_the_outermost() {
        let grid = Grid {
            root: Parts::new([2.0, 4.0], 64),
            along: Parts::new([-1.0, 1.0], 4),
        };
        for level in [Level::new(), Level::baseline()] {
            dispatch!(level, simd => {
                let check = |root: f64, along: f64, cell: usize, place: [f64; 2]| {
                    let [root, along] = [root, along].map(|number| Lanes::splat(simd, number));
                    let own = grid.locate(root, along);
                    assert_eq!(own.cells, [cell; LANES]);
                    let off = (own.x[0] - place[0]).abs().max((own.t[0] - place[1]).abs());
                    assert!(off < 1e-12, "{off:e}");
                };
                check(2.0, -1.0, 0, [-0.5, -0.5]);
                check(4.0, 1.0, 255, [0.5, 0.5]);
                check(4.0_f64.next_up(), 1.0_f64.next_up(), 255, [0.5, 0.5]);
                check(1.9, -1.0_f64.next_up(), 0, [-3.7, -0.5]);
                for (strip, column) in [(0, 3), (17, 1), (63, 0)] {
                    let [root, along] = [
                        grid.root.coordinate(strip, 0.3),
                        grid.along.coordinate(column, -0.4),
                    ];
                    check(root, along, 4 * strip + column, [0.3, -0.4]);
                }
            });
        }
    }
}
