//! The force of a mounted bearing from a table.

use super::ring::{CageAngle, Vector5};
use super::seat::Seat;
use super::support::Support;
use super::table_ring::{TableRing, TableWish};
use super::{BallRegion, TableError, TableReport};

/// Least swing that a table allows for, over the distance of the groove centres.
const LEAST_SWING: f64 = 1e-3;
/// Azimuths at which the largest ball load is looked for.
const AZIMUTHS: usize = 72;

impl Support {
    /// Compiles the law of the balls into a table for motions at `speed` in rad/s that stay within
    /// `swing` of `displacement`, both in m and rad of the shaft. The forces of [`Support::force`]
    /// then differ by no more than `tolerance` times the largest ball load at `displacement` a
    /// ball; further out and at other speeds they are exact, and slow.
    ///
    /// None where a table would not pay: for Hertz contacts without film, a linear bearing, and a
    /// floating ring, which asks for much more than forces.
    ///
    /// # Errors
    /// [`TableError`] where no table is good enough; forces stay exact.
    pub fn tabulate(
        &mut self,
        displacement: &Vector5,
        swing: &Vector5,
        speed: f64,
        tolerance: f64,
    ) -> Option<Result<TableReport, TableError>> {
        if self.frozen.is_some() || matches!(self.seat, Seat::Spring { .. }) {
            return None;
        }
        let place = self.ring_displacement(displacement, CageAngle::START, speed);
        let wish = TableWish {
            region: self.ball_region(&place, swing),
            speed,
            load: self.largest_load_around(&place, speed),
            tolerance,
        };
        let compiled = TableRing::compile(&self.ring, &self.definition, &wish)?;
        Some(compiled.map(|(table, report)| {
            self.table = Some(Box::new(table));
            report
        }))
    }

    /// Whether the forces with the shaft at `displacement` come from a table alone; so they do where
    /// there is none.
    pub fn is_inside_table(&self, displacement: &Vector5, cage: CageAngle, speed: f64) -> bool {
        let Some(table) = &self.table else {
            return true;
        };
        table.covers(
            &self.ring_displacement(displacement, cage, speed),
            cage,
            speed,
        )
    }

    /// Where balls come, whatever their azimuth, with the shaft within `swing` of the ring's `place`.
    fn ball_region(&self, place: &Vector5, swing: &Vector5) -> BallRegion {
        let geometry = &self.definition.bearing.geometry;
        let [x, y, z, tilt_x, tilt_y] = *place;
        let tilting = swing[3].hypot(swing[4]);
        let arm = geometry.inner_groove_radius();
        let least = LEAST_SWING * geometry.groove_centre_distance();
        let axial = arm * (tilt_x.hypot(tilt_y) + tilting) + swing[2].max(least);
        let lateral = swing[0].hypot(swing[1]) + self.definition.position.abs() * tilting;
        let radial = x.hypot(y) + lateral.max(least);
        let around = |middle: f64, half: f64| [middle - half, middle + half];
        BallRegion {
            axial: around(geometry.free_axial() + z, axial),
            radial: around(geometry.free_radial(), radial),
        }
    }

    /// Largest load that a ball at any azimuth bears with the ring at `place`, N.
    fn largest_load_around(&self, place: &Vector5, speed: f64) -> f64 {
        self.ring
            .around(place, speed, Some(AZIMUTHS))
            .iter()
            .map(|around| around.contact.load_inner)
            .fold(0.0, f64::max)
    }
}
