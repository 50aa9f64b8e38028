//! `[study]`.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::scenario::scalar::Scalar;

/// One number of the scenario that takes many values, the static question answered at each
/// (`jeffcott bearing`).
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(extend("x-exactly-one" = ["values", "count"]))]
pub struct StudyInput {
    /// Path of the key that takes the values, for instance "load[0].constant.z",
    /// "speed.constant" or "bearing[0].preload".
    #[schemars(extend("examples" = ["speed.constant"]))]
    pub vary: String,
    /// The values, each written as that key is, for instance ["200 N", "400 N"].
    #[schemars(extend("minItems" = 1, "maxItems" = 10_000))]
    pub values: Option<Vec<Scalar>>,
    /// First of `count` evenly spaced values.
    pub from: Option<Scalar>,
    /// Last of `count` evenly spaced values.
    pub to: Option<Scalar>,
    /// How many evenly spaced values, 2 to 10000.
    #[schemars(range(min = 2, max = 10_000))]
    pub count: Option<u32>,
    /// At how many azimuths around a bearing, from +X on, deformation and contact angle are
    /// evaluated, 3 to 3600. Default: where its balls are.
    #[schemars(range(min = 3, max = 3600))]
    pub positions: Option<u32>,
}
