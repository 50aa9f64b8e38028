//! The walk of the method in use.

use super::explicit::{self, Course};
use super::explicit::{Dop853, Tsit5, Verner76};
use super::nystrom::{self, Dprkn8, Dprkn12};
use super::{Counters, IntegrateError, Method, Scaling, System};

/// Where the pairs of this crate stand; of other methods, at their start.
#[derive(Debug, Clone)]
pub(super) enum Walks<const N: usize> {
    Explicit(explicit::Walk<N>),
    Nystrom(nystrom::Walk<N>),
}

/// The same of either walk.
macro_rules! either {
    ($walks:expr, $walk:ident => $of:expr) => {
        match $walks {
            Self::Explicit($walk) => $of,
            Self::Nystrom($walk) => $of,
        }
    };
}

impl<const N: usize> Walks<N> {
    /// Stands at time 0 in a deviation from the origin.
    pub fn new(method: Method, deviation: [f64; N]) -> Self {
        match method {
            Method::Dprkn8 | Method::Dprkn12 => Self::Nystrom(nystrom::Walk::new(deviation)),
            _ => Self::Explicit(explicit::Walk::new(deviation)),
        }
    }

    /// The walk of numbers as by [`Walks::numbers`], with its counters; none of any others.
    pub fn restored(method: Method, numbers: &[f64], counters: Counters) -> Option<Self> {
        match method {
            Method::Dprkn8 | Method::Dprkn12 => {
                nystrom::Walk::restored(numbers, counters).map(Self::Nystrom)
            }
            _ => explicit::Walk::restored(numbers, counters).map(Self::Explicit),
        }
    }

    /// State at a time that is not before the start of the latest step; walks on as far as needed.
    ///
    /// # Errors
    /// Why the walk ends before that time.
    pub fn state_at<S: System<N>>(
        &mut self,
        course: &Course<'_, S, N>,
        time: f64,
    ) -> Result<[f64; N], IntegrateError> {
        match (self, course.settings.method) {
            (Self::Nystrom(walk), Method::Dprkn8) => walk.state_at::<Dprkn8, S>(course, time),
            (Self::Nystrom(walk), _) => walk.state_at::<Dprkn12, S>(course, time),
            (Self::Explicit(walk), Method::Dop853) => walk.state_at::<Dop853, S>(course, time),
            (Self::Explicit(walk), Method::Tsit5) => walk.state_at::<Tsit5, S>(course, time),
            (Self::Explicit(walk), _) => walk.state_at::<Verner76, S>(course, time),
        }
    }

    /// End of the latest step, s.
    pub fn time(&self) -> f64 {
        either!(self, walk => walk.time())
    }

    /// Size of the latest step or of the one to come, s.
    pub fn step_size(&self) -> f64 {
        either!(self, walk => walk.step_size())
    }

    /// Scaled state at the end of the latest step.
    pub fn scaled(&self, scaling: &Scaling<N>) -> [f64; N] {
        either!(self, walk => walk.scaled(scaling))
    }

    /// Everything but the counters as numbers.
    pub fn numbers(&self) -> Vec<f64> {
        either!(self, walk => walk.numbers())
    }

    /// Work done so far.
    pub fn counters(&self) -> Counters {
        either!(self, walk => walk.counters())
    }
}
