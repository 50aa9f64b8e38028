//! The law that a table stands for.

use fearless_simd::{Level, Simd, SimdBase, SimdFloat, SimdMask, dispatch};

use super::chart::Chart;
use super::side_by_side::transposed;
use super::strips::{InCells, Strips};
use crate::bearing::{
    BallContact, BallForce, BallLaw, BallTangent, LANES, LaneForces, Lanes, LoadSlope,
};

/// Powers of x, along the root of the approach, in a cell.
pub(super) const ROOT_TERMS: usize = 4;
/// Powers of t, along |A1|, in a cell.
pub(super) const AXIAL_TERMS: usize = 4;

/// End of a range, with what rounding may add.
const END: f64 = 1.0 + 1e-13;

/// Coefficients of F_a/u and F_r/u in a cell: for every power of x the pairs (F_a, F_r) of
/// (t⁰, t¹) and of (t², t³). Whole lines of the cache: none is read in halves.
#[derive(Debug, Clone, Copy)]
#[repr(align(64))]
pub(super) struct ForceCell(pub(super) [[[f64; 4]; 2]; ROOT_TERMS]);

/// Coefficients of couple/u in a cell: for every power of x those of t⁰ … t³.
#[derive(Debug, Clone, Copy)]
#[repr(align(64))]
pub(super) struct CoupleCell(pub(super) [[f64; AXIAL_TERMS]; ROOT_TERMS]);

/// A ball law as a table of polynomials at one speed, exact elsewhere.
///
/// ```text
/// p = |A1|   u = (A2 − c)² − M(p)   v = √u   F = u Σ c_kl x^k t^l
/// ```
///
/// with x and t the places in the cell of (v, p). `u = 0` is the line of lift-off, beyond which a
/// ball carries nothing. Places outside the region and other speeds than that of the table go to the
/// exact law, and so does everything but forces. `COUPLE` says whether the law has a couple.
///
/// The force differs from the exact one by the bound of its [`super::TableReport`]. It is continuous
/// within a strip of v and between strips of equally many cells; between others it may step by a
/// quarter of the tolerance.
///
/// A [`crate::bearing::Support`] looks up and evaluates the balls of a ring side by side; one by one,
/// as by [`BallLaw::force`], they give the same numbers.
#[derive(Debug, Clone)]
pub struct TableLaw<L, const COUPLE: bool> {
    pub(super) exact: L,
    pub(super) speed: f64,
    /// Least A2, m.
    pub(super) lowest: f64,
    pub(super) chart: Chart,
    pub(super) strips: Strips,
    pub(super) forces: Vec<ForceCell>,
    pub(super) couples: Vec<CoupleCell>,
}

/// Places of balls side by side in the table.
#[derive(Clone, Copy)]
pub(in crate::bearing) struct Located<S: Simd> {
    /// max(u, 0), m².
    past_lift: Lanes<S>,
    /// The same with the sign of A1: what is odd in it.
    odd: Lanes<S>,
    in_cells: InCells<S>,
}

/// A single place in the coordinates of the table, as [`Located`].
struct Single {
    past_lift: f64,
    /// dx/dv and dt/dτ.
    rates: [f64; 2],
    cell: usize,
    x: f64,
    t: f64,
}

impl<L: BallLaw, const COUPLE: bool> TableLaw<L, COUPLE> {
    /// The law that the table was compiled from.
    pub fn exact(&self) -> &L {
        &self.exact
    }

    /// Whether the force at a place and speed comes from the table.
    pub fn covers(&self, axial: f64, radial: f64, speed: f64) -> bool {
        self.locate_single(axial, radial, speed).is_some()
    }

    /// Where a single place is in the table.
    fn locate_single(&self, axial: f64, radial: f64, speed: f64) -> Option<Single> {
        dispatch!(Level::baseline(), simd => {
            let lanes = |number| Lanes::splat(simd, number);
            let place = self.locate(lanes(axial), lanes(radial), speed)?;
            let [root_rate, along_rate] = self.strips.rates(place.past_lift.sqrt());
            Some(Single {
                past_lift: place.past_lift[0],
                rates: [root_rate[0], along_rate[0]],
                cell: place.in_cells.cells[0],
                x: place.in_cells.x[0],
                t: place.in_cells.t[0],
            })
        })
    }

    /// Where places are in the table; none where any of them is outside.
    #[inline(always)]
    pub(in crate::bearing) fn locate<S: Simd>(
        &self,
        axial: Lanes<S>,
        radial: Lanes<S>,
        speed: f64,
    ) -> Option<Located<S>> {
        let simd = axial.witness();
        let [along, past_lift] = self.chart.coordinates(axial.abs(), radial);
        let past_lift = past_lift.max(Lanes::splat(simd, 0.0));
        let root = past_lift.sqrt();
        let among_bins = self.strips.among_bins(root);
        let inside =
            along.abs().simd_le(END) & Strips::contain(among_bins) & radial.simd_ge(self.lowest);
        if !(inside.all_true() && speed == self.speed) {
            return None;
        }
        Some(Located {
            past_lift,
            odd: past_lift.copysign(axial),
            in_cells: self.strips.locate(root, among_bins, along),
        })
    }

