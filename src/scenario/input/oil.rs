//! `[bearing.oil]`.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::bearing::Oil;
use crate::scenario::quantity::{PressureViscosity, Quantity, Viscosity};

/// Lubricating oil at the temperature of the bearing.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct OilInput {
    /// Dynamic viscosity at ambient pressure, for instance "0.04 Pa s".
    #[schemars(extend("x-above" = 0.0))]
    pub viscosity: Quantity<Viscosity>,
    /// How the viscosity grows with the pressure, for instance "22 1/GPa".
    #[schemars(extend("x-above" = 0.0))]
    pub pressure_viscosity: Quantity<PressureViscosity>,
}

impl OilInput {
    /// The oil.
    pub fn build(&self) -> Oil {
        Oil {
            viscosity: self.viscosity.si(),
            pressure_viscosity: self.pressure_viscosity.si(),
        }
    }
}
