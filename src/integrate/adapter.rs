//! Dopri5 and Dop853 of `ode_solvers` behind one function: a block of states on a uniform grid.
//!
//! The library is used in a way that keeps clear of its limits in version 0.6:
//! - Dop853 evaluates its last stage at a wrong time; time is therefore carried as one more state.
//! - Its last dense point may be an extrapolation; a block asks for the points before its end only,
//!   and the state at the end is the one that the accepted step was evaluated at.
//! - Its derivative cannot fail; a derivative that is not finite is remembered until a step with a
//!   finite one is accepted, and explains the step-size underflow that follows.
//! - Grid times drift by added round-off; callers rebuild them from the index.
//! - Its own test for stiffness comes once in a thousand steps of one solver, and ends runs that
//!   would end well; it is left out for [`stiffness`], which knows the Jacobian and the limit on
//!   steps.

use std::cell::{Cell, RefCell};
use std::sync::atomic::Ordering;

use ode_solvers::dop_shared::{IntegrationError, OutputType, Stats};
use ode_solvers::{DVector, Dop853, Dopri5, System as LibrarySystem};

use super::block::{Block, Outcome};
use super::rosenbrock::LOCAL_PART;
use super::stiffness::{is_check_due, stiffness};
use super::{Counters, IntegrateError, Method, States};

/// Evaluations after an accepted step's own that dense output may add, and that one itself.
const REMEMBERED: usize = 4;

/// The methods of the library.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum LibraryMethod {
    Dopri5,
    Dop853,
}

impl LibraryMethod {
    /// The method of the library that a method is.
    pub fn of(method: Method) -> Option<Self> {
        match method {
            Method::Dopri5 => Some(Self::Dopri5),
            Method::Dop853 => Some(Self::Dop853),
            _ => None,
        }
    }

    /// Product of step and largest eigenvalue at which the method ceases to be stable, on the
    /// negative real axis.
    ///
    /// Source: Hairer, Nørsett & Wanner, codes DOPRI5 and DOP853, bounds of their tests for stiffness.
    pub fn stability_limit(self) -> f64 {
        match self {
            Self::Dopri5 => 3.25,
            Self::Dop853 => 6.1,
        }
    }
}

/// Integrates a block from a scaled state.
pub(super) fn integrate(method: LibraryMethod, block: &Block<'_>, start: &[f64]) -> Outcome {
    let time_scale = block.problem.scaling.time;
    // the time comes last
    let initial = DVector::from_column_slice(start).push(0.0);
    let recorder = Recorder::new(&initial);
    let bridge = Bridge {
        block,
        recorder: &recorder,
        method,
        state: RefCell::new(start.to_vec()),
    };
    let dx = block.interval / time_scale;
    let end = dx * block.intervals as f64;
    let tolerance = LOCAL_PART * block.problem.settings.tolerance;
    let step_limit = u32::try_from(block.steps_left).unwrap_or(u32::MAX);
    let first_step = (block.first_step / time_scale).min(end);
    macro_rules! solve {
        ($Solver:ident, $beta:expr, $shrink:expr, $grow:expr) => {{
            let mut solver = $Solver::from_param(
                bridge,
                0.0,
                end,
                dx,
                initial,
                tolerance,
                tolerance,
                0.9,
                $beta,
                $shrink,
                $grow,
                end,
                first_step,
                step_limit,
                NO_TEST_FOR_STIFFNESS,
                OutputType::Dense,
            );
            let result = solver.integrate();
            outcome(method, block, &recorder, result, solver.y_out())
        }};
    }
    match method {
        LibraryMethod::Dopri5 => solve!(Dopri5, 0.04, 0.2, 10.0),
        LibraryMethod::Dop853 => solve!(Dop853, 0.0, 0.333, 6.0),
    }
}

/// Accepted steps between two of the library's own tests: none comes so far.
const NO_TEST_FOR_STIFFNESS: u32 = u32::MAX;
fn outcome(
    method: LibraryMethod,
    block: &Block<'_>,
    recorder: &Recorder,
    result: Result<Stats, IntegrationError>,
    dense: &[DVector<f64>],
) -> Outcome {
    let reached = recorder.time(block);
    let last_step = recorder.longest_late_step() * block.problem.scaling.time;
    let rejected = match &result {
        Ok(stats) => u64::from(stats.rejected_steps),
        Err(IntegrationError::MaxNumStepReached { n_step, .. }) => {
            u64::from(*n_step).saturating_sub(recorder.accepted.get())
        }
        Err(_) => 0,
    };
    let error = match result {
        _ if recorder.hopeless.borrow().is_some() => recorder.hopeless.take(),
        _ if recorder.stopped.get() => Some(IntegrateError::Interrupted { time: reached }),
        Ok(_) => None,
        Err(_) if recorder.fault.get() => Some(IntegrateError::NotFinite { time: reached }),
        Err(IntegrationError::MaxNumStepReached { .. }) => Some(
            stiff(method, block, recorder).unwrap_or(IntegrateError::StepLimit {
                time: reached,
                limit: block.problem.settings.step_limit,
            }),
        ),
        // the library does not test for stiffness
        Err(
            IntegrationError::StepSizeUnderflow { .. } | IntegrationError::StiffnessDetected { .. },
        ) => Some(IntegrateError::StepUnderflow {
            time: reached,
            step: last_step,
        }),
    };
    let mut states = States::with_capacity(block.problem.system.states(), block.intervals);
    let finite = |state: &&DVector<f64>| state.iter().all(|value| value.is_finite());
    for state in dense.iter().take(block.intervals).take_while(finite) {
        states.push(without_time(state));
    }
    Outcome {
        states,
        end: without_time(&recorder.end.borrow()).to_vec(),
        last_step,
        counters: Counters {
            steps: recorder.accepted.get(),
            rejected,
            evaluations: recorder.evaluations.get(),
        },
        error,
    }
}

