//! Place of a ball between its races: damped Newton from an explicit start.

use nalgebra::{Matrix2, Vector2};

use super::balance::{Balance, Ball};
use crate::bearing::contact_spring::ContactSpring;

/// Newton steps after which a solve ends with what it has.
pub(super) const MOST_STEPS: usize = 60;

impl Ball {
    /// Balance at the ball's place of rest, and the number of trial positions that it took.
    #[inline]
    pub(super) fn solve(
        &self,
        groove: Vector2<f64>,
        start: Vector2<f64>,
        springs: &[impl ContactSpring; 2],
        force_scale: f64,
    ) -> (Balance, usize) {
        let mut centre = start;
        let mut balance = self.balance(groove, centre, springs, force_scale);
        let mut trials = 1;
        for _ in 0..MOST_STEPS {
            let error = balance.residual.norm();
            if error <= balance.round_off() {
                break;
            }
            let Some(mut step) = newton_step(&balance) else {
                break;
            };
            let room = 0.5 * self.free_inner.min(self.free_outer);
            let length = step.norm();
            if length > room {
                step *= room / length;
            }
            let mut improved = false;
            for _ in 0..30 {
                let trial = self.balance(groove, centre + step, springs, force_scale);
                trials += 1;
                if trial.residual.norm() < error {
                    improved = true;
                    centre += step;
                    balance = trial;
                    break;
                }
                step *= 0.5;
                if step.norm() <= f64::EPSILON * centre.norm() {
                    break;
                }
            }
            if !improved {
                break;
            }
        }
        (balance, trials)
    }
}

/// −J⁻¹ r
#[inline]
fn newton_step(balance: &Balance) -> Option<Vector2<f64>> {
    let jacobian: Matrix2<f64> = balance.jacobian();
    jacobian
        .try_inverse()
        .map(|inverse| -(inverse * balance.residual))
}

impl Balance {
    /// Residual in N that rounding of the groove distances alone can leave.
    #[inline]
    pub(super) fn round_off(&self) -> f64 {
        let (inner, outer) = (&self.inner, &self.outer);
        f64::EPSILON
            * (inner.stiffness * inner.direction.length
                + outer.stiffness * outer.direction.length
                + inner.load
                + outer.load)
    }
}
