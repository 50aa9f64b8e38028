//! The law that a table stands for.

use super::ball_table::{BallTable, Single};
use super::cells::with_slopes;
use crate::bearing::{BallContact, BallForce, BallLaw, BallTangent, LoadSlope};

/// A ball law as a table of polynomials at one speed, exact elsewhere.
///
/// ```text
/// p = |A1|   v = p² + A2²                   F_a = Σ c_kl x^k t^l   of balls that never lift off
///                                           F_r = A2 Σ d_kl x^k t^l
///            u = (A2 − c)² − M(p)   v = √u  F = u Σ c_kl x^k t^l    across lift-off
/// ```
///
/// with x and t the places in the cell of (v, p). `u = 0` is the line of lift-off, beyond which a
/// ball carries nothing. Places outside the region and other speeds than that of the table go to the
/// exact law, and so does everything but forces. `COUPLE` says whether the law has a couple.
///
/// The force differs from the exact one by the bound of its [`super::TableReport`]. Where one width of
/// strips of v serves the whole region it is continuous. Elsewhere strips have widths and cells of their
/// own: it is continuous within a strip and between strips of equally many cells; between others it may
/// step by a quarter of the tolerance.
///
/// A [`crate::bearing::Support`] looks up and evaluates the balls of a ring side by side; one by one,
/// as by [`BallLaw::force`], they give the same numbers.
#[derive(Debug, Clone)]
pub struct TableLaw<L, const COUPLE: bool> {
    pub(super) exact: L,
    pub(super) table: BallTable<COUPLE>,
}

impl<L: BallLaw, const COUPLE: bool> TableLaw<L, COUPLE> {
    /// The law that the table was compiled from.
    pub fn exact(&self) -> &L {
        &self.exact
    }

    /// Its table.
    pub(in crate::bearing) fn table(&self) -> &BallTable<COUPLE> {
        &self.table
    }

    /// Whether the force at a place and speed comes from the table.
    pub fn covers(&self, axial: f64, radial: f64, speed: f64) -> bool {
        self.table.locate_single(axial, radial, speed).is_some()
    }
}

impl<L: BallLaw, const COUPLE: bool> BallLaw for TableLaw<L, COUPLE> {
    const HAS_COUPLE: bool = COUPLE;

    fn force(&self, axial: f64, radial: f64, speed: f64) -> BallForce {
        match self.table.single_force(axial, radial, speed) {
            None => self.exact.force(axial, radial, speed),
            Some([axial, radial, couple]) => BallForce {
                axial,
                radial,
                couple,
            },
        }
    }

    /// The derivative of the table's own force.
    fn force_and_tangent(&self, axial: f64, radial: f64, speed: f64) -> (BallForce, BallTangent) {
        let table = &self.table;
        let Some(place) = table.locate_single(axial, radial, speed) else {
            return self.exact.force_and_tangent(axial, radial, speed);
        };
        let Single {
            factors,
            rates: [x_rate, t_rate],
            cell,
            x,
            t,
        } = place;
        let slopes = table.chart.slopes(axial.abs(), radial);
        // F = f H(x, t)
        let row = |kind: usize, term: &dyn Fn(usize, usize) -> f64| {
            let [value, by_x, by_t] = with_slopes(term, x, t);
            let (factor, slopes) = (factors[kind], &slopes[kind]);
            let by = |axis: usize| slopes.factor[axis] * value + slopes.root[axis] * x_rate * by_x;
            let along = slopes.along * t_rate * by_t;
            [factor * value, by(0) + along, by(1)]
        };
        let forces = &table.forces[cell].0;
        let pair = |output: usize| move |k: usize, l: usize| forces[k][l / 2][2 * (l % 2) + output];
        let side = 1.0_f64.copysign(axial);
        let even = |[value, by_axial, by_radial]: [f64; 3]| (value, [side * by_axial, by_radial]);
        let odd =
            |[value, by_axial, by_radial]: [f64; 3]| (side * value, [by_axial, side * by_radial]);
        let (push_axial, axial_row) = odd(row(0, &pair(0)));
        let (push_radial, radial_row) = even(row(1, &pair(1)));
        let (couple, couple_row) = if COUPLE {
            odd(row(0, &|k, l| table.couples[cell].0[k][l]))
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
            self.table.chart.distance_past_lift(axial.abs(), radial)
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
