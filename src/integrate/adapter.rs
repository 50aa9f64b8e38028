//! Dopri5 and Dop853 of `ode_solvers` behind one function: a block of states on a uniform grid.
//!
//! The library is used in a way that keeps clear of its limits in version 0.6:
//! - Dop853 evaluates its last stage at a wrong time; time is therefore carried as one more state.
//! - Its last dense point may be an extrapolation; a block asks for the points before its end only,
//!   and the state at the end is the one that the accepted step was evaluated at.
//! - Its derivative cannot fail; a derivative that is not finite is remembered until a step with a
//!   finite one is accepted, and explains the step-size underflow that follows.
//! - Grid times drift by added round-off; callers rebuild them from the index.
//! - Its own look for stiffness comes once in a thousand steps of one solver, and ends runs that
//!   would end well; it is left out for [`stiffness`], which knows the Jacobian and the limit on
//!   steps.

use std::cell::{Cell, RefCell};
use std::sync::atomic::Ordering;

use ode_solvers::dop_shared::{IntegrationError, OutputType, Stats};
use ode_solvers::{Dop853, Dopri5, SVector, System as LibrarySystem};

use nalgebra::Const;

use super::block::{Block, Outcome};
use super::stiffness::stiffness;
use super::{Counters, IntegrateError, Linearised, Square};

/// Evaluations after an accepted step's own that dense output may add, and that one itself.
const REMEMBERED: usize = 4;

/// The methods of the library.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum ExplicitMethod {
    Dopri5,
    Dop853,
}

impl ExplicitMethod {
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

/// Integrates a block from a scaled state. `M` must be `N + 1`: the state and the time.
pub(super) fn integrate<S, const N: usize, const M: usize>(
    method: ExplicitMethod,
    block: &Block<'_, S, N>,
    start: &[f64; N],
) -> Outcome<N>
where
    S: Linearised<N>,
    Const<N>: Square,
{
    const { assert!(M == N + 1, "one more state than the system has: the time") };
    let initial = SVector::<f64, M>::from_fn(|row, _| if row < N { start[row] } else { 0.0 });
    let recorder = Recorder::new(initial);
    let bridge = Bridge {
        block,
        recorder: &recorder,
        method,
    };
    let dx = block.interval / block.scaling.time;
    let end = dx * block.intervals as f64;
    let tolerance = block.local_tolerance();
    let step_limit = u32::try_from(block.steps_left).unwrap_or(u32::MAX);
    let first_step = (block.first_step / block.scaling.time).min(end);
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
        ExplicitMethod::Dopri5 => solve!(Dopri5, 0.04, 0.2, 10.0),
        ExplicitMethod::Dop853 => solve!(Dop853, 0.0, 0.333, 6.0),
    }
}

/// Accepted steps between two of the library's own tests: none comes so far.
const NO_TEST_FOR_STIFFNESS: u32 = u32::MAX;
/// Accepted steps between two looks at whether the run comes to its end.
const OUTLOOK_EVERY: u64 = 1000;
/// Part of the limit on steps that is used before a run is called hopeless: a short stiff stretch
/// passes.
const PATIENCE: f64 = 0.01;

fn outcome<S, const N: usize, const M: usize>(
    method: ExplicitMethod,
    block: &Block<'_, S, N>,
    recorder: &Recorder<M>,
    result: Result<Stats, IntegrationError>,
    dense: &[SVector<f64, M>],
) -> Outcome<N>
where
    S: Linearised<N>,
    Const<N>: Square,
{
    let time = |x: f64| block.start + x * block.scaling.time;
    let end = recorder.end.get();
    let reached = time(recorder.end_x.get());
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
            look(method, block, recorder).unwrap_or(IntegrateError::StepLimit {
                time: reached,
                limit: block.settings.step_limit,
            }),
        ),
        // the library does not look for stiffness
        Err(
            IntegrationError::StepSizeUnderflow { .. } | IntegrationError::StiffnessDetected { .. },
        ) => Some(IntegrateError::StepUnderflow {
            time: reached,
            step: recorder.longest_late_step() * block.scaling.time,
        }),
    };
    let states = dense
        .iter()
        .take(block.intervals)
        .take_while(|state| state.iter().all(|value| value.is_finite()))
        .map(without_time)
        .collect();
    Outcome {
        states,
        end: without_time(&end),
        last_step: recorder.longest_late_step() * block.scaling.time,
        counters: Counters {
            steps: recorder.accepted.get(),
            rejected,
            evaluations: recorder.evaluations.get(),
        },
        error,
    }
}

/// The error that ends a run that stability keeps from its end: none where steps are as long as
/// accuracy allows.
fn look<S, const N: usize, const M: usize>(
    method: ExplicitMethod,
    block: &Block<'_, S, N>,
    recorder: &Recorder<M>,
) -> Option<IntegrateError>
where
    S: Linearised<N>,
    Const<N>: Square,
{
    let step = recorder.longest_late_step() * block.scaling.time;
    if step <= 0.0 {
        return None;
    }
    let time = block.start + recorder.end_x.get() * block.scaling.time;
    let state = without_time(&recorder.end.get());
    let found = stiffness(block, method.stability_limit(), time, &state, step)?;
    Some(IntegrateError::Stiff {
        needed: needed(block, recorder, time, step),
        limit: block.settings.step_limit,
        stiffness: found,
    })
}

