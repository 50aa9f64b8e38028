//! The stepper of the method in use, and the choice of one for a run that names none.
//!
//! The choice is one rule. A run begins with the exponential method, whose steps are longer than the vibrations of the
//! shaft as long as its forces are smooth. Where balls part from a race again and again, each time takes a row of short
//! steps. Once these are far more than an explicit method takes meanwhile, the explicit pair `verner76` goes on, whose
//! steps end on such surfaces and cost less. It goes on, too, where the exponential method can take no step.

use super::explicit::ExplicitStepper;
use super::exponential::{ExponentialStepper, PreparedSteps};
use super::library::LibraryStepper;
use super::problem::Problem;
use super::rosenbrock::RosenbrockStepper;
use super::{Counters, IntegrateError, Method};

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

    /// Takes over, before the first step, what was found out on a motion that led here, where the method uses it.
    fn take_over(&mut self, _prepared: PreparedSteps, _problem: &Problem<'_>) {}

    /// What a motion that goes on from here may take over.
    fn into_prepared(self: Box<Self>) -> Option<PreparedSteps> {
        None
    }

    /// Largest eigenvalue of the linear part that the method treats exactly, 1/s; zero of one that does not.
    fn largest_eigenvalue(&self) -> f64 {
        0.0
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

/// Crossings of surfaces in the latest 64 steps of the exponential method from which on short steps are put down to them.
const CROSSINGS: u32 = 2;
/// Largest angle, rad, by which the fastest vibration turns in a step of an explicit method.
const EXPLICIT_ANGLE: f64 = 2.0;
/// Largest such excess: then an explicit method goes on. A motion that goes on from there begins with it, and stays with the
/// exponential method only where its steps have become long.
const MOST_EXCESS: f64 = 64.0;

/// What was found out on a motion and serves one that goes on from it.
#[derive(Debug, Clone)]
pub struct Prepared {
    /// What the exponential method goes on with.
    pub(super) steps: Option<PreparedSteps>,
    excess: StepExcess,
}

impl Prepared {
    /// Nothing found out yet, before a start.
    pub(super) fn nothing(start: &Start) -> Self {
        Self {
            steps: None,
            excess: StepExcess::new(start),
        }
    }

    /// What serves a motion of another system that is much like it.
    #[must_use]
    pub fn for_another_system(self) -> Self {
        Self {
            steps: None,
            ..self
        }
    }
}

/// How many steps more the exponential method takes than an explicit one would.
#[derive(Debug, Clone)]
struct StepExcess {
    /// A bit for each of the latest steps, set where it crossed a surface.
    crossings: u64,
    /// Time, s, and number of trials at the end of the latest step.
    latest: (f64, u64),
    /// Steps tried since crossings began, less those that an explicit method would have taken meanwhile. It never falls below
    /// zero, so that long steps make up for short ones but are not saved up for later.
    ///
    /// Source: the cumulative sum of E. S. Page, *Continuous inspection schemes*, Biometrika 41 (1954), 100–115.
    excess: f64,
}

impl StepExcess {
    /// Before the first step.
    fn new(start: &Start) -> Self {
        Self {
            crossings: 0,
            latest: (start.time, trials(&start.counters)),
            excess: 0.0,
        }
    }

    /// Takes a step, with the trials before it that failed; whether surfaces are crossed again and again, and an explicit
    /// method takes far fewer steps.
    fn is_too_large(&mut self, method: &dyn MethodStepper) -> bool {
        let reached = method.reached();
        let now = (reached.time, trials(&reached.counters));
        let before = std::mem::replace(&mut self.latest, now);
        self.crossings = self.crossings << 1 | u64::from(method.crossed());
        if self.crossings.count_ones() >= CROSSINGS {
            self.excess += (now.1 - before.1) as f64;
        }
        let explicit = (now.0 - before.0) * method.largest_eigenvalue() / EXPLICIT_ANGLE;
        self.excess = (self.excess - explicit).max(0.0);
        self.excess > MOST_EXCESS
    }
}

/// Steps that were tried.
fn trials(counters: &Counters) -> u64 {
    counters.steps + counters.rejected
}

/// The stepper of the method in use, and the rule that may change it.
pub(super) struct Stepper {
    method: Box<dyn MethodStepper>,
    /// Which method carried the run, where the choice is left open.
    pub method_use: Option<MethodUse>,
    step_excess: StepExcess,
    /// Whether the explicit pair goes on from here: before the next step, for samples may lie within the latest one.
    is_change_due: bool,
}

impl Stepper {
    /// By the method of the settings; `method_use` says which one has carried the run, where the choice is left open.
    pub fn new(method_use: Option<MethodUse>, problem: &Problem<'_>, start: &Start) -> Self {
        let method = method_use.map_or(problem.settings.method, |used| used.latest());
        Self {
            method: method_stepper(method, problem, start),
            method_use,
            step_excess: StepExcess::new(start),
            is_change_due: false,
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
        if self.is_change_due {
            self.change(ChangeReason::Crossings, problem);
        }
        let ending = self.method.step(problem);
        let is_open = |used: &MethodUse| used.latest() == Method::Exponential;
        if !self.method_use.as_ref().is_some_and(is_open) {
            return ending;
        }
        match ending {
            Err(IntegrateError::StepUnderflow { .. } | IntegrateError::NotFinite { .. }) => {
                self.change(ChangeReason::NoStep, problem);
            }
            Err(error) => return Err(error),
            Ok(()) => self.is_change_due = self.step_excess.is_too_large(&*self.method),
        }
        Ok(())
    }

    /// Lets the explicit pair go on from the end of the latest step.
    fn change(&mut self, reason: ChangeReason, problem: &Problem<'_>) {
        let reached = self.method.reached();
        let start = Start {
            time: reached.time,
            deviation: reached.deviation.to_vec(),
            counters: reached.counters,
        };
        let change = Some((reason, start.time));
        self.method_use = Some(MethodUse { change });
        self.method = method_stepper(Method::Verner76, problem, &start);
        self.is_change_due = false;
    }

    /// Takes over, before the first step, what was found out on a motion that led here.
    pub fn take_over(&mut self, prepared: Prepared, problem: &Problem<'_>) {
        if let Some(steps) = prepared.steps {
            self.method.take_over(steps, problem);
        }
        self.step_excess = StepExcess {
            latest: self.step_excess.latest,
            excess: prepared.excess.excess.min(MOST_EXCESS),
            ..prepared.excess
        };
    }

    /// What a motion that goes on from here may take over.
    pub fn into_prepared(self) -> Prepared {
        Prepared {
            steps: self.method.into_prepared(),
            excess: self.step_excess,
        }
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

/// Which method carried a run under [`Method::Auto`]: the exponential one, until `verner76` went on from it.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct MethodUse {
    /// Why `verner76` went on, and when, s.
    pub change: Option<(ChangeReason, f64)>,
}

/// Why a run went over from the exponential method to `verner76`.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ChangeReason {
    /// The motion crossed surfaces again and again at which the derivative is not smooth, which kept its steps short.
    Crossings,
    /// The exponential method could take no further step.
    NoStep,
}

impl MethodUse {
    /// The method of the latest step.
    pub fn latest(&self) -> Method {
        match self.change {
            None => Method::Exponential,
            Some(_) => Method::Verner76,
        }
    }
}
