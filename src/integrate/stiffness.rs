//! Whether stability, rather than accuracy, holds the steps of an explicit method.

use std::sync::atomic::AtomicBool;

use nalgebra::DMatrix;
use nalgebra::linalg::Schur;

use super::problem::Problem;
use super::rosenbrock::RosenbrockStepper;
use super::stepper::{MethodStepper, Start};
use super::{Counters, IntegrateError, Settings};

/// Part of the stability limit from which on a step counts as held by it: step sizes vary below it.
const NEAR: f64 = 0.5;
/// How much longer the steps of the implicit method must be to be worth a word.
const WORTH: f64 = 2.0;
/// Length of the implicit method's trial, in steps of the explicit one.
const TRIAL: f64 = 1000.0;
/// Steps that the trial may take: enough to find its step size.
const TRIAL_STEPS: u64 = 50;
/// Sweeps after which the search for eigenvalues gives up.
const SWEEPS: usize = 1000;

/// The trial is over before anybody can stop it.
static GOES_ON: AtomicBool = AtomicBool::new(false);

/// An explicit method whose steps stability holds far below what accuracy asks for.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Stiffness {
    /// Where this was seen, s.
    pub time: f64,
    /// Step size there, s.
    pub step: f64,
    /// Largest eigenvalue of the Jacobian there, 1/s: its product with the step is near the limit of
    /// the method's stability.
    pub eigenvalue: f64,
    /// Step size that [`Method::Rodas`](super::Method::Rodas) takes there for the same tolerance, s.
    pub implicit_step: f64,
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

/// Checks for stiffness in a deviation from the origin at a time, where an explicit method that is stable up to
/// `limit` = step × eigenvalue takes steps of size `step`.
///
/// The eigenvalue alone does not tell: a fine tolerance may need the same short steps for accuracy.
/// So the implicit method is tried from here, and it is stiffness only where its steps are longer.
pub(super) fn stiffness(
    problem: &Problem<'_>,
    limit: f64,
    time: f64,
    deviation: &[f64],
    step: f64,
) -> Option<Stiffness> {
    let states = deviation.len();
    let (mut jacobian, mut by_time) = (DMatrix::zeros(states, states), vec![0.0; states]);
    let mut state = by_time.clone();
    problem.write_state(deviation, &mut state);
    let system = problem.system;
    system.linearisation(time, &state, &mut jacobian, &mut by_time);
    problem.scaling.scale_jacobian(&mut jacobian);
    let held = NEAR * limit / step;
    // no eigenvalue exceeds the norm, which costs nothing
    let norm = jacobian.norm();
    if !norm.is_finite() || norm < held {
        return None;
    }
    let eigenvalue = largest_eigenvalue(jacobian)?;
    if eigenvalue < held {
        return None;
    }
    let implicit_step = implicit_step(problem, time, deviation, step);
    (implicit_step >= WORTH * step).then_some(Stiffness {
        time,
        step,
        eigenvalue,
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
fn implicit_step(problem: &Problem<'_>, time: f64, deviation: &[f64], step: f64) -> f64 {
    let trial = Problem {
        settings: Settings {
            step_limit: TRIAL_STEPS,
            ..problem.settings
        },
        stop: &GOES_ON,
        pace: None,
        end: (time + TRIAL * step).min(problem.system.next_break(time + step)),
        ..problem.clone()
    };
    let start = Start {
        time,
        deviation: deviation.to_vec(),
        step,
        counters: Counters::default(),
    };
    let mut stepper = RosenbrockStepper::new(&trial, &start);
    while stepper.time() < trial.end && stepper.step(&trial).is_ok() {}
    stepper.step_size()
}
