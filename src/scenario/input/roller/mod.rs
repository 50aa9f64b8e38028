//! `[bearing.roller]`.

mod dimensions;
mod profile;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::bearing::BearingInput;
use super::geometry::millimetres;
use super::identity::Printed;
use super::settings::{ContactChoice, ModelInput};
use crate::bearing::{Bearing, Geometry, GeometryError, RollerKind, RollerLine, Rollers};
use crate::physics::Material;
use crate::scenario::Issue;
use crate::scenario::problems::Problems;
use crate::scenario::quantity::{Angle, Length, Quantity};
use profile::{DropInput, ProfileInput};

/// Steel for which ISO/TS 16281 gives the stiffness of rollers.
const ROLLER_STEEL: Material = Material {
    youngs_modulus: 206e9,
    ..Material::BEARING_STEEL
};

/// Rollers in place of balls, with their internal dimensions. With a roller bearing of the catalogue or ratings with `kind`,
/// those that differ; without, kind, rollers, diameter, length and pitch_diameter are needed.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct RollerInput {
    /// "cylindrical" or "needle", which hold nothing along z; "tapered"; "spherical", with two rows.
    pub kind: Option<RollerKind>,
    /// Number of rollers of a row, 3 to 200.
    #[schemars(range(min = 3, max = 200))]
    pub rollers: Option<u32>,
    /// Diameter of a roller in its middle, for instance "7.5 mm".
    #[schemars(extend("examples" = ["7.5 mm"], "x-minimum" = 1e-5))]
    pub diameter: Option<Quantity<Length>>,
    /// Effective length of a roller, for instance "8 mm".
    #[schemars(extend("examples" = ["8 mm"], "x-minimum" = 1e-5))]
    pub length: Option<Quantity<Length>>,
    /// Diameter of the circle of the middles of the rollers, for instance "46 mm".
    #[schemars(extend("examples" = ["46 mm"], "x-minimum" = 1e-5))]
    pub pitch_diameter: Option<Quantity<Length>>,
    /// Contact angle with the outer race, for instance "14 deg", of tapered and spherical rollers; cylindrical ones have
    /// none.
    #[schemars(extend("examples" = ["14 deg"], "x-minimum" = 0.0, "x-maximum" = Geometry::LARGEST_CONTACT_ANGLE))]
    pub contact_angle: Option<Quantity<Angle>>,
    /// Diametral clearance, for instance "20 um"; negative where the rollers are squeezed without load. Default: "0 um" of
    /// tapered rollers, of others the middle of `clearance_class` for the `bore`.
    #[schemars(extend("examples" = ["20 um"]))]
    pub diametral_clearance: Option<Quantity<Length>>,
    /// Profile of a roller: "logarithmic", that of ISO/TS 16281, or "flat". Default: "logarithmic", but of spherical rollers
    /// that of their radii.
    pub profile: Option<ProfileInput>,
    /// Drops of a roller, at rising distances from its middle, instead of `profile`: straight lines in between.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub drop: Vec<DropInput>,
    /// Radius of a spherical roller along its length, for instance "33.2 mm".
    #[schemars(extend("examples" = ["33.2 mm"], "x-above" = 0.0))]
    pub roller_radius: Option<Quantity<Length>>,
    /// Radius of the races of spherical rollers along the rollers, for instance "34 mm".
    #[schemars(extend("examples" = ["34 mm"], "x-above" = 0.0))]
    pub race_radius: Option<Quantity<Length>>,
    /// Number of slices that a roller is cut into, 4 to 500; ISO/TS 16281 asks for 30 at least. Default: 30.
    #[schemars(range(min = Rollers::FEWEST_LAMINAE, max = Rollers::MOST_LAMINAE))]
    pub laminae: Option<u32>,
    /// Width of the bearing; the rollers are checked against it.
    #[schemars(extend("examples" = ["16 mm"], "x-above" = 0.0))]
    pub width: Option<Quantity<Length>>,
    /// Bore of the bearing; classes of clearance and fits need it.
    #[schemars(extend("examples" = ["30 mm"], "x-above" = 0.0))]
    pub bore: Option<Quantity<Length>>,
    /// Outside diameter of the bearing; fits need it.
    #[schemars(extend("examples" = ["62 mm"], "x-above" = 0.0))]
    pub outside_diameter: Option<Quantity<Length>>,
}

