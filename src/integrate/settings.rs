//! Method, tolerance and limits of an integration, its work, and its progress.

use std::fmt;
use std::sync::{Mutex, MutexGuard, PoisonError};

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// Integration method.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Method {
    /// "exponential"; where balls part from a race again and again, which keeps its steps short, "verner76" goes on.
    Auto,
    /// Verner 7(6), explicit: its steps end where a ball parts from a race or meets it again.
    Verner76,
    /// Exponential collocation: the linear part of the motion exactly, for balls that stay loaded, and for
    /// strong damping.
    Exponential,
    /// RODAS 4(3), linearly implicit: for stiff scenes, as with strong damping.
    Rodas,
    /// Dormand–Prince 5(4) of the library `ode_solvers`, to compare with.
    Dopri5,
    /// Dormand–Prince 8(5,3) of the library `ode_solvers`, to compare with.
    Dop853,
}

impl fmt::Display for Method {
    /// The name that scenarios have for it.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.serialize(f)
    }
}

/// Method, tolerance and limits.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Settings {
    /// Method.
    pub method: Method,
    /// Error aimed at, relative to the scale of the motion; a step's own error is kept at a part of it
    /// that is measured for each method.
    pub tolerance: f64,
    /// Largest number of steps, accepted and rejected together.
    pub step_limit: u64,
}

/// Work done by an integration.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize)]
#[non_exhaustive]
pub struct Counters {
    /// Accepted steps.
    pub steps: u64,
    /// Rejected steps.
    pub rejected: u64,
    /// Evaluations of the derivative.
    pub evaluations: u64,
}

impl Counters {
    /// Adds the work of a further part.
    pub(crate) fn add(&mut self, part: &Self) {
        self.steps += part.steps;
        self.rejected += part.rejected;
        self.evaluations += part.evaluations;
    }
}

/// How far an integration has come, for other threads: updated at every trial of a step.
#[derive(Debug, Default)]
pub struct Progress(Mutex<(f64, Counters)>);

impl Progress {
    /// Records a time in s and the work done up to it.
    pub(super) fn record(&self, time: f64, counters: &Counters) {
        *self.locked() = (time, *counters);
    }

    /// The latest time, s, and the work done up to there.
    pub fn latest(&self) -> (f64, Counters) {
        *self.locked()
    }

    fn locked(&self) -> MutexGuard<'_, (f64, Counters)> {
        // the numbers are whole even where the thread that wrote them panicked
        self.0.lock().unwrap_or_else(PoisonError::into_inner)
    }
}
