//! Sets of two bearings.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::bearing::Facing;

/// How the two bearings of a set face each other.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Arrangement {
    /// O arrangement: the contact lines diverge towards the shaft axis, stiff against tilting.
    BackToBack,
    /// X arrangement: the contact lines converge towards the shaft axis, yielding to tilting.
    FaceToFace,
    /// Both bearings face the same way and share the axial load.
    Tandem,
}

impl Arrangement {
    /// Position in m and orientation of both bearings, `spacing` in m apart about `centre`;
    /// `facing` is that of a tandem set.
    ///
    /// The contact line of a bearing that faces +z runs from ball to shaft axis towards −z: back
    /// to back the one at the −z end faces +z.
    pub fn places(self, centre: f64, spacing: f64, facing: Facing) -> [(f64, Facing); 2] {
        let [low, high] = match self {
            Self::BackToBack => [Facing::PlusZ, Facing::MinusZ],
            Self::FaceToFace => [Facing::MinusZ, Facing::PlusZ],
            Self::Tandem => [facing; 2],
        };
        [
            (centre - 0.5 * spacing, low),
            (centre + 0.5 * spacing, high),
        ]
    }
}
