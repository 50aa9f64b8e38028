//! Steps of an explicit pair, one after the other, and the states between their ends.

use fearless_simd::Level;

use super::crossing::Crossing;
use super::substitution::Substitution;
use super::tableau::{Arguments, Error, Factors, MOST, Pair, Weights, sum};
use crate::integrate::control::Control;
use crate::integrate::course::Course;
use crate::integrate::{Counters, IntegrateError, Scaling, System};
use crate::registers::in_wide_registers;

/// Times that a step looks for a better place to land on.
const MOST_SEARCHES: u32 = 5;

/// The latest step, and how to go on. States are kept as deviations from the scaling's origin: sums
/// of them lose less to round-off.
#[derive(Debug, Clone)]
pub(in crate::integrate) struct Walk<const N: usize> {
    /// What the processor has.
    pub(super) level: Level,
    /// Start and end of the latest step, s.
    pub(super) start: f64,
    pub(super) time: f64,
    /// Size of the latest step and of the next one, s.
    pub(super) size: f64,
    pub(super) next_size: f64,
    /// Time that the next step must not reach over, s.
    pub(super) limit: f64,
    /// States at the start and at the end of the latest step.
    pub(super) from: [f64; N],
    pub(super) to: [f64; N],
    /// Slopes by the variable of the step.
    pub(super) stages: [[f64; N]; MOST],
    pub(super) substitution: Substitution,
    /// The derivative at the end of the latest step, where the variable of the step is substituted.
    pub(super) end_rate: [f64; N],
    pub(super) crossing: Crossing<N>,
    /// Whether the derivative at the end of the trial is there.
    pub(super) ended: bool,
    /// Whether the stages for dense output are there.
    pub(super) extended: bool,
    /// Whether the quintic is exact enough.
    pub(super) quintic: bool,
    /// h³ q‴ at the end of the step before, by its polynomial; infinite where there was none.
    pub(super) jerk: [f64; N],
    pub(super) size_before: f64,
    /// The derivative at the start of the step before; infinite where there was none.
    pub(super) rate_before: [f64; N],
    pub(super) control: Control,
    /// Whether a trial since the latest good step was not finite.
    pub(super) fault: bool,
    /// Whether the surfaces about the start are known.
    looked_around: bool,
    pub(super) counters: Counters,
}

impl<const N: usize> Walk<N> {
    /// At a time, s, in a deviation from the origin, after so much work; a size of zero lets the first step find its
    /// own.
    pub fn new(time: f64, deviation: [f64; N], size: f64, counters: Counters) -> Self {
        Self {
            level: Level::new(),
            start: time,
            time,
            size: 0.0,
            next_size: size,
            limit: time,
            from: deviation,
            to: deviation,
            stages: [[0.0; N]; MOST],
            substitution: Substitution::NONE,
            end_rate: [0.0; N],
            crossing: Crossing::NEW,
            ended: false,
            extended: false,
            quintic: false,
            jerk: [f64::INFINITY; N],
            size_before: 0.0,
            rate_before: [f64::INFINITY; N],
            control: Control::NEW,
            fault: false,
            looked_around: false,
            counters,
        }
    }

    /// End of the latest step, s.
    pub fn time(&self) -> f64 {
        self.time
    }

    /// Size of the latest step, s, or, where a break or the end cut it, of the one to come; zero
    /// before the first.
    pub fn step_size(&self) -> f64 {
        if self.time >= self.limit {
            self.next_size
        } else {
            self.size
        }
    }

    /// Scaled state at the end of the latest step.
    pub fn scaled(&self, scaling: &Scaling<N>) -> [f64; N] {
        std::array::from_fn(|i| self.to[i] / scaling.scale[i])
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
        while self.time < time {
            self.step::<P, S>(course)?;
        }
        Ok(self.state_within::<P, S>(course, time))
    }

    /// State at a time that is neither before the start of the latest step nor after its end.
    pub fn state_within<P: Pair, S: System<N>>(
        &mut self,
        course: &Course<'_, S, N>,
        time: f64,
    ) -> [f64; N] {
        let deviation = if time >= self.time {
            self.to
        } else if self.quintic {
            self.by_quintic(time, P::LAST)
        } else {
            self.extend::<P, S>(course);
            self.by_stages::<P>(time)
        };
        course.state(&deviation)
    }

    /// Takes a step.
    ///
    /// # Errors
    /// Why the walk ends here.
    pub fn step<P: Pair, S: System<N>>(
        &mut self,
        course: &Course<'_, S, N>,
    ) -> Result<(), IntegrateError> {
        self.begin::<P, S>(course);
        let start_rate = self.stages[0];
        let mut next = match self.crossing.planned {
            None => self.foresee::<P, S>(course),
            planned => [planned, None],
        };
        let mut searches = 0;
        loop {
            let size = self.next_size.min(self.crossing.sizes[0]);
            course.check(self.start, size, &self.counters, self.fault)?;
            let aim = self.aim(next[0]);
            course.check_progress([self.start, aim.end], aim.size, self.fault)?;
            self.size = aim.size;
            self.substitute(&aim, &start_rate);
            let error = self.trial::<P, S>(course);
            let found = self.crossed::<P, S>(course, &aim, error);
            if let Some(found) = found.filter(|_| searches < MOST_SEARCHES) {
                self.counters.rejected += 1;
                searches += 1;
                next = found;
            } else if error <= 1.0 {
                self.accept::<P>(&aim, error);
                self.finish::<P, S>(course);
                self.arrive(course, &aim, next);
                self.rate_before = start_rate;
                return Ok(());
            } else {
                self.reject::<P>(error);
            }
        }
    }

