//! `[bearing.linear]`.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::components::Components;
use crate::rotor::LinearBearing;
use crate::scenario::quantity::{Damping, Stiffness, TiltDamping, TiltStiffness};

/// Springs and dampers to the ground in place of balls, for comparison with books and other programs. What is left out is
/// zero.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct LinearInput {
    /// Stiffness, for instance { x = "1e6 N/m", y = "1e6 N/m" }.
    #[schemars(extend("examples" = [{ "x": "1 N/um", "y": "1 N/um" }]))]
    pub stiffness: Components<Stiffness, TiltStiffness>,
    /// Damping, for instance { x = "100 N s/m", y = "100 N s/m" }. Default: none.
    pub damping: Option<Components<Damping, TiltDamping>>,
}

impl LinearInput {
    /// The bearing at a position in m.
    pub fn build(&self, position: f64) -> LinearBearing {
        let damping = self.damping.as_ref().map(Components::values);
        LinearBearing {
            position,
            stiffness: self.stiffness.values().map(Option::unwrap_or_default),
            damping: damping.unwrap_or_default().map(Option::unwrap_or_default),
        }
    }
}