/// Steps of the whole run that goes on with steps of a size.
fn needed<S, const N: usize, const M: usize>(
    block: &Block<'_, S, N>,
    recorder: &Recorder<M>,
    time: f64,
    step: f64,
) -> f64 {
    used(block, recorder) + (block.run_end - time).max(0.0) / step
}

/// Steps of the whole run so far.
fn used<S, const N: usize, const M: usize>(block: &Block<'_, S, N>, recorder: &Recorder<M>) -> f64 {
    let before = block.settings.step_limit - block.steps_left;
    (before + recorder.accepted.get()) as f64
}

fn without_time<const N: usize, const M: usize>(state: &SVector<f64, M>) -> [f64; N] {
    std::array::from_fn(|row| state[row])
}

/// What the solver's calls reveal and its interface does not.
struct Recorder<const M: usize> {
    /// Latest evaluations, in a ring.
    evaluated: RefCell<[(f64, SVector<f64, M>); REMEMBERED]>,
    evaluations: Cell<u64>,
    accepted: Cell<u64>,
    /// State at the end of the latest accepted step.
    end: Cell<SVector<f64, M>>,
    end_x: Cell<f64>,
    /// Sizes of the latest accepted steps.
    steps: Cell<[f64; 3]>,
    /// Whether an evaluation since the latest accepted step was not finite.
    fault: Cell<bool>,
    stopped: Cell<bool>,
    /// Why the run will not come to its end.
    hopeless: RefCell<Option<IntegrateError>>,
}

impl<const M: usize> Recorder<M> {
    fn new(start: SVector<f64, M>) -> Self {
        Self {
            evaluated: RefCell::new([(f64::NAN, start); REMEMBERED]),
            evaluations: Cell::new(0),
            accepted: Cell::new(0),
            end: Cell::new(start),
            end_x: Cell::new(0.0),
            steps: Cell::new([0.0; 3]),
            fault: Cell::new(false),
            stopped: Cell::new(false),
            hopeless: RefCell::new(None),
        }
    }

    fn evaluated(&self, x: f64, state: &SVector<f64, M>, finite: bool) {
        let count = self.evaluations.get();
        self.evaluated.borrow_mut()[count as usize % REMEMBERED] = (x, *state);
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
            .find(|(at, _)| *at == x && x > self.end_x.get())
            .map(|(_, state)| *state);
        let accepted = state.is_some();
        if let Some(state) = state {
            let [_, second, third] = self.steps.get();
            self.steps.set([second, third, x - self.end_x.get()]);
            self.end_x.set(x);
            self.end.set(state);
            self.accepted.set(self.accepted.get() + 1);
            self.fault.set(false);
        }
        accepted
    }

    /// The last step may be cut short by the end of the block; one of those before was not.
    fn longest_late_step(&self) -> f64 {
        self.steps.get().into_iter().fold(0.0, f64::max)
    }
}

/// The system as the library sees it: scaled, and with the time as its last state.
struct Bridge<'a, S, const N: usize, const M: usize> {
    block: &'a Block<'a, S, N>,
    recorder: &'a Recorder<M>,
    method: ExplicitMethod,
}

impl<S, const N: usize, const M: usize> Bridge<'_, S, N, M>
where
    S: Linearised<N>,
    Const<N>: Square,
{
    /// Whether stability keeps the run from ending within its limit on steps; looked at now and then.
    fn is_hopeless(&self) -> bool {
        let (block, recorder) = (self.block, self.recorder);
        if !recorder.accepted.get().is_multiple_of(OUTLOOK_EVERY) {
            return false;
        }
        let limit = block.settings.step_limit as f64;
        let time = block.start + recorder.end_x.get() * block.scaling.time;
        let step = recorder.longest_late_step() * block.scaling.time;
        let used = used(block, recorder);
        if used < PATIENCE * limit || needed(block, recorder, time, step) < limit {
            return false;
        }
        *recorder.hopeless.borrow_mut() = look(self.method, block, recorder);
        recorder.hopeless.borrow().is_some()
    }
}

impl<S, const N: usize, const M: usize> LibrarySystem<f64, SVector<f64, M>> for Bridge<'_, S, N, M>
where
    S: Linearised<N>,
    Const<N>: Square,
{
    fn system(&self, x: f64, state: &SVector<f64, M>, rate: &mut SVector<f64, M>) {
        let scaling = self.block.scaling;
        let physical = scaling.state(&state.as_slice()[..N]);
        let mut derivative = [0.0; N];
        let time = self.block.start + state[N] * scaling.time;
        self.block
            .system
            .derivative(time, &physical, &mut derivative);
        let mut sum = 0.0;
        for row in 0..N {
            rate[row] = derivative[row] * (scaling.time / scaling.scale[row]);
            sum += rate[row];
        }
        rate[N] = 1.0;
        self.recorder.evaluated(x, state, sum.is_finite());
    }

    fn solout(&mut self, x: f64, _stale: &SVector<f64, M>, _rate: &SVector<f64, M>) -> bool {
        let accepted = self.recorder.announced(x);
        let stop = self.block.stop.load(Ordering::Relaxed);
        self.recorder.stopped.set(stop);
        stop || (accepted && self.is_hopeless())
    }
}
