//! The law that a table stands for.

use fearless_simd::{Level, Simd, SimdBase, SimdFloat, SimdMask, dispatch};

use super::chart::Chart;
use super::strips::{InCell, Strips};
use crate::bearing::ball_law::one_by_one;
use crate::bearing::{
    BallContact, BallForce, BallLaw, BallTangent, LANES, LaneForces, Lanes, LoadSlope,
};

/// Powers of x, along the root of the approach, in a cell.
pub(super) const ROOT_TERMS: usize = 4;
/// Powers of t, along |A1|, in a cell.
pub(super) const AXIAL_TERMS: usize = 4;

/// End of a range, with what rounding may add.
const END: f64 = 1.0 + 1e-13;

/// Adding and taking it away rounds to a whole number, which then stands in the lowest bits.
pub(super) const ROUNDING: f64 = 6_755_399_441_055_744.0;

/// Keeps the ends of a range from being rounded into the cells beyond them.
pub(super) const INSIDE: f64 = 1.0 - 1e-12;

/// Coefficients of F_a/u and F_r/u in a cell: for every power of x the pairs (F_a, F_r) of
/// (t⁰, t¹) and of (t², t³).
pub(super) type ForceCell = [[[f64; 4]; 2]; ROOT_TERMS];

/// Coefficients of couple/u in a cell: for every power of x those of t⁰ … t³.
pub(super) type CoupleCell = [[f64; AXIAL_TERMS]; ROOT_TERMS];

/// A ball law as a table of polynomials at one speed, exact elsewhere.
///
/// ```text
/// p = |A1|   u = √(p² + (A2 − c)²) − R(p)   v = √u   F = u Σ c_kl x^k t^l
/// ```
///
/// with x and t the places in the cell of (v, p). `u = 0` is the line of lift-off, beyond which a
/// ball carries nothing. Places outside the region and other speeds than that of the table go to the
/// exact law, and so does everything but forces. `COUPLE` says whether the law has a couple.
///
/// The force differs from the exact one by the bound of its [`super::TableReport`]. It is continuous
/// within a strip of v and between strips of equally many cells; between others it may step by a
/// quarter of the tolerance.
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

/// Places in the coordinates of the table.
struct Located<S: Simd> {
    /// max(u, 0), m.
    past_lift: Lanes<S>,
    root: Lanes<S>,
    /// τ.
    along: Lanes<S>,
    /// Bins of the strips.
    bins: [usize; LANES],
}

/// A single place in the coordinates of the table, as [`Located`].
struct Single {
    past_lift: f64,
    root: f64,
    along: f64,
    bin: usize,
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
            let place = self.locate(lanes(axial.abs()), lanes(radial), speed)?;
            Some(Single {
                past_lift: place.past_lift[0],
                root: place.root[0],
                along: place.along[0],
                bin: place.bins[0],
            })
        })
    }

    /// Where places are in the table; none where any of them is outside.
    #[inline(always)]
    fn locate<S: Simd>(&self, axial: Lanes<S>, radial: Lanes<S>, speed: f64) -> Option<Located<S>> {
        let [along, past_lift] = self.chart.coordinates(axial, radial);
        let past_lift = past_lift.max(Lanes::splat(axial.witness(), 0.0));
        let root = past_lift.sqrt();
        let part = self.strips.part(root);
        let inside =
            along.abs().simd_le(END) & part.abs().simd_le(END) & radial.simd_ge(self.lowest);
        if !(inside.all_true() && speed == self.speed) {
            return None;
        }
        Some(Located {
            past_lift,
            root,
            along,
            bins: Strips::bins(part),
        })
    }
}

/// The whole number in the lowest bits.
#[inline(always)]
fn low(x: f64) -> usize {
    x.to_bits() as u32 as usize
}

/// Nearest whole numbers.
#[inline(always)]
pub(super) fn whole<S: Simd>(x: Lanes<S>) -> [usize; LANES] {
    let [a, b, c, d] = *(x + ROUNDING);
    [low(a), low(b), low(c), low(d)]
}

/// F_a/u and F_r/u at x and t of a cell.
#[inline(always)]
fn cell_force<S: Simd>(simd: S, cell: &ForceCell, x: f64, t: f64) -> [f64; 2] {
    let [even, odd] = &cell[ROOT_TERMS - 1];
    let mut low = simd.load_array_ref_f64x4(even);
    let mut high = simd.load_array_ref_f64x4(odd);
    for [even, odd] in cell[..ROOT_TERMS - 1].iter().rev() {
        low = low * x + simd.load_array_ref_f64x4(even);
        high = high * x + simd.load_array_ref_f64x4(odd);
    }
    let [a0, r0, a1, r1] = *(low + high * (t * t));
    [a0 + t * a1, r0 + t * r1]
}

