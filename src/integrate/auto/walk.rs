//! A walk whose method changes.

use super::cost::{Prices, WAYS, Way};
use super::selector::{Mark, Outlook, Selector};
use super::usage::{MethodChange, MethodUse, Stretch};
use crate::integrate::explicit::{Course, Dop853, Verner76, Walk};
use crate::integrate::exponential::ExponentialWalk;
use crate::integrate::{Counters, IntegrateError, Linearised, Method, Scaling, Settings};

/// Evaluations of the exponential method per radian of what drives a settled motion, at a tolerance.
const EVALUATIONS_PER_RADIAN: f64 = 20.0;
const AT_TOLERANCE: f64 = 1e-8;
/// Root of the tolerance that they fall with.
const ROOT: f64 = -1.0 / 7.0;

/// Step sizes that a break adds to those of the exponential method: up to it and after it.
const SIZES_PER_BREAK: f64 = 2.0;
/// Breaks that are looked ahead to.
const BREAKS: u32 = 16;

/// The walks of all methods, of which one goes on.
#[derive(Debug, Clone)]
pub(in crate::integrate) struct AutoWalk<const N: usize> {
    pub(super) explicit: Walk<N>,
    pub(super) exponential: ExponentialWalk<N>,
    pub(super) selector: Selector,
    /// Work and simulated time of each method up to its latest change.
    pub(super) done: [Counters; WAYS.len()],
    pub(super) covered: [f64; WAYS.len()],
    /// Step size that the explicit pairs had last, s.
    pub(super) explicit_size: f64,
    /// Whether a surface was crossed in the latest stretch of an explicit pair.
    pub(super) contacts_change: bool,
    pub(super) changes: Vec<(f64, Way)>,
}

impl Way {
    /// As users know it.
    pub(super) fn method(self) -> Method {
        match self {
            Self::Verner76 => Method::Verner76,
            Self::Dop853 => Method::Dop853,
            Self::Exponential => Method::Exponential,
        }
    }
}

impl<const N: usize> AutoWalk<N> {
    /// Stands at time 0 in a deviation from the origin, on a grid of samples.
    pub fn new(deviation: [f64; N], interval: f64) -> Self {
        let first = Way::Verner76;
        Self {
            explicit: Walk::new(deviation),
            exponential: ExponentialWalk::new(deviation, interval),
            selector: Selector::new(first),
            done: [Counters::default(); WAYS.len()],
            covered: [0.0; WAYS.len()],
            explicit_size: 0.0,
            contacts_change: false,
            changes: vec![(0.0, first)],
        }
    }

    /// Whether the exponential method walks.
    fn is_exponential(&self) -> bool {
        self.selector.way == Way::Exponential
    }

    /// End of the latest step, s.
    pub fn time(&self) -> f64 {
        if self.is_exponential() {
            self.exponential.time()
        } else {
            self.explicit.time()
        }
    }

    /// Size of the latest step, s.
    pub fn step_size(&self) -> f64 {
        if self.is_exponential() {
            self.exponential.step_size()
        } else {
            self.explicit.step_size()
        }
    }

    /// Scaled state at the end of the latest step.
    pub fn scaled(&self, scaling: &Scaling<N>) -> [f64; N] {
        if self.is_exponential() {
            self.exponential.scaled(scaling)
        } else {
            self.explicit.scaled(scaling)
        }
    }

    /// Work done so far.
    pub fn counters(&self) -> Counters {
        let mut all = Counters::default();
        for way in WAYS {
            all.add(&self.work(way));
        }
        all
    }

    /// Work of a method so far.
    fn work(&self, way: Way) -> Counters {
        let mut work = self.done[way as usize];
        if way == self.selector.way {
            work.add(&self.under_way());
        }
        work
    }

    /// Work since the latest change.
    fn under_way(&self) -> Counters {
        if self.is_exponential() {
            self.exponential.counters()
        } else {
            self.explicit.counters()
        }
    }

    /// Which methods walked.
    pub fn usage(&self) -> MethodUse {
        let began = self.selector.began.time;
        let stretch = |way: Way| {
            let rate = self.selector.rates[way as usize];
            let under_way = if way == self.selector.way {
                self.time() - began
            } else {
                0.0
            };
            Stretch {
                method: way.method(),
                covered: self.covered[way as usize] + under_way,
                counters: self.work(way),
                rate: rate.is_finite().then_some(rate),
            }
        };
        let changes = self.changes.iter();
        MethodUse {
            stretches: WAYS.map(stretch).to_vec(),
            changes: changes
                .map(|&(time, way)| MethodChange {
                    time,
                    method: way.method(),
                })
                .collect(),
        }
    }

