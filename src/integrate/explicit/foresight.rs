//! Surfaces that a step is about to cross, seen before it is tried: a landing then costs no trial.

use super::landing::Landing;
use super::tableau::Pair;
use super::walk::Walk;
use crate::integrate::System;
use crate::integrate::course::Course;
use crate::integrate::look::Look;
use crate::integrate::stride::each;

/// Steps without a crossing after which none is looked out for: a trial finds it.
const SELDOM: f64 = 8.0;

impl<const N: usize> Walk<N> {
    /// Where the step to come crosses surfaces that spoil it, as far as place, velocity and acceleration at its start
    /// tell: the first time, and the next one.
    pub(super) fn foresee<P: Pair, S: System<N>>(
        &mut self,
        course: &Course<'_, S, N>,
    ) -> [Option<Landing>; 2] {
        self.crossing.foreseen = None;
        let often = self.start - self.crossing.latest < SELDOM * self.next_size;
        if !often || !course.system.is_second_order() {
            return [None; 2];
        }
        let aim = self.aim(None);
        let end = self.carried(aim.end);
        let state = course.state(&end);
        if self
            .crossing
            .looked
            .is_clear(course.system, aim.end, &state)
        {
            return [None; 2];
        }
        let ahead = Look::around(course.system, aim.end, state);
        self.crossing.foreseen = Some(ahead);
        let changed = ahead.sides ^ self.crossing.sides;
        if changed == 0 {
            return [None; 2];
        }
        let stride = self.stride_to(course, &aim, &end);
        if !each(changed).any(|surface| stride.spoils(surface, P::CROSSED)) {
            return [None; 2];
        }
        stride.landings(changed, ahead.sides, |time| self.carried(time))
    }

    /// Deviation at a time after the start of the step to come, as if its acceleration went on as of late; velocities
    /// as if it stayed.
    fn carried(&self, time: f64) -> [f64; N] {
        let (after, rate) = (time - self.start, &self.stages[0]);
        std::array::from_fn(|i| {
            if i >= N / 2 {
                return self.from[i] + after * rate[i];
            }
            let [velocity, acceleration] = [self.from[N / 2 + i], rate[N / 2 + i]];
            let before = self.rate_before[N / 2 + i];
            let jerk = if before.is_finite() {
                (acceleration - before) / self.size_before
            } else {
                0.0
            };
            let curved = acceleration + after * jerk / 3.0;
            self.from[i] + after * (velocity + 0.5 * after * curved)
        })
    }
}

#[cfg(test)]
mod tests {
    use std::sync::atomic::AtomicBool;

    use super::*;
    use crate::integrate::explicit::Verner76;
    use crate::integrate::{Counters, Method, Scaling, Settings, Surroundings};

    /// A ball that falls on elastic ground.
    struct Falling;

    impl System<2> for Falling {
        fn derivative(&self, _time: f64, [place, speed]: &[f64; 2], rate: &mut [f64; 2]) {
            *rate = [*speed, 1e3 * (-place).max(0.0).powf(1.5) - 1.0];
        }

        fn surroundings(&self, _time: f64, [place, _]: &[f64; 2]) -> Surroundings {
            Surroundings {
                sides: u128::from(*place <= 0.0),
                nearest: place.abs(),
            }
        }

        fn past(&self, _surface: u32, _time: f64, [place, _]: &[f64; 2]) -> f64 {
            -place
        }

        fn added(&self, _surface: u32, _time: f64, distance: f64) -> [f64; 2] {
            [0.0, 1e3 * distance.powf(1.5)]
        }

        fn is_second_order(&self) -> bool {
            true
        }
    }

    /// The landing that is foreseen from a height of one, at rest, by a step of a size.
    fn foreseen(size: f64, latest_crossing: f64) -> Option<Landing> {
        let (stop, scaling) = (AtomicBool::new(false), Scaling::IDENTITY);
        let settings = Settings {
            method: Method::Verner76,
            tolerance: 1e-6,
            step_limit: u64::MAX,
        };
        let course = Course {
            system: &Falling,
            scaling: &scaling,
            settings: &settings,
            stop: &stop,
            end: 100.0,
            slack: 1e-9,
        };
        let mut walk = Walk::new(0.0, [1.0, 0.0], size, Counters::default());
        walk.begin::<Verner76, _>(&course);
        walk.crossing.latest = latest_crossing;
        walk.foresee::<Verner76, _>(&course)[0]
    }

    /// y = 1 − t²/2 comes to the ground at √2.
    #[test]
    fn a_fall_is_foreseen_where_one_was_of_late_and_the_step_reaches_the_ground() {
        let landing = foreseen(1.6, 0.0).expect("a landing");
        let off = landing.time - std::f64::consts::SQRT_2;
        assert!(off.abs() < 1e-8 && landing.sides == 1, "{landing:?}");
        assert_eq!(foreseen(1.4, 0.0), None);
        assert_eq!(foreseen(1.6, -100.0), None);
    }
}
