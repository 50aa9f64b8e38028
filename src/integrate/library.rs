//! Dopri5 and Dop853 of `ode_solvers` as steppers, whose steps are blocks of samples that breaks cut.
//!
//! The library is used in a way that keeps clear of its limits in version 0.6:
//! - Dop853 evaluates its last stage at a wrong time; time is therefore carried as one more state.
//! - Its last dense point may be an extrapolation; a block asks for the points before its end only,
//!   and the state at the end is the one that the accepted step was evaluated at.
//! - Its derivative cannot fail; a derivative that is not finite is remembered until a step with a
//!   finite one is accepted, and explains the step-size underflow that follows.
//! - Grid times drift by added round-off; they are rebuilt from the index.
//! - Its own test for stiffness comes once in a thousand steps of one solver, and ends runs that
//!   would end well; it is left out for [`stiffness`], which knows the Jacobian and the limit on
//!   steps.

use std::cell::RefCell;
use std::sync::atomic::Ordering;

use ode_solvers::dop_shared::{IntegrationError, OutputType, Stats};
use ode_solvers::{DVector, Dop853, Dopri5, System as LibrarySystem};

use super::problem::Problem;
use super::rosenbrock::LOCAL_PART;
use super::stepper::{MethodStepper, Start};
use super::stiffness::{is_check_due, stiffness};
use super::{Counters, IntegrateError, Method, SEGMENT, States};

/// Evaluations after an accepted step's own that dense output may add, and that one itself.
const REMEMBERED: usize = 4;
/// Accepted steps between two of the library's own tests for stiffness: none comes so far.
const NO_TEST_FOR_STIFFNESS: u32 = u32::MAX;

/// A method of the library under way.
pub(super) struct LibraryStepper {
    method: Method,
    /// Start of the latest block, s, and the scaled states at its samples.
    start: f64,
    samples: States,
    /// Its end, s, with the scaled state and the deviation there.
    time: f64,
    scaled: Vec<f64>,
    deviation: Vec<f64>,
    /// Size of the latest step that no end of a block cut, s.
    step: f64,
    counters: Counters,
    /// Why the run ends after these samples.
    ending: Option<IntegrateError>,
}

/// Product of step and largest eigenvalue at which a method ceases to be stable, on the negative real axis.
///
/// Source: Hairer, Nørsett & Wanner, codes DOPRI5 and DOP853, bounds of their tests for stiffness.
fn stability_limit(method: Method) -> f64 {
    match method {
        Method::Dopri5 => 3.25,
        _ => 6.1,
    }
}

impl LibraryStepper {
    /// Before the first step of `Dopri5` or `Dop853`.
    pub fn new(method: Method, problem: &Problem<'_>, start: &Start) -> Self {
        let units = start.deviation.iter().zip(&problem.scaling.scale);
        Self {
            method,
            start: start.time,
            samples: States::new(start.deviation.len()),
            time: start.time,
            scaled: units.map(|(deviation, scale)| deviation / scale).collect(),
            deviation: start.deviation.clone(),
            step: start.step,
            counters: start.counters,
            ending: None,
        }
    }

    /// The block to come: up to the end of a segment of samples, to the next break, or from one to the next sample.
    fn next_block<'a>(&self, problem: &'a Problem<'a>) -> Block<'a> {
        let (time, interval) = (self.time, problem.interval);
        let limit = problem.limit_after(time);
        let index = (time / interval).round();
        let block = |end: f64, intervals: f64| Block {
            problem,
            method: self.method,
            start: time,
            end,
            intervals: intervals as usize,
            before: self.counters,
        };
        if index * interval == time {
            let free = ((limit - time + problem.slack()) / interval).floor();
            let whole = free.min(SEGMENT as f64 - index % SEGMENT as f64);
            if whole >= 1.0 {
                return block((index + whole) * interval, whole);
            }
        }
        // the sample at which the block begins, within round-off, is behind it
        let behind = ((time + problem.slack()) / interval).floor();
        let next = (behind + 1.0) * interval;
        let is_cut = limit < next - problem.slack();
        block(if is_cut { limit } else { next }, 1.0)
    }

