//! Place of a ball between its races: damped Newton from an explicit start.

use nalgebra::{Matrix2, Vector2};

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
    /// Newton's method on the sum of forces r. A step is halved until the next one, with the same
    /// slopes, is shorter: the natural monotonicity test, which measures the error in metres and
    /// so is not misled by contacts that are stiff along their normal and soft across it.
    ///
    /// Source: P. Deuflhard, *Newton Methods for Nonlinear Problems* (2004), sec. 3.3.
    #[inline(always)]
    pub(super) fn solve(
        &self,
        groove: Vector2<f64>,
        start: Vector2<f64>,
        springs: &[impl ContactSpring; 2],
        force_scale: f64,
    ) -> Rest {
        let mut centre = start;
        let mut step = Vector2::new(0.0, 0.0);
        let mut slopes_inverse = Matrix2::zeros();
        let mut longest_next = f64::INFINITY;
        let mut rest = Rest::default();
        for trials in 1..=MOST_TRIALS {
            let trial = self.balance(groove, centre + step, springs, force_scale);
            let next = square(apply(&slopes_inverse, trial.residual));
            if next < longest_next {
                centre += step;
                rest = Rest {
                    balance: trial,
                    trials,
                };
                let Some(inverse) = trial.slopes_inverse() else {
                    break;
                };
                slopes_inverse = inverse;
                step = -apply(&inverse, trial.residual);
                longest_next = square(step);
                let longest = self.longest_step(&trial);
                if longest_next > longest {
                    step *= (longest / longest_next).sqrt();
                }
            } else if square(step) > f64::EPSILON * f64::EPSILON * square(centre) {
                step *= 0.5;
            } else {
                break;
            }
        }
        rest
    }

    /// Square of the step in m² whose sagitta is as large as the present approaches: a longer one
    /// leaves the slopes it was computed from.
    #[inline(always)]
    fn longest_step(&self, balance: &Balance) -> f64 {
        let (inner, outer) = (&balance.inner, &balance.outer);
        let approach =
            (inner.length - self.free_inner).abs() + (outer.length - self.free_outer).abs();
        4.0 * self.free_inner.min(self.free_outer) * approach
    }
}

impl Balance {
    /// `(∂r/∂X)⁻¹`; nothing where the residual is round-off already, or there is none.
    #[inline(always)]
    fn slopes_inverse(&self) -> Option<Matrix2<f64>> {
        let round_off = self.round_off();
        if square(self.residual) <= round_off * round_off {
            return None;
        }
        inverse(&self.slopes().by_centre())
    }

    /// Residual in N that rounding of lengths and loads alone can leave.
    #[inline(always)]
    pub(super) fn round_off(&self) -> f64 {
        let (inner, outer) = (&self.inner, &self.outer);
        let stiffness = inner.stiffness + outer.stiffness;
        f64::EPSILON * (stiffness * (inner.length + outer.length) + inner.load + outer.load)
    }
}
