//! The ring sum of balls whose law is a table.

use fearless_simd::Simd;

use super::ring_lanes::{Directions, LaneSums, LaneVector};
use super::table::Located;
use super::{BallLaw, CageAngle, Ring, TableLaw};

/// Balls that are looked up before any force is found, in rows of [`super::LANES`].
const ROWS: usize = 4;

impl<L: BallLaw, const COUPLE: bool> Ring<TableLaw<L, COUPLE>> {
    /// Adds the balls as [`Ring::force`] does; none, and says so, where one is outside the table. Where a ball
    /// is in the table takes long to find out, one step waiting for the other: that of many balls is found
    /// at the same time, and their forces after it.
    #[inline(always)]
    pub(super) fn add_by_table<S: Simd>(
        &self,
        simd: S,
        displacement: &LaneVector<S>,
        cage: CageAngle,
        speed: f64,
        sums: &mut LaneSums<S>,
    ) -> bool {
        let mut all = LaneSums::new(simd);
        for rows in self.lanes.chunks(ROWS) {
            let mut located: [Option<(Directions<S>, Located<S>)>; ROWS] = [None; ROWS];
            for (azimuths, row) in rows.iter().zip(&mut located) {
                let directions = azimuths.turned(simd, cage);
                let axial = directions.axial(self.free_axial, displacement, self.arm);
                let radial = directions.radial(self.free_radial, displacement);
                let Some(place) = self.law().locate(axial, radial, speed) else {
                    return false;
                };
                *row = Some((directions, place));
            }
            for (directions, place) in located.iter().flatten() {
                let balls = self.law().forces_at(place);
                all.add(directions, [balls.radial, balls.axial, self.moment(&balls)]);
            }
        }
        *sums = all;
        true
    }
}

#[cfg(test)]
mod tests {
    use fearless_simd::{Level, SimdBase, dispatch};

    use super::*;
    use crate::bearing::{BallRegion, FreePosition, Geometry, JonesLaw, Vector5, catalogue};
    use crate::physics::RaceControl;

    const SPEED: f64 = 1000.0;

    /// A ring of so many small balls under the table of a 7205C.
    fn ring(balls: usize) -> Ring<TableLaw<JonesLaw, false>> {
        let bearing = catalogue::find("7205C").unwrap().bearing().unwrap();
        let law = JonesLaw::new(&bearing, RaceControl::Outer).unwrap();
        let own = &bearing.geometry;
        let around = |middle: f64, half: f64| [middle - half, middle + half];
        let region = BallRegion {
            axial: around(own.free_axial() + 10e-6, 8e-6),
            radial: around(own.free_radial(), 20e-6),
        };
        let (table, _) = TableLaw::compile(law, region, SPEED, 300.0, 1e-9).unwrap();
        let free = FreePosition::ContactAngle(15f64.to_radians());
        let geometry = Geometry::new(balls, 4e-3, 38.5e-3, free, 0.525, 0.525).unwrap();
        let mut ring = Ring::new(&geometry, 0.1, table);
        (ring.free_axial, ring.free_radial) = (own.free_axial(), own.free_radial());
        ring
    }

    fn by_table(
        ring: &Ring<TableLaw<JonesLaw, false>>,
        level: Level,
        place: &Vector5,
        cage: CageAngle,
    ) -> Option<Vector5> {
        dispatch!(level, simd => {
            let mut sums = LaneSums::new(simd);
            let place = place.map(|number| SimdBase::splat(simd, number));
            ring.add_by_table(simd, &place, cage, SPEED, &mut sums)
                .then(|| sums.force(ring.arm))
        })
    }

    #[test]
    fn balls_looked_up_together_bear_what_they_bear_one_by_one() {
        let cage = CageAngle::new(0.7);
        for balls in [3, 12, 21] {
            let ring = ring(balls);
            let place = [6e-6, -8e-6, 10e-6, 8e-5, -1e-4];
            let expected = ring.force(&place, cage, SPEED);
            for level in [Level::new(), Level::baseline()] {
                assert_eq!(by_table(&ring, level, &place, cage), Some(expected));
            }
            let outside = [6e-6, -8e-6, 30e-6, 0.0, 0.0];
            assert_eq!(by_table(&ring, Level::new(), &outside, cage), None);
        }
    }
}
