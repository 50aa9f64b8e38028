//! Place of a ball between its races: damped Newton from an explicit start.

use nalgebra::Vector2;

use super::balance::{Balance, Ball};
use super::plane::{apply, inverse, square};
use crate::bearing::contact_spring::ContactSpring;

/// Trial positions after which a solve ends with what it has.
pub(super) const MOST_TRIALS: usize = 200;

/// A ball at rest.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(super) struct Rest {
    pub(super) balance: Balance,
    /// Number of trial positions that it took.
    pub(super) trials: usize,
}

impl Ball {
    /// Balance at the ball's place of rest.
    ///
    /// Newton's method on the sum of forces. A step that does not lower it is halved; the springs
    /// being convex, their force has no other place where it cannot be lowered.
    #[inline(always)]
    pub(super) fn solve(
        &self,
        groove: Vector2<f64>,
        start: Vector2<f64>,
        springs: &[impl ContactSpring; 2],
        force_scale: f64,
    ) -> Rest {
        let longest = 0.5 * self.free_inner.min(self.free_outer);
        let mut centre = start;
        let mut step = Vector2::new(0.0, 0.0);
        let mut error = f64::INFINITY;
        let mut rest = Rest::default();
        for trials in 1..=MOST_TRIALS {
            let trial = self.balance(groove, centre + step, springs, force_scale);
            if square(trial.residual) < error {
                centre += step;
                error = square(trial.residual);
                rest = Rest {
                    balance: trial,
                    trials,
                };
                let Some(newton) = trial.newton_step() else {
                    break;
                };
                let size = square(newton);
                step = if size > longest * longest {
                    newton * (longest / size.sqrt())
                } else {
                    newton
                };
            } else {
                step *= 0.5;
                if square(step) < f64::EPSILON * f64::EPSILON * square(centre) {
                    break;
                }
            }
        }
        rest
    }
}

impl Balance {
    /// `−J⁻¹ r`; nothing where the residual is round-off already, or no step is defined.
    #[inline(always)]
    fn newton_step(&self) -> Option<Vector2<f64>> {
        let round_off = self.round_off();
        if square(self.residual) <= round_off * round_off {
            return None;
        }
        inverse(&self.slopes().by_centre()).map(|inverse| -apply(&inverse, self.residual))
    }

    /// Residual in N that rounding of lengths and loads alone can leave.
    #[inline(always)]
    pub(super) fn round_off(&self) -> f64 {
        let (inner, outer) = (&self.inner, &self.outer);
        let stiffness = inner.stiffness + outer.stiffness;
        f64::EPSILON * (stiffness * (inner.length + outer.length) + inner.load + outer.load)
    }
}
