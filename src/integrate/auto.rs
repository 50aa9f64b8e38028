//! The choice of a method for a run that names none.
//!
//! One rule, asked once: where the motion is expected to cross surfaces at which the derivative is not smooth, as
//! the lift-off of a ball from a race ([`System::expects_crossings`](super::System::expects_crossings)), the
//! explicit pair `verner76`, whose steps end on them, takes the run; elsewhere the exponential method. And one way
//! back: a run of the exponential method that crosses them again and again goes on with `verner76`, and so does one
//! in which that method can take no step.

use super::course::Course;
use super::explicit::{self, SET_NUMBERS, Verner76, numbers_of_set, set_of_numbers};
use super::exponential::ExponentialWalk;
use super::look::Look;
use super::{Counters, IntegrateError, Linearised, Method, Scaling, Settings, Sides};

/// Steps of the exponential method that are looked back over, and how many of them that crossed a surface are
/// "again and again".
const LOOKED_BACK: u32 = u64::BITS;
const AGAIN_AND_AGAIN: u32 = LOOKED_BACK / 4;

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
}

/// The steppers of both methods, one of which goes on.
#[derive(Debug, Clone)]
pub(super) struct AutoStepper<const N: usize> {
    /// Known from the first step on.
    method_use: Option<MethodUse>,
    explicit: explicit::Walk<N>,
    exponential: ExponentialWalk<N>,
    /// Work of the exponential method, where it is over.
    before: Counters,
    /// The latest event check of the exponential method.
    looked: Look<N>,
    /// Its latest steps, a bit for each, set where a step crossed a surface.
    crossings: u64,
}

/// The same of the stepper that goes on.
macro_rules! present {
    ($auto:expr, $stepper:ident => $of:expr) => {
        if $auto.is_explicit() {
            let $stepper = &$auto.explicit;
            $of
        } else {
            let $stepper = &$auto.exponential;
            $of
        }
    };
}

impl<const N: usize> AutoStepper<N> {
    /// At time 0 in a deviation from the origin, on a grid of samples.
    pub fn new(deviation: [f64; N], interval: f64) -> Self {
        Self {
            method_use: None,
            explicit: explicit::Walk::new(deviation),
            exponential: ExponentialWalk::new(deviation, interval),
            before: Counters::default(),
            looked: Look::NONE,
            crossings: 0,
        }
    }

    pub fn is_explicit(&self) -> bool {
        self.method_use
            .is_some_and(|used| used.latest() == Method::Verner76)
    }

    /// Which method carried the run, and why; none before the first step.
    pub fn method_use(&self) -> Option<MethodUse> {
        self.method_use
    }

    /// End of the latest step, s.
    pub fn time(&self) -> f64 {
        present!(self, stepper => stepper.time())
    }

    /// Size of the latest step, s.
    pub fn step_size(&self) -> f64 {
        present!(self, stepper => stepper.step_size())
    }

    /// Scaled state at the end of the latest step.
    pub fn scaled(&self, scaling: &Scaling<N>) -> [f64; N] {
        present!(self, stepper => stepper.scaled(scaling))
    }

    /// Work done so far.
    pub fn counters(&self) -> Counters {
        let mut all = self.before;
        all.add(&present!(self, stepper => stepper.counters()));
        all
    }

