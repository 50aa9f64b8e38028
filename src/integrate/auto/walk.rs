//! A walk whose method changes.

use super::beforehand::Beforehand;
use super::cost::{WAYS, Way};
use super::selector::{Mark, Selector};
use super::usage::{MethodChange, MethodUse, Stretch};
use crate::integrate::course::Course;
use crate::integrate::explicit::{Dop853, Verner76, Walk};
use crate::integrate::exponential::ExponentialWalk;
use crate::integrate::nystrom::{self, Dprkn8};
use crate::integrate::{Counters, IntegrateError, Linearised, Scaling, Settings};

/// The same of the walk that goes on.
macro_rules! present {
    ($auto:expr, $walk:ident => $of:expr) => {
        match $auto.selector.way {
            Way::Verner76 | Way::Dop853 => {
                let $walk = &$auto.explicit;
                $of
            }
            Way::Dprkn8 => {
                let $walk = &$auto.nystrom;
                $of
            }
            Way::Exponential => {
                let $walk = &$auto.exponential;
                $of
            }
        }
    };
}

/// The walks of all methods, of which one goes on.
#[derive(Debug, Clone)]
pub(in crate::integrate) struct AutoWalk<const N: usize> {
    pub(super) explicit: Walk<N>,
    pub(super) nystrom: nystrom::Walk<N>,
    pub(super) exponential: ExponentialWalk<N>,
    pub(super) selector: Selector,
    /// Work and simulated time of each method up to its latest change.
    pub(super) done: [Counters; WAYS.len()],
    pub(super) covered: [f64; WAYS.len()],
    /// Step size that the explicit pairs had last, s.
    pub(super) explicit_size: f64,
    /// Whether a surface was crossed in the latest window of a pair.
    pub(super) contacts_change: bool,
    pub(super) changes: Vec<(f64, Way)>,
    /// What is known beforehand, once it was asked.
    pub(super) beforehand: Option<Beforehand>,
}

impl<const N: usize> AutoWalk<N> {
    /// Stands at time 0 in a deviation from the origin, on a grid of samples.
    pub fn new(deviation: [f64; N], interval: f64) -> Self {
        let first = Way::Verner76;
        Self {
            explicit: Walk::new(deviation),
            nystrom: nystrom::Walk::new(deviation),
            exponential: ExponentialWalk::new(deviation, interval),
            selector: Selector::new(first),
            done: [Counters::default(); WAYS.len()],
            covered: [0.0; WAYS.len()],
            explicit_size: 0.0,
            contacts_change: false,
            changes: vec![(0.0, first)],
            beforehand: None,
        }
    }

    /// End of the latest step, s.
    pub fn time(&self) -> f64 {
        present!(self, walk => walk.time())
    }

    /// Size of the latest step, s.
    pub fn step_size(&self) -> f64 {
        present!(self, walk => walk.step_size())
    }

    /// Scaled state at the end of the latest step.
    pub fn scaled(&self, scaling: &Scaling<N>) -> [f64; N] {
        present!(self, walk => walk.scaled(scaling))
    }

    /// Work done so far.
    pub fn counters(&self) -> Counters {
        let mut all = Counters::default();
        for way in WAYS {
            all.add(&self.work(way));
        }
        all
    }

    /// Steps so far.
    pub(super) fn steps(&self) -> u64 {
        let before = self.done.iter().map(|done| done.steps);
        before.sum::<u64>() + self.under_way().steps
    }

    /// Work of a method so far.
    pub(super) fn work(&self, way: Way) -> Counters {
        let mut work = self.done[way as usize];
        if way == self.selector.way {
            work.add(&self.under_way());
        }
        work
    }

    /// Simulated time that a method carried the run over so far, s.
    pub(super) fn covered_by(&self, way: Way) -> f64 {
        let under_way = if way == self.selector.way {
            self.time() - self.selector.began.time
        } else {
            0.0
        };
        self.covered[way as usize] + under_way
    }

    /// Work since the latest change.
    fn under_way(&self) -> Counters {
        present!(self, walk => walk.counters())
    }

