//! The system as the library calls it, and what its calls reveal beyond its interface.

use std::cell::RefCell;
use std::sync::atomic::Ordering;

use ode_solvers::dop_shared::{IntegrationError, Stats};
use ode_solvers::{DVector, System};

use super::{Block, stability_limit, without_time};
use crate::integrate::stepper::Reached;
use crate::integrate::stiffness::{is_check_due, stiffness};
use crate::integrate::{Counters, IntegrateError};

/// Latest evaluations that are kept: that at the end of an accepted step, and those that dense output may add after it.
const REMEMBERED: usize = 4;

/// What the solver's calls reveal and its interface does not.
pub(super) struct Record {
    /// Latest evaluations, in a ring.
    evaluated: [(f64, DVector<f64>); REMEMBERED],
    pub evaluations: u64,
    pub accepted: u64,
    /// State at the end of the latest accepted step.
    pub end: DVector<f64>,
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
    pub fn new(scaled: &[f64]) -> Self {
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

    /// Records a step that ended at `x`, if one did: Dopri5 announces dense points as well, and those were not evaluated.
    /// Whether it did.
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
    pub fn longest_late_step(&self) -> f64 {
        self.steps.into_iter().fold(0.0, f64::max)
    }

    pub fn rejected(&self, result: &Result<Stats, IntegrationError>) -> u64 {
        match result {
            Ok(stats) => u64::from(stats.rejected_steps),
            Err(IntegrationError::MaxNumStepReached { n_step, .. }) => {
                u64::from(*n_step).saturating_sub(self.accepted)
            }
            Err(_) => 0,
        }
    }

    /// Why the run ends within a block, if it does, after steps of a size in s.
    pub fn ending(
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
        let reached = Reached {
            time: block.time(self.end_x),
            deviation: &problem.scaling.deviation(without_time(&self.end)),
            step: self.longest_late_step() * problem.scaling.time,
            counters: Counters::default(),
        };
        stiffness(problem, stability_limit(block.method), &reached)?.ending(problem, steps)
    }
}

/// The system as the library sees it: scaled, and with the time as its last state.
pub(super) struct Bridge<'a> {
    pub block: &'a Block<'a>,
    pub record: &'a RefCell<Record>,
}

impl System<f64, DVector<f64>> for Bridge<'_> {
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
        if let Some(progress) = problem.progress {
            progress.record(block.time(x), &counters);
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