    /// State at a sample that is not before the start of the latest step; steps on as far as needed.
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
        Ok(if self.is_explicit() {
            self.explicit.state_within::<Verner76, S>(course, time)
        } else {
            self.exponential.state_within(course, time)
        })
    }

    fn step<S: Linearised<N>>(&mut self, course: &Course<'_, S, N>) -> Result<(), IntegrateError> {
        if self.method_use.is_none() {
            self.begin(course);
        }
        if self.is_explicit() {
            return self.explicit_step(course);
        }
        match self.exponential.step(course) {
            Err(IntegrateError::StepUnderflow { .. } | IntegrateError::NotFinite { .. }) => {
                self.change(ChangeReason::NoStep);
                self.explicit_step(course)
            }
            Ok(()) => {
                self.count_crossings(course);
                if self.crossings.count_ones() >= AGAIN_AND_AGAIN {
                    self.change(ChangeReason::Crossings);
                }
                Ok(())
            }
            Err(error) => Err(error),
        }
    }

    /// Applies the rule.
    fn begin<S: Linearised<N>>(&mut self, course: &Course<'_, S, N>) {
        let first = if course.system.expects_crossings() {
            Method::Verner76
        } else {
            Method::Exponential
        };
        self.method_use = Some(MethodUse {
            first,
            change: None,
        });
        if first == Method::Exponential {
            let state = course.state(&self.exponential.deviation());
            self.looked = Look::around(course.system, self.time(), state);
        }
    }

    /// Takes a step of the explicit pair, with what is left of the limit on steps.
    fn explicit_step<S: Linearised<N>>(
        &mut self,
        course: &Course<'_, S, N>,
    ) -> Result<(), IntegrateError> {
        let limit = course.settings.step_limit;
        let used = self.before.steps + self.before.rejected;
        let settings = Settings {
            step_limit: limit.saturating_sub(used),
            ..*course.settings
        };
        let course = Course {
            settings: &settings,
            ..*course
        };
        let result = self.explicit.step::<Verner76, S>(&course);
        result.map_err(|error| match error {
            IntegrateError::StepLimit { time, .. } => IntegrateError::StepLimit { time, limit },
            other => other,
        })
    }

    /// Takes note of whether the latest step of the exponential method crossed a surface.
    fn count_crossings<S: Linearised<N>>(&mut self, course: &Course<'_, S, N>) {
        let (time, state) = (self.time(), course.state(&self.exponential.deviation()));
        self.crossings <<= 1;
        if self.looked.is_clear(course.system, time, &state) {
            return;
        }
        let look = Look::around(course.system, time, state);
        self.crossings |= u64::from(look.sides != self.looked.sides);
        self.looked = look;
    }

    /// Lets the explicit pair go on from the end of the latest step.
    fn change(&mut self, reason: ChangeReason) {
        let time = self.time();
        self.before = self.exponential.counters();
        // the pair finds its own first step
        self.explicit = explicit::Walk::at(time, self.exponential.deviation(), 0.0);
        if let Some(used) = &mut self.method_use {
            used.change = Some((reason, time));
        }
    }

    /// Everything but the counters as numbers: the choice, the work before it, the event check and the stepper that
    /// goes on.
    pub fn numbers(&self) -> Vec<f64> {
        let choice = match self.method_use {
            None => [0.0; 3],
            Some(MethodUse { first, change }) => {
                let first = if first == Method::Verner76 { 1.0 } else { 2.0 };
                match change {
                    None => [first, 0.0, 0.0],
                    Some((ChangeReason::Crossings, time)) => [first, 1.0, time],
                    Some((ChangeReason::NoStep, time)) => [first, 2.0, time],
                }
            }
        };
        let Counters {
            steps,
            rejected,
            evaluations,
        } = self.before;
        let work = [steps, rejected, evaluations].map(|count| count as f64);
        let [crossings, sides] =
            [Sides::from(self.crossings), self.looked.sides].map(numbers_of_set);
        let mut numbers = [&choice[..], &work, &crossings, &sides].concat();
        numbers.extend(present!(self, stepper => stepper.numbers()));
        numbers
    }

    /// From numbers as by [`AutoStepper::numbers`], with the counters of the run; none of any others.
    pub fn restored(numbers: &[f64], counters: Counters, interval: f64) -> Option<Self> {
        let (&[first, reason, time], numbers) = numbers.split_first_chunk()?;
        let (work, numbers) = numbers.split_first_chunk::<3>()?;
        let (crossings, numbers) = numbers.split_first_chunk::<SET_NUMBERS>()?;
        let (sides, numbers) = numbers.split_first_chunk::<SET_NUMBERS>()?;
        let mut auto = Self::new([0.0; N], interval);
        let [steps, rejected, evaluations] = work.map(|count| count as u64);
        auto.before = Counters {
            steps,
            rejected,
            evaluations,
        };
        auto.crossings = set_of_numbers(*crossings) as u64;
        auto.looked.sides = set_of_numbers(*sides);
        let change = match reason {
            0.0 => None,
            1.0 => Some((ChangeReason::Crossings, time)),
            2.0 => Some((ChangeReason::NoStep, time)),
            _ => return None,
        };
        let first = match first {
            0.0 => None,
            1.0 => Some(Method::Verner76),
            2.0 => Some(Method::Exponential),
            _ => return None,
        };
        auto.method_use = first.map(|first| MethodUse { first, change });
        let own = counters.without(&auto.before);
        if auto.is_explicit() {
            auto.explicit = explicit::Walk::restored(numbers, own)?;
        } else {
            auto.exponential = ExponentialWalk::restored(numbers, own, interval)?;
        }
        Some(auto)
    }
}