/// The error that ends a run that stability keeps from its end within the limit on steps; none where steps are as long
/// as accuracy allows.
fn stiff(method: LibraryMethod, block: &Block<'_>, recorder: &Recorder) -> Option<IntegrateError> {
    let step = recorder.longest_late_step() * block.problem.scaling.time;
    let (time, end) = (recorder.time(block), recorder.end.borrow());
    let limit = method.stability_limit();
    let deviation = block.problem.scaling.deviation(without_time(&end));
    stiffness(&block.problem, limit, time, &deviation, step)?
        .ending(&block.problem, recorder.steps(block))
}

fn without_time(state: &DVector<f64>) -> &[f64] {
    &state.as_slice()[..state.len() - 1]
}

/// What the solver's calls reveal and its interface does not.
struct Recorder {
    /// Latest evaluations, in a ring.
    evaluated: RefCell<[(f64, DVector<f64>); REMEMBERED]>,
    evaluations: Cell<u64>,
    accepted: Cell<u64>,
    /// State at the end of the latest accepted step.
    end: RefCell<DVector<f64>>,
    end_x: Cell<f64>,
    /// Sizes of the latest accepted steps.
    steps: Cell<[f64; 3]>,
    /// Whether an evaluation since the latest accepted step was not finite.
    fault: Cell<bool>,
    stopped: Cell<bool>,
    /// Why the run will not come to its end.
    hopeless: RefCell<Option<IntegrateError>>,
}

impl Recorder {
    fn new(start: &DVector<f64>) -> Self {
        Self {
            evaluated: RefCell::new(std::array::from_fn(|_| (f64::NAN, start.clone()))),
            evaluations: Cell::new(0),
            accepted: Cell::new(0),
            end: RefCell::new(start.clone()),
            end_x: Cell::new(0.0),
            steps: Cell::new([0.0; 3]),
            fault: Cell::new(false),
            stopped: Cell::new(false),
            hopeless: RefCell::new(None),
        }
    }

    fn evaluated(&self, x: f64, state: &DVector<f64>, finite: bool) {
        let count = self.evaluations.get();
        let (at, kept) = &mut self.evaluated.borrow_mut()[count as usize % REMEMBERED];
        *at = x;
        kept.copy_from(state);
        self.evaluations.set(count + 1);
        if !finite {
            self.fault.set(true);
        }
    }

    /// Takes note of a step that ended at `x`, if one did: Dopri5 announces dense points as well,
    /// and those were not evaluated. Whether it did.
    fn announced(&self, x: f64) -> bool {
        let (count, evaluated) = (self.evaluations.get() as usize, self.evaluated.borrow());
        let state = (1..=REMEMBERED.min(count))
            .map(|back| &evaluated[(count - back) % REMEMBERED])
            .find(|(at, _)| *at == x && x > self.end_x.get());
        let Some((_, state)) = state else {
            return false;
        };
        let [_, second, third] = self.steps.get();
        self.steps.set([second, third, x - self.end_x.get()]);
        self.end_x.set(x);
        self.end.borrow_mut().copy_from(state);
        self.accepted.set(self.accepted.get() + 1);
        self.fault.set(false);
        true
    }

    /// Time at the end of the latest accepted step, s.
    fn time(&self, block: &Block<'_>) -> f64 {
        block.start + self.end_x.get() * block.problem.scaling.time
    }

    /// Accepted steps of the whole run.
    fn steps(&self, block: &Block<'_>) -> u64 {
        block.problem.settings.step_limit - block.steps_left + self.accepted.get()
    }

    /// The last step may be cut short by the end of the block; one of those before was not.
    fn longest_late_step(&self) -> f64 {
        self.steps.get().into_iter().fold(0.0, f64::max)
    }
}

/// The system as the library sees it: scaled, and with the time as its last state.
struct Bridge<'a> {
    block: &'a Block<'a>,
    recorder: &'a Recorder,
    method: LibraryMethod,
    /// Room for a state.
    state: RefCell<Vec<f64>>,
}

impl LibrarySystem<f64, DVector<f64>> for Bridge<'_> {
    fn system(&self, x: f64, state: &DVector<f64>, rate: &mut DVector<f64>) {
        let own = state.len() - 1;
        let time = self.block.start + state[own] * self.block.problem.scaling.time;
        let (problem, rates) = (&self.block.problem, &mut rate.as_mut_slice()[..own]);
        let room = &mut self.state.borrow_mut();
        problem.scaling.write_state(without_time(state), room);
        problem.system.derivative(time, room, rates);
        for (rate, scale) in rates.iter_mut().zip(&problem.scaling.scale) {
            *rate *= problem.scaling.time / scale;
        }
        let sum: f64 = rates.iter().sum();
        rate[own] = 1.0;
        self.recorder.evaluated(x, state, sum.is_finite());
    }

    fn solout(&mut self, x: f64, _stale: &DVector<f64>, _rate: &DVector<f64>) -> bool {
        let accepted = self.recorder.announced(x);
        let (block, recorder) = (self.block, self.recorder);
        let stop = block.problem.stop.load(Ordering::Relaxed);
        recorder.stopped.set(stop);
        let steps = recorder.steps(block);
        if let Some(pace) = block.problem.pace {
            let counters = Counters {
                steps,
                ..Counters::default()
            };
            let time = block.start + x * block.problem.scaling.time;
            pace.note(time, &counters);
        }
        if accepted && is_check_due(&block.problem, steps - 1, steps) {
            *recorder.hopeless.borrow_mut() = stiff(self.method, block, recorder);
        }
        stop || recorder.hopeless.borrow().is_some()
    }
}
