//! The force of a mounted bearing from a table.

use super::any_ring::AnyRing;
use super::ring::{CageAngle, Vector5};
use super::seat::Seat;
use super::support::Support;
use super::{BallLaw, BallRegion, BallTable, Ring, TableError, TableReport};

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
        let request = (
            self.ball_region(&place, swing),
            speed,
            self.largest_load_around(&place, speed),
            tolerance,
        );
        let compiled = match &self.ring {
            AnyRing::Hertz(_) => return None,
            AnyRing::HertzFilm(ring) => under_table(ring, request),
            AnyRing::Jones(ring) => under_table(ring, request),
            AnyRing::JonesFilm(ring) => under_table(ring, request),
        };
        Some(compiled.map(|(table, report)| {
            self.table = Some(Box::new(table));
            report
        }))
    }

    /// The table where it covers every ball of the ring at `place`, wherever the cage stands.
    #[inline(always)]
    pub(super) fn table_at(&self, place: &Vector5, speed: f64) -> Option<&Ring<BallTable>> {
        let table = self.table.as_deref()?;
        table.is_covered(place, speed).then_some(table)
    }

    /// Whether the forces with the shaft at `displacement` come from a table; so they do where
    /// there is none.
    pub fn is_inside_table(&self, displacement: &Vector5, cage: CageAngle, speed: f64) -> bool {
        let place = || self.ring_displacement(displacement, cage, speed);
        self.table.is_none() || self.table_at(&place(), speed).is_some()
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

/// The same balls under a table over a region, at a speed, within a tolerance of a load.
fn under_table<L: BallLaw>(
    ring: &Ring<L>,
    (region, speed, load, tolerance): (BallRegion, f64, f64, f64),
) -> Result<(Ring<BallTable>, TableReport), TableError> {
    let (table, report) = BallTable::compile(ring.law(), region, speed, load, tolerance)?;
    Ok((ring.under(table), report))
}
