//! `[bearing.roller]`.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::bearing::BearingInput;
use super::geometry::millimetres;
use super::settings::{ContactChoice, ModelInput};
use crate::bearing::{
    Bearing, ClearanceClass, Geometry, GeometryError, Profile, ProfilePoints, RollerEstimate,
    RollerKind, RollerLine, Rollers,
};
use crate::physics::Material;
use crate::scenario::Issue;
use crate::scenario::problems::Problems;
use crate::scenario::quantity::{Angle, Length, Quantity, si};

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

/// Profile of a roller by its name.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum ProfileInput {
    /// That of ISO/TS 16281 for the kind and the proportions of the rollers.
    Logarithmic,
    /// None.
    Flat,
}

/// How much a roller is thinner at a distance from its middle.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct DropInput {
    /// Distance from the middle, for instance "3.5 mm".
    #[schemars(extend("examples" = ["3.5 mm"], "x-minimum" = 0.0))]
    pub at: Quantity<Length>,
    /// Drop of roller and race together, for instance "4 um".
    #[schemars(extend("examples" = ["4 um"], "x-minimum" = 0.0))]
    pub drop: Quantity<Length>,
}

/// What a catalogue prints of a roller bearing.
pub struct PrintedRollers {
    /// The line.
    pub line: RollerLine,
    /// Its designation, or what stands for it.
    pub name: String,
    /// The key that gives it, from the bearing.
    pub key: &'static str,
    /// Class of the clearance that its suffixes name.
    pub class: Option<ClearanceClass>,
}

/// Rollers as their table, and else the catalogue, has them; lengths in m.
struct Known {
    kind: RollerKind,
    rollers: usize,
    diameter: f64,
    length: f64,
    pitch_diameter: f64,
    contact_angle: f64,
    bore: Option<f64>,
    outside_diameter: Option<f64>,
    width: Option<f64>,
    estimate: Option<RollerEstimate>,
}

impl RollerInput {
    /// The bearing of these rollers, as far as nothing in its table contradicts it.
    pub fn bearing(
        &self,
        own: &BearingInput,
        printed: Option<&PrintedRollers>,
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
                "film = true holds for balls; the films of rollers are told, and part nothing here"
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
        let by_rollers = || {
            let rollers = geometry.rollers();
            rollers.map(|rollers| rollers.dynamic_rating(&geometry))
        };
        let rating = printed.map(|printed| printed.line.dynamic_rating);
        Some(Bearing {
            ring_material: ROLLER_STEEL,
            clearance_class,
            boundary: known.bore.zip(known.outside_diameter).map(Into::into),
            dynamic_rating: rating.or_else(by_rollers),
            estimated: known.estimate.is_some_and(|estimate| estimate.estimated),
            ..Bearing::of_steel(geometry)
        })
    }

    /// The dimensions, where all that are needed are given or follow from what is printed.
    fn known(
        &self,
        printed: Option<&PrintedRollers>,
        problems: &mut Problems<'_>,
    ) -> Option<Known> {
        let line = printed.map(|printed| printed.line);
        if let (Some(given), Some(line)) = (self.kind, line)
            && given != line.kind
        {
            let message = format!("these are {} rollers", line.kind.name());
            let issue = Issue::new(".roller.kind", message).help("remove it");
            problems.refuse(issue.against(".ratings.kind").against(".catalogue"));
            return None;
        }
        let rollers = self.rollers.map(|rollers| rollers as usize);
        let [diameter, length, pitch] =
            [&self.diameter, &self.length, &self.pitch_diameter].map(si);
        let estimate = match printed {
            Some(printed) => {
                let line = RollerLine {
                    rollers: rollers.or(printed.line.rollers),
                    diameter: diameter.or(printed.line.diameter),
                    length: length.or(printed.line.length),
                    pitch_diameter: pitch.or(printed.line.pitch_diameter),
                    ..printed.line
                };
                let wrong = |error| Issue::new(printed.key, format!("{}: {error}", printed.name));
                Some(problems.take(line.estimate().map_err(wrong))?)
            }
            None => None,
        };
        let found = estimate.as_ref().map(|estimate| estimate.best);
        let mut need = |key: &str, value: Option<f64>| {
            let message = format!(
                "`{}` needs `{key}` where no catalogue bearing gives it",
                problems.path(".roller")
            );
            problems.take(value.ok_or_else(|| Issue::new(format!(".roller.{key}"), message)))
        };
        let pitch = pitch.or(estimate.as_ref().map(|estimate| estimate.pitch_diameter));
        let dimensions = [
            need("diameter", diameter.or(found.map(|found| found.diameter))),
            need("length", length.or(found.map(|found| found.length))),
            need("pitch_diameter", pitch),
        ];
        let count = rollers.or(found.map(|found| found.rollers));
        let count = need("rollers", count.map(|count| count as f64));
        let kind = self.kind.or(line.map(|line| line.kind));
        // a kind that is missing is the last to be told
        need("kind", kind.map(|_| 0.0))?;
        let [Some(diameter), Some(length), Some(pitch_diameter)] = dimensions else {
            return None;
        };
        let boundary = line.map(|line| line.boundary);
        let angle = line.map_or(0.0, |line| line.contact_angle);
        Some(Known {
            kind: kind?,
            rollers: count? as usize,
            diameter,
            length,
            pitch_diameter,
            contact_angle: si(&self.contact_angle).unwrap_or(angle),
            bore: si(&self.bore).or(boundary.map(|[bore, ..]| bore)),
            outside_diameter: si(&self.outside_diameter).or(boundary.map(|own| own[1])),
            width: si(&self.width).or(boundary.map(|own| own[2])),
            estimate,
        })
    }

