//! Steps of an explicit pair, one after the other, and the states between their ends.

use super::control::Control;
use super::course::Course;
use super::quintic::{self, Quintic};
use super::tableau::{Arguments, CoarseError, Error, Factors, MOST, Pair, Weights, sum};
use crate::integrate::{Counters, IntegrateError, Scaling, System};

/// Part of a step that the end of a stretch may lengthen it by.
const STRETCH: f64 = 1.01;
/// Part of the local error that the interpolation without evaluations may be estimated to have.
const QUINTIC_PART: f64 = 0.1;

/// Single numbers of a walk.
const SINGLE: usize = 9;

fn flag(set: bool) -> f64 {
    f64::from(u8::from(set))
}

/// The latest step, and how to go on. States are kept as deviations from the scaling's origin: sums
/// of them lose less to round-off.
#[derive(Debug, Clone)]
pub(in crate::integrate) struct Walk<const N: usize> {
    /// Start and end of the latest step, s.
    start: f64,
    time: f64,
    /// Size of the latest step and of the next one, s.
    size: f64,
    next_size: f64,
    /// Time that the next step must not reach over, s.
    limit: f64,
    /// States at the start and at the end of the latest step.
    from: [f64; N],
    to: [f64; N],
    stages: [[f64; N]; MOST],
    /// Whether the stages for dense output are there.
    extended: bool,
    /// Whether the quintic is exact enough.
    quintic: bool,
    /// h³ q‴ at the end of the step before, by its polynomial; infinite where there was none.
    jerk: [f64; N],
    size_before: f64,
    control: Control,
    /// Whether a trial since the latest good step was not finite.
    fault: bool,
    counters: Counters,
}

