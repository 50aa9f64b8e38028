//! Sums over the laminae of a roller as polynomials, each made when a roller first comes to its cell.

use std::sync::OnceLock;

use fearless_simd::{Bytes, ExtractToken, Level, Simd, SimdBase, SimdFloat, u32x8};

use super::cells::{Cell, joined, lobatto, power_weights, weighted};
use crate::bearing::law::laminae::{Four, NEVER, Sums, fours};
use crate::bearing::law::ninth_root::ninth_root;
use crate::bearing::number::{LANES, Lanes};
use crate::numerics::registers::in_wide_registers;

/// Powers of x, along the approach, and of t, along the tilt, in a cell.
const POWERS: usize = 8;
const TILT_POWERS: usize = 6;
/// Widths of the cells: each octave of a coordinate has two to the power of this many.
const APPROACH_BITS: u32 = 4;
const TILT_BITS: u32 = 5;
/// Octaves of the coordinates.
const APPROACH_OCTAVES: usize = 8;
const TILT_OCTAVES: usize = 6;
/// Cells along the approach, and along the tilt of rollers that tilt.
const COLUMNS: usize = APPROACH_OCTAVES << APPROACH_BITS;
const STRIPS: usize = TILT_OCTAVES << TILT_BITS;
/// Least approach of a lamina in a cell over the range of its approaches there: its load is then a polynomial to 1e-12.
const MARGIN: f64 = 2.0;

/// Loads and couples of a roller by its approach and its tilt, over c_s.
///
/// ```text
/// p = δ + |T| L/2 − least 2 P   τ = |T| L/2       lamina k bears where p > τ + T s_k + 2 P_k − least 2 P
/// Σ q = Σ_far + Σ_near          Σ_far = Σ c_kl x^k t^l
/// ```
///
/// with x and t the positions in a cell of (p, τ), whose width grows with the distance from zero. Laminae that are
/// well pressed throughout a cell are a polynomial in it, through values at nodes. The few laminae that meet the
/// races near the cell are summed one by one, those of rollers side by side together: the kinks at which they do are where
/// they are. A cell is made when it is first asked for, and is the same whoever asks; beyond all cells the sum is over all laminae.
#[derive(Debug)]
pub(in crate::bearing::law) struct RollerCells {
    /// Vector instructions of the processor.
    pub level: Level,
    pub laminae: Box<[Four]>,
    /// The laminae one by one, each a position and 2 P, m.
    each: Box<[[f64; 2]]>,
    /// L/2, m.
    pub half_length: f64,
    /// Least 2 P of any lamina, m.
    pub least_drop: f64,
    /// Distance over which the cells double their widths, from zero on, m.
    unit: f64,
    cells: Box<[OnceLock<Box<RollerCell>>]>,
}

/// A cell of the table.
#[derive(Debug)]
struct RollerCell {
    /// Σ q and −Σ s q of the laminae that are well pressed.
    far: Cell<POWERS, { TILT_POWERS / 2 }>,
    /// The laminae that meet the races in the cell or near it, each a position and 2 P, m.
    near: Box<[[f64; 2]]>,
}

impl RollerCells {
    /// The cells of a roller whose laminae are each a position and 2 P in m.
    pub fn new(laminae: &[[f64; 2]], half_length: f64, unit: f64, tilts: bool) -> Self {
        let strips = if tilts { STRIPS } else { 1 };
        let cells = (0..COLUMNS * strips).map(|_| OnceLock::new());
        Self {
            level: Level::new(),
            laminae: fours(laminae),
            each: laminae.into(),
            half_length,
            least_drop: laminae
                .iter()
                .fold(f64::INFINITY, |least, lamina| least.min(lamina[1])),
            unit,
            cells: cells.collect(),
        }
    }

    /// Σ q and −Σ s q of rollers by the approaches of their middles, m, and their tilts, rad.
    #[inline(always)]
    pub fn loads<S: Simd>(&self, [middle, tilt]: [Lanes<S>; 2]) -> [Lanes<S>; 2] {
        let simd = middle.token();
        let zero = Lanes::splat(simd, 0.0);
        let size = tilt.abs();
        let along = size * self.half_length;
        let past = (middle + along) - self.least_drop;
        let (columns, x) = locate(past.max(zero) * (1.0 / self.unit), APPROACH_BITS);
        let (strips, t) = locate(along * (1.0 / self.unit), TILT_BITS);
        let square = t * t;
        let (mut far, mut near) = ([zero; LANES], [&[][..]; LANES]);
        for lane in 0..LANES {
            if past[lane] <= 0.0 {
                continue;
            }
            near[lane] = match self.cell(columns[lane], strips[lane]) {
                Some(cell) => {
                    let (x, square) = (x[lane], square[lane]);
                    far[lane] = cell
                        .far
                        .pairs(Lanes::splat(simd, x), Lanes::splat(simd, square));
                    &cell.near
                }
                None => &self.each,
            };
        }
        let [mut load, mut couple] = joined(far, t);
        for number in 0..near.iter().map(|near| near.len()).fold(0, usize::max) {
            let (mut position, mut drop) = ([0.0; LANES], [NEVER; LANES]);
            for lane in 0..LANES {
                if let Some(lamina) = near[lane].get(number) {
                    [position[lane], drop[lane]] = *lamina;
                }
            }
            let position = Lanes::load_array(simd, position);
            let approach = (middle - position * size) - Lanes::load_array(simd, drop);
            let pressed = approach.max(zero);
            let pushed = pressed * ninth_root(pressed);
            load += pushed;
            couple -= position * pushed;
        }
        [load, Lanes::splat(simd, 1.0).copysign(tilt) * couple]
    }

