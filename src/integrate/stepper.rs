//! The stepper of the method in use.

use super::auto::{Choice, MethodUse};
use super::course::Course;
use super::explicit::{self, Pair, Verner76};
use super::exponential::ExponentialWalk;
use super::{Counters, IntegrateError, Linearised, Method, Scaling};

/// The stepper of a method of this crate, whose steps do not end with a block of samples.
#[derive(Debug, Clone)]
pub(super) struct Stepper<const N: usize> {
    of: Of<N>,
    /// Where the choice of the method is left open.
    choice: Option<Choice<N>>,
    /// Interval of the samples, s.
    interval: f64,
}

#[derive(Debug, Clone)]
enum Of<const N: usize> {
    Explicit(Box<explicit::Walk<N>>),
    Exponential(Box<ExponentialWalk<N>>),
}

/// The same of either.
macro_rules! either {
    ($of:expr, $stepper:ident => $value:expr) => {
        match $of {
            Of::Explicit($stepper) => $value,
            Of::Exponential($stepper) => $value,
        }
    };
}

/// Where a stepper begins.
#[derive(Debug, Clone, Copy)]
pub(super) struct Start<const N: usize> {
    /// s.
    pub time: f64,
    /// From the scaling's origin.
    pub deviation: [f64; N],
    /// Size of the first step, s; zero where it is to find its own.
    pub step: f64,
    /// Work done before.
    pub counters: Counters,
    /// Which method has carried the run, where the choice is left open and it is under way.
    pub method_use: Option<MethodUse>,
}

impl<const N: usize> Of<N> {
    fn new(method: Method, start: &Start<N>, interval: f64) -> Self {
        let Start {
            time,
            deviation,
            step,
            counters,
            ..
        } = *start;
        match method {
            Method::Exponential => {
                let times = [time, interval];
                let stepper = ExponentialWalk::new(times, deviation, step, counters);
                Self::Exponential(Box::new(stepper))
            }
            _ => Self::Explicit(Box::new(explicit::Walk::new(
                time, deviation, step, counters,
            ))),
        }
    }
}

impl<const N: usize> Stepper<N> {
    /// By a method, before samples at an interval, s.
    pub fn new(method: Method, start: &Start<N>, interval: f64) -> Self {
        let method = start.method_use.map_or(method, |used| used.latest());
        Self {
            of: Of::new(method, start, interval),
            choice: start.method_use.map(Choice::new),
            interval,
        }
    }

    /// State at a time that is not before the start of the latest step; steps on as far as needed.
    ///
    /// # Errors
    /// Why the run ends before that time.
    #[inline]
    pub fn state_at<S: Linearised<N>>(
        &mut self,
        course: &Course<'_, S, N>,
        time: f64,
    ) -> Result<[f64; N], IntegrateError> {
        while self.time() < time {
            self.step(course)?;
        }
        Ok(match &mut self.of {
            Of::Explicit(stepper) => stepper.state_within::<Verner76, S>(course, time),
            Of::Exponential(stepper) => stepper.state_within(course, time),
        })
    }

    fn step<S: Linearised<N>>(&mut self, course: &Course<'_, S, N>) -> Result<(), IntegrateError> {
        let stepper = match &mut self.of {
            Of::Explicit(stepper) => return stepper.step::<Verner76, S>(course),
            Of::Exponential(stepper) => stepper,
        };
        let (start, from) = (stepper.time(), stepper.deviation());
        let ending = stepper.step(course);
        let Some(choice) = &mut self.choice else {
            return ending;
        };
        let (time, deviation) = (stepper.time(), stepper.deviation());
        if choice.is_over(course, [start, time], [&from, &deviation], ending)? {
            let start = Start {
                time,
                deviation,
                // the pair finds its own first step
                step: 0.0,
                counters: stepper.counters(),
                method_use: None,
            };
            self.of = Of::new(Method::Verner76, &start, self.interval);
        }
        Ok(())
    }

    /// Product of step and largest eigenvalue at which the method ceases to be stable; none where nothing holds it.
    pub fn stability_limit(&self) -> Option<f64> {
        match self.of {
            Of::Explicit(_) => Some(Verner76::STABILITY),
            Of::Exponential(_) => None,
        }
    }

    /// Which method carried the run, where the choice is left open.
    pub fn method_use(&self) -> Option<MethodUse> {
        self.choice.as_ref().map(|choice| choice.method_use)
    }

    /// End of the latest step, s.
    pub fn time(&self) -> f64 {
        either!(&self.of, stepper => stepper.time())
    }

    /// Work done so far, the size of the latest step or of the one to come, s, and the scaled state at the end of the
    /// latest.
    pub fn progress(&self, scaling: &Scaling<N>) -> (Counters, f64, [f64; N]) {
        either!(&self.of, stepper => (stepper.counters(), stepper.step_size(), stepper.scaled(scaling)))
    }
}