    /// State at a sample that is not before the start of the latest step; walks on as far as needed.
    ///
    /// # Errors
    /// Why the walk ends before that time.
    pub fn state_at<S: Linearised<N>>(
        &mut self,
        course: &Course<'_, S, N>,
        time: f64,
    ) -> Result<[f64; N], IntegrateError> {
        while self.time() < time {
            self.step(course)?;
        }
        Ok(match self.selector.way {
            Way::Verner76 => self.explicit.state_within::<Verner76, S>(course, time),
            Way::Dop853 => self.explicit.state_within::<Dop853, S>(course, time),
            Way::Exponential => self.exponential.state_within(course, time),
        })
    }

    fn step<S: Linearised<N>>(&mut self, course: &Course<'_, S, N>) -> Result<(), IntegrateError> {
        self.choose(course);
        let limit = course.settings.step_limit;
        let settings = self.settings_left(course.settings);
        let course = Course {
            settings: &settings,
            ..*course
        };
        let sides = self.explicit.sides();
        match self.selector.way {
            Way::Verner76 => self.explicit.step::<Verner76, S>(&course),
            Way::Dop853 => self.explicit.step::<Dop853, S>(&course),
            Way::Exponential => self.exponential.step(&course),
        }
        .map_err(|error| with_limit(error, limit))?;
        // before the first step nothing is known
        self.contacts_change |= sides.is_some_and(|sides| self.explicit.sides() != Some(sides));
        Ok(())
    }

    /// The limit on steps less those of earlier stretches.
    fn settings_left(&self, settings: &Settings) -> Settings {
        let before = self.done.iter().map(|done| done.steps + done.rejected);
        Settings {
            step_limit: settings.step_limit.saturating_sub(before.sum()),
            ..*settings
        }
    }

    /// Goes over to another method where the latest step leads to it.
    fn choose<S: Linearised<N>>(&mut self, course: &Course<'_, S, N>) {
        let (time, prices) = (self.time(), Prices::new(course.system.effort(), N));
        let here = Mark {
            time,
            spent: self.spent(&prices),
            steps: self.counters().steps,
        };
        let outlook = || {
            let pace = course.system.pace(time, course.end);
            let finer = (course.settings.tolerance / AT_TOLERANCE).powf(ROOT);
            let evaluation = prices.evaluation[Way::Exponential as usize];
            let evaluations = EVALUATIONS_PER_RADIAN * pace * finer;
            let breaks = SIZES_PER_BREAK * breaks_per_time(course, time);
            Outlook {
                prices,
                left: course.end - time,
                exponential: if self.contacts_change {
                    f64::NAN
                } else {
                    evaluations * evaluation + breaks * prices.matrices
                },
            }
        };
        let mut selector = self.selector;
        let way = selector.look(here, outlook);
        self.selector = selector;
        if let Some(way) = way {
            self.change(here, way);
        }
    }

    /// Cost of all that was done, s.
    fn spent(&self, prices: &Prices) -> f64 {
        let evaluations =
            WAYS.map(|way| self.work(way).evaluations as f64 * prices.evaluation[way as usize]);
        let [linear_parts, sizes] = self.exponential.matrices().map(|count| count as f64);
        evaluations.iter().sum::<f64>()
            + linear_parts * prices.linear_part
            + sizes * prices.matrices
    }

    /// Lets another method go on from the end of the latest step.
    fn change(&mut self, here: Mark, way: Way) {
        let (time, old) = (self.time(), self.selector.way);
        let deviation = if self.is_exponential() {
            self.exponential.deviation()
        } else {
            self.explicit_size = self.explicit.step_size();
            self.explicit.deviation()
        };
        self.done[old as usize] = self.work(old);
        self.covered[old as usize] += time - self.selector.began.time;
        if way == Way::Exponential {
            self.exponential.stand_at(time, deviation);
        } else {
            self.explicit = Walk::at(time, deviation, self.explicit_size);
            self.contacts_change = false;
        }
        self.selector.change(here, way);
        self.changes.push((time, way));
    }
}

/// How often the system breaks from a time on, 1/s.
fn breaks_per_time<S: Linearised<N>, const N: usize>(course: &Course<'_, S, N>, from: f64) -> f64 {
    let (mut time, mut count) = (from, 0);
    while count < BREAKS {
        let next = course.system.next_break(time + course.slack);
        if next >= course.end {
            return f64::from(count) / (course.end - from);
        }
        (time, count) = (next, count + 1);
    }
    f64::from(count) / (time - from)
}

/// A limit on steps is that of the run.
fn with_limit(error: IntegrateError, limit: u64) -> IntegrateError {
    match error {
        IntegrateError::StepLimit { time, .. } => IntegrateError::StepLimit { time, limit },
        other => other,
    }
}