    /// Integrates over a block: the scaled states at its samples, the end left out, and why it is not whole.
    fn solve(
        &self,
        block: &Block<'_>,
        record: &RefCell<Record>,
    ) -> (Vec<DVector<f64>>, Result<Stats, IntegrationError>) {
        let unit = block.problem.scaling.time;
        // the time comes last
        let initial = DVector::from_column_slice(&self.scaled).push(0.0);
        let bridge = Bridge { block, record };
        let end = (block.end - block.start) / unit;
        let interval = end / block.intervals as f64;
        let tolerance = LOCAL_PART * block.problem.settings.tolerance;
        let first_step = (self.step / unit).min(end);
        macro_rules! solve {
            ($Solver:ident, $beta:expr, $shrink:expr, $grow:expr) => {{
                let mut solver = $Solver::from_param(
                    bridge,
                    0.0,
                    end,
                    interval,
                    initial,
                    tolerance,
                    tolerance,
                    0.9,
                    $beta,
                    $shrink,
                    $grow,
                    end,
                    first_step,
                    block.steps_left(),
                    NO_TEST_FOR_STIFFNESS,
                    OutputType::Dense,
                );
                let result = solver.integrate();
                let samples = solver.y_out().iter().take(block.intervals).cloned();
                (samples.collect(), result)
            }};
        }
        match self.method {
            Method::Dopri5 => solve!(Dopri5, 0.04, 0.2, 10.0),
            _ => solve!(Dop853, 0.0, 0.333, 6.0),
        }
    }
}

impl MethodStepper for LibraryStepper {
    fn step(&mut self, problem: &Problem<'_>) -> Result<(), IntegrateError> {
        if let Some(ending) = self.ending.take() {
            return Err(ending);
        }
        let block = self.next_block(problem);
        let record = RefCell::new(Record::new(&self.scaled));
        let (samples, result) = self.solve(&block, &record);
        let record = record.into_inner();
        self.counters.steps += record.accepted;
        self.counters.evaluations += record.evaluations;
        self.counters.rejected += record.rejected(&result);
        self.step = record.longest_late_step() * problem.scaling.time;
        self.start = self.time;
        self.samples.clear();
        let finite = |state: &&DVector<f64>| state.iter().all(|value| value.is_finite());
        for state in samples.iter().take_while(finite) {
            self.samples.push(without_time(state));
        }
        let end = without_time(&record.end).to_vec();
        self.ending = record.ending(&block, result, self.step);
        if let Some(ending) = self.ending.take_if(|_| self.samples.len() < 2) {
            return Err(ending);
        }
        match (&self.ending, self.samples.last()) {
            (Some(_), Some(last)) => {
                let index =
                    (self.start / problem.interval).round() + self.samples.len() as f64 - 1.0;
                self.time = index * problem.interval;
                self.scaled = last.to_vec();
            }
            _ => {
                self.time = block.end;
                self.scaled = end;
            }
        }
        self.deviation = problem.scaling.deviation(&self.scaled);
        Ok(())
    }

    fn state_within(&mut self, problem: &Problem<'_>, time: f64, state: &mut [f64]) {
        let index = ((time - self.start) / problem.interval).round();
        let before_end = self.samples.get(index as usize);
        let scaled = before_end.filter(|_| time < self.time);
        problem
            .scaling
            .write_state(scaled.unwrap_or(&self.scaled), state);
    }

    fn time(&self) -> f64 {
        self.time
    }

    fn deviation(&self) -> &[f64] {
        &self.deviation
    }

    fn counters(&self) -> Counters {
        self.counters
    }

    fn step_size(&self) -> f64 {
        self.step
    }

    fn stability_limit(&self) -> Option<f64> {
        Some(stability_limit(self.method))
    }
}

fn without_time(state: &DVector<f64>) -> &[f64] {
    &state.as_slice()[..state.len() - 1]
}

/// Some intervals between samples, or a part of one.
#[derive(Clone, Copy)]
struct Block<'a> {
    problem: &'a Problem<'a>,
    method: Method,
    /// s.
    start: f64,
    end: f64,
    intervals: usize,
    /// Work before.
    before: Counters,
}

impl Block<'_> {
    /// Time at a distance from its start in units of the scaling, s.
    fn time(&self, x: f64) -> f64 {
        self.start + x * self.problem.scaling.time
    }

    /// Steps that are left of the limit.
    fn steps_left(&self) -> u32 {
        let used = self.before.steps + self.before.rejected;
        let left = self.problem.settings.step_limit.saturating_sub(used);
        u32::try_from(left).unwrap_or(u32::MAX)
    }
}

/// What the solver's calls reveal and its interface does not.
struct Record {
    /// Latest evaluations, in a ring.
    evaluated: [(f64, DVector<f64>); REMEMBERED],
    evaluations: u64,
    accepted: u64,
    /// State at the end of the latest accepted step.
    end: DVector<f64>,
    end_x: f64,
    /// Sizes of the latest accepted steps.
    steps: [f64; 3],
    /// Whether an evaluation since the latest accepted step was not finite.
    fault: bool,
    /// Why the solver was told to stop.
    ending: Option<IntegrateError>,
    /// Room for a state.
    state: Vec<f64>,
}

