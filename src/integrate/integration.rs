//! A state carried along a grid of times, block by block, and from break to break.

use std::sync::atomic::AtomicBool;

use nalgebra::Const;

use super::adapter::{self, ExplicitMethod};
use super::block::Block;
use super::explicit::{Course, Dop853, Pair, Tsit5, Verner76, Walk};
use super::rosenbrock;
use super::{Counters, IntegrateError, Linearised, Method, Scaling, Settings, Square};

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
}

/// Distance, as a part of the grid's interval, below which a break does not divide a step.
const BREAK_SLACK: f64 = 1e-6;

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
    /// Where the pairs of this crate stand: their steps do not end with a block.
    walk: Walk<N>,
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
        Self {
            system,
            scaling,
            grid,
            settings,
            stop,
            scaled: scaling.scaled(state),
            next: 0,
            step: 0.0,
            counters: Counters::default(),
            walk: Walk::new(std::array::from_fn(|i| state[i] - scaling.origin[i])),
        }
    }

    /// Work done so far.
    pub fn counters(&self) -> Counters {
        self.counters
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
        match self.settings.method {
            Method::Verner76 => self.walk::<Verner76>(points, states),
            Method::Dop853 => self.walk::<Dop853>(points, states),
            Method::Tsit5 => self.walk::<Tsit5>(points, states),
            Method::Dopri5 | Method::OdeSolversDop853 | Method::Rodas => {
                self.by_blocks(points, states)
            }
        }
    }

    /// Walks with a pair of this crate; a block's end is no end of a step.
    fn walk<P: Pair>(
        &mut self,
        points: usize,
        states: &mut Vec<[f64; N]>,
    ) -> Result<(), IntegrateError> {
        let course = Course {
            system: self.system,
            scaling: &self.scaling,
            settings: &self.settings,
            stop: self.stop,
            end: self.grid.time(self.grid.count.saturating_sub(1)),
            slack: self.slack(),
        };
        let mut result = Ok(());
        for _ in 0..points {
            let time = self.grid.time(self.next);
            match self.walk.state_at::<P, S>(&course, time) {
                Ok(state) => states.push(state),
                Err(error) => {
                    result = Err(error);
                    break;
                }
            }
            self.next += 1;
        }
        self.counters = self.walk.counters();
        result
    }

    /// Integrates block by block, cut at breaks, with a method that stands behind [`Block`].
    fn by_blocks(
        &mut self,
        mut points: usize,
        states: &mut Vec<[f64; N]>,
    ) -> Result<(), IntegrateError> {
        while points > 0 {
            let whole = self.intervals_before_break(points);
            let before = states.len();
            let result = match whole {
                0 => self.cut_interval(states),
                _ => self.stretch(self.grid.time(self.next), self.grid.interval, whole, states),
            };
            self.next += (states.len() - before) as u64;
            result?;
            points -= whole.max(1);
        }
        Ok(())
    }

    /// Breaks nearer than this to a grid time, or to another break, count as standing there, s.
    fn slack(&self) -> f64 {
        BREAK_SLACK * self.grid.interval
    }

    /// Number of the next intervals, up to `most`, that no break cuts.
    fn intervals_before_break(&self, most: usize) -> usize {
        let start = self.grid.time(self.next);
        let free = self.system.next_break(start + self.slack()) - start;
        let whole = ((free + self.slack()) / self.grid.interval).floor();
        // the cast saturates
        most.min(whole as usize)
    }

    /// Integrates over one interval from break to break.
    fn cut_interval(&mut self, states: &mut Vec<[f64; N]>) -> Result<(), IntegrateError> {
        let (mut start, end) = (self.grid.time(self.next), self.grid.time(self.next + 1));
        let kept = states.len() + 1;
        while start < end {
            let next = self.system.next_break(start + self.slack());
            let stop = if next < end - self.slack() { next } else { end };
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
        let used = self.counters.steps + self.counters.rejected;
        let block = Block {
            system: self.system,
            scaling: &self.scaling,
            settings: &self.settings,
            stop: self.stop,
            start,
            interval,
            intervals,
            first_step: self.step,
            steps_left: self.settings.step_limit.saturating_sub(used),
        };
        let explicit = |method| adapter::integrate::<S, N, M>(method, &block, &self.scaled);
        let outcome = match self.settings.method {
            Method::Dopri5 => explicit(ExplicitMethod::Dopri5),
            Method::OdeSolversDop853 => explicit(ExplicitMethod::Dop853),
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
