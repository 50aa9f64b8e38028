//! States between the ends of a step.

use fearless_simd::Simd;

use super::entries::Entries;
use super::factor::Factor;
use super::tableau::Pair;
use super::walk::Walk;
use crate::integrate::System;
use crate::integrate::course::Course;
use crate::integrate::registers::in_wide_registers;

/// Part of the error aimed at that states within a step may be estimated to have of their own.
const WITHIN_PART: f64 = 0.3;

/// How states within the latest step are found.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Dense {
    /// Nobody has asked yet.
    Unknown,
    ByPolynomial,
    /// By a step of their own.
    BySteps,
}

impl<const N: usize> Walk<N> {
    /// The polynomial for states within the step, where one is exact enough: of as few ends as it takes.
    pub(super) fn polynomial<S, E: Entries<N>>(
        &mut self,
        course: &Course<'_, S, N>,
        factor: &Factor<E, N>,
    ) -> Dense {
        in_wide_registers!(self.level, simd => self.fitted(simd, course, factor))
    }

    #[inline(always)]
    fn fitted<S, E: Entries<N>, V: Simd>(
        &mut self,
        simd: V,
        course: &Course<'_, S, N>,
        factor: &Factor<E, N>,
    ) -> Dense {
        let part = WITHIN_PART * course.settings.tolerance;
        let scale = &course.scaling.scale;
        let per = std::array::from_fn(|i| 1.0 / (part * (scale[i] + self.from.state[i].abs())));
        let [start, end] = [&self.from, &self.to].map(|stand| stand.end(simd, factor));
        self.within.begin(&start, &end);
        for stand in &self.past[..self.known] {
            self.within.add(&stand.end(simd, factor));
            if self.within.is_within(&per) {
                return Dense::ByPolynomial;
            }
        }
        Dense::BySteps
    }

    /// Deviation at a time within the step by its polynomial.
    pub(super) fn by_polynomial(&self, time: f64) -> [f64; N] {
        in_wide_registers!(self.level, self.within.at(time))
    }

    /// Deviation at a time within the step by a shorter step from its start.
    pub(super) fn by_step<P: Pair, S: System<N>, E: Entries<N>>(
        &mut self,
        course: &Course<'_, S, N>,
        factor: &mut Factor<E, N>,
        time: f64,
    ) -> [f64; N] {
        let size = self.size;
        self.size = time - self.from.time;
        let state = in_wide_registers!(self.level, simd => {
            factor.prepare::<P, _>(simd, self.size);
            self.moved_by::<P, S, E, _>(simd, course, factor)
        });
        self.size = size;
        state
    }
}