impl RollerInput {
    /// The bearing of these rollers, as far as nothing in its table contradicts it.
    pub fn bearing(
        &self,
        own: &BearingInput,
        printed: Option<&Printed<RollerLine>>,
        model: &ModelInput,
        problems: &mut Problems<'_>,
    ) -> Option<Bearing> {
        // what the others must be depends on them
        let keys = [".roller", ".catalogue", ".ratings"].map(|key| problems.path(key));
        if keys.iter().any(|key| problems.has_fault(key)) {
            return None;
        }
        if self.kind.is_none() && printed.is_none() && own.catalogue.is_some() {
            let issue = Issue::new(
                ".catalogue",
                "the catalogue has no roller bearing of this name",
            );
            let help = "remove `[bearing.roller]`, or give `kind` and all dimensions there instead of `catalogue`";
            problems.refuse(issue.help(help).against(".roller"));
            return None;
        }
        let known = self.known(printed, problems)?;
        check_keys(known.kind, own, printed, problems);
        let class = own.clearance_class.or(printed.and_then(|own| own.class));
        let (clearance, clearance_class) = self.clearance(&known, class, problems)?;
        let geometry = self.geometry(&known, clearance, problems)?;
        let changed = geometry.with_clearance_change(own.clearance_change.si());
        let wrong = |error: GeometryError| Issue::new(".clearance_change", error.to_string());
        let geometry = problems.take(changed.map_err(wrong))?;
        let notes = known.estimate.iter().flat_map(|estimate| &estimate.notes);
        let notes: Vec<_> = notes.map(String::as_str).collect();
        let has_profile = self.profile.is_some() || !self.drop.is_empty();
        let has_radii = self.roller_radius.is_some() || self.race_radius.is_some();
        let spherical = known.kind == RollerKind::Spherical;
        for (given, message) in [
            (
                spherical && !has_profile && !has_radii,
                "the barrels are taken to have 0.98 of the radius of their outer race: give `roller_radius` and \
                 `race_radius` in [bearing.roller] where you know them"
                    .to_owned(),
            ),
            (
                own.contact(model) == ContactChoice::Jones,
                "contact = \"jones\" holds for balls; rollers have no inertia here".to_owned(),
            ),
            (
                own.film.unwrap_or(model.film),
                "film = true holds for balls; the films of rollers are reported, and part nothing here"
                    .to_owned(),
            ),
            (
                !notes.is_empty(),
                format!(
                    "{} rollers of {} × {} are estimated from the ratings: {}",
                    known.rollers,
                    millimetres(known.diameter),
                    millimetres(known.length),
                    notes.join("; ")
                ),
            ),
        ] {
            if given {
                problems.warn(format!("`{}`: {message}", problems.path(".")));
            }
        }
        let rating = printed.map(|printed| printed.line.dynamic_rating);
        Some(Bearing {
            ring_material: ROLLER_STEEL,
            clearance_class,
            boundary: known.bore.zip(known.outside_diameter).map(Into::into),
            dynamic_rating: Some(rating.unwrap_or_else(|| geometry.dynamic_rating())),
            estimated: known.estimate.is_some_and(|estimate| estimate.estimated),
            ..Bearing::of_steel(geometry)
        })
    }
}

/// Refuses what belongs to balls, and what says twice what the bearing is.
fn check_keys(
    kind: RollerKind,
    own: &BearingInput,
    printed: Option<&Printed<RollerLine>>,
    problems: &mut Problems<'_>,
) {
    let printed = printed.map_or("", |printed| printed.key);
    let twice = [".catalogue", ".ratings"].into_iter();
    let twice: Vec<_> = twice.filter(|key| *key != printed).collect();
    let of_balls = "this belongs to balls";
    let mut refuse = |keys: &[&str], message: &str| {
        for key in keys {
            if problems.node(&problems.path(key)).is_some() {
                let issue = Issue::new(*key, message).help("remove it");
                problems.refuse(issue.against(".roller"));
            }
        }
    };
    refuse(
        &twice,
        "`[bearing.roller]` already says what the bearing is",
    );
    refuse(&[".geometry", ".shoulder_angle", ".race_control"], of_balls);
    if own.contact == Some(ContactChoice::Jones) {
        refuse(&[".contact"], of_balls);
    }
    if kind != RollerKind::Tapered {
        let preloads = [".axial_offset", ".preload", ".spring_preload"];
        refuse(
            &preloads,
            "only tapered rollers are preloaded along the axis",
        );
    }
}
