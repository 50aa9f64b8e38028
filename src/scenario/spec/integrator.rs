//! `[integrator]`.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::integrate::{Method, Settings};

/// How to integrate and how exactly.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
pub struct IntegratorSpec {
    /// Integration method. Default: "auto".
    pub method: MethodChoice,
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

/// Integration method.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
#[schemars(extend("successors" = {
    "tsit5": "verner76",
    "dprkn8": "exponential",
    "dprkn12": "verner76",
    "ode_solvers_dop853": "dop853",
}))]
pub enum MethodChoice {
    /// "verner76" where a ball may part from a race on this motion, else "exponential".
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

impl Default for IntegratorSpec {
    fn default() -> Self {
        Self {
            method: MethodChoice::Auto,
            tolerance: 1e-8,
            step_limit: 100_000_000,
            verify: true,
        }
    }
}

impl IntegratorSpec {
    /// Method, tolerance and limit.
    pub fn build(&self) -> Settings {
        Settings {
            method: self.method.method(),
            tolerance: self.tolerance,
            step_limit: self.step_limit,
        }
    }
}

impl MethodChoice {
    /// As the integration knows it.
    pub fn method(self) -> Method {
        match self {
            Self::Auto => Method::Auto,
            Self::Verner76 => Method::Verner76,
            Self::Exponential => Method::Exponential,
            Self::Rodas => Method::Rodas,
            Self::Dopri5 => Method::Dopri5,
            Self::Dop853 => Method::Dop853,
        }
    }
}
