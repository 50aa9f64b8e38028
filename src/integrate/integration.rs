//! A state carried along a grid of times, block by block, and from break to break.

use std::sync::atomic::AtomicBool;

use serde::{Deserialize, Serialize};

use super::problem::Problem;
use super::stepper::{Start, Stepper};
use super::stiffness::{is_check_due, stiffness};
use super::{
    Counters, Grid, IntegrateError, Method, MethodUse, Pace, Scaling, Settings, States, Stiffness,
    System,
};

/// Steps between two checks for stiffness: the implicit method's trial then costs a few per cent of them.
const CHECK_EVERY: u64 = 2000;

/// Samples of a segment: at the end of each the method begins afresh, so that one that goes on from there is the same
/// by construction.
pub const SEGMENT: u64 = 4096;

/// State of an integration at the end of a segment of its grid: another integration of the same system, scaling,
/// grid and settings goes on from it to the very same states.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Checkpoint {
    /// Number of the grid time.
    pub next: u64,
    /// Scaled state there.
    pub scaled: Vec<f64>,
    /// Size of the step to go on with, s.
    pub step: f64,
    /// Work done so far.
    pub counters: Counters,
    /// Stiffness, where it was seen.
    pub stiffness: Option<Stiffness>,
    /// Which method carried the run, where the choice is left open.
    pub method_use: Option<MethodUse>,
}

/// A checkpoint of another integration.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
#[error(
    "a checkpoint of {states} states at grid time {next} belongs to another integration: this one \
     has {expected} states and {count} grid times"
)]
pub struct CheckpointMismatch {
    /// States of the checkpoint.
    pub states: usize,
    /// Number of its grid time.
    pub next: u64,
    /// States of the integration.
    pub expected: usize,
    /// Grid times of the integration.
    pub count: u64,
}

/// An integration under way: it knows its state at a grid time and how to go on.
pub struct Integration<'a> {
    problem: Problem<'a>,
    grid: Grid,
    /// Room for a state.
    state: Vec<f64>,
    next: u64,
    stepper: Stepper,
    /// The latest end of a segment, and stiffness where it was seen since.
    checkpoint: Checkpoint,
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
            step: 0.0,
            counters: Counters::default(),
        };
        let is_open = settings.method == Method::Auto;
        let method_use = is_open.then(|| MethodUse::of(system));
        let problem = Problem {
            system,
            scaling,
            settings,
            stop,
            pace: None,
            interval: grid.interval,
            end: grid.time(grid.count.saturating_sub(1)),
        };
        Self {
            stepper: Stepper::new(method_use, &problem, &start),
            checkpoint: Checkpoint {
                next: 0,
                scaled: problem.scaling.scaled(state),
                step: 0.0,
                counters: Counters::default(),
                stiffness: None,
                method_use,
            },
            problem,
            grid,
            state: state.to_vec(),
            next: 0,
        }
    }

    /// The same, watched from elsewhere.
    #[must_use]
    pub fn watched(mut self, pace: Option<&'a Pace>) -> Self {
        self.problem.pace = pace;
        self
    }

    /// What it takes to go on another time from the latest end of a segment.
    pub fn checkpoint(&self) -> &Checkpoint {
        &self.checkpoint
    }

    /// Goes on from the checkpoint of another integration of the same system, scaling, grid and settings; the states
    /// that follow are the same, bit by bit.
    ///
    /// # Errors
    /// [`CheckpointMismatch`] where it cannot be one of the same system and grid.
    pub fn go_on_from(&mut self, checkpoint: &Checkpoint) -> Result<(), CheckpointMismatch> {
        let (states, expected) = (checkpoint.scaled.len(), self.state.len());
        if states != expected || checkpoint.next > self.grid.count {
            return Err(CheckpointMismatch {
                states,
                next: checkpoint.next,
                expected,
                count: self.grid.count,
            });
        }
        self.checkpoint = checkpoint.clone();
        self.next = checkpoint.next;
        if self.next > 0 {
            self.begin_afresh();
        }
        Ok(())
    }

    /// Lets the method begin afresh at the checkpoint.
    fn begin_afresh(&mut self) {
        let checkpoint = &self.checkpoint;
        let start = Start {
            time: self.grid.time(checkpoint.next),
            deviation: self.problem.scaling.deviation(&checkpoint.scaled),
            step: checkpoint.step,
            counters: checkpoint.counters,
        };
        self.stepper = Stepper::new(checkpoint.method_use, &self.problem, &start);
    }

    /// Ends a segment in the present state.
    fn end_segment(&mut self) {
        self.checkpoint = Checkpoint {
            next: self.next,
            scaled: self.problem.scaling.scaled(&self.state),
            step: self.stepper.method().step_size(),
            counters: self.counters(),
            stiffness: self.checkpoint.stiffness,
            method_use: self.method_use(),
        };
        self.begin_afresh();
    }

    /// Work done so far.
    pub fn counters(&self) -> Counters {
        self.stepper.method().counters()
    }

    /// Stiffness that an explicit method met, where it was first seen: stability held its steps far
    /// below what accuracy asks for. [`Integration::advance`] checks for it at its end, once in some
    /// thousand steps: where there are fewer, they are no burden.
    pub fn stiffness(&self) -> Option<Stiffness> {
        self.checkpoint.stiffness
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
            if self.next.is_multiple_of(SEGMENT) && self.next < self.grid.count {
                self.find_state()?;
                self.end_segment();
            }
        }
        let due = self.counters().steps / CHECK_EVERY != checks_before;
        // steps that are longer than the distance of the samples are no burden
        let is_short = self.stepper.method().step_size() < self.grid.interval;
        if due && self.checkpoint.stiffness.is_none() && is_short {
            self.checkpoint.stiffness = self.find_stiffness();
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
        stiffness.and_then(ending).map_or(result, Err)
    }

    /// Finds the state at the next grid time.
    fn find_state(&mut self) -> Result<(), IntegrateError> {
        let time = self.grid.time(self.next);
        self.stepper.state_at(&self.problem, time, &mut self.state)
    }

    /// Stiffness at the end of the latest step.
    fn find_stiffness(&self) -> Option<Stiffness> {
        let method = self.stepper.method();
        let (limit, deviation) = (method.stability_limit()?, method.deviation());
        stiffness(
            &self.problem,
            limit,
            method.time(),
            deviation,
            method.step_size(),
        )
    }
}
