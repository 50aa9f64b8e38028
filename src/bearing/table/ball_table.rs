//! A table of polynomials, and how balls are looked up in it.

use fearless_simd::{Level, Simd, SimdBase, SimdFloat, SimdMask, dispatch};

use super::cells::{CoupleCell, ForceCell, cell_couples, cell_forces};
use super::chart::{Chart, Coordinates, with_chart};
use super::division::{Division, InCells, Search, with_division};
use super::region::BallRegion;
use crate::bearing::{LaneForces, Lanes};

/// End of a range, with what rounding may add.
const END: f64 = 1.0 + 1e-13;

/// The forces of a ball law at one speed over a region, whatever law it is.
#[derive(Debug, Clone)]
pub(in crate::bearing) struct BallTable<const COUPLE: bool> {
    /// Shaft speed, rad/s.
    pub(super) speed: f64,
    /// Where the balls of a ring may be looked up, its A1 as [`BallRegion::one_sided`].
    pub(super) region: BallRegion,
    pub(in crate::bearing) chart: Chart,
    pub(in crate::bearing) division: Division,
    pub(super) forces: Vec<ForceCell>,
    pub(super) couples: Vec<CoupleCell>,
}

/// Places of balls side by side in the table.
#[derive(Clone, Copy)]
pub(in crate::bearing) struct Located<S: Simd> {
    /// What the polynomials of the radial force are to be multiplied by.
    radial: Lanes<S>,
    /// What those of the axial force and the couple are, with the sign of A1, in which these are odd.
    odd: Lanes<S>,
    in_cells: InCells<S>,
}

/// A single place in the coordinates of the table, as [`Located`].
pub(super) struct Single {
    /// Without the sign, those of axial force and couple, and those of the radial force.
    pub(super) factors: [f64; 2],
    /// dx/dv and dt/dτ.
    pub(super) rates: [f64; 2],
    pub(super) cell: usize,
    pub(super) x: f64,
    pub(super) t: f64,
}

impl<const COUPLE: bool> BallTable<COUPLE> {
    /// Whether a single place at a speed is in the table.
    #[inline(always)]
    fn covers<S: Simd>(&self, axial: Lanes<S>, radial: Lanes<S>, speed: f64) -> bool {
        let [along, root, ..] =
            with_chart!(&self.chart, chart => chart.coordinates(axial.abs(), radial));
        let inside = along.abs().simd_le(END)
            & with_division!(&self.division, division => division.contain(root))
            & radial.simd_ge(self.region.radial[0]);
        inside.all_true() && speed == self.speed
    }

    /// Where a single place is in the table.
    pub(super) fn locate_single(&self, axial: f64, radial: f64, speed: f64) -> Option<Single> {
        dispatch!(Level::baseline(), simd => {
            let [axial, radial] = [axial, radial].map(|number| Lanes::splat(simd, number));
            if !self.covers(axial, radial, speed) {
                return None;
            }
            let [_, root, ..] = with_chart!(&self.chart, chart => chart.coordinates(axial.abs(), radial));
            let place = self.located(axial, radial);
            let [root_rate, along_rate] = with_division!(&self.division, division => division.rates(root));
            Some(Single {
                factors: [place.odd[0].abs(), place.radial[0]],
                rates: [root_rate[0], along_rate[0]],
                cell: place.in_cells.cells[0] as usize,
                x: place.in_cells.x[0],
                t: place.in_cells.t[0],
            })
        })
    }

    /// Force of a single ball: the axial and the radial one and the couple, by the table.
    pub(super) fn single_force(&self, axial: f64, radial: f64, speed: f64) -> Option<[f64; 3]> {
        dispatch!(Level::baseline(), simd => {
            let [axial, radial] = [axial, radial].map(|number| Lanes::splat(simd, number));
            self.covers(axial, radial, speed).then(|| {
                let place = self.located(axial, radial);
                let LaneForces { axial, radial, couple } = self.forces_at(&place);
                [axial[0], radial[0], couple[0]]
            })
        })
    }

    /// Whether all places are in the region of the table whose A1 and A2 are within their swings of the
    /// middle, at a speed; each is the middle and the square of the swing, in m and m².
    #[inline(always)]
    pub(in crate::bearing) fn holds(&self, axial: [f64; 2], radial: [f64; 2], speed: f64) -> bool {
        // squares in place of a root, which takes long
        let room = |[middle, square]: [f64; 2], [low, high]: [f64; 2]| {
            let (below, above) = (middle - low, high - middle);
            (below >= 0.0) & (above >= 0.0) & (below * below >= square) & (above * above >= square)
        };
        let axial = [axial[0].abs(), axial[1]];
        room(radial, self.region.radial) & room(axial, self.region.axial) & (speed == self.speed)
    }

    /// As [`BallTable::locate`], by the table's own chart and division.
    #[inline(always)]
    fn located<S: Simd>(&self, axial: Lanes<S>, radial: Lanes<S>) -> Located<S> {
        with_chart!(&self.chart, chart => {
            with_division!(&self.division, division => Self::locate(chart, division, axial, radial))
        })
    }

    /// Where places of a table's region are in it; elsewhere a place without meaning.
    #[inline(always)]
    pub(in crate::bearing) fn locate<S: Simd>(
        chart: &impl Coordinates,
        division: &impl Search,
        axial: Lanes<S>,
        radial: Lanes<S>,
    ) -> Located<S> {
        let [along, root, odd, factor] = chart.coordinates(axial.abs(), radial);
        Located {
            radial: factor,
            odd: odd.copysign(axial),
            in_cells: division.locate(root, along),
        }
    }

    /// Forces at places in the table: polynomials in their cells.
    #[inline(always)]
    pub(in crate::bearing) fn forces_at<S: Simd>(&self, place: &Located<S>) -> LaneForces<S> {
        let InCells { cells, x, t } = place.in_cells;
        let [a, b, c, d] = cells;
        let of = |cell: u32| &self.forces[cell as usize];
        let [push_axial, push_radial] = cell_forces([of(a), of(b), of(c), of(d)], x, t);
        let couple = if COUPLE {
            let of = |cell: u32| &self.couples[cell as usize];
            place.odd * cell_couples([of(a), of(b), of(c), of(d)], x, t)
        } else {
            Lanes::splat(x.witness(), 0.0)
        };
        LaneForces {
            axial: place.odd * push_axial,
            radial: place.radial * push_radial,
            couple,
        }
    }
}
