//! What all walks have in common: where steps end, when a walk gives up, and how long a first step is.

use std::sync::atomic::{AtomicBool, Ordering};

use super::{Counters, Grid, IntegrateError, Scaling, Settings, System};

/// Least first guess of a step size, in units of the scaling's time.
const LEAST_GUESS: f64 = 1e-6;
/// Part of a step that the end of a stretch may lengthen it by.
pub(super) const STRETCH: f64 = 1.01;

/// What a walk goes by.
pub(super) struct Course<'a, S, const N: usize> {
    pub system: &'a S,
    pub scaling: &'a Scaling<N>,
    pub settings: &'a Settings,
    pub stop: &'a AtomicBool,
    /// No step ends after this, s.
    pub end: f64,
    /// Breaks nearer than this to a step's start count as standing there, s.
    pub slack: f64,
}

impl<'a, S, const N: usize> Course<'a, S, N> {
    /// Over a grid of times.
    pub fn over(
        grid: &Grid,
        system: &'a S,
        scaling: &'a Scaling<N>,
        settings: &'a Settings,
        stop: &'a AtomicBool,
    ) -> Self {
        Self {
            system,
            scaling,
            settings,
            stop,
            end: grid.time(grid.count.saturating_sub(1)),
            slack: grid.slack(),
        }
    }

    /// Whether another trial may be made of a step that starts at a time; `fault` where one from there
    /// was not finite.
    ///
    /// # Errors
    /// Why it may not.
    pub fn check(
        &self,
        time: f64,
        size: f64,
        counters: &Counters,
        fault: bool,
    ) -> Result<(), IntegrateError> {
        let limit = self.settings.step_limit;
        if self.stop.load(Ordering::Relaxed) {
            return Err(IntegrateError::Interrupted { time });
        }
        if counters.steps + counters.rejected >= limit {
            return Err(IntegrateError::StepLimit { time, limit });
        }
        self.check_progress([time, time + 0.1 * size], size, fault)
    }

    /// Whether a step of a size between two times moves time at all; `fault` where a trial from the first was not
    /// finite.
    ///
    /// # Errors
    /// Why it does not.
    pub fn check_progress(
        &self,
        [time, end]: [f64; 2],
        size: f64,
        fault: bool,
    ) -> Result<(), IntegrateError> {
        if end > time {
            return Ok(());
        }
        Err(if fault {
            IntegrateError::NotFinite { time }
        } else {
            IntegrateError::StepUnderflow { time, step: size }
        })
    }

    /// The state at a deviation from the origin.
    #[inline(always)]
    pub fn state(&self, deviation: &[f64; N]) -> [f64; N] {
        std::array::from_fn(|i| self.scaling.origin[i] + deviation[i])
    }

    /// Root mean square over what is allowed at a deviation.
    pub fn norm(&self, deviation: &[f64; N], vector: &[f64; N]) -> f64 {
        let squares = (0..N).map(|i| {
            let unit = self.scaling.scale[i] + deviation[i].abs();
            (vector[i] / (self.settings.tolerance * unit)).powi(2)
        });
        (squares.sum::<f64>() / N as f64).sqrt()
    }
}

impl<S: System<N>, const N: usize> Course<'_, S, N> {
    /// The time that no step from a time on may reach over, s.
    pub fn limit_after(&self, time: f64) -> f64 {
        let next = self.system.next_break(time + self.slack);
        if next < self.end - self.slack {
            next
        } else {
            self.end
        }
    }

    /// Size of the first step from a deviation with its slope for a method of an order, s; takes one
    /// evaluation.
    ///
    /// Source: Hairer, Nørsett & Wanner, *Solving Ordinary Differential Equations I*, sec. II.4.
    pub fn first_size(
        &self,
        [start, limit]: [f64; 2],
        deviation: &[f64; N],
        slope: &[f64; N],
        order: i32,
    ) -> f64 {
        let state_size = self.norm(deviation, deviation);
        let slope_size = self.norm(deviation, slope);
        let least = LEAST_GUESS * self.scaling.time;
        let most = (limit - start).max(least);
        // no number where nothing moves
        let guess = (0.01 * state_size / slope_size).max(least).min(most);
        let origin = &self.scaling.origin;
        let ahead = std::array::from_fn(|i| origin[i] + (deviation[i] + guess * slope[i]));
        let mut rate = [0.0; N];
        self.system.derivative(start + guess, &ahead, &mut rate);
        let change = std::array::from_fn(|i| rate[i] - slope[i]);
        let bend_size = self.norm(deviation, &change) / guess;
        let fastest = slope_size.max(bend_size);
        (0.01 / fastest)
            .powf(1.0 / f64::from(order))
            .min(100.0 * guess)
    }
}
