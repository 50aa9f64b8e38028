//! A state carried along a grid of times, block by block, and from break to break.

use std::sync::atomic::AtomicBool;

use nalgebra::Const;

use super::adapter::{self, ExplicitMethod};
use super::block::Block;
use super::course::Course;
use super::rosenbrock;
use super::stepper::{Start, Stepper};
use super::stiffness::stiffness;
use super::{
    Checkpoint, CheckpointMismatch, Counters, IntegrateError, Linearised, Method, MethodUse,
    SEGMENT, Scaling, Settings, Square, Stiffness,
};

/// Uniform grid of times: `t_k = k · interval`, k = 0 … count − 1.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Grid {
    /// Distance of two grid times, s, positive.
    pub interval: f64,
    /// Number of grid times.
    pub count: u64,
}

impl Grid {
    /// Time of a grid point, s; free of accumulated round-off.
    pub fn time(&self, index: u64) -> f64 {
        index as f64 * self.interval
    }

    /// Breaks nearer than this to a grid time, or to another break, count as standing there, s.
    pub(super) fn slack(&self) -> f64 {
        BREAK_SLACK * self.interval
    }
}

/// Distance, as a part of the grid's interval, below which a break does not divide a step.
const BREAK_SLACK: f64 = 1e-6;
/// Steps between two looks for stiffness: the implicit method's trial then costs a few per cent of them.
const LOOK_EVERY: u64 = 2000;
/// Part of the limit on steps after which a run is looked at for stiffness that keeps it from its end,
/// time and again.
const EARLY: f64 = 0.01;

/// An integration under way: it knows its state at a grid time and how to go on.
///
/// `M` must be `N + 1`.
pub struct Integration<'a, S, const N: usize, const M: usize> {
    system: &'a S,
    scaling: Scaling<N>,
    grid: Grid,
    settings: Settings,
    stop: &'a AtomicBool,
    scaled: [f64; N],
    next: u64,
    step: f64,
    counters: Counters,
    stiffness: Option<Stiffness>,
    /// Of the methods of this crate whose steps do not end with a block.
    stepper: Stepper<N>,
    /// The latest end of a segment.
    checkpoint: Checkpoint,
}

