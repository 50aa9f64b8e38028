//! `[model]`.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::bearing::ContactLaw;
use crate::physics::RaceControl;
use crate::rotor::CageMotion;

/// Which physics to simulate.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
pub struct ModelInput {
    /// Force law of the bearings. Default: "hertz".
    pub contact: ContactChoice,
    /// With contact = "auto": largest difference of force and stiffness from the most exact law, at the
    /// operating points of the scene, relative, 1e-9 to 1. Default: 1e-3.
    #[schemars(range(min = 1e-9, max = 1))]
    pub model_error: Option<f64>,
    /// Whether oil films part balls and races; the bearings then need `[bearing.oil]`.
    /// Default: false.
    pub film: bool,
    /// Which race the balls roll on without spinning, with contact = "jones". Default: "outer".
    pub race_control: Option<RaceControl>,
    /// Whether costly ball laws (all but "hertz" without film) are compiled into tables before the
    /// motion starts: many times as fast at constant speed, with an error below 1e-9 of the largest
    /// static ball load, which the summary states. Where a ball leaves the table, and where the speed
    /// varies, the law itself is used. Default: false.
    pub table: bool,
    /// How the balls go round. Default: "rolling".
    pub cage: CageMotion,
}

/// Force law of a bearing.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
#[non_exhaustive]
pub enum ContactChoice {
    /// The stiffness matrix at the static equilibrium, frozen.
    Linear,
    /// Hertz contact of each ball with both races; the inertia of the balls is neglected.
    #[default]
    Hertz,
    /// Jones's ball equilibrium: as "hertz", with the centrifugal force and the gyroscopic moment
    /// of every ball.
    Jones,
    /// The cheapest of all these, with oil films where `[bearing.oil]` is given, whose force and stiffness
    /// differ from the most exact one by no more than `model_error` at the operating points of the scene.
    Auto,
}

impl ContactChoice {
    /// The force law; the race control plays a part in Jones's only.
    pub fn law(self, control: Option<RaceControl>) -> ContactLaw {
        match self {
            Self::Linear => ContactLaw::Linear,
            Self::Hertz => ContactLaw::Hertz,
            // what is to be chosen starts at the top
            Self::Jones | Self::Auto => ContactLaw::Jones(control.unwrap_or_default()),
        }
    }
}
