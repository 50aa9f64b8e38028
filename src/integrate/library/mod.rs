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
//!   would end well; it is left out for [`stiffness`](super::stiffness()), which knows the Jacobian and the limit
//!   on steps.

mod bridge;

use std::cell::RefCell;

use ode_solvers::dop_shared::{IntegrationError, OutputType, Stats};
use ode_solvers::{DVector, Dop853, Dopri5};

use super::problem::Problem;
use super::stepper::{MethodStepper, Reached, Start};
use super::{Counters, IntegrateError, Method, States};
use bridge::{Bridge, Record};

/// Error allowed in one step, as a part of the error aimed at over the run: local errors add up.
const LOCAL_PART: f64 = 0.25;
/// Most samples of a block, which the library keeps in memory.
const BLOCK: f64 = 4096.0;

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
            step: 0.0,
            counters: start.counters,
            ending: None,
        }
    }

    /// The block to come: up to the next break, or from one to the next sample.
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
            let whole = free.min(BLOCK);
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
                    // accepted steps to the library's own test for stiffness
                    u32::MAX,
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
        // the samples behind are given back before the library keeps the next ones
        self.samples = States::new(self.scaled.len());
        let (samples, result) = self.solve(&block, &record);
        let record = record.into_inner();
        self.counters.steps += record.accepted;
        self.counters.evaluations += record.evaluations;
        self.counters.rejected += record.rejected(&result);
        self.step = record.longest_late_step() * problem.scaling.time;
        self.start = self.time;
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

    fn reached(&self) -> Reached<'_> {
        Reached {
            time: self.time,
            deviation: &self.deviation,
            step: self.step,
            counters: self.counters,
        }
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
