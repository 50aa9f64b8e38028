//! Materials.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::physics::Material;
use crate::scenario::quantity::{Density, Pressure, Quantity, si};

/// Elastic constants and density.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct MaterialInput {
    /// Young's modulus, for instance "207 GPa" (the default, bearing steel) or "310 GPa"
    /// (silicon nitride).
    #[schemars(extend("x-minimum" = 1e3))]
    pub youngs_modulus: Option<Quantity<Pressure>>,
    /// Poisson's ratio, 0 to 0.5. Default: 0.3.
    #[schemars(range(min = 0.0, max = 0.5))]
    pub poisson_ratio: Option<f64>,
    /// Density, for instance "7800 kg/m^3" (the default) or "3200 kg/m^3" (silicon nitride).
    #[schemars(extend("x-above" = 0.0))]
    pub density: Option<Quantity<Density>>,
}

/// The material; what is not given is that of `base`.
pub fn material(input: Option<&MaterialInput>, base: Material) -> Material {
    let Some(input) = input else { return base };
    Material {
        youngs_modulus: si(&input.youngs_modulus).unwrap_or(base.youngs_modulus),
        poisson_ratio: input.poisson_ratio.unwrap_or(base.poisson_ratio),
        density: si(&input.density).unwrap_or(base.density),
    }
}
