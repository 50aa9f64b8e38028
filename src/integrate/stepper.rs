//! The stepper of the method in use.

use super::auto::{AutoStepper, MethodUse};
use super::course::Course;
use super::explicit::{self, Pair, Verner76};
use super::exponential::ExponentialWalk;
use super::{Counters, IntegrateError, Linearised, Method, Scaling};

/// The stepper of a method of this crate whose steps do not end with a block; of others, one at the start.
#[derive(Debug, Clone)]
pub(super) enum Stepper<const N: usize> {
    Explicit(Box<explicit::Walk<N>>),
    Exponential(Box<ExponentialWalk<N>>),
    Auto(Box<AutoStepper<N>>),
}

/// The same of any stepper.
macro_rules! any {
    ($steppers:expr, $stepper:ident => $of:expr) => {
        match $steppers {
            Self::Explicit($stepper) => $of,
            Self::Exponential($stepper) => $of,
            Self::Auto($stepper) => $of,
        }
    };
}

impl<const N: usize> Stepper<N> {
    /// At time 0 in a deviation from the origin, before samples at an interval, s.
    pub fn new(method: Method, deviation: [f64; N], interval: f64) -> Self {
        match method {
            Method::Exponential => {
                Self::Exponential(Box::new(ExponentialWalk::new(deviation, interval)))
            }
            Method::Auto => Self::Auto(Box::new(AutoStepper::new(deviation, interval))),
            _ => Self::Explicit(Box::new(explicit::Walk::new(deviation))),
        }
    }

    /// The stepper of numbers as by [`Stepper::numbers`], with its counters; none of any others.
    pub fn restored(
        method: Method,
        numbers: &[f64],
        counters: Counters,
        interval: f64,
    ) -> Option<Self> {
        Some(match method {
            Method::Exponential => {
                let stepper = ExponentialWalk::restored(numbers, counters, interval)?;
                Self::Exponential(Box::new(stepper))
            }
            Method::Auto => {
                let stepper = AutoStepper::restored(numbers, counters, interval)?;
                Self::Auto(Box::new(stepper))
            }
            _ => Self::Explicit(Box::new(explicit::Walk::restored(numbers, counters)?)),
        })
    }

    /// State at a time that is not before the start of the latest step; steps on as far as needed.
    ///
    /// # Errors
    /// Why the run ends before that time.
    pub fn state_at<S: Linearised<N>>(
        &mut self,
        course: &Course<'_, S, N>,
        time: f64,
    ) -> Result<[f64; N], IntegrateError> {
        match self {
            Self::Exponential(stepper) => stepper.state_at(course, time),
            Self::Auto(stepper) => stepper.state_at(course, time),
            Self::Explicit(stepper) => stepper.state_at::<Verner76, S>(course, time),
        }
    }

    /// Product of step and largest eigenvalue at which the method ceases to be stable; none where nothing holds it.
    pub fn stability_limit(&self) -> Option<f64> {
        let by_verner = match self {
            Self::Explicit(_) => true,
            Self::Exponential(_) => false,
            Self::Auto(stepper) => stepper.is_explicit(),
        };
        by_verner.then_some(Verner76::STABILITY)
    }

    /// Which method carried the run, where the choice was left open.
    pub fn method_use(&self) -> Option<MethodUse> {
        match self {
            Self::Auto(stepper) => stepper.method_use(),
            _ => None,
        }
    }

    /// End of the latest step, s.
    pub fn time(&self) -> f64 {
        any!(self, stepper => stepper.time())
    }

    /// Work done so far, the size of the latest step or of the one to come, s, and the scaled state at the end of the
    /// latest.
    pub fn progress(&self, scaling: &Scaling<N>) -> (Counters, f64, [f64; N]) {
        any!(self, stepper => (stepper.counters(), stepper.step_size(), stepper.scaled(scaling)))
    }

    /// Everything but the counters as numbers.
    pub fn numbers(&self) -> Vec<f64> {
        any!(self, stepper => stepper.numbers())
    }
}
