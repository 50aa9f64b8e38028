//! Whether stability, rather than accuracy, holds the steps of an explicit method.

use nalgebra::DMatrix;

use super::IntegrateError;
use super::problem::Problem;
use super::stepper::Reached;
use crate::numerics::eigenvectors::largest_eigenvalue;

/// Part of the stability limit from which on a step counts as held by it: step sizes vary below it.
const NEAR: f64 = 0.5;

/// An explicit method whose steps are as long as its stability allows.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Stiffness {
    /// Where this was seen, s.
    pub time: f64,
    /// Step size there, s.
    pub step: f64,
    /// Largest eigenvalue of the Jacobian there, 1/s: its product with the step is near the limit of
    /// the method's stability.
    pub eigenvalue: f64,
}

/// Part of the limit on steps after which a run is checked for stiffness that keeps it from its end, time and again.
const EARLY: f64 = 0.01;

/// Whether a run that went from so many steps to so many is to be checked for stiffness that keeps it from its end.
pub(super) fn is_check_due(problem: &Problem<'_>, before: u64, now: u64) -> bool {
    let part = ((EARLY * problem.settings.step_limit as f64) as u64).max(1);
    before / part != now / part
}

impl Stiffness {
    /// The error that ends a run after so many steps: none where the limit on them lets it come to its end.
    pub(super) fn ending(self, problem: &Problem<'_>, steps: u64) -> Option<IntegrateError> {
        let left = (problem.end - self.time).max(0.0);
        let (needed, limit) = (steps as f64 + left / self.step, problem.settings.step_limit);
        (needed > limit as f64).then_some(IntegrateError::Stiff {
            stiffness: self,
            needed,
            limit,
        })
    }
}

/// The stiffness where an explicit method has come to that is stable up to `limit` = step × eigenvalue; none where its
/// steps are shorter than that.
pub(super) fn stiffness(
    problem: &Problem<'_>,
    limit: f64,
    &Reached {
        time,
        deviation,
        step,
        ..
    }: &Reached<'_>,
) -> Option<Stiffness> {
    let states = deviation.len();
    let (mut jacobian, mut state) = (DMatrix::zeros(states, states), vec![0.0; states]);
    problem.write_state(deviation, &mut state);
    let system = problem.system;
    system.linearisation(time, &state, &mut jacobian);
    problem.scaling.scale_jacobian(&mut jacobian);
    let held = NEAR * limit / step;
    // no eigenvalue exceeds the norm, which costs nothing
    let norm = jacobian.norm();
    if !norm.is_finite() || norm < held {
        return None;
    }
    let eigenvalue = largest_eigenvalue(jacobian)?;
    (eigenvalue >= held).then_some(Stiffness {
        time,
        step,
        eigenvalue,
    })
}
