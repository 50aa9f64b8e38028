//! Steps of a Nyström pair, one after the other, and the states between their ends.

use fearless_simd::{Fallback, Level};

use super::any_factor::AnyFactor;
use super::crossing::Crossing;
use super::dense::Dense;
use super::entries::Entries;
use super::factor::Factor;
use super::row::Row;
use super::stand::Stand;
use super::tableau::{MOST, Pair};
use super::within::{ENDS, Within};
use crate::integrate::control::{Control, errors};
use crate::integrate::course::{Course, STRETCH};
use crate::integrate::{Counters, IntegrateError, Scaling, System, VelocityDependence};

/// Factors of the step size between which it stays as it is: the integrating factor is then at hand.
const KEPT: [f64; 2] = [0.95, 1.2];
/// Part of the factor's largest step from which on it may hold the steps: what it multiplies grows within
/// them as it does.
const HELD: f64 = 0.25;
/// Product of step and largest eigenvalue that stands for stability there: the eigenvalue of damping alone is
/// twice the norm that the factor's largest step is of, and half of this product counts as near.
const SERVED: f64 = 4.0 * HELD;
/// Starts of steps before the latest that are kept.
pub(super) const PAST: usize = ENDS - 2;

/// The latest step, and how to go on. States are kept as deviations from the scaling's origin: sums
/// of them lose less to round-off.
#[derive(Debug, Clone)]
pub(in crate::integrate) struct Walk<const N: usize> {
    /// What the processor has.
    pub(super) level: Level,
    pub(super) from: Stand<N>,
    pub(super) to: Stand<N>,
    /// Starts of the steps before, the latest first, back to the latest break, and their number.
    pub(super) past: [Stand<N>; PAST],
    pub(super) known: usize,
    /// Size of the latest step and of the next one, s.
    pub(super) size: f64,
    pub(super) next_size: f64,
    /// Time that the next step must not reach over, s.
    pub(super) limit: f64,
    pub(super) stages: [Row<N>; MOST],
    pub(super) dense: Dense,
    pub(super) within: Within<N>,
    pub(super) crossing: Crossing<N>,
    pub(super) control: Control,
    /// Whether a trial since the latest good step was not finite.
    pub(super) fault: bool,
    pub(super) counters: Counters,
    /// Made as the walk begins, or goes on.
    pub(super) factor: Option<AnyFactor<N>>,
}

impl<const N: usize> Walk<N> {
    /// Stands at time 0 in a deviation from the origin.
    pub fn new(deviation: [f64; N]) -> Self {
        let stand = Stand {
            time: 0.0,
            state: deviation,
            push: Row::ZERO,
        };
        Self {
            level: Level::new(),
            from: stand,
            to: stand,
            past: [stand; PAST],
            known: 0,
            size: 0.0,
            next_size: 0.0,
            limit: 0.0,
            stages: [Row::ZERO; MOST],
            dense: Dense::Unknown,
            within: Within::NONE,
            crossing: Crossing::NEW,
            control: Control::NEW,
            fault: false,
            counters: Counters::default(),
            factor: None,
        }
    }

    /// Stands at a time, s, in a deviation from the origin, with the factor that there is; the first step
    /// has the size of the latest one here, or this one, s, where there was none.
    pub fn stand_at(&mut self, time: f64, deviation: [f64; N], size: f64) {
        let next_size = if self.next_size > 0.0 {
            self.next_size
        } else {
            size
        };
        let mut new = Self::new(deviation);
        (new.from.time, new.to.time, new.limit) = (time, time, time);
        (new.next_size, new.factor) = (next_size, self.factor.take());
        *self = new;
    }

    /// Deviation at the end of the latest step.
    pub fn deviation(&self) -> [f64; N] {
        self.to.state
    }

    /// End of the latest step, s.
    pub fn time(&self) -> f64 {
        self.to.time
    }

    /// Size of the latest step, s, or, where a break or the end cut it, of the one to come; zero
    /// before the first.
    pub fn step_size(&self) -> f64 {
        if self.to.time >= self.limit {
            self.next_size
        } else {
            self.size
        }
    }

    /// Product of step and largest eigenvalue from which on stability may hold the steps, or damping that
    /// the integrating factor ceases to serve.
    pub fn stability<P: Pair>(&self) -> f64 {
        let factor = self.factor.as_ref();
        let largest = factor.map_or(f64::INFINITY, AnyFactor::largest_step);
        if self.step_size() < HELD * largest {
            P::STABILITY
        } else {
            P::STABILITY.min(SERVED)
        }
    }

    /// Scaled state at the end of the latest step.
    pub fn scaled(&self, scaling: &Scaling<N>) -> [f64; N] {
        std::array::from_fn(|i| self.to.state[i] / scaling.scale[i])
    }

    /// Work done so far.
    pub fn counters(&self) -> Counters {
        self.counters
    }

    /// State at a time that is not before the start of the latest step; walks on as far as needed.
    ///
    /// # Errors
    /// Why the walk ends before that time.
    pub fn state_at<P: Pair, S: System<N>>(
        &mut self,
        course: &Course<'_, S, N>,
        time: f64,
    ) -> Result<[f64; N], IntegrateError> {
        let mut factor = self.take_factor(course)?;
        let deviation = match &mut factor {
            AnyFactor::Few(factor) => self.deviation_at::<P, S, _>(course, factor, time),
            AnyFactor::All(factor) => self.deviation_at::<P, S, _>(course, factor, time),
        };
        self.factor = Some(factor);
        deviation.map(|deviation| course.state(&deviation))
    }

