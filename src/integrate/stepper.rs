//! The stepper of the method in use, and the choice of one for a run that names none.
//!
//! The choice is one rule, asked once: where the motion is expected to cross event surfaces, as the lift-off of a ball
//! from a race ([`System::expects_crossings`]), the explicit pair `verner76`, whose steps end on them, takes the run;
//! elsewhere the exponential method. And one way back: a run of the exponential method that crosses them again and
//! again goes on with `verner76`, and so does one in which that method can take no step.

use super::explicit::ExplicitStepper;
use super::exponential::ExponentialStepper;
use super::library::LibraryStepper;
use super::problem::Problem;
use super::rosenbrock::RosenbrockStepper;
use super::{Counters, IntegrateError, Method, System};

/// A method under way: its steps end where it will, not with a sample.
pub(super) trait MethodStepper {
    /// Takes a step.
    ///
    /// # Errors
    /// Why the run ends here.
    fn step(&mut self, problem: &Problem<'_>) -> Result<(), IntegrateError>;

    /// Writes the state at a sample that is neither before the start of the latest step nor after its end.
    fn state_within(&mut self, problem: &Problem<'_>, time: f64, state: &mut [f64]);

    /// What the latest step has come to.
    fn reached(&self) -> Reached<'_>;

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
    /// Work done before.
    pub counters: Counters,
}

#[cfg(test)]
impl Start {
    /// At time zero in a deviation.
    pub fn from_deviation(deviation: &[f64]) -> Self {
        Self {
            time: 0.0,
            deviation: deviation.to_vec(),
            counters: Counters::default(),
        }
    }
}

/// What a stepper has come to.
#[derive(Debug, Clone, Copy)]
pub(super) struct Reached<'a> {
    /// End of the latest step, s.
    pub time: f64,
    /// Deviation from the scaling's origin there.
    pub deviation: &'a [f64],
    /// Size of the latest step or of the one to come, s; zero before the first.
    pub step: f64,
    /// Work done so far.
    pub counters: Counters,
}

fn method_stepper(method: Method, problem: &Problem<'_>, start: &Start) -> Box<dyn MethodStepper> {
    match method {
        Method::Dopri5 | Method::Dop853 => Box::new(LibraryStepper::new(method, problem, start)),
        Method::Rodas => Box::new(RosenbrockStepper::new(problem, start)),
        Method::Exponential => Box::new(ExponentialStepper::new(problem, start)),
        Method::Verner76 | Method::Auto => Box::new(ExplicitStepper::new(problem, start)),
    }
}

/// Crossings of surfaces in the latest 64 steps of the exponential method from which on it gives way.
const MOST_CROSSINGS: u32 = 16;

/// The stepper of the method in use, and the rule that may change it.
pub(super) struct Stepper {
    method: Box<dyn MethodStepper>,
    /// Which method carried the run, where the choice is left open.
    pub method_use: Option<MethodUse>,
    /// The latest steps of the exponential method, a bit for each, set where a step crossed a surface.
    crossings: u64,
}

impl Stepper {
    /// By the method of the settings; `method_use` says which one has carried the run, where the choice is left open.
    pub fn new(method_use: Option<MethodUse>, problem: &Problem<'_>, start: &Start) -> Self {
        let method = method_use.map_or(problem.settings.method, |used| used.latest());
        Self {
            method: method_stepper(method, problem, start),
            method_use,
            crossings: 0,
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
        while self.method.reached().time < time {
            self.step(problem)?;
        }
        self.method.state_within(problem, time, state);
        Ok(())
    }

    /// Takes a step; where the exponential method had the choice and can or should not go on, the explicit pair does.
    fn step(&mut self, problem: &Problem<'_>) -> Result<(), IntegrateError> {
        let ending = self.method.step(problem);
        let is_open = |used: &&mut MethodUse| used.latest() == Method::Exponential;
        let Some(method_use) = self.method_use.as_mut().filter(is_open) else {
            return ending;
        };
        let reason = match ending {
            Err(IntegrateError::StepUnderflow { .. } | IntegrateError::NotFinite { .. }) => {
                ChangeReason::NoStep
            }
            Err(error) => return Err(error),
            Ok(()) => {
                self.crossings = self.crossings << 1 | u64::from(self.method.crossed());
                if self.crossings.count_ones() < MOST_CROSSINGS {
                    return Ok(());
                }
                ChangeReason::Crossings
            }
        };
        let reached = self.method.reached();
        let start = Start {
            time: reached.time,
            deviation: reached.deviation.to_vec(),
            counters: reached.counters,
        };
        method_use.change = Some((reason, start.time));
        self.method = method_stepper(method_use.latest(), problem, &start);
        Ok(())
    }

    /// What the latest step has come to.
    pub fn reached(&self) -> Reached<'_> {
        self.method.reached()
    }

    /// Product of step and largest eigenvalue at which the method ceases to be stable; none where nothing holds it.
    pub fn stability_limit(&self) -> Option<f64> {
        self.method.stability_limit()
    }
}

/// Which method carried a run under [`Method::Auto`], and why.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MethodUse {
    /// The method of the first step.
    pub first: Method,
    /// Why `verner76` went on from the exponential method, and when, s.
    pub change: Option<(ChangeReason, f64)>,
}

/// Why a run went over from the exponential method to `verner76`.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ChangeReason {
    /// The motion crossed surfaces at which the derivative is not smooth again and again.
    Crossings,
    /// The exponential method could take no further step.
    NoStep,
}

impl MethodUse {
    /// The method of the latest step.
    pub fn latest(&self) -> Method {
        match self.change {
            None => self.first,
            Some(_) => Method::Verner76,
        }
    }

    /// By the rule, before the first step.
    pub(super) fn from_system(system: &dyn System) -> Self {
        let first = if system.expects_crossings() {
            Method::Verner76
        } else {
            Method::Exponential
        };
        Self {
            first,
            change: None,
        }
    }
}
