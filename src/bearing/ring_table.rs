//! The ring sum of balls whose law is a table.

use fearless_simd::Simd;

use super::ring_lanes::{Azimuths, Directions, LaneSums, LaneVector};
use super::table::{BallTable, Chart, Coordinates, Division, Located, Search};
use super::{BallLaw, CageAngle, Ring, TableLaw};

/// The balls of a ring with their table, whatever law it stands for.
#[derive(Clone, Copy)]
pub(super) struct TabledBalls<'a, const COUPLE: bool> {
    table: &'a BallTable<COUPLE>,
    lanes: &'a [Azimuths],
    free_axial: f64,
    free_radial: f64,
    arm: f64,
}

impl<L: BallLaw, const COUPLE: bool> Ring<TableLaw<L, COUPLE>> {
    /// The balls and their table alone.
    #[inline(always)]
    pub(super) fn tabled(&self) -> TabledBalls<'_, COUPLE> {
        TabledBalls {
            table: self.law().table(),
            lanes: &self.lanes,
            free_axial: self.free_axial,
            free_radial: self.free_radial,
            arm: self.arm,
        }
    }
}

impl<const COUPLE: bool> TabledBalls<'_, COUPLE> {
    /// Adds up the forces of the balls in `sums`, as [`Ring::force`] does; leaves it alone, and says so, where the
    /// ring may take a ball out of the table at some angle of the cage.
    #[inline(always)]
    pub fn add<S: Simd>(
        &self,
        simd: S,
        displacement: &LaneVector<S>,
        cage: CageAngle,
        speed: f64,
        sums: &mut LaneSums<S>,
    ) -> bool {
        let [x, y, z, tilt_x, tilt_y] = displacement.each_ref().map(|lanes| lanes[0]);
        let axial = [
            self.free_axial + z,
            self.arm * self.arm * (tilt_x * tilt_x + tilt_y * tilt_y),
        ];
        let radial = [self.free_radial, x * x + y * y];
        if !self.table.holds(axial, radial, speed) {
            return false;
        }
        match (&self.table.chart, &self.table.division) {
            (Chart::Loaded(chart), Division::Even(even)) => {
                self.add_by(simd, (chart, even), displacement, cage, sums)
            }
            (Chart::Loaded(chart), Division::Uneven(strips)) => {
                self.add_by(simd, (chart, strips), displacement, cage, sums)
            }
            (Chart::Lifting(chart), Division::Even(even)) => {
                self.add_by(simd, (chart, even), displacement, cage, sums)
            }
            (Chart::Lifting(chart), Division::Uneven(strips)) => {
                self.add_by(simd, (chart, strips), displacement, cage, sums)
            }
        }
        true
    }

    /// Directions to balls side by side, and where they are in the table.
    #[inline(always)]
    fn located<S: Simd>(
        &self,
        simd: S,
        (chart, division): (&impl Coordinates, &impl Search),
        displacement: &LaneVector<S>,
        cage: CageAngle,
        azimuths: &Azimuths,
    ) -> (Directions<S>, Located<S>) {
        let directions = azimuths.turned(simd, cage);
        let axial = directions.axial(self.free_axial, displacement, self.arm);
        let radial = directions.radial(self.free_radial, displacement);
        (
            directions,
            BallTable::<COUPLE>::locate(chart, division, axial, radial),
        )
    }

    /// Adds what balls bear at their places.
    #[inline(always)]
    fn add_forces<S: Simd>(
        &self,
        directions: &Directions<S>,
        place: &Located<S>,
        sums: &mut LaneSums<S>,
    ) {
        let balls = self.table.forces_at(place);
        // over the arm, as the sums take it
        let moment = if COUPLE {
            balls.axial + balls.couple / self.arm
        } else {
            balls.axial
        };
        sums.add(directions, [balls.radial, balls.axial, moment]);
    }

    /// The same with a known chart and division. Where a ball is in the table takes long to find out, one step
    /// waiting for the other: some balls are looked up before the forces of those before them are found. The sums
    /// stay where they are handed in: the balls leave no registers for them.
    #[inline(always)]
    fn add_by<S: Simd>(
        &self,
        simd: S,
        places: (&impl Coordinates, &impl Search),
        displacement: &LaneVector<S>,
        cage: CageAngle,
        sums: &mut LaneSums<S>,
    ) {
        let Some((first, others)) = self.lanes.split_first() else {
            return;
        };
        let mut ahead = self.located(simd, places, displacement, cage, first);
        for azimuths in others {
            let (directions, place) = ahead;
            ahead = self.located(simd, places, displacement, cage, azimuths);
            self.add_forces(&directions, &place, sums);
        }
        let (directions, place) = ahead;
        self.add_forces(&directions, &place, sums);
    }
}

