//! `[integrator]`.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::integrate::{Method, Settings};

/// How to integrate and how exactly.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
pub struct IntegratorInput {
    /// Integration method. Default: "auto".
    pub method: Method,
    /// Error aimed at, relative to the scale of the motion, 1e-13 to 1e-2.
    /// Default: 1e-8.
    #[schemars(range(min = 1e-13, max = 1e-2))]
    pub tolerance: f64,
    /// Largest number of steps, accepted and rejected together. Default: 100 million.
    #[schemars(range(min = 1, max = 1_000_000_000_000_i64))]
    pub step_limit: u64,
    /// Whether a second run at a tenth of the tolerance measures the error of the first.
    /// Default: true.
    pub verify: bool,
}

impl Default for IntegratorInput {
    fn default() -> Self {
        Self {
            method: Method::Auto,
            tolerance: 1e-8,
            step_limit: 100_000_000,
            verify: true,
        }
    }
}

impl IntegratorInput {
    /// Method, tolerance and limit.
    pub fn build(&self) -> Settings {
        Settings {
            method: self.method,
            tolerance: self.tolerance,
            step_limit: self.step_limit,
        }
    }
}
