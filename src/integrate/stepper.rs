//! The stepper of the method in use.

use super::auto::{Choice, MethodUse};
use super::explicit::{ExplicitStepper, STABILITY};
use super::exponential::ExponentialStepper;
use super::problem::Problem;
use super::rosenbrock::RosenbrockStepper;
use super::{Counters, IntegrateError, Method};

/// The stepper of a method of this crate, whose steps do not end with a block of samples.
#[derive(Debug, Clone)]
pub(super) struct Stepper {
    of: Of,
    /// Where the choice of the method is left open.
    choice: Option<Choice>,
    /// Interval of the samples, s.
    interval: f64,
}

#[derive(Debug, Clone)]
enum Of {
    Explicit(Box<ExplicitStepper>),
    Exponential(Box<ExponentialStepper>),
    Rosenbrock(Box<RosenbrockStepper>),
}

/// The same of each.
macro_rules! each {
    ($of:expr, $stepper:ident => $value:expr) => {
        match $of {
            Of::Explicit($stepper) => $value,
            Of::Exponential($stepper) => $value,
            Of::Rosenbrock($stepper) => $value,
        }
    };
}

/// Where a stepper begins.
#[derive(Debug, Clone)]
pub(super) struct Start {
    /// s.
    pub time: f64,
    /// From the scaling's origin.
    pub deviation: Vec<f64>,
    /// Size of the first step, s; zero where it is to find its own.
    pub step: f64,
    /// Work done before.
    pub counters: Counters,
    /// Which method has carried the run, where the choice is left open.
    pub method_use: Option<MethodUse>,
}

impl Of {
    fn new(method: Method, problem: &Problem<'_>, start: &Start, interval: f64) -> Self {
        let Start {
            time,
            ref deviation,
            step,
            counters,
            ..
        } = *start;
        match method {
            Method::Exponential => {
                let times = [time, interval];
                let stepper = ExponentialStepper::new(problem, times, deviation, step, counters);
                Self::Exponential(Box::new(stepper))
            }
            Method::Rodas => {
                let stepper = RosenbrockStepper::new(problem, time, deviation, step, counters);
                Self::Rosenbrock(Box::new(stepper))
            }
            _ => {
                let stepper = ExplicitStepper::new(problem, time, deviation, step, counters);
                Self::Explicit(Box::new(stepper))
            }
        }
    }
}

impl Stepper {
    /// By a method, before samples at an interval, s.
    pub fn new(method: Method, problem: &Problem<'_>, start: &Start, interval: f64) -> Self {
        let method = start.method_use.map_or(method, |used| used.latest());
        Self {
            of: Of::new(method, problem, start, interval),
            choice: start.method_use.map(Choice::new),
            interval,
        }
    }

    /// Writes the state at a time that is not before the start of the latest step; takes steps as far as needed.
    ///
    /// # Errors
    /// Why the run ends before that time.
    pub fn state_at(
        &mut self,
        problem: &Problem<'_>,
        time: f64,
        state: &mut [f64],
    ) -> Result<(), IntegrateError> {
        while self.time() < time {
            self.step(problem)?;
        }
        each!(&mut self.of, stepper => stepper.state_within(problem, time, state));
        Ok(())
    }

    fn step(&mut self, problem: &Problem<'_>) -> Result<(), IntegrateError> {
        let (Of::Exponential(stepper), Some(choice)) = (&mut self.of, &mut self.choice) else {
            return each!(&mut self.of, stepper => stepper.step(problem));
        };
        let ending = stepper.step(problem);
        if choice.is_over(ending, stepper.time(), stepper.crossed())? {
            let start = Start {
                time: stepper.time(),
                deviation: stepper.deviation().to_vec(),
                // the pair finds its own first step
                step: 0.0,
                counters: stepper.counters(),
                method_use: None,
            };
            self.of = Of::new(Method::Verner76, problem, &start, self.interval);
        }
        Ok(())
    }

    /// Product of step and largest eigenvalue at which the method ceases to be stable; none where nothing holds it.
    pub fn stability_limit(&self) -> Option<f64> {
        matches!(self.of, Of::Explicit(_)).then_some(STABILITY)
    }

    /// Which method carried the run, where the choice is left open.
    pub fn method_use(&self) -> Option<MethodUse> {
        self.choice.as_ref().map(|choice| choice.method_use)
    }

    /// End of the latest step, s.
    pub fn time(&self) -> f64 {
        each!(&self.of, stepper => stepper.time())
    }

    /// Deviation at the end of the latest step.
    pub fn deviation(&self) -> &[f64] {
        each!(&self.of, stepper => stepper.deviation())
    }

    /// Work done so far, and the size of the latest step or of the one to come, s.
    pub fn progress(&self) -> (Counters, f64) {
        each!(&self.of, stepper => (stepper.counters(), stepper.step_size()))
    }
}