impl Record {
    fn new(scaled: &[f64]) -> Self {
        let start = DVector::from_column_slice(scaled).push(0.0);
        Self {
            evaluated: std::array::from_fn(|_| (f64::NAN, start.clone())),
            evaluations: 0,
            accepted: 0,
            end: start,
            end_x: 0.0,
            steps: [0.0; 3],
            fault: false,
            ending: None,
            state: scaled.to_vec(),
        }
    }

    /// Takes note of a step that ended at `x`, if one did: Dopri5 announces dense points as well,
    /// and those were not evaluated. Whether it did.
    fn announced(&mut self, x: f64) -> bool {
        let count = self.evaluations as usize;
        let state = (1..=REMEMBERED.min(count))
            .map(|back| &self.evaluated[(count - back) % REMEMBERED])
            .find(|(at, _)| *at == x && x > self.end_x);
        let Some((_, state)) = state else {
            return false;
        };
        self.end.copy_from(state);
        let [_, second, third] = self.steps;
        self.steps = [second, third, x - self.end_x];
        self.end_x = x;
        self.accepted += 1;
        self.fault = false;
        true
    }

    /// The last step may be cut short by the end of the block; one of those before was not.
    fn longest_late_step(&self) -> f64 {
        self.steps.into_iter().fold(0.0, f64::max)
    }

    fn rejected(&self, result: &Result<Stats, IntegrationError>) -> u64 {
        match result {
            Ok(stats) => u64::from(stats.rejected_steps),
            Err(IntegrationError::MaxNumStepReached { n_step, .. }) => {
                u64::from(*n_step).saturating_sub(self.accepted)
            }
            Err(_) => 0,
        }
    }

    /// Why the run ends within a block, if it does, after steps of a size in s.
    fn ending(
        self,
        block: &Block<'_>,
        result: Result<Stats, IntegrationError>,
        step: f64,
    ) -> Option<IntegrateError> {
        let time = block.time(self.end_x);
        match result {
            _ if self.ending.is_some() => self.ending,
            Ok(_) => None,
            Err(_) if self.fault => Some(IntegrateError::NotFinite { time }),
            Err(IntegrationError::MaxNumStepReached { .. }) => Some(IntegrateError::StepLimit {
                time,
                limit: block.problem.settings.step_limit,
            }),
            // the library does not test for stiffness
            Err(
                IntegrationError::StepSizeUnderflow { .. }
                | IntegrationError::StiffnessDetected { .. },
            ) => Some(IntegrateError::StepUnderflow { time, step }),
        }
    }

    /// The error that ends a run which stability keeps from its end within the limit on steps.
    fn stiff(&self, block: &Block<'_>, steps: u64) -> Option<IntegrateError> {
        let problem = block.problem;
        let deviation = problem.scaling.deviation(without_time(&self.end));
        let step = self.longest_late_step() * problem.scaling.time;
        let (limit, time) = (stability_limit(block.method), block.time(self.end_x));
        stiffness(problem, limit, time, &deviation, step)?.ending(problem, steps)
    }
}

/// The system as the library sees it: scaled, and with the time as its last state.
struct Bridge<'a> {
    block: &'a Block<'a>,
    record: &'a RefCell<Record>,
}

impl LibrarySystem<f64, DVector<f64>> for Bridge<'_> {
    fn system(&self, x: f64, state: &DVector<f64>, rate: &mut DVector<f64>) {
        let own = state.len() - 1;
        let (problem, rates) = (self.block.problem, &mut rate.as_mut_slice()[..own]);
        let record = &mut *self.record.borrow_mut();
        let time = self.block.time(state[own]);
        problem
            .scaling
            .write_state(without_time(state), &mut record.state);
        problem.system.derivative(time, &record.state, rates);
        for (rate, scale) in rates.iter_mut().zip(&problem.scaling.scale) {
            *rate *= problem.scaling.time / scale;
        }
        record.fault |= !rates.iter().sum::<f64>().is_finite();
        rate[own] = 1.0;
        let (at, kept) = &mut record.evaluated[record.evaluations as usize % REMEMBERED];
        *at = x;
        kept.copy_from(state);
        record.evaluations += 1;
    }

    fn solout(&mut self, x: f64, _stale: &DVector<f64>, _rate: &DVector<f64>) -> bool {
        let (block, record) = (self.block, &mut *self.record.borrow_mut());
        let problem = block.problem;
        let accepted = record.announced(x);
        let counters = Counters {
            steps: block.before.steps + record.accepted,
            ..Counters::default()
        };
        if let Some(pace) = problem.pace {
            pace.note(block.time(x), &counters);
        }
        if problem.stop.load(Ordering::Relaxed) {
            let time = block.time(record.end_x);
            record.ending = Some(IntegrateError::Interrupted { time });
        }
        if accepted && is_check_due(problem, counters.steps - 1, counters.steps) {
            record.ending = record.stiff(block, counters.steps).or(record.ending.take());
        }
        record.ending.is_some()
    }
}
