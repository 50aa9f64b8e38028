//! Surfaces at which the force is not smooth: steps go over them, but none goes over one by more than its
//! error allows.

use super::tableau::Pair;
use super::walk::Walk;
use crate::integrate::System;
use crate::integrate::course::Course;
use crate::integrate::look::Look;
use crate::integrate::stride::{Stride, each};

/// Error for a surface that is let pass, over the tolerance.
const LET_PASS: f64 = 0.75;

/// Where a walk stands between the surfaces.
#[derive(Debug, Clone, Copy)]
pub(super) struct Crossing<const N: usize> {
    /// The latest look around on the way, and that at the end of the trial, where there was one.
    looked: Option<Look<N>>,
    ahead: Option<Look<N>>,
    /// Whether the latest step went over a surface.
    went_over: bool,
}

impl<const N: usize> Crossing<N> {
    pub const NEW: Self = Self {
        looked: None,
        ahead: None,
        went_over: false,
    };
}

impl<const N: usize> Walk<N> {
    /// Whether the latest step went over a surface.
    pub fn went_over_surface(&self) -> bool {
        self.crossing.went_over
    }

    /// Looks around at the start of a step where nobody has.
    pub(super) fn look_around<S: System<N>>(&mut self, course: &Course<'_, S, N>) {
        if self.crossing.looked.is_none() {
            let state = course.state(&self.from.state);
            self.crossing.looked = Some(Look::around(course.system, self.from.time, state));
        }
    }

    /// Error of the trial for the surfaces that it goes over, over what is allowed.
    pub(super) fn crossed<P: Pair, S: System<N>>(&mut self, course: &Course<'_, S, N>) -> f64 {
        self.crossing.ahead = None;
        let Some(looked) = &self.crossing.looked else {
            return 0.0;
        };
        let (time, state) = (self.from.time + self.size, course.state(&self.to.state));
        if looked.is_clear(course.system, time, &state) {
            return 0.0;
        }
        let ahead = Look::around(course.system, time, state);
        let changed = looked.sides ^ ahead.sides;
        self.crossing.ahead = Some(ahead);
        if changed == 0 {
            return 0.0;
        }
        let stride = Stride {
            course,
            times: [self.from.time, time],
            deviations: [&self.from.state, &self.to.state],
            size: self.size,
        };
        let errors = each(changed).map(|surface| stride.error_over(surface, P::CROSSED));
        errors.fold(0.0, f64::max) / LET_PASS
    }

    /// Takes note of the sides after a good step.
    pub(super) fn arrive(&mut self) {
        let crossing = &mut self.crossing;
        crossing.went_over = false;
        if let Some(ahead) = crossing.ahead.take() {
            let looked = crossing.looked.replace(ahead);
            crossing.went_over = looked.is_some_and(|looked| looked.sides != ahead.sides);
        }
    }
}
