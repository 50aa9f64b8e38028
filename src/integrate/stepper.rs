//! The stepper of the method in use.

use super::auto::{Choice, MethodUse};
use super::explicit::ExplicitStepper;
use super::exponential::ExponentialStepper;
use super::library::LibraryStepper;
use super::problem::Problem;
use super::rosenbrock::RosenbrockStepper;
use super::{Counters, IntegrateError, Method};

/// A method of this crate under way: its steps do not end with a block of samples.
pub(super) trait MethodStepper {
    /// Takes a step.
    ///
    /// # Errors
    /// Why the run ends here.
    fn step(&mut self, problem: &Problem<'_>) -> Result<(), IntegrateError>;

    /// Writes the state at a sample that is neither before the start of the latest step nor after its end.
    fn state_within(&mut self, problem: &Problem<'_>, time: f64, state: &mut [f64]);

    /// End of the latest step, s.
    fn time(&self) -> f64;

    /// Deviation from the scaling's origin at the end of the latest step.
    fn deviation(&self) -> &[f64];

    /// Work done so far.
    fn counters(&self) -> Counters;

    /// Size of the latest step or of the one to come, s; zero before the first.
    fn step_size(&self) -> f64;

    /// Product of step and largest eigenvalue at which the method ceases to be stable; none where nothing holds it.
    fn stability_limit(&self) -> Option<f64> {
        None
    }

    /// Whether the latest step crossed event surfaces without ending on them.
    fn crossed(&self) -> bool {
        false
    }
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
    /// Interval of the samples, s.
    pub interval: f64,
}

#[cfg(test)]
impl Start {
    /// At time zero in a deviation, with samples a second apart.
    pub fn in_deviation(deviation: &[f64], step: f64) -> Self {
        Self {
            time: 0.0,
            deviation: deviation.to_vec(),
            step,
            counters: Counters::default(),
            interval: 1.0,
        }
    }
}

fn stepper_of(method: Method, problem: &Problem<'_>, start: &Start) -> Box<dyn MethodStepper> {
    match method {
        Method::Dopri5 | Method::Dop853 => Box::new(LibraryStepper::new(method, problem, start)),
        Method::Rodas => Box::new(RosenbrockStepper::new(problem, start)),
        Method::Exponential => Box::new(ExponentialStepper::new(problem, start)),
        Method::Verner76 | Method::Auto => Box::new(ExplicitStepper::new(problem, start)),
    }
}

/// The stepper of the method in use, and the rule that may change it.
pub(super) struct Stepper {
    method: Box<dyn MethodStepper>,
    /// Where the choice of the method is left open.
    choice: Option<Choice>,
    interval: f64,
}

impl Stepper {
    /// By a method; `method_use` says which one has carried the run, where the choice is left open.
    pub fn new(
        method: Method,
        method_use: Option<MethodUse>,
        problem: &Problem<'_>,
        start: &Start,
    ) -> Self {
        let method = method_use.map_or(method, |used| used.latest());
        Self {
            method: stepper_of(method, problem, start),
            choice: method_use.map(Choice::new),
            interval: start.interval,
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
        while self.method.time() < time {
            self.step(problem)?;
        }
        self.method.state_within(problem, time, state);
        Ok(())
    }

    fn step(&mut self, problem: &Problem<'_>) -> Result<(), IntegrateError> {
        let ending = self.method.step(problem);
        let Some(choice) = self.choice.as_mut().filter(|choice| choice.is_open()) else {
            return ending;
        };
        let stepper = &self.method;
        if choice.is_over(ending, stepper.time(), stepper.crossed())? {
            let start = Start {
                time: stepper.time(),
                deviation: stepper.deviation().to_vec(),
                // the pair finds its own first step
                step: 0.0,
                counters: stepper.counters(),
                interval: self.interval,
            };
            self.method = stepper_of(choice.method_use.latest(), problem, &start);
        }
        Ok(())
    }

    /// The method.
    pub fn method(&self) -> &dyn MethodStepper {
        &*self.method
    }

    /// Which method carried the run, where the choice is left open.
    pub fn method_use(&self) -> Option<MethodUse> {
        self.choice.as_ref().map(|choice| choice.method_use)
    }
}
