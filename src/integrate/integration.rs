//! A state carried along a grid of times, block by block.

use std::sync::atomic::AtomicBool;

use nalgebra::Const;

use super::adapter::{self, ExplicitMethod};
use super::block::Block;
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
        if points == 0 {
            return Ok(());
        }
        let used = self.counters.steps + self.counters.rejected;
        let block = Block {
            system: self.system,
            scaling: &self.scaling,
            settings: &self.settings,
            stop: self.stop,
            start: self.grid.time(self.next),
            interval: self.grid.interval,
            intervals: points,
            first_step: self.step,
            steps_left: self.settings.step_limit.saturating_sub(used),
        };
        let explicit = |method| adapter::integrate::<S, N, M>(method, &block, &self.scaled);
        let outcome = match self.settings.method {
            Method::Dopri5 => explicit(ExplicitMethod::Dopri5),
            Method::Dop853 => explicit(ExplicitMethod::Dop853),
            Method::Rodas => rosenbrock::integrate(&block, &self.scaled),
        };
        states.extend(
            outcome
                .states
                .iter()
                .map(|scaled| self.scaling.state(scaled)),
        );
        self.next += outcome.states.len() as u64;
        self.counters.add(&outcome.counters);
        if let Some(error) = outcome.error {
            return Err(error);
        }
        self.scaled = outcome.end;
        self.step = outcome.last_step;
        Ok(())
    }
}
