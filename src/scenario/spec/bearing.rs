//! `[[bearing]]`.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::geometry::{GeometrySpec, Sources};
use super::material::{self, MaterialSpec};
use super::model::ContactChoice;
use crate::bearing::catalogue::{self, CATALOGUE, CatalogueEntry};
use crate::bearing::{Bearing, BearingError, Facing, MountedBearing, Preload};
use crate::physics::Material;
use crate::rotor::Freedoms;
use crate::scenario::Issue;
use crate::scenario::problems::Problems;
use crate::scenario::quantity::{Angle, Force, Length, Quantity};
use crate::scenario::walk::nearest;

/// A ball bearing and its place on the shaft.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(extend("x-at-most-one" = ["axial_offset", "preload"]))]
pub struct BearingSpec {
    /// Designation of a bearing that `jeffcott catalogue` lists, for instance "7205C". Without
    /// it `[bearing.geometry]` must be complete.
    #[schemars(extend("examples" = designations()))]
    pub catalogue: Option<String>,
    /// Position along the shaft, from the centre of mass towards +Z. Default: "0 m".
    #[serde(default)]
    #[schemars(extend("examples" = ["-30 mm"]))]
    pub position: Quantity<Length>,
    /// Which way along Z the shaft must move to load the bearing. Default: "+z".
    #[serde(default)]
    pub facing: FacingChoice,
    /// Azimuth of one ball at the start, from +X towards +Y. Default: "0 rad".
    #[serde(default)]
    #[schemars(extend("examples" = ["-90 deg"]))]
    pub first_ball: Quantity<Angle>,
    /// Axial preset: how far the inner ring is moved the way its facing loads it, for instance
    /// "20 um". Default: "0 m".
    #[schemars(extend("examples" = ["20 um"], "x-minimum" = -0.1, "x-maximum" = 0.1))]
    pub axial_offset: Option<Quantity<Length>>,
    /// Axial preset by the axial force that the bearing carries when the shaft is not
    /// displaced, for instance "200 N"; instead of axial_offset.
    #[schemars(extend("examples" = ["200 N"], "x-minimum" = 0.0))]
    pub preload: Option<Quantity<Force>>,
    /// Force law of this bearing. Default: that of `[model]`.
    pub contact: Option<ContactChoice>,
    /// Internal dimensions; with a catalogue bearing, those that differ.
    pub geometry: Option<GeometrySpec>,
    /// Material of the rings, and of the balls unless they differ. Default: bearing steel.
    pub material: Option<MaterialSpec>,
    /// Material of the balls where it differs from that of the rings.
    pub ball_material: Option<MaterialSpec>,
}

/// Orientation of a bearing.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize, JsonSchema)]
pub enum FacingChoice {
    /// Moving the shaft along +Z loads the bearing.
    #[default]
    #[serde(rename = "+z")]
    PlusZ,
    /// Moving the shaft along −Z loads the bearing.
    #[serde(rename = "-z")]
    MinusZ,
}

fn designations() -> Vec<&'static str> {
    CATALOGUE.iter().map(|entry| entry.designation).collect()
}

impl BearingSpec {
    /// The mounted bearing, as far as nothing contradicts it.
    pub fn build(
        &self,
        index: usize,
        contact: ContactChoice,
        freedoms: Freedoms,
        problems: &mut Problems<'_>,
    ) -> Option<MountedBearing> {
        let path = format!("bearing[{index}]");
        let entry = self.entry(&path, problems)?;
        let spec = self.geometry.clone().unwrap_or_default();
        let sources = Sources {
            spec: &spec,
            entry,
            path: format!("{path}.geometry"),
        };
        let ring_material = material::build(self.material.as_ref(), Material::BEARING_STEEL);
        let bearing = Bearing {
            geometry: sources.build(freedoms, problems)?,
            ring_material,
            ball_material: material::build(self.ball_material.as_ref(), ring_material),
            contact_stiffness: spec.contact_stiffness.as_ref().map(Quantity::si),
            dynamic_rating: entry.map(|entry| entry.dynamic_rating),
            roughness: None,
            shoulder_angle: None,
        };
        check_contact(&bearing, &sources, problems);
        Some(MountedBearing {
            bearing,
            law: self.contact.unwrap_or(contact).into(),
            oil: None,
            position: self.position.si(),
            facing: match self.facing {
                FacingChoice::PlusZ => Facing::PlusZ,
                FacingChoice::MinusZ => Facing::MinusZ,
            },
            preload: match (&self.preload, &self.axial_offset) {
                (Some(force), _) => Preload::Force(force.si()),
                (None, Some(offset)) => Preload::AxialOffset(offset.si()),
                (None, None) => Preload::AxialOffset(0.0),
            },
            first_ball: self.first_ball.si(),
        })
    }

    /// The catalogue entry, `Some(None)` where the geometry stands alone, `None` where neither
    /// tells what the bearing is.
    fn entry(
        &self,
        path: &str,
        problems: &mut Problems<'_>,
    ) -> Option<Option<&'static CatalogueEntry>> {
        let key = format!("{path}.catalogue");
        let Some(designation) = &self.catalogue else {
            if self.geometry.is_none() {
                let message = format!("`{path}` needs `catalogue` or a table `[bearing.geometry]`");
                let issue = Issue::new(key, message).help("for instance: catalogue = \"7205C\"");
                problems.refuse(issue, &[format!("{path}.geometry")]);
                return None;
            }
            return Some(None);
        };
        let entry = catalogue::find(designation);
        if entry.is_none() {
            let known = designations();
            let help = match nearest(designation, known.iter().copied()) {
                Some(near) => format!("did you mean \"{near}\"? It has {}", known.join(", ")),
                None => format!("it has {}", known.join(", ")),
            };
            let message = format!("the catalogue has no bearing \"{designation}\"");
            problems.refuse(Issue::new(key, message).help(help), &[]);
        }
        entry.map(Some)
    }
}

/// Refuses dimensions whose balls and races do not form a Hertz contact.
fn check_contact(bearing: &Bearing, sources: &Sources<'_>, problems: &mut Problems<'_>) {
    if let Err(error) = bearing.load_deflection_constant() {
        let key = match error {
            BearingError::Contact { race: "inner", .. } => "groove_factor_inner",
            _ => "groove_factor_outer",
        };
        problems.refuse(Issue::new(sources.key(key), error.to_string()), &[]);
    }
}
