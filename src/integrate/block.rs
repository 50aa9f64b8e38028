//! Integration block by block, cut at breaks: for the library's methods, whose steps end with a block of samples.

use super::adapter::{self, LibraryMethod};
use super::problem::Problem;
use super::{Counters, IntegrateError, Integration, SEGMENT, States};

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

impl Integration<'_> {
    /// Integrates block by block over so many grid times.
    pub(super) fn by_blocks(
        &mut self,
        method: LibraryMethod,
        mut points: usize,
        states: &mut States,
    ) -> Result<(), IntegrateError> {
        while points > 0 {
            let left = SEGMENT - self.next % SEGMENT;
            let left = usize::try_from(left).unwrap_or(usize::MAX);
            let whole = self.intervals_before_break(points.min(left));
            let before = states.len();
            let result = match whole {
                0 => self.cut_interval(method, states),
                _ => {
                    let start = self.grid.time(self.next);
                    self.integrate_block(method, [start, self.grid.interval], whole, states)
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

    /// Number of the next intervals, up to `most`, that no break cuts.
    fn intervals_before_break(&self, most: usize) -> usize {
        let start = self.grid.time(self.next);
        let free = self.system.next_break(start + self.grid.slack()) - start;
        let whole = ((free + self.grid.slack()) / self.grid.interval).floor();
        // the cast saturates
        most.min(whole as usize)
    }

    /// Integrates over one interval from break to break.
    fn cut_interval(
        &mut self,
        method: LibraryMethod,
        states: &mut States,
    ) -> Result<(), IntegrateError> {
        let (mut start, end) = (self.grid.time(self.next), self.grid.time(self.next + 1));
        let kept = states.len() + 1;
        while start < end {
            let next = self.system.next_break(start + self.grid.slack());
            let stop = if next < end - self.grid.slack() {
                next
            } else {
                end
            };
            let result = self.integrate_block(method, [start, stop - start], 1, states);
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
        method: LibraryMethod,
        [start, interval]: [f64; 2],
        intervals: usize,
        states: &mut States,
    ) -> Result<(), IntegrateError> {
        let used = self.counters.steps + self.counters.rejected;
        let block = Block {
            problem: self.problem(),
            start,
            interval,
            intervals,
            first_step: self.step,
            steps_left: self.settings.step_limit.saturating_sub(used),
        };
        let outcome = adapter::integrate(method, &block, &self.scaled);
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
}
