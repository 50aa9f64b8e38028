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
pub enum MethodChoice {
    /// The cheapest of Verner 7(6), Dormand–Prince 8(5,3), the Nyström pair dprkn8 and exponential
    /// collocation, chosen and chosen again during the run.
    Auto,
    /// Verner 7(6): for all tolerances.
    Verner76,
    /// Dormand–Prince 8(5,3): for fine tolerances.
    Dop853,
    /// Tsitouras 5(4): for coarse tolerances.
    Tsit5,
    /// Dormand–El-Mikkawy–Prince 8(6), a Nyström pair: half the evaluations where all balls stay loaded. Not
    /// with a drive, `energy` or damping of contacts, nor with gyroscopic moments at a changing speed.
    Dprkn8,
    /// Dormand–El-Mikkawy–Prince 12(10), as `dprkn8`: for the finest tolerances and few samples.
    Dprkn12,
    /// Exponential collocation: for preloaded bearings whose shaft turns slowly beside its natural
    /// frequencies.
    Exponential,
    /// RODAS 4(3), linearly implicit: for stiff scenes, as with strong damping.
    Rodas,
    /// Dormand–Prince 5(4) of the library `ode_solvers`, to compare with.
    Dopri5,
    /// Dormand–Prince 8(5,3) of the library `ode_solvers`, to compare with.
    OdeSolversDop853,
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
            Self::Dop853 => Method::Dop853,
            Self::Tsit5 => Method::Tsit5,
            Self::Dprkn8 => Method::Dprkn8,
            Self::Dprkn12 => Method::Dprkn12,
            Self::Exponential => Method::Exponential,
            Self::Rodas => Method::Rodas,
            Self::Dopri5 => Method::Dopri5,
            Self::OdeSolversDop853 => Method::OdeSolversDop853,
        }
    }
}