    /// Which methods walked.
    pub fn usage(&self) -> MethodUse {
        let stretch = |way: Way| {
            let rate = self.selector.rates[way as usize];
            Stretch {
                method: way.method(),
                covered: self.covered_by(way),
                counters: self.work(way),
                rate: (rate < f64::MAX).then_some(rate),
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
    #[inline]
    pub fn state_at<S: Linearised<N>>(
        &mut self,
        course: &Course<'_, S, N>,
        time: f64,
    ) -> Result<[f64; N], IntegrateError> {
        while self.time() < time {
            self.step(course)?;
        }
        match self.selector.way {
            Way::Exponential => Ok(self.exponential.state_within(course, time)),
            Way::Verner76 => Ok(self.explicit.state_within::<Verner76, S>(course, time)),
            Way::Dop853 => Ok(self.explicit.state_within::<Dop853, S>(course, time)),
            Way::Dprkn8 => self.nystrom.state_at::<Dprkn8, S>(course, time),
        }
    }

    /// Takes a step; where the method cannot, one that always can goes on for it.
    fn step<S: Linearised<N>>(&mut self, course: &Course<'_, S, N>) -> Result<(), IntegrateError> {
        self.choose(course);
        match self.step_by_choice(course) {
            Err(IntegrateError::StepUnderflow { .. } | IntegrateError::NotFinite { .. })
                if matches!(self.selector.way, Way::Exponential | Way::Dprkn8) =>
            {
                self.give_up_method(course);
                self.step_by_choice(course)
            }
            result => result,
        }
    }

    fn step_by_choice<S: Linearised<N>>(
        &mut self,
        course: &Course<'_, S, N>,
    ) -> Result<(), IntegrateError> {
        let limit = course.settings.step_limit;
        let settings = self.settings_left(course.settings);
        let course = Course {
            settings: &settings,
            ..*course
        };
        match self.selector.way {
            Way::Verner76 => self.explicit.step::<Verner76, S>(&course),
            Way::Dop853 => self.explicit.step::<Dop853, S>(&course),
            Way::Dprkn8 => self.nystrom.go_on::<Dprkn8, S>(&course),
            Way::Exponential => self.exponential.step(&course),
        }
        .map_err(|error| with_limit(error, limit))?;
        self.contacts_change |= match self.selector.way {
            Way::Verner76 | Way::Dop853 => self.explicit.went_over_surface(),
            Way::Dprkn8 => self.nystrom.went_over_surface(),
            Way::Exponential => false,
        };
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

    /// Lets another method go on from the end of the latest step.
    pub(super) fn change(&mut self, here: Mark, way: Way) {
        let (time, old) = (self.time(), self.selector.way);
        let deviation = present!(self, walk => walk.deviation());
        if matches!(old, Way::Verner76 | Way::Dop853) {
            self.explicit_size = self.explicit.step_size();
        }
        self.done[old as usize] = self.work(old);
        self.covered[old as usize] += time - self.selector.began.time;
        match way {
            Way::Exponential => self.exponential.stand_at(time, deviation),
            Way::Dprkn8 => {
                self.nystrom.stand_at(time, deviation, self.explicit_size);
                self.contacts_change = false;
            }
            Way::Verner76 | Way::Dop853 => {
                self.explicit = Walk::at(time, deviation, self.explicit_size);
                self.contacts_change = false;
            }
        }
        self.selector.change(here, way);
        // a stretch of no length is none
        let walked = |&(begin, _): &(f64, Way)| begin < time;
        if !self.changes.last().is_some_and(walked) {
            self.changes.pop();
        }
        if self.changes.last().is_none_or(|&(_, last)| last != way) {
            self.changes.push((time, way));
        }
    }
}

/// A limit on steps is that of the run.
fn with_limit(error: IntegrateError, limit: u64) -> IntegrateError {
    match error {
        IntegrateError::StepLimit { time, .. } => IntegrateError::StepLimit { time, limit },
        other => other,
    }
}
