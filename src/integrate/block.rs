//! Integration block by block, cut at breaks: for methods whose steps end with a block of samples.

use super::problem::Problem;
use super::{Counters, IntegrateError, Integration, Method, SEGMENT, States, adapter, rosenbrock};

/// Error allowed in one step, as a part of the error aimed at over the run: local errors add up.
const LOCAL_PART: f64 = 0.25;

/// A block of the grid to integrate over.
#[derive(Clone, Copy)]
pub(super) struct Block<'a> {
    pub problem: Problem<'a>,
    /// Time at the start of the block, s.
    pub start: f64,
    /// Distance of the grid points, s.
    pub interval: f64,
    /// Number of intervals in the block.
    pub intervals: usize,
    /// Step size to start with in s; zero lets the method choose.
    pub first_step: f64,
    /// Steps that are left of the limit.
    pub steps_left: u64,
}

/// What came of a block.
pub(super) struct Outcome {
    /// Scaled states at the grid points, the first at the block's start, the end left out.
    pub states: States,
    /// Scaled state at the end of the block.
    pub end: Vec<f64>,
    /// A good step size to go on with, s.
    pub last_step: f64,
    pub counters: Counters,
    pub error: Option<IntegrateError>,
}

impl Block<'_> {
    /// Error allowed in one step, relative to one plus the scaled state.
    pub fn local_tolerance(&self) -> f64 {
        LOCAL_PART * self.problem.settings.tolerance
    }

    /// Writes the derivative of a scaled state by scaled time, at a time in s; `state` is room for the state.
    pub fn scaled_derivative(
        &self,
        time: f64,
        scaled: &[f64],
        state: &mut [f64],
        rate: &mut [f64],
    ) {
        let scaling = self.problem.scaling;
        scaling.write_state(scaled, state);
        self.problem.system.derivative(time, state, rate);
        for (rate, scale) in rate.iter_mut().zip(&scaling.scale) {
            *rate *= scaling.time / scale;
        }
    }
}

impl Integration<'_> {
    /// Integrates block by block over so many grid times.
    pub(super) fn by_blocks(
        &mut self,
        mut points: usize,
        states: &mut States,
    ) -> Result<(), IntegrateError> {
        while points > 0 {
            let left = SEGMENT - self.next % SEGMENT;
            let left = usize::try_from(left).unwrap_or(usize::MAX);
            let whole = self.intervals_before_break(points.min(left));
            let before = states.len();
            let result = match whole {
                0 => self.cut_interval(states),
                _ => {
                    let start = self.grid.time(self.next);
                    self.integrate_block(start, self.grid.interval, whole, states)
                }
            };
            self.next += (states.len() - before) as u64;
            result?;
            points -= whole.max(1);
            if self.next.is_multiple_of(SEGMENT) {
                self.end_segment(self.scaled.clone());
            }
        }
        Ok(())
    }

    pub(super) fn block(&self, start: f64, interval: f64, intervals: usize) -> Block<'_> {
        let used = self.counters.steps + self.counters.rejected;
        Block {
            problem: self.problem(),
            start,
            interval,
            intervals,
            first_step: self.step,
            steps_left: self.settings.step_limit.saturating_sub(used),
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
    fn cut_interval(&mut self, states: &mut States) -> Result<(), IntegrateError> {
        let (mut start, end) = (self.grid.time(self.next), self.grid.time(self.next + 1));
        let kept = states.len() + 1;
        while start < end {
            let next = self.system.next_break(start + self.grid.slack());
            let stop = if next < end - self.grid.slack() {
                next
            } else {
                end
            };
            let result = self.integrate_block(start, stop - start, 1, states);
            // the states at the breaks stand on no grid time
            states.resize(states.len().min(kept));
            result?;
            start = stop;
        }
        Ok(())
    }

    /// Integrates over equal intervals and appends the states at their starts.
    fn integrate_block(
        &mut self,
        start: f64,
        interval: f64,
        intervals: usize,
        states: &mut States,
    ) -> Result<(), IntegrateError> {
        let block = self.block(start, interval, intervals);
        let outcome = match adapter::LibraryMethod::of(self.settings.method) {
            Some(method) => adapter::integrate(method, &block, &self.scaled),
            None => rosenbrock::integrate(&block, &self.scaled),
        };
        for scaled in outcome.states.iter() {
            self.scaling.write_state(scaled, &mut self.state);
            states.push(&self.state);
        }
        self.counters.add(&outcome.counters);
        if let Some(error) = outcome.error {
            return Err(error);
        }
        self.scaled = outcome.end;
        self.step = outcome.last_step;
        Ok(())
    }

    /// Whether the method integrates block by block.
    pub(super) fn is_by_blocks(&self) -> bool {
        matches!(
            self.settings.method,
            Method::Dopri5 | Method::Dop853 | Method::Rodas
        )
    }
}
