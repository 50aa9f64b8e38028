//! A state carried along a grid of times, block by block, and from break to break.

use std::sync::atomic::AtomicBool;

use super::adapter::LibraryMethod;
use super::problem::Problem;
use super::stepper::{Start, Stepper};
use super::stiffness::{is_check_due, stiffness};
use super::{
    Checkpoint, CheckpointMismatch, Counters, Grid, IntegrateError, Method, MethodUse, Pace,
    SEGMENT, Scaling, Settings, States, Stiffness, System,
};

/// Steps between two checks for stiffness: the implicit method's trial then costs a few per cent of them.
const CHECK_EVERY: u64 = 2000;
/// An integration under way: it knows its state at a grid time and how to go on.
pub struct Integration<'a> {
    pub(super) system: &'a dyn System,
    pub(super) scaling: Scaling,
    pub(super) grid: Grid,
    pub(super) settings: Settings,
    stop: &'a AtomicBool,
    pace: Option<&'a Pace>,
    /// Scaled state where the latest block or segment ended.
    pub(super) scaled: Vec<f64>,
    /// Room for a state.
    pub(super) state: Vec<f64>,
    pub(super) next: u64,
    pub(super) step: f64,
    pub(super) counters: Counters,
    stiffness: Option<Stiffness>,
    /// Of the methods of this crate whose steps do not end with a block.
    stepper: Stepper,
    /// The latest end of a segment.
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
        let open = settings.method == Method::Auto;
        let deviation = state.iter().zip(&scaling.origin);
        let start = Start {
            time: 0.0,
            deviation: deviation.map(|(state, origin)| state - origin).collect(),
            step: 0.0,
            counters: Counters::default(),
            interval: grid.interval,
        };
        let method_use = open.then(|| MethodUse::of(system));
        let scaled = scaling.scaled(state);
        let problem = Problem::over(&grid, system, &scaling, &settings, (stop, None));
        Self {
            stepper: Stepper::new(settings.method, method_use, &problem, &start),
            checkpoint: Checkpoint {
                next: 0,
                scaled: scaled.clone(),
                step: 0.0,
                counters: Counters::default(),
                stiffness: None,
                method_use,
            },
            system,
            scaling,
            grid,
            settings,
            stop,
            pace: None,
            scaled,
            state: state.to_vec(),
            next: 0,
            step: 0.0,
            counters: Counters::default(),
            stiffness: None,
        }
    }

    /// The same, watched from elsewhere.
    #[must_use]
    pub fn watched(self, pace: Option<&'a Pace>) -> Self {
        Self { pace, ..self }
    }

    pub(super) fn problem(&self) -> Problem<'_> {
        let (scaling, settings) = (&self.scaling, &self.settings);
        let watched = (self.stop, self.pace);
        Problem::over(&self.grid, self.system, scaling, settings, watched)
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
        let states = checkpoint.scaled.len();
        if states != self.scaled.len() || checkpoint.next > self.grid.count {
            return Err(CheckpointMismatch {
                states,
                next: checkpoint.next,
                expected: self.scaled.len(),
                count: self.grid.count,
            });
        }
        self.checkpoint = checkpoint.clone();
        self.next = checkpoint.next;
        self.counters = checkpoint.counters;
        self.stiffness = checkpoint.stiffness;
        self.begin_afresh();
        Ok(())
    }

    /// Lets the method begin afresh at the latest end of a segment.
    fn begin_afresh(&mut self) {
        self.scaled.clone_from(&self.checkpoint.scaled);
        self.step = self.checkpoint.step;
        if self.next > 0 {
            let start = Start {
                time: self.grid.time(self.next),
                deviation: self.scaling.deviation(&self.scaled),
                step: self.step,
                counters: self.counters,
                interval: self.grid.interval,
            };
            let (method, method_use) = (self.settings.method, self.checkpoint.method_use);
            self.stepper = Stepper::new(method, method_use, &self.problem(), &start);
        }
    }

    /// Takes note of the end of a segment in a scaled state.
    pub(super) fn end_segment(&mut self, scaled: Vec<f64>) {
        self.checkpoint = Checkpoint {
            next: self.next,
            scaled,
            step: self.step,
            counters: self.counters,
            stiffness: self.stiffness,
            method_use: self.method_use(),
        };
        self.begin_afresh();
    }

    /// Work done so far.
    pub fn counters(&self) -> Counters {
        self.counters
    }

    /// Stiffness that an explicit method met, where it was first seen: stability held its steps far
    /// below what accuracy asks for. [`Integration::advance`] checks for it at its end, once in some
    /// thousand steps: where there are fewer, they are no burden.
    pub fn stiffness(&self) -> Option<Stiffness> {
        self.stiffness
    }

    /// Which method carried the run, where the choice was left open.
    pub fn method_use(&self) -> Option<MethodUse> {
        self.stepper.method_use()
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
        let checks_before = self.counters.steps / CHECK_EVERY;
        match LibraryMethod::of(self.settings.method) {
            Some(method) => self.by_blocks(method, points, states)?,
            None => self.by_steps(points, states)?,
        }
        let due = self.counters.steps / CHECK_EVERY != checks_before;
        if due && self.stiffness.is_none() && self.step < self.grid.interval {
            // steps that are longer than the distance of the samples are no burden
            self.stiffness = self.find_stiffness(self.grid.time(self.next));
            if self.checkpoint.next == self.next {
                self.checkpoint.stiffness = self.stiffness;
            }
        }
        Ok(())
    }

    /// Integrates by steps of this crate's own, which a block's end does not cut.
    fn by_steps(&mut self, points: usize, states: &mut States) -> Result<(), IntegrateError> {
        for _ in 0..points {
            let steps_before = self.counters.steps;
            match self.next_state() {
                Ok(()) => {
                    states.push(&self.state);
                    self.next += 1;
                    if is_check_due(&self.problem(), steps_before, self.counters.steps) {
                        self.give_up_where_stiff()?;
                    }
                }
                Err(IntegrateError::StepLimit { time, limit }) => {
                    self.give_up_where_stiff()?;
                    return Err(IntegrateError::StepLimit { time, limit });
                }
                Err(error) => return Err(error),
            }
            if self.next.is_multiple_of(SEGMENT) && self.next < self.grid.count {
                self.next_state()?;
                self.note_progress();
                self.end_segment(self.scaling.scaled(&self.state));
            }
        }
        // a state within a step may take evaluations, too
        self.note_progress();
        Ok(())
    }

    /// Finds the state at the next grid time.
    fn next_state(&mut self) -> Result<(), IntegrateError> {
        let time = self.grid.time(self.next);
        let is_within = self.stepper.method().time() >= time;
        let (scaling, settings) = (&self.scaling, &self.settings);
        let watched = (self.stop, self.pace);
        let problem = Problem::over(&self.grid, self.system, scaling, settings, watched);
        let result = self.stepper.state_at(&problem, time, &mut self.state);
        if !is_within || result.is_err() {
            self.note_progress();
        }
        result
    }

    /// Takes note of the work and the step size that the stepper has come to.
    fn note_progress(&mut self) {
        (self.counters, self.step) = self.stepper.progress();
    }

    /// Ends a run that stability keeps from its end.
    fn give_up_where_stiff(&self) -> Result<(), IntegrateError> {
        let time = self.stepper.method().time();
        let stiffness = self.find_stiffness(time);
        let ending = |found: Stiffness| found.ending(&self.problem(), self.counters.steps);
        stiffness.and_then(ending).map_or(Ok(()), Err)
    }

    fn find_stiffness(&self, time: f64) -> Option<Stiffness> {
        let (problem, step) = (self.problem(), self.step);
        match LibraryMethod::of(self.settings.method) {
            Some(method) => {
                let deviation = self.scaling.deviation(&self.scaled);
                stiffness(&problem, method.stability_limit(), time, &deviation, step)
            }
            None => {
                let method = self.stepper.method();
                let limit = method.stability_limit()?;
                stiffness(&problem, limit, time, method.deviation(), step)
            }
        }
    }
}
