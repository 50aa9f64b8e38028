//! A system with its settings, and what all steppers share: where steps end, when a run is given up, how long the first
//! step is, and how its size follows the error.

use std::sync::atomic::{AtomicBool, Ordering};

use super::{Counters, IntegrateError, Progress, Scaling, Settings, System};

/// Least first guess of a step size, in units of the scaling's time.
const LEAST_GUESS: f64 = 1e-6;
/// Factor by which a step may be longer, so as to end at a break, a landing or the end of the run.
pub(super) const STRETCH: f64 = 1.01;

/// Part of the samples' interval below which two times are one.
pub(super) const SLACK: f64 = 1e-6;

/// A system with the settings of its integration.
#[derive(Clone)]
pub(super) struct Problem<'a> {
    pub system: &'a dyn System,
    pub scaling: Scaling,
    pub settings: Settings,
    pub stop: &'a AtomicBool,
    pub progress: Option<&'a Progress>,
    /// Interval of the samples, s.
    pub interval: f64,
    /// No step ends after this, s.
    pub end: f64,
}

impl Problem<'_> {
    /// Breaks nearer than this to a step's start, or to a sample, count as being there, s.
    pub fn slack(&self) -> f64 {
        SLACK * self.interval
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
        if let Some(progress) = self.progress {
            progress.record(time, counters);
        }
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

    /// Writes the state at a deviation from the origin.
    #[inline]
    pub fn write_state(&self, deviation: &[f64], state: &mut [f64]) {
        let parts = self.scaling.origin.iter().zip(deviation);
        for (state, (origin, deviation)) in state.iter_mut().zip(parts) {
            *state = origin + deviation;
        }
    }

    /// Root mean square over what is allowed at a deviation.
    pub fn norm(&self, deviation: &[f64], vector: &[f64]) -> f64 {
        let units = self.scaling.scale.iter().zip(deviation);
        let squares = vector.iter().zip(units).map(|(value, (scale, deviation))| {
            let unit = scale + deviation.abs();
            (value / (self.settings.tolerance * unit)).powi(2)
        });
        (squares.sum::<f64>() / vector.len() as f64).sqrt()
    }

    /// The time that no step from a time on may reach over, s.
    pub fn limit_after(&self, time: f64) -> f64 {
        let next = self.system.next_break(time + self.slack());
        if next < self.end - self.slack() {
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
        deviation: &[f64],
        slope: &[f64],
        order: i32,
    ) -> f64 {
        let state_size = self.norm(deviation, deviation);
        let slope_size = self.norm(deviation, slope);
        let least = LEAST_GUESS * self.scaling.time;
        let most = (limit - start).max(least);
        // no number where nothing moves
        let guess = (0.01 * state_size / slope_size).max(least).min(most);
        let moved = deviation.iter().zip(slope);
        let moved: Vec<f64> = moved.map(|(from, slope)| from + guess * slope).collect();
        let [mut ahead, mut change] = [moved.clone(), moved.clone()];
        self.write_state(&moved, &mut ahead);
        self.system.derivative(start + guess, &ahead, &mut change);
        for (change, slope) in change.iter_mut().zip(slope) {
            *change -= slope;
        }
        let bend_size = self.norm(deviation, &change) / guess;
        let fastest = slope_size.max(bend_size);
        (0.01 / fastest)
            .powf(1.0 / f64::from(order))
            .min(100.0 * guess)
    }
}

/// Part of the step that the error estimate would allow: over surfaces larger ones are rejected too often.
const SAFETY: f64 = 0.8;
/// Least and largest change of the size from one trial to the next.
const SHRINK: f64 = 0.2;
pub(super) const GROW: f64 = 6.0;

/// Factors of the step size from errors: `h₁/h = 0.8 error^(−1/p)`, where an error of one is just allowed and the error
/// falls with the power p of the size.
///
/// A part proportional to the change of the error, as K. Gustafsson proposes (*ACM Trans. Math. Softw.*
/// 17 (1991) 533–554), was tried at 0.1 to 0.4 of the exponent: evaluations to a given error moved by
/// less than their scatter, on smooth motion and over surfaces.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Control {
    /// Whether the latest trial was rejected.
    pub rejected: bool,
}

impl Control {
    /// Factor after a good step; none above one directly after a bad one.
    pub fn accepted(&mut self, error: f64, power: i32) -> f64 {
        let most = if self.rejected { 1.0 } else { GROW };
        self.rejected = false;
        growth(error, power).clamp(SHRINK, most)
    }

    /// Factor after a bad step, whose error may be no number.
    pub fn rejected(&mut self, error: f64, power: i32) -> f64 {
        self.rejected = true;
        growth(error, power).max(SHRINK)
    }
}

fn growth(error: f64, power: i32) -> f64 {
    SAFETY * error.powf(-1.0 / f64::from(power))
}
