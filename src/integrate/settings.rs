//! What the user chooses about the integration, and what it costs.

use serde::{Deserialize, Serialize};

/// Integration method.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
pub enum Method {
    /// Verner 7(6) where the motion is expected to cross surfaces at which the derivative is not smooth, else
    /// exponential collocation.
    Auto,
    /// Verner 7(6), "most efficient"; its steps end on the surfaces of a [`super::System`] at which the derivative is
    /// not smooth.
    Verner76,
    /// Exponential collocation of order 7: the linear part exactly, for motion that follows a slow drive.
    Exponential,
    /// RODAS 4(3): linearly implicit, for stiff systems.
    Rodas,
    /// Dormand–Prince 5(4) of the library `ode_solvers`.
    Dopri5,
    /// Dormand–Prince 8(5,3) of the library `ode_solvers`.
    Dop853,
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
    pub fn add(&mut self, part: &Self) {
        self.steps += part.steps;
        self.rejected += part.rejected;
        self.evaluations += part.evaluations;
    }
}