    fn geometry(
        &self,
        known: &Known,
        clearance: f64,
        problems: &mut Problems<'_>,
    ) -> Option<Geometry> {
        let profile = self.profile(known, problems);
        self.check_room(known, problems);
        let laminae = self
            .laminae
            .map_or(Rollers::STANDARD_LAMINAE, |count| count as usize);
        if laminae < Rollers::STANDARD_LAMINAE {
            problems.warn(format!(
                "`{}`: {laminae} slices of a roller are fewer than the {} of ISO/TS 16281: edges and tilts are coarse",
                problems.path(".roller.laminae"),
                Rollers::STANDARD_LAMINAE
            ));
        }
        let rollers = Rollers {
            kind: known.kind,
            length: known.length,
            profile: profile?,
            laminae,
            clearance,
        };
        let built = Geometry::of_rollers(
            known.rollers,
            known.diameter,
            known.pitch_diameter,
            known.contact_angle,
            rollers,
        );
        problems.take(built.map_err(|error| wrong(known.kind, &error)))
    }

    /// The profile, where radii, drops and a name do not contradict each other.
    fn profile(&self, known: &Known, problems: &mut Problems<'_>) -> Option<Profile> {
        let (roller, race) = (si(&self.roller_radius), si(&self.race_radius));
        let spherical = known.kind == RollerKind::Spherical;
        let radii = [
            (".roller.roller_radius", roller),
            (".roller.race_radius", race),
        ];
        for (key, _) in radii
            .iter()
            .filter(|(_, radius)| radius.is_some() && !spherical)
        {
            let issue = Issue::new(
                *key,
                "only spherical rollers have a radius along their length",
            );
            problems.refuse(issue.help("remove it").against(".roller.kind"));
        }
        let named = self.profile.map(|profile| match profile {
            ProfileInput::Logarithmic => Profile::Logarithmic,
            ProfileInput::Flat => Profile::Flat,
        });
        let is_round = roller.is_some() || race.is_some();
        let ways = [named.is_some(), !self.drop.is_empty(), is_round];
        if ways.into_iter().filter(|given| *given).count() > 1 {
            let message = "the profile of the rollers is given in two ways";
            let issue = Issue::new(".roller", message);
            problems.refuse(issue.help("keep one of `profile`, `drop` and the two radii"));
            return None;
        }
        if !self.drop.is_empty() {
            let pairs: Vec<_> = self
                .drop
                .iter()
                .map(|own| [own.at.si(), own.drop.si()])
                .collect();
            let message = format!(
                "the distances of a profile must rise, with at most {} points",
                ProfilePoints::MOST
            );
            let points = ProfilePoints::new(&pairs).map(Profile::Points);
            return problems.take(points.ok_or_else(|| Issue::new(".roller.drop", message)));
        }
        if named.is_some() || !spherical {
            return Some(named.unwrap_or(Profile::Logarithmic));
        }
        if let Some(estimate) = known.estimate.as_ref().filter(|_| !is_round) {
            return Some(estimate.profile(known.contact_angle));
        }
        let half = 0.5 * known.length;
        problems.take(match (roller, race) {
            (Some(roller_radius), Some(race_radius))
                if roller_radius > half && race_radius >= roller_radius =>
            {
                Ok(Profile::Barrel {
                    roller_radius,
                    race_radius,
                })
            }
            (Some(_), Some(_)) => {
                let message = "a spherical roller is a barrel in a wider race: half its length is less than its radius, and that \
                               no more than the radius of the race";
                Err(Issue::new(".roller.roller_radius", message)
                    .against_all([".roller.race_radius", ".roller.length"]))
            }
            _ => {
                let message = "spherical rollers need `roller_radius` and `race_radius`";
                let issue = Issue::new(".roller.roller_radius", message);
                Err(issue
                    .help("for instance roller_radius = \"33.2 mm\" and race_radius = \"34 mm\", or profile = \"flat\"")
                    .against(".roller.race_radius"))
            }
        })
    }

