//! The ring sum of balls whose law is a table.

use fearless_simd::Simd;

use super::ring_lanes::{Azimuths, Directions, LaneSums, LaneVector};
use super::ring_lift_off::LiftOffs;
use super::table::Located;
use super::{BallTable, CageAngle, Matrix5, Ring, Vector5};

impl Ring<BallTable> {
    /// Whether the table covers every ball of the ring at a displacement, wherever the cage stands.
    #[inline(always)]
    pub(super) fn is_covered(&self, displacement: &Vector5, speed: f64) -> bool {
        let [x, y, z, tilt_x, tilt_y] = *displacement;
        let tilt = self.arm * self.arm * (tilt_x * tilt_x + tilt_y * tilt_y);
        let axial = [self.free_axial + z, tilt];
        let radial = [self.free_radial, x * x + y * y];
        self.law().covers_around(axial, radial, speed)
    }

    /// As the force of a ring by its law, the table covering all balls. To find a ball in the table takes long, one step
    /// waiting for the other: those side by side are looked up before the forces of those before them are worked out.
    #[inline(always)]
    pub(super) fn table_force<S: Simd>(
        &self,
        simd: S,
        displacement: &LaneVector<S>,
        cage: CageAngle,
    ) -> Vector5 {
        let mut sums = LaneSums::new(simd);
        let Some(first) = self.lanes.first() else {
            return [0.0; 5];
        };
        let mut ahead = self.located(simd, displacement, cage, first);
        for next in 1..=self.lanes.len() {
            let (directions, place) = ahead;
            if let Some(azimuths) = self.lanes.get(next) {
                ahead = self.located(simd, displacement, cage, azimuths);
            }
            self.add(&directions, &place, &mut sums);
        }
        sums.force(self.arm)
    }

    /// Directions to balls side by side, and where they are in the table.
    #[inline(always)]
    fn located<S: Simd>(
        &self,
        simd: S,
        displacement: &LaneVector<S>,
        cage: CageAngle,
        azimuths: &Azimuths,
    ) -> (Directions<S>, Located<S>) {
        let directions = azimuths.turned(simd, cage);
        let axial = directions.axial(self.free_axial, displacement, self.arm);
        let radial = directions.radial(self.free_radial, displacement);
        (directions, self.law().locate(axial, radial))
    }

    /// Adds what balls bear at their places.
    #[inline(always)]
    fn add<S: Simd>(&self, directions: &Directions<S>, place: &Located<S>, sums: &mut LaneSums<S>) {
        let table = self.law();
        let balls = table.forces(place);
        // over the arm, as the sums take it
        let moment = if table.has_couple() {
            balls.axial + balls.couple / self.arm
        } else {
            balls.axial
        };
        sums.add(directions, [balls.radial, balls.axial, moment]);
    }

    /// Force and its derivative, the table covering all balls.
    pub(super) fn table_stiffness(
        &self,
        displacement: &Vector5,
        cage: CageAngle,
    ) -> (Vector5, Matrix5) {
        self.assemble(displacement, cage, |axial, radial| {
            self.law().force_and_tangent(axial, radial)
        })
    }

    /// The balls about the table's line of lift-off.
    pub(super) fn table_lift_offs(&self, displacement: &Vector5, cage: CageAngle) -> LiftOffs {
        let balls = self.placed(*displacement, cage);
        LiftOffs::of(balls.map(|ball| self.law().past_lift_off(ball.axial, ball.radial)))
    }

    /// How far a ball of the ring is pressed past it, m.
    pub(super) fn table_past_lift_off(
        &self,
        ball: usize,
        displacement: &Vector5,
        cage: CageAngle,
    ) -> f64 {
        let ball = self.placed_ball(ball, displacement, cage);
        self.law().past_lift_off(ball.axial, ball.radial)
    }
}

#[cfg(test)]
mod tests {
    use fearless_simd::{Level, dispatch};

    use super::*;
    use crate::bearing::ring_lanes::side_by_side;
    use crate::bearing::{BallLaw, BallRegion, HertzFilmLaw, JonesLaw, Oil, catalogue};
    use crate::physics::RaceControl;

    const SPEED: f64 = 1000.0;

    /// Sums by every level of the processor, and one ball by one, about an axial displacement and as far radially as
    /// given in m.
    fn check_together_and_one_by_one<L: BallLaw>(law: &L, [pressed, far]: [f64; 2]) {
        let bearing = catalogue::find("7205C").unwrap().bearing().unwrap();
        let geometry = &bearing.geometry;
        let around = |middle: f64, half: f64| [middle - half, middle + half];
        let region = BallRegion {
            axial: around(geometry.free_axial() + pressed, 8e-6),
            radial: around(geometry.free_radial(), far),
        };
        let (table, _) = BallTable::compile(law, region, SPEED, 300.0, 1e-9).unwrap();
        let ring = Ring::new(
            geometry,
            0.1,
            JonesLaw::new(&bearing, RaceControl::Outer).unwrap(),
        );
        let ring = ring.under(table);
        let (place, cage) = ([6e-6, -8e-6, pressed, 8e-5, -1e-4], CageAngle::new(0.7));
        assert!(ring.is_covered(&place, SPEED));
        let (one_by_one, _) = ring.table_stiffness(&place, cage);
        let mut sums = [Level::new(), Level::baseline()].into_iter().map(|level| {
            dispatch!(level, simd => ring.table_force(simd, &side_by_side(simd, &place), cage))
        });
        let first = sums.next().unwrap();
        assert_eq!(sums.next(), Some(first));
        for (own, expected) in first.into_iter().zip(one_by_one) {
            assert!((own - expected).abs() < 1e-9, "{own}, {expected}");
        }
        for outside in [
            [6e-6, -8e-6, pressed + 20e-6, 0.0, 0.0],
            [0.8 * far, -0.8 * far, pressed, 0.0, 0.0],
            [0.0, 0.0, pressed, 5e-4, 0.0],
            [f64::NAN, 0.0, pressed, 0.0, 0.0],
        ] {
            assert!(!ring.is_covered(&outside, SPEED));
        }
        assert!(!ring.is_covered(&place, 999.0));
    }

    #[test]
    fn balls_looked_up_together_bear_what_they_bear_one_by_one() {
        let bearing = catalogue::find("7205C").unwrap().bearing().unwrap();
        let loaded = JonesLaw::new(&bearing, RaceControl::Outer).unwrap();
        check_together_and_one_by_one(&loaded, [30e-6, 12e-6]);
        let oil = Oil {
            viscosity: 0.04,
            pressure_viscosity: 2.2e-8,
        };
        let lifting = HertzFilmLaw::new(&bearing, oil, SPEED).unwrap();
        check_together_and_one_by_one(&lifting, [10e-6, 20e-6]);
    }
}