    /// Takes a step.
    ///
    /// # Errors
    /// Why the walk ends here; it then stands where it stood.
    pub fn go_on<P: Pair, S: System<N>>(
        &mut self,
        course: &Course<'_, S, N>,
    ) -> Result<(), IntegrateError> {
        let mut factor = self.take_factor(course)?;
        let result = match &mut factor {
            AnyFactor::Few(factor) => self.step::<P, S, _>(course, factor),
            AnyFactor::All(factor) => self.step::<P, S, _>(course, factor),
        };
        self.factor = Some(factor);
        if result.is_err() {
            self.to = self.from;
        }
        result
    }

    fn take_factor<S: System<N>>(
        &mut self,
        course: &Course<'_, S, N>,
    ) -> Result<AnyFactor<N>, VelocityDependence> {
        match self.factor.take() {
            Some(factor) => Ok(factor),
            None => AnyFactor::of(course.system),
        }
    }

    pub(super) fn deviation_at<P: Pair, S: System<N>, E: Entries<N>>(
        &mut self,
        course: &Course<'_, S, N>,
        factor: &mut Factor<E, N>,
        time: f64,
    ) -> Result<[f64; N], IntegrateError> {
        while self.to.time < time {
            self.step::<P, S, E>(course, factor)?;
        }
        if time >= self.to.time {
            return Ok(self.to.state);
        }
        if self.dense == Dense::Unknown {
            self.dense = self.polynomial(course, factor);
        }
        if self.dense == Dense::ByPolynomial {
            return Ok(self.by_polynomial(time));
        }
        Ok(self.by_step::<P, S, E>(course, factor, time))
    }

    fn step<P: Pair, S: System<N>, E: Entries<N>>(
        &mut self,
        course: &Course<'_, S, N>,
        factor: &mut Factor<E, N>,
    ) -> Result<(), IntegrateError> {
        self.begin::<P, S, E>(course, factor);
        self.look_around(course);
        loop {
            course.check(self.from.time, self.next_size, &self.counters, self.fault)?;
            let cut = self.from.time + STRETCH * self.next_size >= self.limit;
            self.size = if cut {
                self.limit - self.from.time
            } else {
                self.next_size
            };
            let error = self.trial::<P, S, E>(course, factor);
            let factor_of_size = if error <= 1.0 {
                let crossed = self.crossed::<P, S>(course);
                if crossed <= 1.0 {
                    self.arrive();
                    self.accept::<P>(error, cut, factor.largest_step());
                    self.finish::<P, S>(course);
                    return Ok(());
                }
                self.control.crossed(crossed)
            } else {
                self.fault |= !error.is_finite();
                self.control.rejected(error, P::ERROR_POWER)
            };
            self.counters.rejected += 1;
            self.next_size = self.size * factor_of_size;
        }
    }

    /// Makes the end of the latest step the start of the next.
    fn begin<P: Pair, S: System<N>, E: Entries<N>>(
        &mut self,
        course: &Course<'_, S, N>,
        factor: &Factor<E, N>,
    ) {
        self.past.copy_within(..PAST - 1, 1);
        self.past[0] = self.from;
        self.known = (self.known + 1).min(PAST);
        self.from = self.to;
        self.dense = Dense::Unknown;
        if self.from.time >= self.limit {
            self.limit = course.limit_after(self.from.time);
            // the force after a break, or the very first
            let from = self.from;
            let [origin, place] = [&course.scaling.origin, &from.state].map(Row::place);
            let places = [&origin, &place];
            self.from.push = self.push(Fallback::new(), course.system, from.time, places);
            self.known = 0;
        }
        if self.next_size <= 0.0 {
            let first = self.first_size::<P, S, E>(course, factor);
            self.next_size = first.min(factor.largest_step());
        }
    }

    fn first_size<P: Pair, S: System<N>, E: Entries<N>>(
        &mut self,
        course: &Course<'_, S, N>,
        factor: &Factor<E, N>,
    ) -> f64 {
        let end = self.from.end(Fallback::new(), factor);
        let slope = std::array::from_fn(|i| {
            if i < N / 2 {
                end.velocity[i]
            } else {
                end.acceleration[i - N / 2]
            }
        });
        self.counters.evaluations += 1;
        let stretch = [self.from.time, self.limit];
        course.first_size(stretch, &self.from.state, &slope, P::ORDER)
    }

    /// Makes the end of a good step known, and the size of the next.
    fn accept<P: Pair>(&mut self, error: f64, cut: bool, largest: f64) {
        let kept = const { errors(KEPT, P::ERROR_POWER) };
        let growth = self.control.kept_or_accepted(error, kept, P::ERROR_POWER);
        let proposed = (self.size * growth).min(largest);
        // a step that was cut tells little of how long the next may be
        self.next_size = if cut {
            proposed.max(self.next_size)
        } else {
            proposed
        };
        self.to.time = if cut {
            self.limit
        } else {
            self.from.time + self.size
        };
    }

    /// Completes a good step.
    fn finish<P: Pair, S: System<N>>(&mut self, course: &Course<'_, S, N>) {
        if const { !P::ENDS_ON_STAGE } {
            let [origin, place] = [&course.scaling.origin, &self.to.state].map(Row::place);
            let (end, places) = (self.stage_time(1.0), [&origin, &place]);
            self.to.push = self.push(Fallback::new(), course.system, end, places);
        }
        self.counters.steps += 1;
        self.fault = false;
    }
}

#[cfg(test)]
#[path = "walk_tests.rs"]
mod tests;