    /// The clearance, m, and the class whose middle it is; of tapered rollers none where it is not given.
    fn clearance(
        &self,
        known: &Known,
        class: Option<ClearanceClass>,
        problems: &mut Problems<'_>,
    ) -> Option<(f64, Option<ClearanceClass>)> {
        let key = ".roller.diametral_clearance";
        let (given, kind) = (si(&self.diametral_clearance), known.kind);
        let surplus = match (given, kind) {
            (Some(_), _) => "the rollers already have a clearance",
            (None, RollerKind::Tapered) => "tapered rollers have no class of clearance",
            _ => "",
        };
        if class.is_some() && !surplus.is_empty() {
            let issue = Issue::new(".clearance_class", surplus).help("remove it");
            problems.refuse(issue.against_all([key, ".roller.kind"]));
        }
        let assumed = (kind == RollerKind::Tapered).then_some(0.0);
        if let Some(clearance) = given.or(assumed) {
            return Some((clearance, None));
        }
        let taken = class.unwrap_or_default();
        let name = kind.name();
        problems.take(match known.bore {
            None => {
                let message = format!("{name} rollers need `diametral_clearance`");
                Err(Issue::new(key, message).help(
                    "for instance: diametral_clearance = \"20 um\"; or give `bore`, for that of a `clearance_class`",
                ))
            }
            Some(bore) => taken
                .roller_middle(kind, bore)
                .map(|clearance| (clearance, Some(taken)))
                .ok_or_else(|| {
                    let message = format!(
                        "class {} has no clearance for this bore of {name} rollers (ISO 5753-1, up to 250 mm)",
                        taken.name()
                    );
                    Issue::new(key, message)
                        .help("give diametral_clearance = \"200 um\", for instance")
                        .against(".roller.bore")
                }),
        })
    }

    /// Refuses rollers that are longer than the bearing is wide, or that no bearing of this pitch circle has.
    fn check_room(&self, known: &Known, problems: &mut Problems<'_>) {
        let takes = known.kind.rows() as f64 * known.length * known.contact_angle.cos();
        let (room, key, what) = match known.width {
            Some(width) => (width, ".roller.width", "the bearing is wide"),
            None => (
                known.pitch_diameter,
                ".roller.pitch_diameter",
                "their pitch circle",
            ),
        };
        if takes > room {
            let message = format!(
                "the rollers take {} along the axis, more than {what}: {}",
                millimetres(takes),
                millimetres(room)
            );
            problems.refuse(Issue::new(".roller.length", message).against(key));
        }
    }
}

/// Refuses what belongs to balls, and what says twice what the bearing is.
fn check_keys(
    kind: RollerKind,
    own: &BearingInput,
    printed: Option<&PrintedRollers>,
    problems: &mut Problems<'_>,
) {
    let twice = "`[bearing.roller]` already says what the bearing is";
    let ball = "this belongs to balls";
    let one_way = "only tapered rollers are preloaded along the axis";
    let preloads = kind != RollerKind::Tapered;
    let named = own.catalogue.is_some() && printed.is_none_or(|own| own.key != ".catalogue");
    let rated = own.ratings.is_some() && printed.is_none_or(|own| own.key != ".ratings");
    for (key, given, message) in [
        (".catalogue", named, twice),
        (".ratings", rated, twice),
        (".geometry", own.geometry.is_some(), ball),
        (".shoulder_angle", own.shoulder_angle.is_some(), ball),
        (".race_control", own.race_control.is_some(), ball),
        (".contact", own.contact == Some(ContactChoice::Jones), ball),
        (
            ".axial_offset",
            preloads && own.axial_offset.is_some(),
            one_way,
        ),
        (".preload", preloads && own.preload.is_some(), one_way),
        (
            ".spring_preload",
            preloads && own.spring_preload.is_some(),
            one_way,
        ),
    ] {
        if given {
            let issue = Issue::new(key, message).help("remove it");
            problems.refuse(issue.against(".roller"));
        }
    }
}

/// The problem of dimensions that make no bearing.
fn wrong(kind: RollerKind, error: &GeometryError) -> Issue {
    let key = match error {
        GeometryError::RollerAngle { .. } => ".roller.contact_angle",
        GeometryError::RollerClearance { .. } => ".roller.diametral_clearance",
        GeometryError::Laminae { .. } => ".roller.laminae",
        _ => ".roller.rollers",
    };
    let message = match *error {
        GeometryError::Overlap {
            balls,
            ball_diameter,
            pitch_diameter,
            largest,
        } => format!(
            "{balls} rollers of {} overlap on a pitch circle of {}: at most {largest} fit",
            millimetres(ball_diameter),
            millimetres(pitch_diameter)
        ),
        GeometryError::RollerAngle { rule, .. } => {
            format!("the contact angle of {} rollers: {rule}", kind.name())
        }
        _ => error.to_string(),
    };
    Issue::new(key, message).against(".roller.kind")
}
