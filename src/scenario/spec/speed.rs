//! `[speed]`.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::scenario::quantity::{AngularSpeed, Quantity};

/// How fast the shaft turns about +Z.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct SpeedSpec {
    /// Constant speed from the start on, for instance "500 rad/s" or "3000 rpm"; zero or
    /// positive.
    #[schemars(extend("x-minimum" = 0.0))]
    pub constant: Quantity<AngularSpeed>,
}
