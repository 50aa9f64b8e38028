//! States between the ends of a step.

use super::quintic::{self, Quintic};
use super::tableau::Pair;
use super::walk::Walk;
use crate::integrate::System;
use crate::integrate::course::Course;

/// Part of the local error that the interpolation without evaluations may be estimated to have.
const QUINTIC_PART: f64 = 0.1;

impl<const N: usize> Walk<N> {
    /// Evaluates the stages for dense output, once a step.
    pub(super) fn extend<P: Pair, S: System<N>>(&mut self, course: &Course<'_, S, N>) {
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
        stages!(7 8 9 10 11 12);
    }

    /// Deviation within the step by the pair's own interpolant.
    pub(super) fn by_stages<P: Pair>(&self, time: f64) -> [f64; N] {
        let part = self.substitution.inverse((time - self.start) / self.size);
        let mut sum = [0.0; N];
        for (row, stage) in P::DENSE.iter().zip(&self.stages).take(P::STAGES) {
            let factor = part * row.iter().rev().fold(0.0, |sum, term| sum * part + term);
            for i in 0..N {
                sum[i] += factor * stage[i];
            }
        }
        std::array::from_fn(|i| self.from[i] + self.size * sum[i])
    }

    /// Deviation within the step by the motion at both ends, `last` being the stage at the second.
    pub(super) fn by_quintic(&self, time: f64, last: usize) -> [f64; N] {
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
    pub(super) fn ends(&self, freedom: usize, last: usize) -> [quintic::Motion; 2] {
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
    pub(super) fn judge_quintic<P: Pair, S>(&mut self, course: &Course<'_, S, N>) -> bool {
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
