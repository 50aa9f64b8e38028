//! The force of a mounted bearing from a table.

use super::{Seat, Support, Vector5};
use crate::bearing::BearingRotation;
use crate::bearing::law::{BallRegion, BallTable, TableError, TableReport, with_law};

/// Least amplitude that a table allows for, over the distance of the groove centres.
const LEAST_AMPLITUDE: f64 = 1e-3;
/// Azimuths at which the largest ball load is looked for.
const AZIMUTHS: usize = 72;

impl Support {
    /// Compiles the law of the balls into a table for motions at `speed` in rad/s that stay within
    /// `amplitude` of `displacement`, both in m and rad. The forces of [`Support::force`]
    /// then differ by no more than `tolerance` times the largest ball load at `displacement` a
    /// ball; further out and at other speeds they are exact, and slow.
    ///
    /// None where a table would not pay: for Hertz contacts without film, rollers, a linear bearing, and a
    /// floating ring, which asks for much more than forces.
    ///
    /// # Errors
    /// [`TableError`] where no table is good enough; forces stay exact.
    pub(crate) fn tabulate(
        &mut self,
        displacement: &Vector5,
        amplitude: &Vector5,
        speed: f64,
        tolerance: f64,
    ) -> Option<Result<TableReport, TableError>> {
        if !self.may_gain_from_table() {
            return None;
        }
        if self.is_imperfect() {
            return Some(Err(TableError::Imperfect));
        }
        let place = self.settled(displacement, &BearingRotation::at_start(speed));
        let region = self.ball_region(&place, amplitude);
        let around = self.around(&place, speed, Some(AZIMUTHS));
        let loads = around.iter().map(|ball| ball.contact.load_inner);
        let load = loads.fold(0.0, f64::max);
        let compiled = with_law!(&self.law, law => {
            BallTable::compile(law, region, speed, load, tolerance)
        });
        Some(compiled.map(|(table, report)| {
            self.table = Some(Box::new(table));
            report
        }))
    }

    /// Whether a table may pay.
    fn may_gain_from_table(&self) -> bool {
        let floats = matches!(self.seat, Seat::Spring { .. });
        self.frozen.is_none() && !floats && self.law.gains_from_table()
    }

    /// Whether a table is compiled where one is asked for.
    pub(crate) fn gains_from_table(&self) -> bool {
        self.may_gain_from_table() && !self.is_imperfect()
    }

    /// The table where it covers every ball with the inner ring at `place`, at any angle of the cage.
    #[inline(always)]
    pub(super) fn table_at(&self, place: &Vector5, speed: f64) -> Option<&BallTable> {
        // looked at first: most bearings have none
        let table = self.table.as_deref()?;
        let [axial, radial] = self.ring.amplitudes(place);
        table.covers_around(axial, radial, speed).then_some(table)
    }

    /// Whether the forces at a displacement come from a table; so they do where
    /// there is none.
    pub(crate) fn is_inside_table(
        &self,
        displacement: &Vector5,
        rotation: &BearingRotation,
    ) -> bool {
        let place = || self.settled(displacement, rotation);
        self.table.is_none() || self.table_at(&place(), rotation.speed).is_some()
    }

    /// Where balls come, whatever their azimuth, with the inner ring within `amplitude` of the ring's `place`.
    fn ball_region(&self, place: &Vector5, amplitude: &Vector5) -> BallRegion {
        let geometry = &self.definition.bearing.geometry;
        let [x, y, z, tilt_x, tilt_y] = *place;
        let tilting = amplitude[3].hypot(amplitude[4]);
        let arm = geometry.lever();
        let least = LEAST_AMPLITUDE * geometry.length_scale();
        let axial = arm * (tilt_x.hypot(tilt_y) + tilting) + amplitude[2].max(least);
        let lateral = amplitude[0].hypot(amplitude[1]);
        let radial = x.hypot(y) + lateral.max(least);
        let around = |middle: f64, half: f64| [middle - half, middle + half];
        BallRegion {
            axial: around(geometry.free_axial() + z, axial),
            radial: around(geometry.free_radial(), radial),
        }
    }
}