#[cfg(test)]
mod tests {
    use fearless_simd::{Level, SimdBase, dispatch};

    use super::*;
    use crate::bearing::{
        BallRegion, Bearing, FreePosition, Geometry, HertzFilmLaw, JonesLaw, Oil, Vector5,
        catalogue,
    };
    use crate::physics::RaceControl;

    const SPEED: f64 = 1000.0;

    fn bearing() -> Bearing {
        catalogue::find("7205C").unwrap().bearing().unwrap()
    }

    /// A ring of so many small balls under the table of a law of a 7205C, about an axial displacement and as
    /// far radially as given in m.
    fn ring<L: BallLaw + Clone>(
        law: &L,
        balls: usize,
        [pressed, far]: [f64; 2],
    ) -> Ring<TableLaw<L, false>> {
        let own = bearing().geometry;
        let around = |middle: f64, half: f64| [middle - half, middle + half];
        let region = BallRegion {
            axial: around(own.free_axial() + pressed, 8e-6),
            radial: around(own.free_radial(), far),
        };
        let (table, _) = TableLaw::compile(law.clone(), region, SPEED, 300.0, 1e-9).unwrap();
        let free = FreePosition::ContactAngle(15f64.to_radians());
        let geometry = Geometry::new(balls, 4e-3, 38.5e-3, free, 0.525, 0.525).unwrap();
        let mut ring = Ring::new(&geometry, 0.1, table);
        (ring.free_axial, ring.free_radial) = (own.free_axial(), own.free_radial());
        ring
    }

    fn by_table<L: BallLaw>(
        ring: &Ring<TableLaw<L, false>>,
        level: Level,
        place: &Vector5,
        cage: CageAngle,
    ) -> Option<Vector5> {
        dispatch!(level, simd => {
            let mut sums = LaneSums::new(simd);
            let place = place.map(|number| SimdBase::splat(simd, number));
            ring.tabled()
                .add(simd, &place, cage, SPEED, &mut sums)
                .then(|| sums.force(ring.arm))
        })
    }

    fn check_together_and_one_by_one<L: BallLaw + Clone>(law: &L, size: [f64; 2], lifts: bool) {
        let cage = CageAngle::new(0.7);
        let [pressed, far] = size;
        for balls in [3, 12, 21] {
            let ring = ring(law, balls, size);
            let chart = &ring.law().table().chart;
            assert_eq!(matches!(chart, Chart::Lifting(_)), lifts);
            let place = [6e-6, -8e-6, pressed, 8e-5, -1e-4];
            let expected = ring.force(&place, cage, SPEED);
            for level in [Level::new(), Level::baseline()] {
                assert_eq!(by_table(&ring, level, &place, cage), Some(expected));
            }
            for outside in [
                [6e-6, -8e-6, pressed + 20e-6, 0.0, 0.0],
                [0.8 * far, -0.8 * far, pressed, 0.0, 0.0],
                [0.0, 0.0, pressed, 5e-4, 0.0],
                [f64::NAN, 0.0, pressed, 0.0, 0.0],
            ] {
                assert_eq!(by_table(&ring, Level::new(), &outside, cage), None);
            }
        }
    }

    #[test]
    fn loaded_balls_looked_up_together_bear_what_they_bear_one_by_one() {
        let law = JonesLaw::new(&bearing(), RaceControl::Outer).unwrap();
        check_together_and_one_by_one(&law, [30e-6, 12e-6], false);
    }

    #[test]
    fn balls_that_lift_off_do_so_too() {
        let oil = Oil {
            viscosity: 0.04,
            pressure_viscosity: 2.2e-8,
        };
        let law = HertzFilmLaw::new(&bearing(), oil, SPEED).unwrap();
        check_together_and_one_by_one(&law, [10e-6, 20e-6], true);
    }
}
