//! Sets of two bearings.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::bearing::BearingInput;
use crate::bearing::Facing;
use crate::scenario::Issue;
use crate::scenario::problems::Problems;

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

impl BearingInput {
    /// Position in m and orientation of the bearing, or of both of a set.
    pub(super) fn places(&self, problems: &mut Problems<'_>) -> Option<Vec<(f64, Facing)>> {
        let centre = self.position.si();
        let facing = self.facing.unwrap_or_default();
        let places = match (self.arrangement, &self.spacing) {
            (None, None) => Ok(vec![(centre, facing)]),
            (None, Some(_)) => {
                let message = "`spacing` needs an `arrangement`: one bearing has none";
                Err(Issue::new(".spacing", message)
                    .help("for instance: arrangement = \"back-to-back\""))
            }
            (Some(_), None) => {
                let issue = Issue::new(".spacing", "a set of bearings needs a `spacing`");
                Err(issue.help("for instance: spacing = \"15 mm\""))
            }
            (Some(arrangement), Some(spacing)) => {
                if self.facing.is_some() && arrangement != Arrangement::Tandem {
                    let message = "`facing` is for \"tandem\": the two bearings of this set face \
                                   each other or away";
                    let issue = Issue::new(".facing", message).help(
                        "remove it: \"back-to-back\" faces +z at its lower end and -z at its upper end, \
                         \"face-to-face\" the other way round; for anything else write two `[[bearing]]` tables",
                    );
                    problems.refuse(issue.against(".arrangement"));
                }
                Ok(arrangement.places(centre, spacing.si(), facing).to_vec())
            }
        };
        problems.take(places.map_err(|issue| issue.against(".arrangement")))
    }
}
