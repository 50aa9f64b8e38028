//! A state carried along a grid of times, block by block.

use std::sync::atomic::AtomicBool;

use super::problem::Problem;
use super::stepper::{Start, Stepper};
use super::stiffness::{is_check_due, stiffness};
use super::{
    Counters, Grid, IntegrateError, Method, MethodUse, Prepared, Progress, Scaling, Settings,
    States, Stiffness, System,
};

/// Steps between two checks for stiffness.
const CHECK_EVERY: u64 = 2000;

/// An integration under way: it knows its state at a grid time and how to go on.
pub struct Integration<'a> {
    problem: Problem<'a>,
    grid: Grid,
    /// Room for a state.
    state: Vec<f64>,
    next: u64,
    stepper: Stepper,
    stiffness: Option<Stiffness>,
}

impl<'a> Integration<'a> {
    /// Starts at time 0 in `state`. Setting `stop` ends the integration at its next step.
    pub fn new(
        system: &'a dyn System,
        scaling: Scaling,
        grid: Grid,
        settings: Settings,
        stop: &'a AtomicBool,
        state: &[f64],
    ) -> Self {
        let deviation = state.iter().zip(&scaling.origin);
        let start = Start {
            time: 0.0,
            deviation: deviation.map(|(state, origin)| state - origin).collect(),
            counters: Counters::default(),
        };
        let is_open = settings.method == Method::Auto;
        let method_use = is_open.then(MethodUse::default);
        let problem = Problem {
            system,
            scaling,
            settings,
            stop,
            progress: None,
            interval: grid.interval,
            end: grid.time(grid.count.saturating_sub(1)),
        };
        Self {
            stepper: Stepper::new(method_use, &problem, &start),
            stiffness: None,
            problem,
            grid,
            state: state.to_vec(),
            next: 0,
        }
    }

    /// With its progress recorded for other threads.
    #[must_use]
    pub fn watched(mut self, progress: Option<&'a Progress>) -> Self {
        self.problem.progress = progress;
        self
    }

    /// Before its first step, with what an integration that led to its start has found out.
    #[must_use]
    pub fn prepared_by(mut self, prepared: Option<Prepared>) -> Self {
        if let Some(prepared) = prepared {
            self.stepper.take_over(prepared, &self.problem);
        }
        self
    }

    /// What an integration that goes on from its end may take over.
    pub fn into_prepared(self) -> Prepared {
        self.stepper.into_prepared()
    }

    /// Work done so far.
    pub fn counters(&self) -> Counters {
        self.stepper.reached().counters
    }

    /// Stiffness that an explicit method met, where it was first seen: its steps were as long as its stability
    /// allows. [`Integration::advance`] checks for it at its end, once in some
    /// thousand steps: where there are fewer, they are no burden.
    pub fn stiffness(&self) -> Option<Stiffness> {
        self.stiffness
    }

    /// Which method carried the run, where the choice was left open.
    pub fn method_use(&self) -> Option<MethodUse> {
        self.stepper.method_use
    }

    /// Number of grid times handed out so far.
    pub fn done(&self) -> u64 {
        self.next
    }

    /// Integrates over up to `points` further grid times and appends the states there to `states`.
    /// Nothing is appended when the grid is exhausted.
    ///
    /// # Errors
    /// [`IntegrateError`] where the integration cannot go on; the states before that time have been
    /// appended.
    pub fn advance(&mut self, points: usize, states: &mut States) -> Result<(), IntegrateError> {
        let left = self.grid.count - self.next;
        let points = usize::try_from(left).unwrap_or(usize::MAX).min(points);
        let checks_before = self.counters().steps / CHECK_EVERY;
        for _ in 0..points {
            self.next_sample()?;
            states.push(&self.state);
            self.next += 1;
        }
        let due = self.counters().steps / CHECK_EVERY != checks_before;
        // steps that are longer than the distance of the samples are no burden
        let is_short = self.stepper.reached().step < self.grid.interval;
        if due && self.stiffness.is_none() && is_short {
            self.stiffness = self.find_stiffness();
        }
        Ok(())
    }

    /// Finds the state at the next grid time, or that stability keeps the run from its end.
    fn next_sample(&mut self) -> Result<(), IntegrateError> {
        let steps_before = self.counters().steps;
        let result = self.find_state();
        let is_due = match &result {
            Ok(()) => is_check_due(&self.problem, steps_before, self.counters().steps),
            Err(error) => matches!(error, IntegrateError::StepLimit { .. }),
        };
        let stiffness = if is_due { self.find_stiffness() } else { None };
        let ending = |found: Stiffness| found.ending(&self.problem, self.counters().steps);
        let result = stiffness.and_then(ending).map_or(result, Err);
        if let (Err(_), Some(progress)) = (&result, self.problem.progress) {
            let reached = self.stepper.reached();
            progress.record(reached.time, &reached.counters);
        }
        result
    }

    /// Finds the state at the next grid time.
    fn find_state(&mut self) -> Result<(), IntegrateError> {
        let time = self.grid.time(self.next);
        self.stepper.state_at(&self.problem, time, &mut self.state)
    }

    /// Stiffness at the end of the latest step.
    fn find_stiffness(&self) -> Option<Stiffness> {
        let limit = self.stepper.stability_limit()?;
        stiffness(&self.problem, limit, &self.stepper.reached())
    }
}
