//! `[speed.drive]`.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::rotor::Drive;
use crate::scenario::quantity::{AngularSpeed, Moment, Quantity, si};

/// A motor that turns the shaft against a load and the friction of the bearings. `shaft.inertia_polar`
/// is that of everything that turns; `[shaft.torsion]` adds the twist under the friction moment.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct DriveInput {
    /// Speed at the start. Default: "0 rad/s".
    #[serde(default)]
    #[schemars(extend("examples" = ["0 rpm"], "x-minimum" = 0.0))]
    pub start: Quantity<AngularSpeed>,
    /// Moment of the motor at rest, for instance "5 N m".
    #[schemars(extend("examples" = ["5 N m"], "x-minimum" = 0.0))]
    pub torque: Quantity<Moment>,
    /// Speed up to which the moment falls linearly to zero, for instance "3000 rpm". Without it the
    /// moment is constant.
    #[schemars(extend("examples" = ["3000 rpm"], "x-above" = 0.0))]
    pub no_load_speed: Option<Quantity<AngularSpeed>>,
    /// Moment of the driven machine against the rotation. Default: "0 N m".
    #[serde(default)]
    #[schemars(extend("examples" = ["2 N m"], "x-minimum" = 0.0))]
    pub load_torque: Quantity<Moment>,
    /// Whether the friction moment of the bearings (Palmgren) resists. Default: true.
    #[serde(default = "yes")]
    pub friction: bool,
}

fn yes() -> bool {
    true
}

impl DriveInput {
    /// The drive of a shaft that a friction moment twists by `compliance` in rad/(N m).
    pub fn build(&self, compliance: f64) -> Drive {
        Drive {
            torque: self.torque.si(),
            no_load_speed: si(&self.no_load_speed),
            load_torque: self.load_torque.si(),
            friction: self.friction,
            compliance,
        }
    }
}
