//! The even division of a table into cells, the polynomials in them, and their nodes.

use std::f64::consts::PI;

use fearless_simd::{ExtractToken, Simd, SimdBase, f64x2};

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
pub(super) struct Cell<const POWERS: usize = ROOT_TERMS, const HALVES: usize = PAIRS>(
    [[[f64; 4]; HALVES]; POWERS],
);

impl<const POWERS: usize, const HALVES: usize> Cell<POWERS, HALVES> {
    /// From the coefficients of x^k t^l of both.
    pub(super) fn new<const TERMS: usize>(terms: &[[[f64; 2]; TERMS]; POWERS]) -> Self {
        const { assert!(TERMS == 2 * HALVES, "powers in pairs") };
        Self(terms.map(|row| {
            std::array::from_fn(|pair| {
                let ([p0, r0], [p1, r1]) = (row[2 * pair], row[2 * pair + 1]);
                [p0, r0, p1, r1]
            })
        }))
    }

    /// Whether both polynomials vanish.
    pub(super) fn is_zero(&self) -> bool {
        let coefficients = self.0.as_flattened().as_flattened();
        coefficients.iter().all(|coefficient| *coefficient == 0.0)
    }

    /// Value, and slopes by x and t, of the first polynomial or the second.
    pub(super) fn with_slopes(&self, which: usize, x: f64, t: f64) -> [f64; 3] {
        let [mut value, mut by_x, mut by_t] = [0.0; 3];
        for row in self.0.iter().rev() {
            let [mut of_row, mut row_rate] = [0.0; 2];
            for power in (0..2 * HALVES).rev() {
                row_rate = row_rate * t + of_row;
                of_row = of_row * t + row[power / 2][2 * (power % 2) + which];
            }
            by_x = by_x * x + value;
            value = value * x + of_row;
            by_t = by_t * x + row_rate;
        }
        [value, by_x, by_t]
    }

    /// Both polynomials at x, by the even and the odd powers of t: they are P₀ + t P₁ and R₀ + t R₁ with the lanes P₀, R₀, P₁
    /// and R₁. The same x and t² in all lanes.
    #[inline(always)]
    pub(super) fn pairs<S: Simd>(&self, x: Lanes<S>, square: Lanes<S>) -> Lanes<S> {
        let simd = x.token();
        // Σ x^k of every pair, then Σ t^2l of the pairs
        let mut pairs = [Lanes::splat(simd, 0.0); HALVES];
        for (sum, term) in pairs.iter_mut().zip(&self.0[POWERS - 1]) {
            *sum = Lanes::load_array_ref(simd, term);
        }
        for row in self.0[..POWERS - 1].iter().rev() {
            for (sum, term) in pairs.iter_mut().zip(row) {
                *sum = *sum * x + Lanes::load_array_ref(simd, term);
            }
        }
        let mut sum = pairs[HALVES - 1];
        for pair in (0..HALVES - 1).rev() {
            sum = sum * square + pairs[pair];
        }
        sum
    }
}

/// Both polynomials at positions in cells of a table.
#[inline(always)]
pub(super) fn values<S: Simd>(table: &[Cell], position: &InCells<S>) -> [Lanes<S>; 2] {
    let InCells { cells, x, t } = *position;
    let simd = x.token();
    let square = t * t;
    let mut rows = [Lanes::splat(simd, 0.0); LANES];
    for ball in 0..LANES {
        let x = Lanes::splat(simd, x[ball]);
        let square = Lanes::splat(simd, square[ball]);
        rows[ball] = table[cells[ball]].pairs(x, square);
    }
    joined(rows, t)
}

/// Both polynomials of balls side by side from the [`Cell::pairs`] of each.
#[inline(always)]
pub(super) fn joined<S: Simd>(rows: [Lanes<S>; LANES], t: Lanes<S>) -> [Lanes<S>; 2] {
    let [p0, r0, p1, r1] = transposed(rows);
    [p0 + t * p1, r0 + t * r1]
}

