//! `[model]`.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::bearing::ContactLaw;
use crate::rotor::CageMotion;

/// Which physics to simulate.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
pub struct ModelSpec {
    /// Force law of the bearings. Default: "hertz".
    pub contact: ContactChoice,
    /// How the balls go round. Default: "rolling".
    pub cage: CageChoice,
}

/// Force law of a bearing.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum ContactChoice {
    /// The stiffness matrix at the static equilibrium, frozen.
    Linear,
    /// Hertz contact of each ball with both races; the inertia of the balls is neglected.
    #[default]
    Hertz,
}

/// Motion of the balls around the bearing.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum CageChoice {
    /// The cage rolls at its nominal speed: the stiffness varies with the ball pass.
    #[default]
    Rolling,
    /// The cage stands: no ball-pass lines.
    Frozen,
}

impl From<ContactChoice> for ContactLaw {
    fn from(choice: ContactChoice) -> Self {
        match choice {
            ContactChoice::Linear => Self::Linear,
            ContactChoice::Hertz => Self::Hertz,
        }
    }
}

impl From<CageChoice> for CageMotion {
    fn from(choice: CageChoice) -> Self {
        match choice {
            CageChoice::Rolling => Self::Rolling,
            CageChoice::Frozen => Self::Frozen,
        }
    }
}