impl<const N: usize> Walk<N> {
    /// Stands at time 0 in a deviation from the origin.
    pub fn new(deviation: [f64; N]) -> Self {
        Self {
            start: 0.0,
            time: 0.0,
            size: 0.0,
            next_size: 0.0,
            limit: 0.0,
            from: deviation,
            to: deviation,
            stages: [[0.0; N]; MOST],
            extended: false,
            quintic: false,
            jerk: [f64::INFINITY; N],
            size_before: 0.0,
            control: Control::NEW,
            fault: false,
            counters: Counters::default(),
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

    /// Everything but the counters as numbers.
    pub fn numbers(&self) -> Vec<f64> {
        let single = [
            self.start,
            self.time,
            self.size,
            self.next_size,
            self.limit,
            self.size_before,
            flag(self.extended),
            flag(self.quintic),
            flag(self.control.was_rejected()),
        ];
        let vectors = [&self.from, &self.to, &self.jerk];
        let vectors = vectors.into_iter().chain(&self.stages).flatten();
        single.iter().chain(vectors).copied().collect()
    }

    /// The walk of numbers as by [`Walk::numbers`], with its counters; none of any others.
    pub fn restored(numbers: &[f64], counters: Counters) -> Option<Self> {
        let (single, vectors) = numbers.split_at_checked(SINGLE)?;
        let vectors: &[[f64; N]] = match vectors.as_chunks() {
            (vectors, []) => vectors,
            _ => return None,
        };
        let [
            start,
            time,
            size,
            next_size,
            limit,
            size_before,
            extended,
            quintic,
            rejected,
        ] = *<&[f64; SINGLE]>::try_from(single).ok()?;
        let [from, to, jerk, stages @ ..] = vectors else {
            return None;
        };
        Some(Self {
            start,
            time,
            size,
            next_size,
            limit,
            from: *from,
            to: *to,
            stages: stages.try_into().ok()?,
            extended: extended != 0.0,
            quintic: quintic != 0.0,
            jerk: *jerk,
            size_before,
            control: Control::after(rejected != 0.0),
            fault: false,
            counters,
        })
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
        let origin = &course.scaling.origin;
        let deviation = if time >= self.time {
            self.to
        } else if self.quintic {
            self.by_quintic(time, P::LAST)
        } else {
            self.extend::<P, S>(course);
            self.by_stages::<P>(time)
        };
        Ok(std::array::from_fn(|i| origin[i] + deviation[i]))
    }

    fn step<P: Pair, S: System<N>>(
        &mut self,
        course: &Course<'_, S, N>,
    ) -> Result<(), IntegrateError> {
        self.begin::<P, S>(course);
        loop {
            course.check(self.start, self.next_size, &self.counters, self.fault)?;
            let cut = self.start + STRETCH * self.next_size >= self.limit;
            self.size = if cut {
                self.limit - self.start
            } else {
                self.next_size
            };
            let error = self.trial::<P, S>(course);
            if error <= 1.0 {
                let growth = self.control.accepted(error, P::ERROR_POWER);
                let proposed = self.size * growth;
                // a step that was cut tells little of how long the next may be
                self.next_size = if cut {
                    proposed.max(self.next_size)
                } else {
                    proposed
                };
                self.time = if cut {
                    self.limit
                } else {
                    self.start + self.size
                };
                self.finish::<P, S>(course);
                return Ok(());
            }
            self.counters.rejected += 1;
            self.fault |= !error.is_finite();
            self.next_size = self.size * self.control.rejected(error, P::ERROR_POWER);
        }
    }

    /// Makes the end of the latest step the start of the next.
    fn begin<P: Pair, S: System<N>>(&mut self, course: &Course<'_, S, N>) {
        self.start = self.time;
        self.size_before = self.size;
        self.from = self.to;
        self.stages[0] = self.stages[P::LAST];
        if self.time >= self.limit {
            self.limit = course.limit_after(self.time);
            // the derivative after a break, or the very first
            let from = self.from;
            self.evaluate(course, 0, self.time, &from);
            self.jerk = [f64::INFINITY; N];
        }
        if self.next_size <= 0.0 {
            let stretch = [self.start, self.limit];
            self.next_size = course.first_size(stretch, &self.from, &self.stages[0], P::ORDER);
            self.counters.evaluations += 1;
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
        let origin = &course.scaling.origin;
        let state = std::array::from_fn(|i| origin[i] + deviation[i]);
        course
            .system
            .derivative(time, &state, &mut self.stages[stage]);
        self.counters.evaluations += 1;
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
    fn stage<P: Pair, S: System<N>, const I: usize>(&mut self, course: &Course<'_, S, N>) {
        let argument = self.moved::<Arguments<P, I>>();
        self.evaluate(course, I, self.stage_time(P::NODES[I]), &argument);
    }

    /// Tries a step; its error over what is allowed, or no number.
    fn trial<P: Pair, S: System<N>>(&mut self, course: &Course<'_, S, N>) -> f64 {
        macro_rules! stages {
            ($($stage:literal)*) => {$(
                if const { $stage < P::TRIAL } {
                    self.stage::<P, S, $stage>(course);
                }
            )*};
        }
        stages!(1 2 3 4 5 6 7 8 9 10 11 12 13 14 15);
        self.to = self.moved::<Weights<P>>();
        self.error::<P>(course.scaling) * self.size / (P::LOCAL_PART * course.settings.tolerance)
    }

    /// Root mean square of the error per time, relative to one unit and the deviation.
    #[inline(always)]
    fn error<P: Pair>(&self, scaling: &Scaling<N>) -> f64 {
        let error = sum::<Error<P>, N>(&self.stages);
        let inverse: [f64; N] = std::array::from_fn(|i| {
            (scaling.scale[i] + self.from[i].abs().max(self.to[i].abs())).recip()
        });
        let square = |error: [f64; N]| {
            let mut squares = 0.0;
            for i in 0..N {
                let part = error[i] * inverse[i];
                squares += part * part;
            }
            squares / N as f64
        };
        let fine = square(error);
        if P::COARSE_ERROR.is_none() {
            return fine.sqrt();
        }
        // Hairer, Nørsett & Wanner, eq. (II.10.17)
        let coarse = square(sum::<CoarseError<P>, N>(&self.stages));
        let both = fine + 0.01 * coarse;
        if both == 0.0 { 0.0 } else { fine / both.sqrt() }
    }

    /// Completes a good step.
    fn finish<P: Pair, S: System<N>>(&mut self, course: &Course<'_, S, N>) {
        if const { P::LAST >= P::TRIAL } {
            let to = self.to;
            self.evaluate(course, P::LAST, self.stage_time(1.0), &to);
        }
        self.counters.steps += 1;
        self.fault = false;
        self.extended = const { P::LAST + 1 >= P::STAGES };
        self.quintic = course.system.is_second_order() && self.judge_quintic::<P, S>(course);
    }

    /// Evaluates the stages for dense output, once a step.
    fn extend<P: Pair, S: System<N>>(&mut self, course: &Course<'_, S, N>) {
        if self.extended {
            return;
        }
        self.extended = true;
        macro_rules! stages {
            ($($stage:literal)*) => {$(
                if const { $stage > P::LAST && $stage < P::STAGES } {
                    self.stage::<P, S, $stage>(course);
                }
            )*};
        }
        stages!(7 8 9 10 11 12 13 14 15);
    }

    /// Deviation within the step by the pair's own interpolant.
    fn by_stages<P: Pair>(&self, time: f64) -> [f64; N] {
        let part = (time - self.start) / self.size;
        let mut sum = [0.0; N];
        for (row, stage) in P::DENSE.iter().zip(&self.stages).take(P::STAGES) {
            let factor = part * row.iter().rev().fold(0.0, |sum, term| sum * part + term);
            for i in 0..N {
                sum[i] += factor * stage[i];
            }
        }
        std::array::from_fn(|i| self.from[i] + self.size * sum[i])
    }

    fn by_quintic(&self, time: f64, last: usize) -> [f64; N] {
        let part = (time - self.start) / self.size;
        let mut deviation = self.to;
        for i in 0..N / 2 {
            let [start, end] = self.ends(i, last);
            let quintic = Quintic::new(self.size, start, end);
            [deviation[i], deviation[N / 2 + i]] = quintic.at(part, self.size, start);
        }
        deviation
    }

    /// Motion of a freedom at both ends of the step.
    #[inline(always)]
    fn ends(&self, freedom: usize, last: usize) -> [quintic::Motion; 2] {
        let velocity = N / 2 + freedom;
        [
            [
                self.from[freedom],
                self.from[velocity],
                self.stages[0][velocity],
            ],
            [
                self.to[freedom],
                self.to[velocity],
                self.stages[last][velocity],
            ],
        ]
    }

    /// Whether the quintic's error is small beside what the step may have.
    fn judge_quintic<P: Pair, S>(&mut self, course: &Course<'_, S, N>) -> bool {
        let (size, before) = (self.size, self.size_before);
        let scale = &course.scaling.scale;
        let allowed = QUINTIC_PART * course.settings.tolerance;
        let mut good = true;
        for i in 0..N / 2 {
            let [start, end] = self.ends(i, P::LAST);
            let [first, last] = Quintic::new(size, start, end).jerks();
            let jump = first / size.powi(3) - self.jerk[i];
            self.jerk[i] = last / size.powi(3);
            let [place, velocity] = quintic::errors(jump, size, before);
            // not so where the jump is no number
            good &= place <= allowed * (scale[i] + start[0].abs())
                && velocity <= allowed * (scale[N / 2 + i] + start[1].abs());
        }
        good
    }
}

#[cfg(test)]
#[path = "walk_tests.rs"]
mod tests;