impl<'a, S, const N: usize, const M: usize> Integration<'a, S, N, M>
where
    S: Linearised<N>,
    Const<N>: Square,
{
    /// Starts at time 0 in `state`. Setting `stop` ends the integration at its next step.
    pub fn new(
        system: &'a S,
        scaling: Scaling<N>,
        grid: Grid,
        settings: Settings,
        stop: &'a AtomicBool,
        state: &[f64; N],
    ) -> Self {
        let open = settings.method == Method::Auto;
        let start = Start {
            time: 0.0,
            deviation: std::array::from_fn(|i| state[i] - scaling.origin[i]),
            step: 0.0,
            counters: Counters::default(),
            method_use: open.then(|| MethodUse::of(system)),
        };
        let scaled = scaling.scaled(state);
        Self {
            system,
            scaling,
            grid,
            settings,
            stop,
            scaled,
            next: 0,
            step: 0.0,
            counters: Counters::default(),
            stiffness: None,
            stepper: Stepper::new(settings.method, &start, grid.interval),
            checkpoint: Checkpoint {
                next: 0,
                scaled: scaled.to_vec(),
                step: 0.0,
                counters: Counters::default(),
                stiffness: None,
                method_use: start.method_use,
            },
        }
    }

    /// What it takes to go on another time from the latest end of a segment.
    pub fn checkpoint(&self) -> &Checkpoint {
        &self.checkpoint
    }

    /// Goes on from where another integration of the same system, scaling, grid and settings stood; the states that
    /// follow are the same, bit by bit.
    ///
    /// # Errors
    /// [`CheckpointMismatch`] where it cannot be one of the same system and grid.
    pub fn go_on_from(&mut self, checkpoint: &Checkpoint) -> Result<(), CheckpointMismatch> {
        let mismatch = CheckpointMismatch {
            states: checkpoint.scaled.len(),
            next: checkpoint.next,
            expected: N,
            count: self.grid.count,
        };
        let scaled: [f64; N] = checkpoint.scaled[..].try_into().map_err(|_| mismatch)?;
        if checkpoint.next > self.grid.count {
            return Err(mismatch);
        }
        self.checkpoint = checkpoint.clone();
        self.next = checkpoint.next;
        self.counters = checkpoint.counters;
        self.stiffness = checkpoint.stiffness;
        self.begin_afresh(scaled);
        Ok(())
    }

    /// Lets the method begin afresh at the latest end of a segment.
    fn begin_afresh(&mut self, scaled: [f64; N]) {
        self.scaled = scaled;
        self.step = self.checkpoint.step;
        if self.next > 0 {
            let start = Start {
                time: self.grid.time(self.next),
                deviation: std::array::from_fn(|i| self.scaling.scale[i] * scaled[i]),
                step: self.step,
                counters: self.counters,
                method_use: self.checkpoint.method_use,
            };
            self.stepper = Stepper::new(self.settings.method, &start, self.grid.interval);
        }
    }

    /// Takes note of the end of a segment in a scaled state.
    fn end_segment(&mut self, scaled: [f64; N]) {
        self.checkpoint = Checkpoint {
            next: self.next,
            scaled: scaled.to_vec(),
            step: self.step,
            counters: self.counters,
            stiffness: self.stiffness,
            method_use: self.method_use(),
        };
        self.begin_afresh(scaled);
    }

    /// Work done so far.
    pub fn counters(&self) -> Counters {
        self.counters
    }

    /// Stiffness that an explicit method met, where it was first seen: stability held its steps far
    /// below what accuracy asks for. [`Integration::advance`] looks for it at its end, once in some
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
    pub fn advance(
        &mut self,
        points: usize,
        states: &mut Vec<[f64; N]>,
    ) -> Result<(), IntegrateError> {
        let left = self.grid.count - self.next;
        let points = usize::try_from(left).unwrap_or(usize::MAX).min(points);
        let looks_before = self.counters.steps / LOOK_EVERY;
        match self.settings.method {
            Method::Dopri5 | Method::Dop853 | Method::Rodas => self.by_blocks(points, states),
            Method::Verner76 | Method::Exponential | Method::Auto => self.by_steps(points, states),
        }?;
        let due = self.counters.steps / LOOK_EVERY != looks_before;
        if due && self.stiffness.is_none() && self.step < self.grid.interval {
            // steps that are longer than the distance of the samples are no burden
            self.stiffness = self.look_for_stiffness(self.grid.time(self.next));
            if self.checkpoint.next == self.next {
                self.checkpoint.stiffness = self.stiffness;
            }
        }
        Ok(())
    }

    /// Integrates by steps of this crate's own, which a block's end does not cut.
    fn by_steps(
        &mut self,
        points: usize,
        states: &mut Vec<[f64; N]>,
    ) -> Result<(), IntegrateError> {
        let part = ((EARLY * self.settings.step_limit as f64) as u64).max(1);
        for _ in 0..points {
            let steps_before = self.counters.steps;
            match self.next_state() {
                Ok(state) => {
                    states.push(state);
                    self.next += 1;
                    if steps_before / part != self.counters.steps / part {
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
                let state = self.next_state()?;
                self.take_stock();
                self.end_segment(self.scaling.scaled(&state));
            }
        }
        // a state within a step may take evaluations, too
        self.take_stock();
        Ok(())
    }

    /// The state at the next grid time.
    fn next_state(&mut self) -> Result<[f64; N], IntegrateError> {
        let time = self.grid.time(self.next);
        let is_within = self.stepper.time() >= time;
        let (scaling, settings) = (&self.scaling, &self.settings);
        let course = Course::over(&self.grid, self.system, scaling, settings, self.stop);
        let result = self.stepper.state_at(&course, time);
        if !is_within || result.is_err() {
            self.take_stock();
        }
        result
    }

    /// Work, step and state that the stepper has come to.
    fn take_stock(&mut self) {
        (self.counters, self.step, self.scaled) = self.stepper.progress(&self.scaling);
    }

    /// Ends a run that stability keeps from its end.
    fn give_up_where_stiff(&self) -> Result<(), IntegrateError> {
        let time = self.stepper.time();
        let Some(stiffness) = self.look_for_stiffness(time) else {
            return Ok(());
        };
        let left = (self.grid.time(self.grid.count) - time).max(0.0);
        let needed = self.counters.steps as f64 + left / stiffness.step;
        let limit = self.settings.step_limit;
        if needed <= limit as f64 {
            return Ok(());
        }
        Err(IntegrateError::Stiff {
            stiffness,
            needed,
            limit,
        })
    }

    fn look_for_stiffness(&self, time: f64) -> Option<Stiffness> {
        let limit = self.stability_limit()?;
        if self.step <= 0.0 {
            return None;
        }
        let here = self.block(time, self.grid.interval, 1);
        stiffness(&here, limit, time, &self.scaled, self.step)
    }

    /// Product of step and largest eigenvalue at which the method ceases to be stable; none where it
    /// never does.
    fn stability_limit(&self) -> Option<f64> {
        match self.settings.method {
            Method::Dopri5 => Some(ExplicitMethod::Dopri5.stability_limit()),
            Method::Dop853 => Some(ExplicitMethod::Dop853.stability_limit()),
            Method::Rodas => None,
            _ => self.stepper.stability_limit(),
        }
    }

    /// Integrates block by block, cut at breaks, with a method that stands behind [`Block`].
    fn by_blocks(
        &mut self,
        mut points: usize,
        states: &mut Vec<[f64; N]>,
    ) -> Result<(), IntegrateError> {
        while points > 0 {
            let left = SEGMENT - self.next % SEGMENT;
            let left = usize::try_from(left).unwrap_or(usize::MAX);
            let whole = self.intervals_before_break(points.min(left));
            let before = states.len();
            let result = match whole {
                0 => self.cut_interval(states),
                _ => self.stretch(self.grid.time(self.next), self.grid.interval, whole, states),
            };
            self.next += (states.len() - before) as u64;
            result?;
            points -= whole.max(1);
            if self.next.is_multiple_of(SEGMENT) {
                self.end_segment(self.scaled);
            }
        }
        Ok(())
    }

    fn block(&self, start: f64, interval: f64, intervals: usize) -> Block<'_, S, N> {
        let used = self.counters.steps + self.counters.rejected;
        Block {
            system: self.system,
            scaling: &self.scaling,
            settings: &self.settings,
            stop: self.stop,
            start,
            interval,
            intervals,
            first_step: self.step,
            steps_left: self.settings.step_limit.saturating_sub(used),
            run_end: self.grid.time(self.grid.count),
        }
    }

    /// Number of the next intervals, up to `most`, that no break cuts.
    fn intervals_before_break(&self, most: usize) -> usize {
        let start = self.grid.time(self.next);
        let free = self.system.next_break(start + self.grid.slack()) - start;
        let whole = ((free + self.grid.slack()) / self.grid.interval).floor();
        // the cast saturates
        most.min(whole as usize)
    }

    /// Integrates over one interval from break to break.
    fn cut_interval(&mut self, states: &mut Vec<[f64; N]>) -> Result<(), IntegrateError> {
        let (mut start, end) = (self.grid.time(self.next), self.grid.time(self.next + 1));
        let kept = states.len() + 1;
        while start < end {
            let next = self.system.next_break(start + self.grid.slack());
            let stop = if next < end - self.grid.slack() {
                next
            } else {
                end
            };
            let result = self.stretch(start, stop - start, 1, states);
            // the states at the breaks stand on no grid time
            states.truncate(kept);
            result?;
            start = stop;
        }
        Ok(())
    }

    /// Integrates over equal intervals and appends the states at their starts.
    fn stretch(
        &mut self,
        start: f64,
        interval: f64,
        intervals: usize,
        states: &mut Vec<[f64; N]>,
    ) -> Result<(), IntegrateError> {
        let block = self.block(start, interval, intervals);
        let explicit = |method| adapter::integrate::<S, N, M>(method, &block, &self.scaled);
        let outcome = match self.settings.method {
            Method::Dopri5 => explicit(ExplicitMethod::Dopri5),
            Method::Dop853 => explicit(ExplicitMethod::Dop853),
            _ => rosenbrock::integrate(&block, &self.scaled),
        };
        states.extend(
            outcome
                .states
                .iter()
                .map(|scaled| self.scaling.state(scaled)),
        );
        self.counters.add(&outcome.counters);
        if let Some(error) = outcome.error {
            return Err(error);
        }
        self.scaled = outcome.end;
        self.step = outcome.last_step;
        Ok(())
    }
}
