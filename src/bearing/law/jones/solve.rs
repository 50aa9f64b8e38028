//! Place of a ball between its races: damped Newton from an explicit start.

use super::balance::{Balance, Ball, Positions, apply, inverse};
use super::contact::Plane;
use crate::bearing::law::ContactSpring;
use crate::bearing::number::Dual;

/// Trial positions after which a solve ends with what it has.
pub(super) const MOST_TRIALS: usize = 200;

/// Step, over the approaches, of which the forces are linear to round-off.
const LINEAR: f64 = 1e-9;

/// A ball at rest.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Rest {
    pub(super) positions: Positions,
    pub(super) balance: Balance<f64>,
    /// Number of trial positions that it took.
    pub(super) trials: usize,
}

impl Ball {
    /// Balance at the ball's place of rest, from a start of its centre.
    ///
    /// Newton's method on the sum of forces r. A step is halved until the next one, with the same
    /// slopes, is shorter: the natural monotonicity test, which measures the error in metres and
    /// so is not misled by contacts that are stiff along their normal and soft across it.
    ///
    /// Source: P. Deuflhard, *Newton Methods for Nonlinear Problems* (2004), sec. 3.3.
    #[inline(always)]
    pub(super) fn solve(
        &self,
        start: Positions,
        springs: &[impl ContactSpring; 2],
        force_scale: f64,
    ) -> Rest {
        let (mut positions, mut trials) = (start, 1);
        let mut balance = self.linearised(&start, springs, force_scale);
        let ended = |positions, balance: Balance<Dual<f64, 2>>, step, trials| Rest {
            positions,
            balance: balance.moved(step),
            trials,
        };
        while trials < MOST_TRIALS
            && let Some(inverse) = balance.slopes_inverse()
        {
            let centre = positions.centre;
            let mut step = apply(&inverse, balance.residual.map(|part| -part.value));
            let newton = square(step);
            if newton <= balance.linear_step() {
                // the next trial would say no more than the slopes
                positions.centre = [centre[0] + step[0], centre[1] + step[1]];
                return ended(positions, balance, step, trials);
            }
            let longest = self.longest_step(&balance);
            if newton > longest {
                let part = (longest / newton).sqrt();
                step = step.map(|step| part * step);
            }
            loop {
                let trial = Positions {
                    centre: [centre[0] + step[0], centre[1] + step[1]],
                    ..positions
                };
                let tried = self.linearised(&trial, springs, force_scale);
                trials += 1;
                let next = square(apply(&inverse, tried.residual.map(|part| part.value)));
                if next < newton {
                    (positions, balance) = (trial, tried);
                    break;
                }
                let is_round_off = square(step) <= f64::EPSILON * f64::EPSILON * square(centre);
                if is_round_off || trials >= MOST_TRIALS {
                    return ended(positions, balance, [0.0; 2], trials);
                }
                step = step.map(|step| 0.5 * step);
            }
        }
        ended(positions, balance, [0.0; 2], trials)
    }

    /// Balance in some positions with slopes by the ball's centre.
    #[inline(always)]
    fn linearised(
        &self,
        positions: &Positions,
        springs: &[impl ContactSpring; 2],
        force_scale: f64,
    ) -> Balance<Dual<f64, 2>> {
        let Positions {
            centre: [x, y],
            groove,
            drop,
        } = *positions;
        let positions = Positions {
            centre: [Dual::variable(x, 0), Dual::variable(y, 1)],
            groove: groove.map(Dual::fixed),
            drop: drop.map(Dual::fixed),
        };
        self.balance(&positions, springs, None, force_scale)
    }

    /// Square of the step in m² whose sagitta is as large as the present approaches: a longer one
    /// leaves the slopes it was computed from.
    #[inline(always)]
    fn longest_step(&self, balance: &Balance<Dual<f64, 2>>) -> f64 {
        let approach = balance.inner.approach.value.abs() + balance.outer.approach.value.abs();
        4.0 * self.free_inner.min(self.free_outer) * approach
    }
}

impl Balance<Dual<f64, 2>> {
    /// The balance with the ball's centre moved by a short step in m.
    #[inline(always)]
    fn moved(&self, [x, y]: Plane<f64>) -> Balance<f64> {
        self.map(|part| part.value + (part.slopes[0] * x + part.slopes[1] * y))
    }

    /// Square of the longest step in m² over which everything is linear to round-off.
    #[inline(always)]
    fn linear_step(&self) -> f64 {
        let approaches = [&self.inner, &self.outer].map(|contact| contact.approach.value.abs());
        (LINEAR * approaches[0].min(approaches[1])).powi(2)
    }

    /// `(∂r/∂X)⁻¹`; nothing where the residual is round-off already, or there is none.
    #[inline(always)]
    fn slopes_inverse(&self) -> Option<[Plane<f64>; 2]> {
        let round_off = self.round_off();
        if square(self.residual.map(|part| part.value)) <= round_off * round_off {
            return None;
        }
        inverse(&self.residual.map(|part| part.slopes))
    }

    /// Residual in N that rounding of lengths and loads alone can leave.
    #[inline(always)]
    pub(super) fn round_off(&self) -> f64 {
        let (inner, outer) = (&self.inner, &self.outer);
        let stiffness = inner.stiffness + outer.stiffness;
        let length = inner.length.value + outer.length.value;
        f64::EPSILON * (stiffness * length + inner.load.value + outer.load.value)
    }
}

/// `|x|²`
#[inline(always)]
pub(super) fn square([x, y]: Plane<f64>) -> f64 {
    x * x + y * y
}
