//! Where the balls of a ring stand about their lift-off.

use super::BallLaw;
use super::ring::{CageAngle, Ring, Vector5};

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
}

impl<L: BallLaw> Ring<L> {
    /// The balls about their lift-off.
    pub(super) fn lift_offs(
        &self,
        displacement: &Vector5,
        cage: CageAngle,
        speed: f64,
    ) -> LiftOffs {
        let mut seen = LiftOffs::NONE;
        let balls = self.placed(*displacement, cage).take(MOST_BALLS);
        for (index, ball) in balls.enumerate() {
            let past = self.law().past_lift_off(ball.axial, ball.radial, speed);
            seen.pressed |= u128::from(past.is_sign_positive()) << index;
            seen.nearest = seen.nearest.min(past.abs());
        }
        seen
    }

    /// How far a ball is pressed past its lift-off, m; infinite for one that the ring does not have.
    pub(super) fn past_lift_off(
        &self,
        ball: usize,
        displacement: &Vector5,
        cage: CageAngle,
        speed: f64,
    ) -> f64 {
        let placed = self.placed(*displacement, cage).nth(ball);
        placed.map_or(f64::INFINITY, |ball| {
            self.law().past_lift_off(ball.axial, ball.radial, speed)
        })
    }
}
