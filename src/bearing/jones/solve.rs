//! Place of a ball between its races: damped Newton from an explicit start.

use nalgebra::Vector2;

use super::balance::{Balance, Ball};
use super::plane::{apply, inverse, square};
use crate::bearing::contact_spring::ContactSpring;

/// Newton steps after which a solve ends with what it has.
const MOST_STEPS: usize = 60;
/// Halvings of a step after which it cannot matter any more.
const MOST_HALVINGS: usize = 30;

impl Ball {
    /// Balance at the ball's place of rest, and the number of trial positions that it took.
    ///
    /// Newton's method on the sum of forces. A step that does not lower it is halved; the
    /// springs being convex, their force has no other place where it cannot be lowered.
    #[inline]
    pub(super) fn solve(
        &self,
        groove: Vector2<f64>,
        start: Vector2<f64>,
        springs: &[impl ContactSpring; 2],
        force_scale: f64,
    ) -> (Balance, usize) {
        let longest = 0.5 * self.free_inner.min(self.free_outer);
        let mut centre = start;
        let mut balance = self.balance(groove, centre, springs, force_scale);
        let mut trials = 1;
        for _ in 0..MOST_STEPS {
            let Some(mut step) = balance.newton_step() else {
                break;
            };
            let length = square(step).sqrt();
            if length > longest {
                step *= longest / length;
            }
            let error = square(balance.residual);
            let mut better = None;
            for _ in 0..MOST_HALVINGS {
                let trial = self.balance(groove, centre + step, springs, force_scale);
                trials += 1;
                if square(trial.residual) < error {
                    better = Some(trial);
                    break;
                }
                step *= 0.5;
            }
            let Some(trial) = better else {
                break;
            };
            centre += step;
            balance = trial;
        }
        (balance, trials)
    }
}

impl Balance {
    /// `−J⁻¹ r`; nothing where the residual is round-off already, or no step is defined.
    #[inline]
    fn newton_step(&self) -> Option<Vector2<f64>> {
        let jacobian = self.slopes().by_centre();
        // what rounding of the distances alone can leave
        let (inner, outer) = (&self.inner, &self.outer);
        let stiffness = jacobian.m11.abs().max(jacobian.m22.abs());
        let round_off = f64::EPSILON
            * (stiffness * (inner.length + outer.length) + inner.load + outer.load);
        if square(self.residual) <= round_off * round_off {
            return None;
        }
        inverse(&jacobian).map(|inverse| -apply(&inverse, self.residual))
    }

    /// As `newton_step` measures it.
    pub(super) fn round_off(&self) -> f64 {
        let jacobian = self.slopes().by_centre();
        let (inner, outer) = (&self.inner, &self.outer);
        let stiffness = jacobian.m11.abs().max(jacobian.m22.abs());
        f64::EPSILON * (stiffness * (inner.length + outer.length) + inner.load + outer.load)
    }
}