    /// A cell, made where it is asked for first; none beyond all.
    #[inline(always)]
    fn cell(&self, column: usize, strip: usize) -> Option<&RollerCell> {
        if column >= COLUMNS {
            return None;
        }
        let cell = self.cells.get(COLUMNS * strip + column)?;
        Some(match cell.get() {
            Some(cell) => cell,
            None => cell.get_or_init(|| Box::new(self.make(column, strip))),
        })
    }

    #[cold]
    #[inline(never)]
    fn make(&self, column: usize, strip: usize) -> RollerCell {
        let past = edges(column, APPROACH_BITS).map(|edge| self.unit * edge);
        let along = edges(strip, TILT_BITS).map(|edge| self.unit * edge);
        let (mut far, mut near) = (Vec::new(), Vec::new());
        for four in &self.laminae {
            for (&position, &drop) in four.position.iter().zip(&four.drop) {
                // by how much it lags the first that bears at the tilts of both edges, and its approaches
                let lag = along.map(|along| {
                    along * (1.0 + position / self.half_length) + (drop - self.least_drop)
                });
                let [least, most] = [past[0] - lag[1], past[1] - lag[0]];
                if least >= MARGIN * (most - least) {
                    far.push([position, drop]);
                } else if most > 0.0 {
                    near.push([position, drop]);
                }
            }
        }
        let far = fours(&far);
        let (past_nodes, along_nodes) = (lobatto::<POWERS>(), lobatto::<TILT_POWERS>());
        let at = |[low, high]: [f64; 2], node: f64| 0.5 * (low + high) + 0.5 * (high - low) * node;
        let values = past_nodes.map(|node| {
            let past = at(past, node);
            along_nodes.map(|node| {
                let along = at(along, node);
                let place = [(past - along) + self.least_drop, along / self.half_length];
                in_wide_registers!(self.level, simd => Sums::over::<false>(simd, &far, place).total().load)
            })
        });
        let halves = |node: f64| 0.5 * node;
        let by_past = power_weights(&past_nodes.map(halves));
        let by_along = power_weights(&along_nodes.map(halves));
        let terms = by_past.map(|by_past| {
            let row: [[f64; 2]; TILT_POWERS] =
                std::array::from_fn(|l| weighted(&by_past, |k| values[k][l]));
            by_along.map(|by_along| weighted(&by_along, |l| row[l]))
        });
        RollerCell {
            far: Cell::new(&terms),
            near: near.into(),
        }
    }
}

/// Edges of a cell along a coordinate: those of numbers with the same exponent and the same first bits of the mantissa, less 1.
fn edges(cell: usize, bits: u32) -> [f64; 2] {
    [cell, cell + 1].map(|edge| {
        let start = (1 << (edge >> bits)) as f64;
        let part = (edge & ((1 << bits) - 1)) as f64 / f64::from(1 << bits);
        start * (1.0 + part) - 1.0
    })
}

/// Cells along a coordinate in units, not negative, and positions −½ … ½ in them.
#[inline(always)]
fn locate<S: Simd>(coordinate: Lanes<S>, bits: u32) -> ([usize; LANES], Lanes<S>) {
    let simd = coordinate.token();
    let number = coordinate + 1.0;
    let words = number.bitcast::<u32x8<S>>();
    let (exponent, first) = (
        0x7FF0_0000,
        0x7FF0_0000 | (0xF_FFFF << (20 - bits)) & 0xF_FFFF,
    );
    // the lower edge of the cell, and 1 over its start, 2^−e
    let edge = words & upper(simd, first);
    let start = upper(simd, 2 * (1023 << 20)) - (words & upper(simd, exponent));
    let position = (number - float(edge)) * float(start) * f64::from(1 << bits) + (-0.5);
    let [_, a, _, b, _, c, _, d] = *edge;
    let cell = |upper: u32| ((upper - (1023 << 20)) >> (20 - bits)) as usize;
    ([cell(a), cell(b), cell(c), cell(d)], position)
}

/// A mask of the upper halves of numbers.
#[inline(always)]
fn upper<S: Simd>(simd: S, mask: u32) -> u32x8<S> {
    u32x8::load_array(simd, [0, mask, 0, mask, 0, mask, 0, mask])
}

/// The numbers of these bits.
#[inline(always)]
fn float<S: Simd>(bits: u32x8<S>) -> Lanes<S> {
    bits.bitcast()
}