    /// Makes the end of the latest step the start of the next.
    pub(super) fn begin<P: Pair, S: System<N>>(&mut self, course: &Course<'_, S, N>) {
        self.start = self.time;
        self.size_before = self.size;
        self.from = self.to;
        self.stages[0] = if self.substitution.is_none() {
            self.stages[P::LAST]
        } else {
            self.end_rate
        };
        if self.time >= self.limit {
            self.crossing.planned = None;
            if !self.looked_around {
                self.look_around(course);
                self.looked_around = true;
            }
            self.limit = course.limit_after(self.time);
            // the derivative after a break, or the very first
            let from = self.from;
            self.evaluate(course, 0, self.time, &from);
            self.jerk = [f64::INFINITY; N];
            self.rate_before = [f64::INFINITY; N];
        }
        if self.next_size <= 0.0 {
            self.counters.evaluations += 1;
            let stretch = [self.start, self.limit];
            self.next_size = course.first_size(stretch, &self.from, &self.stages[0], P::ORDER);
        }
    }

    /// Derivative in a deviation as a stage.
    #[inline(always)]
    fn evaluate<S: System<N>>(
        &mut self,
        course: &Course<'_, S, N>,
        stage: usize,
        time: f64,
        deviation: &[f64; N],
    ) {
        let state = course.state(deviation);
        course
            .system
            .derivative(time, &state, &mut self.stages[stage]);
        self.counters.evaluations += 1;
    }

    /// Evaluates a stage of a step whose variable is substituted.
    #[inline(never)]
    fn substituted_stage<P: Pair, S: System<N>>(
        &mut self,
        course: &Course<'_, S, N>,
        stage: usize,
        deviation: &[f64; N],
    ) {
        let [part, slope] = self.substitution.at(P::NODES[stage]);
        self.evaluate(course, stage, self.stage_time(part), deviation);
        if stage == P::LAST {
            self.end_rate = self.stages[stage];
        }
        for rate in &mut self.stages[stage] {
            *rate *= slope;
        }
    }

    /// Deviation after the step by some factors.
    #[inline(always)]
    fn moved<F: Factors>(&self) -> [f64; N] {
        let sum = sum::<F, N>(&self.stages);
        std::array::from_fn(|i| self.from[i] + self.size * sum[i])
    }

    /// Time of a stage: what begins at a break is no part of a step that ends there.
    #[inline(always)]
    fn stage_time(&self, node: f64) -> f64 {
        (self.start + node * self.size).min(self.limit.next_down())
    }

    #[inline(always)]
    pub(super) fn stage<P: Pair, S: System<N>, const I: usize>(
        &mut self,
        course: &Course<'_, S, N>,
    ) {
        let argument = self.moved::<Arguments<P, I>>();
        if self.substitution.is_none() {
            self.evaluate(course, I, self.stage_time(P::NODES[I]), &argument);
        } else {
            self.substituted_stage::<P, S>(course, I, &argument);
        }
    }

    /// Tries a step; its error over what is allowed, or no number.
    fn trial<P: Pair, S: System<N>>(&mut self, course: &Course<'_, S, N>) -> f64 {
        in_wide_registers!(self.level, self.tried::<P, S>(course))
    }

    #[inline(always)]
    fn tried<P: Pair, S: System<N>>(&mut self, course: &Course<'_, S, N>) -> f64 {
        macro_rules! stages {
            ($($stage:literal)*) => {$(
                if const { $stage < P::TRIAL } {
                    self.stage::<P, S, $stage>(course);
                }
            )*};
        }
        self.ended = false;
        stages!(1 2 3 4 5 6 7 8 9 10 11 12);
        self.to = self.moved::<Weights<P>>();
        let error = self.error::<P>(course.scaling) * self.size;
        error * self.doubt() / (P::LOCAL_PART * course.settings.tolerance)
    }

    /// Root mean square of the error per time, relative to one unit and the deviation.
    #[inline(always)]
    fn error<P: Pair>(&self, scaling: &Scaling<N>) -> f64 {
        let error = sum::<Error<P>, N>(&self.stages);
        let inverse: [f64; N] = std::array::from_fn(|i| {
            (scaling.scale[i] + self.from[i].abs().max(self.to[i].abs())).recip()
        });
        let mut squares = 0.0;
        for i in 0..N {
            let part = error[i] * inverse[i];
            squares += part * part;
        }
        (squares / N as f64).sqrt()
    }

    /// Evaluates the derivative at the end of the step, where the trial did not.
    pub(super) fn evaluate_end<P: Pair, S: System<N>>(&mut self, course: &Course<'_, S, N>) {
        if const { P::LAST >= P::TRIAL } && !self.ended {
            self.ended = true;
            let to = self.to;
            if self.substitution.is_none() {
                self.evaluate(course, P::LAST, self.stage_time(1.0), &to);
            } else {
                self.substituted_stage::<P, S>(course, P::LAST, &to);
            }
        }
    }

    /// Completes a good step.
    fn finish<P: Pair, S: System<N>>(&mut self, course: &Course<'_, S, N>) {
        self.evaluate_end::<P, S>(course);
        self.counters.steps += 1;
        self.fault = false;
        self.extended = const { P::LAST + 1 >= P::STAGES };
        if !self.substitution.is_none() {
            // the variable of the quintic is the time
            self.quintic = false;
            self.jerk = [f64::INFINITY; N];
            return;
        }
        self.quintic = course.system.is_second_order() && self.judge_quintic::<P, S>(course);
    }
}

#[cfg(test)]
#[path = "walk_tests.rs"]
mod tests;