/// couple/u at x and t of a cell.
#[inline(always)]
fn cell_couple<S: Simd>(simd: S, cell: &CoupleCell, x: f64, t: f64) -> f64 {
    let mut sum = simd.load_array_ref_f64x4(&cell[ROOT_TERMS - 1]);
    for term in cell[..ROOT_TERMS - 1].iter().rev() {
        sum = sum * x + simd.load_array_ref_f64x4(term);
    }
    let [c0, c1, c2, c3] = *sum;
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
        if !self.covers(axial, radial, speed) {
            return self.exact.force(axial, radial, speed);
        }
        dispatch!(Level::baseline(), simd => {
            let lanes = |number| Lanes::splat(simd, number);
            let all = self.forces(lanes(axial), lanes(radial), speed);
            BallForce {
                axial: all.axial[0],
                radial: all.radial[0],
                couple: all.couple[0],
            }
        })
    }

    #[inline(always)]
    fn forces<S: Simd>(&self, axial: Lanes<S>, radial: Lanes<S>, speed: f64) -> LaneForces<S> {
        let simd = axial.witness();
        let Some(place) = self.locate(axial.abs(), radial, speed) else {
            return one_by_one(self, axial, radial, speed);
        };
        let side = Lanes::splat(simd, 1.0).copysign(axial);
        let (roots, alongs) = (*place.root, *place.along);
        let [mut pushes_axial, mut pushes_radial, mut couples] = [[0.0; LANES]; 3];
        for i in 0..LANES {
            let InCell { cell, x, t } = self.strips.locate(place.bins[i], roots[i], alongs[i]);
            [pushes_axial[i], pushes_radial[i]] = cell_force(simd, &self.forces[cell], x, t);
            if COUPLE {
                couples[i] = cell_couple(simd, &self.couples[cell], x, t);
            }
        }
        // even and odd in A1
        let odd = side * place.past_lift;
        LaneForces {
            axial: odd * simd.load_array_f64x4(pushes_axial),
            radial: place.past_lift * simd.load_array_f64x4(pushes_radial),
            couple: odd * simd.load_array_f64x4(couples),
        }
    }

    /// The derivative of the table's own force.
    fn force_and_tangent(&self, axial: f64, radial: f64, speed: f64) -> (BallForce, BallTangent) {
        let Some(place) = self.locate_single(axial, radial, speed) else {
            return self.exact.force_and_tangent(axial, radial, speed);
        };
        let Single {
            past_lift,
            root,
            along,
            bin,
        } = place;
        let InCell { cell, x, t } = self.strips.locate(bin, root, along);
        let [x_rate, t_rate] = self.strips.rates(bin);
        let slopes = self.chart.slopes(axial.abs(), radial);
        let t_rate = t_rate * self.chart.along_rate();
        // F = u H(v, p), v = √u: ∂F/∂u = H + ½ v ∂H/∂v
        let row = |term: &dyn Fn(usize, usize) -> f64| {
            let [value, by_x, by_t] = with_slopes(term, x, t);
            let by_lift = value + 0.5 * root * by_x * x_rate;
            let by_axial = past_lift * by_t * t_rate + by_lift * slopes.by_axial;
            if past_lift > 0.0 {
                [past_lift * value, by_axial, by_lift * slopes.by_radial]
            } else {
                [0.0; 3]
            }
        };
        let forces = &self.forces[cell];
        let pair = |output: usize| move |k: usize, l: usize| forces[k][l / 2][2 * (l % 2) + output];
        let side = 1.0_f64.copysign(axial);
        let even = |[value, by_axial, by_radial]: [f64; 3]| (value, [side * by_axial, by_radial]);
        let odd =
            |[value, by_axial, by_radial]: [f64; 3]| (side * value, [by_axial, side * by_radial]);
        let (push_axial, axial_row) = odd(row(&pair(0)));
        let (push_radial, radial_row) = even(row(&pair(1)));
        let (couple, couple_row) = if COUPLE {
            odd(row(&|k, l| self.couples[cell][k][l]))
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
            self.chart.past_lift(axial.abs(), radial)
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
