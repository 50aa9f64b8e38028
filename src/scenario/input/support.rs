//! The housing of a bearing or an element, `[bearing.housing]`.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::components::Axes;
use crate::bearing::{Housing, Resonator};
use crate::rotor::Freedoms;
use crate::scenario::Issue;
use crate::scenario::quantity::{Damping, Mass, Quantity, Stiffness};

/// The housing that a bearing is mounted in: a mass on springs and dampers to the ground, where sensors sit. It moves along x and
/// y, and along z where the shaft does; its displacement counts from where its own weight has put it. Base accelerations
/// act on it.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct HousingInput {
    /// Mass, for instance "3 kg".
    #[schemars(extend("examples" = ["3 kg"], "x-minimum" = 1e-6))]
    pub mass: Quantity<Mass>,
    /// Stiffness to the ground along each axis, for instance { x = "200 N/um", y = "300 N/um", z = "100 N/um" }.
    #[schemars(extend("examples" = [{ "x": "200 N/um", "y": "300 N/um" }]))]
    pub stiffness: Axes<Stiffness>,
    /// Damping to the ground along each axis, for instance { x = "500 N s/m", y = "500 N s/m" }. Default: none.
    pub damping: Option<Axes<Damping>>,
    /// What vibrates on it: a sensor with its mount, whose resonance rings at every impact. Its motion has columns of its
    /// own, `resonator1_x_acceleration` …
    pub resonator: Option<ResonatorInput>,
}

/// A mass on a spring and a damper on the housing, alike along x, y and z.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ResonatorInput {
    /// Mass, for instance "0.1 kg".
    #[schemars(extend("examples" = ["0.1 kg"], "x-minimum" = 1e-6))]
    pub mass: Quantity<Mass>,
    /// Stiffness to the housing, for instance "1e8 N/m".
    #[schemars(extend("examples" = ["1e8 N/m"], "x-minimum" = 1.0))]
    pub stiffness: Quantity<Stiffness>,
    /// Damping to the housing, for instance "500 N s/m". Default: none.
    #[schemars(extend("x-minimum" = 0.0))]
    pub damping: Option<Quantity<Damping>>,
}

impl HousingInput {
    /// The housing, unless it is free along an axis that it moves along.
    pub fn build(&self, freedoms: Freedoms) -> Result<Housing, Issue> {
        let stiffness = self.stiffness.values();
        let free = stiffness[..freedoms.lengths()]
            .iter()
            .position(|value| *value <= 0.0);
        if let Some(axis) = free {
            let axis = ["x", "y", "z"][axis];
            let message =
                format!("the housing moves along {axis} and nothing holds it to the ground");
            let help = format!("give stiffness.{axis}, for instance \"200 N/um\"");
            return Err(Issue::new(".stiffness", message).help(help));
        }
        Ok(Housing {
            mass: self.mass.si(),
            stiffness,
            damping: self.damping.as_ref().map_or([0.0; 3], Axes::values),
            resonator: self.resonator.as_ref().map(|own| Resonator {
                mass: own.mass.si(),
                stiffness: own.stiffness.si(),
                damping: own.damping.as_ref().map_or(0.0, Quantity::si),
            }),
        })
    }
}
