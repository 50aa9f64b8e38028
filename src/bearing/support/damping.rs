//! The damping of a mounted bearing's contacts as a force on the shaft.

use super::{Matrix5, Support, Vector5};
use crate::bearing::BearingRotation;
use crate::bearing::law::with_law;
use crate::bearing::ring::quarter_turn;

/// Rate at which the damping of a linear bearing is looked at, m/s: so slow that no contact parts.
const SLOW: f64 = 1e-12;

impl Support {
    /// Whether the contacts of the bearing are damped.
    pub(crate) fn is_damped(&self) -> bool {
        self.damped.is_some()
    }

    /// Force as by [`Support::force`], and force and moment that move the inner ring at `velocity` against the damping of
    /// the contacts.
    pub(crate) fn damped_force(
        &self,
        displacement: &Vector5,
        velocity: &Vector5,
        rotation: &BearingRotation,
    ) -> [Vector5; 2] {
        let Some(coefficients) = self.damped else {
            return [self.force(displacement, rotation), [0.0; 5]];
        };
        match &self.frozen {
            Some(linear) => [
                linear.force(*displacement),
                (linear.damping * nalgebra::SVector::from(*velocity)).into(),
            ],
            None => {
                let rate = seen_from_cage(displacement, velocity, rotation);
                self.force_at_cage_rate(coefficients, displacement, &rate, rotation)
            }
        }
    }

    /// Derivative of the damping force by the rate, at rest.
    pub(super) fn damping_at(&self, displacement: &Vector5, rotation: &BearingRotation) -> Matrix5 {
        let mut damping = Matrix5::zeros();
        if let Some(coefficients) = self.damped {
            for column in 0..5 {
                let mut rate = [0.0; 5];
                rate[column] = SLOW;
                let [_, force] =
                    self.force_at_cage_rate(coefficients, displacement, &rate, rotation);
                damping.set_column(column, &(nalgebra::SVector::from(force) / SLOW));
            }
        }
        damping
    }

    /// Both forces at a rate that is seen from the cage.
    fn force_at_cage_rate(
        &self,
        coefficients: [f64; 2],
        displacement: &Vector5,
        rate: &Vector5,
        rotation: &BearingRotation,
    ) -> [Vector5; 2] {
        let (place, rate, follows) = self.followed(displacement, rate, rotation);
        let motion = [&place, &rate];
        let [elastic, damping] = with_law!(&self.law, law => self.ring.damped_force(law, coefficients, motion, rotation));
        match follows {
            None => [elastic, damping],
            // by virtual work
            Some(follows) => {
                let damping = follows.transpose() * nalgebra::SVector::from(damping);
                [elastic, damping.into()]
            }
        }
    }

    /// Place of the inner ring, and its rate as seen from the cage.
    pub(super) fn ring_motion(
        &self,
        [displacement, velocity]: [&Vector5; 2],
        rotation: &BearingRotation,
    ) -> [Vector5; 2] {
        let rate = seen_from_cage(displacement, velocity, rotation);
        let (place, rate, _) = self.followed(displacement, &rate, rotation);
        [place, rate]
    }

    /// Place of the inner ring, its rate, and the derivative of its displacement by that of its place on the shaft, where
    /// that is not the identity; the rates are seen from the cage.
    #[inline(always)]
    fn followed(
        &self,
        displacement: &Vector5,
        rate: &Vector5,
        rotation: &BearingRotation,
    ) -> (Vector5, Vector5, Option<Matrix5>) {
        // a floating ring settles axially, and its rate follows that of the shaft
        let place = self.settled(displacement, rotation);
        let follows = self.seat.follows(|| self.ring_tangent(&place, rotation).1);
        let rate = match &follows {
            None => *rate,
            Some(follows) => (follows * nalgebra::SVector::from(*rate)).into(),
        };
        (place, rate, follows)
    }
}

/// The rate of a displacement in the frame that turns with the cage: `q̇ − ψ̇_c S q`.
fn seen_from_cage(displacement: &Vector5, rate: &Vector5, rotation: &BearingRotation) -> Vector5 {
    let turn = quarter_turn(displacement);
    std::array::from_fn(|axis| rate[axis] - rotation.cage_speed * turn[axis])
}
