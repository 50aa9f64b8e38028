//! The walk of the method in use.

use super::auto::{AutoWalk, MethodUse};
use super::course::Course;
use super::explicit::{self, Dop853, Pair, Tsit5, Verner76};
use super::exponential::ExponentialWalk;
use super::nystrom::{self, Dprkn8, Dprkn12};
use super::{Counters, IntegrateError, Linearised, Method, Scaling};

/// Where the methods of this crate stand whose steps do not end with a block; of others, at their start.
#[derive(Debug, Clone)]
pub(super) enum Walks<const N: usize> {
    Explicit(Box<explicit::Walk<N>>),
    Nystrom(Box<nystrom::Walk<N>>),
    Exponential(Box<ExponentialWalk<N>>),
    Auto(Box<AutoWalk<N>>),
}

/// The same of any walk.
macro_rules! any {
    ($walks:expr, $walk:ident => $of:expr) => {
        match $walks {
            Self::Explicit($walk) => $of,
            Self::Nystrom($walk) => $of,
            Self::Exponential($walk) => $of,
            Self::Auto($walk) => $of,
        }
    };
}

impl<const N: usize> Walks<N> {
    /// Stands at time 0 in a deviation from the origin, before samples at an interval, s.
    pub fn new(method: Method, deviation: [f64; N], interval: f64) -> Self {
        match method {
            Method::Dprkn8 | Method::Dprkn12 => {
                Self::Nystrom(Box::new(nystrom::Walk::new(deviation)))
            }
            Method::Exponential => {
                Self::Exponential(Box::new(ExponentialWalk::new(deviation, interval)))
            }
            Method::Auto => Self::Auto(Box::new(AutoWalk::new(deviation, interval))),
            _ => Self::Explicit(Box::new(explicit::Walk::new(deviation))),
        }
    }

    /// The walk of numbers as by [`Walks::numbers`], with its counters; none of any others.
    pub fn restored(
        method: Method,
        numbers: &[f64],
        counters: Counters,
        interval: f64,
    ) -> Option<Self> {
        Some(match method {
            Method::Dprkn8 | Method::Dprkn12 => {
                Self::Nystrom(Box::new(nystrom::Walk::restored(numbers, counters)?))
            }
            Method::Exponential => {
                let walk = ExponentialWalk::restored(numbers, counters, interval)?;
                Self::Exponential(Box::new(walk))
            }
            Method::Auto => Self::Auto(Box::new(AutoWalk::restored(numbers, interval)?)),
            _ => Self::Explicit(Box::new(explicit::Walk::restored(numbers, counters)?)),
        })
    }

    /// State at a time that is not before the start of the latest step; walks on as far as needed.
    ///
    /// # Errors
    /// Why the walk ends before that time.
    pub fn state_at<S: Linearised<N>>(
        &mut self,
        course: &Course<'_, S, N>,
        time: f64,
    ) -> Result<[f64; N], IntegrateError> {
        match (self, course.settings.method) {
            (Self::Exponential(walk), _) => walk.state_at(course, time),
            (Self::Auto(walk), _) => walk.state_at(course, time),
            (Self::Nystrom(walk), Method::Dprkn8) => walk.state_at::<Dprkn8, S>(course, time),
            (Self::Nystrom(walk), _) => walk.state_at::<Dprkn12, S>(course, time),
            (Self::Explicit(walk), Method::Dop853) => walk.state_at::<Dop853, S>(course, time),
            (Self::Explicit(walk), Method::Tsit5) => walk.state_at::<Tsit5, S>(course, time),
            (Self::Explicit(walk), _) => walk.state_at::<Verner76, S>(course, time),
        }
    }

    /// Product of step and largest eigenvalue at which a method ceases to be stable, or is held by what else
    /// grows with eigenvalues; none where nothing holds it.
    pub fn stability_limit(&self, method: Method) -> Option<f64> {
        match (self, method) {
            (Self::Exponential(_) | Self::Auto(_), _) => None,
            (Self::Nystrom(walk), Method::Dprkn8) => Some(walk.stability::<Dprkn8>()),
            (Self::Nystrom(walk), _) => Some(walk.stability::<Dprkn12>()),
            (Self::Explicit(_), Method::Dop853) => Some(Dop853::STABILITY),
            (Self::Explicit(_), Method::Tsit5) => Some(Tsit5::STABILITY),
            (Self::Explicit(_), _) => Some(Verner76::STABILITY),
        }
    }

    /// Which methods walked, where the choice was left open.
    pub fn method_use(&self) -> Option<MethodUse> {
        match self {
            Self::Auto(walk) => Some(walk.usage()),
            _ => None,
        }
    }

    /// End of the latest step, s.
    pub fn time(&self) -> f64 {
        any!(self, walk => walk.time())
    }

    /// Work done so far, the size of the latest step or of the one to come, s, and the scaled state at the end of the
    /// latest.
    pub fn stock(&self, scaling: &Scaling<N>) -> (Counters, f64, [f64; N]) {
        any!(self, walk => (walk.counters(), walk.step_size(), walk.scaled(scaling)))
    }

    /// Everything but the counters as numbers.
    pub fn numbers(&self) -> Vec<f64> {
        any!(self, walk => walk.numbers())
    }
}
