//! A table of polynomials in place of a ball law.

use fearless_simd::{ExtractToken, Simd, SimdBase, SimdFloat};

use super::cells::{Cell, Grid, InCells, values};
use super::chart::{BallRegion, Chart};
use crate::bearing::law::{Ball, BallForce, ForceLaw};
use crate::bearing::number::{Function, Lanes, Number, Plain};
use crate::numerics::registers::in_baseline_registers;

/// The forces of a ball law at one speed over a region, as polynomials.
///
/// ```text
/// u = (A2 − c)² − M(|A1|)   v = √u   F = u Σ c_kl x^k t^l
/// ```
///
/// with x and t the positions in a cell of (v, |A1|). `u = 0` is the line of lift-off, beyond which a
/// ball carries nothing. It is for the caller to ask the law itself where [`BallTable::covers_around`] says no.
///
/// The force differs from the exact one by the bound of its [`super::TableReport`]; from cell to cell it steps by no more.
#[derive(Debug, Clone)]
pub struct BallTable {
    /// Shaft speed, rad/s.
    pub(super) speed: f64,
    /// Where balls are looked up, folded.
    pub(super) region: BallRegion,
    pub(super) chart: Chart,
    pub(super) grid: Grid,
    /// Polynomials of axial and radial force over u.
    pub(super) forces: Vec<Cell>,
    /// Polynomials of the couple over u, the second polynomials zero; empty for a law without couple.
    pub(super) couples: Vec<Cell>,
}

impl BallTable {
    /// Whether the table holds at a speed and all positions whose A1 and A2 are within their amplitudes of the middle;
    /// each is the middle and the square of the amplitude, in m and m².
    #[inline(always)]
    pub(crate) fn covers_around(&self, axial: [f64; 2], radial: [f64; 2], speed: f64) -> bool {
        // squares in place of a root, which takes long
        let room = |[middle, square]: [f64; 2], [low, high]: [f64; 2]| {
            let (below, above) = (middle - low, high - middle);
            (below >= 0.0) & (above >= 0.0) & (below * below >= square) & (above * above >= square)
        };
        let [near, far] = self.region.axial;
        // both sides of A1 = 0
        let near = if near > 0.0 { near } else { -far };
        let folded = [axial[0].abs(), axial[1]];
        speed == self.speed && room(radial, self.region.radial) & room(folded, [near, far])
    }

    /// Cells of positions that the table covers, and u there.
    #[inline(always)]
    fn locate<S: Simd>(&self, axial: Lanes<S>, radial: Lanes<S>) -> (InCells<S>, Lanes<S>) {
        let [along, root, past_lift] = self.chart.coordinates(axial.abs(), radial);
        (self.grid.locate(root, along), past_lift)
    }
}

/// Axial force, radial force and couple at positions that the table covers.
impl Function<2, 3> for BallTable {
    fn with_slopes(&self, [axial, radial]: [f64; 2]) -> ([f64; 3], [[f64; 2]; 3]) {
        let (past_lift, cell, x, t) = in_baseline_registers!(simd => {
            let [axial, radial] = [axial, radial].map(|number| Lanes::splat(simd, number));
            let (in_cells, past_lift) = self.locate(axial, radial);
            (past_lift[0], in_cells.cells[0], in_cells.x[0], in_cells.t[0])
        });
        let (along_rate, past_lift_rates) = self.chart.slopes(axial.abs(), radial);
        // dx/dv and dt/d|A1|
        let (x_rate, t_rate) = (self.grid.root.scale, self.grid.along.scale * along_rate);
        // F = u H(x, t), u dv/du = v/2
        let row = |cell: &Cell, which: usize| {
            let [value, by_x, by_t] = cell.with_slopes(which, x, t);
            let by_past_lift = value + 0.5 * past_lift.sqrt() * x_rate * by_x;
            let [axial, radial] = past_lift_rates.map(|rate| by_past_lift * rate);
            let slopes = [axial + past_lift * t_rate * by_t, radial];
            (past_lift * value, slopes)
        };
        let side = 1.0_f64.copysign(axial);
        let odd = |(value, [by_axial, by_radial]): (f64, [f64; 2])| {
            (side * value, [by_axial, side * by_radial])
        };
        let (push_axial, axial_row) = odd(row(&self.forces[cell], 0));
        let (push_radial, [by_axial, by_radial]) = row(&self.forces[cell], 1);
        let couple = self.couples.get(cell);
        let (couple, couple_row) = couple.map_or((0.0, [0.0; 2]), |cell| odd(row(cell, 0)));
        (
            [push_axial, push_radial, couple],
            [axial_row, [side * by_axial, by_radial], couple_row],
        )
    }

    fn values(&self, at: [f64; 2]) -> [f64; 3] {
        in_baseline_registers!(simd => {
            let found = self.side_by_side(at.map(|number| Lanes::splat(simd, number)));
            found.map(|lanes| lanes[0])
        })
    }

    #[inline(always)]
    fn side_by_side<S: Simd>(&self, [axial, radial]: [Lanes<S>; 2]) -> [Lanes<S>; 3] {
        let (in_cells, past_lift) = self.locate(axial, radial);
        // axial force and couple are odd in A1
        let odd = past_lift.copysign(axial);
        let [push_axial, push_radial] = values(&self.forces, &in_cells);
        let couple = if self.couples.is_empty() {
            Lanes::splat(past_lift.token(), 0.0)
        } else {
            odd * values(&self.couples, &in_cells)[0]
        };
        [odd * push_axial, past_lift * push_radial, couple]
    }
}

/// On perfect races, at the speed of the table, at positions that it covers.
impl ForceLaw for BallTable {
    const HAS_COUPLE: bool = true;

    #[inline(always)]
    fn force<T: Number>(&self, ball: &Ball<T>, _speed: f64) -> BallForce<T> {
        T::apply(self, [ball.axial, ball.radial]).into()
    }

    #[inline(always)]
    fn distance_past_lift_off<T: Plain>(&self, ball: &Ball<T>, _place: usize, _speed: f64) -> T {
        self.chart.distance_past_lift(ball.axial, ball.radial)
    }
}
