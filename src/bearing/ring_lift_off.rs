//! Where the balls of a ring stand about their lift-off.

use fearless_simd::{Simd, SimdFloat, dispatch};

use super::ring::{CageAngle, Ring, Vector5};
use super::ring_lanes::side_by_side;
use super::{BallLaw, HertzLaw, LANES};

/// Balls that a set of bits has room for.
const MOST_BALLS: usize = u128::BITS as usize;

/// The balls of a bearing about the places where they leave the inner race.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct LiftOffs {
    /// A bit for every ball that is pressed, the lowest for ball 0.
    pub pressed: u128,
    /// Least distance of a ball from its lift-off, m.
    pub nearest: f64,
}

impl LiftOffs {
    /// No ball lifts off.
    pub const NONE: Self = Self {
        pressed: 0,
        nearest: f64::INFINITY,
    };

    /// Of balls so far past their lift-off in m, ball 0 first.
    pub(super) fn of(past_lift_off: impl Iterator<Item = f64>) -> Self {
        let mut seen = Self::NONE;
        for (ball, past) in past_lift_off.take(MOST_BALLS).enumerate() {
            seen.pressed |= u128::from(past.is_sign_positive()) << ball;
            seen.nearest = seen.nearest.min(past.abs());
        }
        seen
    }
}

impl<L: BallLaw> Ring<L> {
    /// The balls about their lift-off.
    pub(super) fn lift_offs(
        &self,
        displacement: &Vector5,
        cage: CageAngle,
        speed: f64,
    ) -> LiftOffs {
        let balls = self.placed(*displacement, cage);
        LiftOffs::of(balls.map(|ball| self.law().past_lift_off(ball.axial, ball.radial, speed)))
    }

    /// How far a ball is pressed past its lift-off, m; infinite for one that the ring does not have.
    pub(super) fn past_lift_off(
        &self,
        ball: usize,
        displacement: &Vector5,
        cage: CageAngle,
        speed: f64,
    ) -> f64 {
        if ball >= self.azimuths.len() {
            return f64::INFINITY;
        }
        let placed = self.placed_ball(ball, displacement, cage);
        self.law().past_lift_off(placed.axial, placed.radial, speed)
    }
}

impl Ring<HertzLaw> {
    /// As [`Ring::lift_offs`], balls side by side: to the same bytes.
    pub(super) fn series_lift_offs(&self, displacement: &Vector5, cage: CageAngle) -> LiftOffs {
        dispatch!(self.level, simd => self.series_lift_offs_by(simd, displacement, cage))
    }

    #[inline(always)]
    fn series_lift_offs_by<S: Simd>(
        &self,
        simd: S,
        displacement: &Vector5,
        cage: CageAngle,
    ) -> LiftOffs {
        let displacement = &side_by_side(simd, displacement);
        let mut seen = LiftOffs::NONE;
        let groups = self.lanes.iter().zip(self.azimuths.chunks(LANES));
        for (group, (azimuths, balls)) in groups.enumerate().take(MOST_BALLS / LANES) {
            let directions = azimuths.turned(simd, cage);
            let axial = directions.axial(self.free_axial, displacement, self.arm);
            let radial = directions.radial(self.free_radial, displacement);
            let past = (axial * axial + radial * radial).sqrt() - self.law().distance;
            let mut pressed = 0;
            for (lane, past) in past.iter().enumerate().take(balls.len()) {
                pressed |= u8::from(past.is_sign_positive()) << lane;
                seen.nearest = seen.nearest.min(past.abs());
            }
            seen.pressed |= u128::from(pressed) << (LANES * group);
        }
        seen
    }

    /// Approach, m, that no ball has less of with the inner ring at a displacement, wherever the cage stands;
    /// negative where that is not certain.
    ///
    /// A distance is no shorter than its part along any direction, here along that to the mean (a, b) of all
    /// inner groove centres:
    ///
    /// ```text
    /// A1 = a + R_i (θx sin φ − θy cos φ)   A2 = b + x cos φ + y sin φ   c = √(a² + b²)
    /// √(A1² + A2²) ≥ (a A1 + b A2)/c ≥ c − |(b x − a R_i θy, b y + a R_i θx)|/c
    /// ```
    pub(super) fn least_approach(&self, [x, y, z, tilt_x, tilt_y]: &Vector5) -> f64 {
        let [axial, radial] = [self.free_axial + z, self.free_radial];
        let [arm_x, arm_y] = [self.arm * tilt_x, self.arm * tilt_y];
        let square = axial * axial + radial * radial;
        let [lean_x, lean_y] = [radial * x - axial * arm_y, radial * y + axial * arm_x];
        let lean = (lean_x * lean_x + lean_y * lean_y).sqrt();
        (square - lean) / square.sqrt() - self.law().distance
    }

    /// Axial distance of the groove centres, m, that no ball has less of there.
    pub(super) fn least_axial(&self, [_, _, z, tilt_x, tilt_y]: &Vector5) -> f64 {
        self.free_axial + z - self.arm * (tilt_x * tilt_x + tilt_y * tilt_y).sqrt()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::bearing::{FreePosition, Geometry};

    /// Thirteen balls, of which none, some or all are pressed.
    #[test]
    fn balls_side_by_side_stand_where_each_does() {
        let free = FreePosition::ContactAngle(0.26);
        let geometry = Geometry::new(13, 7.938e-3, 38.5e-3, free, 0.52, 0.53).expect("a bearing");
        let law = HertzLaw {
            load_deflection_constant: 4.4e9,
            distance: geometry.groove_centre_distance(),
        };
        let (ring, cage) = (Ring::new(&geometry, 0.3, law), CageAngle::new(0.7));
        let mut counts = Vec::new();
        for place in [
            [2e-6, -3e-6, 30e-6, 1e-5, 2e-5],
            [40e-6, 10e-6, 0.0, 0.0, 1e-4],
            [0.0, 0.0, -30e-6, 0.0, 0.0],
        ] {
            let found = ring.series_lift_offs(&place, cage);
            assert_eq!(found, ring.lift_offs(&place, cage, 0.0));
            counts.push(found.pressed.count_ones());
        }
        assert!(
            counts[0] == 13 && (1..13).contains(&counts[1]) && counts[2] == 0,
            "{counts:?}"
        );
    }
}