    /// Forces at places in the table: polynomials in their cells.
    #[inline(always)]
    pub(in crate::bearing) fn forces_at<S: Simd>(&self, place: &Located<S>) -> LaneForces<S> {
        let InCells { cells, x, t, .. } = place.in_cells;
        let [a, b, c, d] = cells;
        let of = |cell: usize| &self.forces[cell];
        let [push_axial, push_radial] = cell_forces([of(a), of(b), of(c), of(d)], x, t);
        let couple = if COUPLE {
            let of = |cell: usize| &self.couples[cell];
            place.odd * cell_couples([of(a), of(b), of(c), of(d)], x, t)
        } else {
            Lanes::splat(x.witness(), 0.0)
        };
        LaneForces {
            axial: place.odd * push_axial,
            radial: place.past_lift * push_radial,
            couple,
        }
    }
}

/// F_a/u and F_r/u at x and t of cells.
#[inline(always)]
fn cell_forces<S: Simd>(cells: [&ForceCell; LANES], x: Lanes<S>, t: Lanes<S>) -> [Lanes<S>; 2] {
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

/// couple/u at x and t of cells.
#[inline(always)]
fn cell_couples<S: Simd>(cells: [&CoupleCell; LANES], x: Lanes<S>, t: Lanes<S>) -> Lanes<S> {
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
fn with_slopes(term: impl Fn(usize, usize) -> f64, x: f64, t: f64) -> [f64; 3] {
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

impl<L: BallLaw, const COUPLE: bool> BallLaw for TableLaw<L, COUPLE> {
    const HAS_COUPLE: bool = COUPLE;

    fn force(&self, axial: f64, radial: f64, speed: f64) -> BallForce {
        dispatch!(Level::baseline(), simd => {
            let lanes = |number| Lanes::splat(simd, number);
            match self.locate(lanes(axial), lanes(radial), speed) {
                None => self.exact.force(axial, radial, speed),
                Some(place) => {
                    let all = self.forces_at(&place);
                    BallForce {
                        axial: all.axial[0],
                        radial: all.radial[0],
                        couple: all.couple[0],
                    }
                }
            }
        })
    }

    /// The derivative of the table's own force.
    fn force_and_tangent(&self, axial: f64, radial: f64, speed: f64) -> (BallForce, BallTangent) {
        let Some(place) = self.locate_single(axial, radial, speed) else {
            return self.exact.force_and_tangent(axial, radial, speed);
        };
        let Single {
            past_lift,
            rates: [x_rate, t_rate],
            cell,
            x,
            t,
        } = place;
        let slopes = self.chart.slopes(axial.abs(), radial);
        let t_rate = t_rate * self.chart.along_rate();
        // F = u H(v, p), v = √u: ∂F/∂u = H + ½ v ∂H/∂v
        let row = |term: &dyn Fn(usize, usize) -> f64| {
            let [value, by_x, by_t] = with_slopes(term, x, t);
            let by_lift = value + 0.5 * past_lift.sqrt() * by_x * x_rate;
            let by_axial = past_lift * by_t * t_rate + by_lift * slopes.by_axial;
            if past_lift > 0.0 {
                [past_lift * value, by_axial, by_lift * slopes.by_radial]
            } else {
                [0.0; 3]
            }
        };
        let forces = &self.forces[cell].0;
        let pair = |output: usize| move |k: usize, l: usize| forces[k][l / 2][2 * (l % 2) + output];
        let side = 1.0_f64.copysign(axial);
        let even = |[value, by_axial, by_radial]: [f64; 3]| (value, [side * by_axial, by_radial]);
        let odd =
            |[value, by_axial, by_radial]: [f64; 3]| (side * value, [by_axial, side * by_radial]);
        let (push_axial, axial_row) = odd(row(&pair(0)));
        let (push_radial, radial_row) = even(row(&pair(1)));
        let (couple, couple_row) = if COUPLE {
            odd(row(&|k, l| self.couples[cell].0[k][l]))
        } else {
            (0.0, [0.0; 2])
        };
        let force = BallForce {
            axial: push_axial,
            radial: push_radial,
            couple,
        };
        (force, [axial_row, radial_row, couple_row])
    }

    /// The table's own line of lift-off; outside the law's.
    fn past_lift_off(&self, axial: f64, radial: f64, speed: f64) -> f64 {
        if self.covers(axial, radial, speed) {
            self.chart.distance_past_lift(axial.abs(), radial)
        } else {
            self.exact.past_lift_off(axial, radial, speed)
        }
    }

    fn load_slopes(&self, axial: f64, radial: f64, speed: f64) -> [LoadSlope; 2] {
        self.exact.load_slopes(axial, radial, speed)
    }

    fn contact(&self, axial: f64, radial: f64, speed: f64) -> BallContact {
        self.exact.contact(axial, radial, speed)
    }
}