/// Columns of four rows. Halves first: what then crosses them is nothing. No closures: these are not always compiled
/// for wide registers.
#[inline(always)]
pub(super) fn transposed<S: Simd>([a, b, c, d]: [Lanes<S>; LANES]) -> [Lanes<S>; LANES] {
    let simd = a.token();
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

/// Adding and taking it away rounds to a whole number, which is then in the lowest bits.
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

    /// The coordinate at a position −½ … ½ in a part.
    pub(super) fn coordinate(&self, part: usize, position: f64) -> f64 {
        (part as f64 + position - self.shift) / self.scale
    }

    /// The coordinates at positions −½ … ½ in all parts, rising, those at a border once.
    pub(super) fn nodes<const N: usize>(&self, positions: &[f64; N]) -> Vec<f64> {
        let mut nodes = vec![self.coordinate(0, positions[0])];
        for part in 0..self.count() {
            let inside = positions[1..].iter();
            nodes.extend(inside.map(|&position| self.coordinate(part, position)));
        }
        nodes
    }

    /// Numbers of the parts and positions −½ … ½ in them; beyond the range those of the last part on that side.
    #[inline(always)]
    fn locate<S: Simd>(&self, coordinate: Lanes<S>) -> [Lanes<S>; 2] {
        let simd = coordinate.token();
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

/// Positions of balls in their cells.
#[derive(Clone, Copy)]
pub(super) struct InCells<S: Simd> {
    pub(super) cells: [usize; LANES],
    /// Along v, −½ … ½.
    pub(super) x: Lanes<S>,
    /// Along τ, −½ … ½.
    pub(super) t: Lanes<S>,
}

impl Grid {
    /// The cells of v and τ, and the positions in them.
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

/// Chebyshev–Lobatto nodes on −1 … 1, rising; symmetric to the bit, both ends exact.
pub(super) fn lobatto<const N: usize>() -> [f64; N] {
    std::array::from_fn(|index| {
        let steps = 2 * index as i64 + 1 - N as i64;
        (PI * steps as f64 / (2 * (N - 1)) as f64).sin()
    })
}

/// Weights by which values at `nodes` make the coefficients of the powers of x: row k for x^k.
pub(super) fn power_weights<const N: usize>(nodes: &[f64; N]) -> [[f64; N]; N] {
    let mut rows = [[0.0; N]; N];
    for node in 0..N {
        // Lagrange's polynomial of the node, factor by factor: Π (x − x_j)/(x_i − x_j)
        let mut powers = [0.0; N];
        powers[0] = 1.0;
        for other in (0..N).filter(|&other| other != node) {
            let scale = 1.0 / (nodes[node] - nodes[other]);
            for power in (0..N).rev() {
                let below = if power > 0 { powers[power - 1] } else { 0.0 };
                powers[power] = (below - nodes[other] * powers[power]) * scale;
            }
        }
        for power in 0..N {
            rows[power][node] = powers[power];
        }
    }
    rows
}

/// Sum of values by weights.
pub(super) fn weighted<const N: usize, const M: usize>(
    weights: &[f64; N],
    values: impl Fn(usize) -> [f64; M],
) -> [f64; M] {
    let mut sum = [0.0; M];
    for (index, weight) in weights.iter().enumerate() {
        for (sum, value) in sum.iter_mut().zip(values(index)) {
            *sum += weight * value;
        }
    }
    sum
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
        let table: Vec<Cell> = (0..9)
            .map(|cell| Cell::new::<AXIAL_TERMS>(&terms(cell)))
            .collect();
        let (cells, x, t) = ([3, 0, 8, 3], [0.1, -0.5, 0.3, 0.4], [-0.2, 0.5, 0.0, 0.35]);
        for level in [Level::new(), Level::baseline()] {
            let own = dispatch!(level, simd => {
                let position = InCells {
                    cells,
                    x: Lanes::load_array(simd, x),
                    t: Lanes::load_array(simd, t),
                };
                values(&table, &position).map(|lanes| *lanes)
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
        let cell: Cell = Cell::new::<AXIAL_TERMS>(&std::array::from_fn(|k| {
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

    #[test]
    fn every_place_has_its_cell_and_those_beyond_the_outermost() {
        let grid = Grid {
            root: Parts::new([2.0, 4.0], 64),
            along: Parts::new([-1.0, 1.0], 4),
        };
        for level in [Level::new(), Level::baseline()] {
            dispatch!(level, simd => {
                let check = |root: f64, along: f64, cell: usize, position: [f64; 2]| {
                    let [root, along] = [root, along].map(|number| Lanes::splat(simd, number));
                    let own = grid.locate(root, along);
                    assert_eq!(own.cells, [cell; LANES]);
                    let off = (own.x[0] - position[0]).abs().max((own.t[0] - position[1]).abs());
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

    #[test]
    fn values_at_the_nodes_give_back_the_powers_of_a_polynomial() {
        let expected = [-2.0, 0.7, -1.2, 0.3, 0.9, -0.4];
        let nodes = lobatto::<6>().map(|node| 0.5 * node);
        let value = |x: f64| expected.iter().rev().fold(0.0, |sum, c| sum * x + c);
        for (weights, expected) in power_weights(&nodes).iter().zip(expected) {
            let [power] = weighted(weights, |node| [value(nodes[node])]);
            assert!((power - expected).abs() < 1e-13, "{power}, {expected}");
        }
    }

    #[test]
    fn nodes_are_symmetric_and_reach_both_ends() {
        let nodes = lobatto::<5>();
        assert_eq!([nodes[0], nodes[2], nodes[4]], [-1.0, 0.0, 1.0]);
        assert_eq!(nodes[1], -nodes[3]);
    }
}
