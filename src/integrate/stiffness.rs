//! Whether stability, rather than accuracy, holds the steps of an explicit method.

use serde::{Deserialize, Serialize};

use std::sync::atomic::AtomicBool;

use nalgebra::DMatrix;
use nalgebra::linalg::Schur;

use super::block::Block;
use super::problem::Problem;
use super::rosenbrock;
use super::{Method, Settings};

/// Part of the stability limit from which on a step counts as held by it: step sizes swing below it.
const NEAR: f64 = 0.5;
/// How much longer the steps of the implicit method must be to be worth a word.
const WORTH: f64 = 2.0;
/// Length of the implicit method's trial, in steps of the explicit one.
const TRIAL: f64 = 1000.0;
/// Steps that the trial may take: enough to find its step size.
const TRIAL_STEPS: u64 = 50;
/// Sweeps after which the search for eigenvalues gives up.
const SWEEPS: usize = 1000;

/// The trial is over before anybody can wish to stop it.
static GOES_ON: AtomicBool = AtomicBool::new(false);

/// An explicit method whose steps stability holds far below what accuracy asks for.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Stiffness {
    /// Where this was seen, s.
    pub time: f64,
    /// Step size there, s.
    pub step: f64,
    /// Largest eigenvalue of the Jacobian there, 1/s: its product with the step is near the limit of
    /// the method's stability.
    pub eigenvalue: f64,
    /// Step size that [`Method::Rodas`] takes there for the same tolerance, s.
    pub implicit_step: f64,
}

/// Checks for stiffness in a scaled state at a time, where an explicit method that is stable up to
/// `limit` = step × eigenvalue takes steps of size `step`.
///
/// The eigenvalue alone does not tell: a fine tolerance may need the same short steps for accuracy.
/// So the implicit method is tried from here, and it is stiffness only where its steps are longer.
pub(super) fn stiffness(
    block: &Block<'_>,
    limit: f64,
    time: f64,
    scaled: &[f64],
    step: f64,
) -> Option<Stiffness> {
    let Problem {
        system, scaling, ..
    } = block.problem;
    let mut jacobian = DMatrix::zeros(scaled.len(), scaled.len());
    let mut by_time = vec![0.0; scaled.len()];
    system.linearisation(time, &scaling.state(scaled), &mut jacobian, &mut by_time);
    scaling.scale_jacobian(&mut jacobian);
    let held = NEAR * limit * scaling.time / step;
    // no eigenvalue exceeds the norm, which costs nothing
    let norm = jacobian.norm();
    if !norm.is_finite() || norm < held {
        return None;
    }
    let eigenvalue = largest_eigenvalue(jacobian)?;
    if eigenvalue < held {
        return None;
    }
    let implicit_step = implicit_step(block, time, scaled, step);
    (implicit_step >= WORTH * step).then(|| Stiffness {
        time,
        step,
        eigenvalue: eigenvalue / scaling.time,
        implicit_step,
    })
}

fn largest_eigenvalue(matrix: DMatrix<f64>) -> Option<f64> {
    let schur = Schur::try_new(matrix, f64::EPSILON, SWEEPS)?;
    let eigenvalues = schur.complex_eigenvalues();
    eigenvalues
        .iter()
        .map(|value| value.norm())
        .reduce(f64::max)
}

/// Step size, s, that the implicit method settles at when it goes on from here for a while.
fn implicit_step(block: &Block<'_>, time: f64, scaled: &[f64], step: f64) -> f64 {
    let smooth = block.problem.system.next_break(time + step) - time;
    let settings = Settings {
        method: Method::Rodas,
        ..*block.problem.settings
    };
    let trial = Block {
        problem: Problem {
            settings: &settings,
            stop: &GOES_ON,
            ..block.problem
        },
        start: time,
        interval: (TRIAL * step).min(smooth),
        intervals: 1,
        first_step: step,
        steps_left: TRIAL_STEPS,
    };
    rosenbrock::integrate(&trial, scaled).last_step
}
