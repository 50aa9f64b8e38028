//! `[[bearing]]` with its materials, its oil and its arrangement in sets.

use std::f64::consts::FRAC_PI_2;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::arrangement::Arrangement;
use super::ball_sizes::BallSizesInput;
use super::fit::FitInput;
use super::geometry::GeometryInput;
use super::identity::{Identity, PrintedBearing};
use super::imperfections::{CageJitterInput, DefectInput, WavinessInput};
use super::material::{MaterialInput, material};
use super::oil::OilInput;
use super::ratings::RatingsInput;
use super::roller::RollerInput;
use super::settings::{ContactChoice, ModelInput};
use super::support::HousingInput;
use crate::bearing::catalogue::{self, CATALOGUE, Catalogue, Found};
use crate::bearing::{
    Bearing, BearingError, ClearanceClass, ContactDamping, Facing, GeometryError, MountedBearing,
    Oil, Preload,
};
use crate::physics::{Race, RaceControl};
use crate::rotor::Freedoms;
use crate::scenario::Issue;
use crate::scenario::problems::Problems;
use crate::scenario::quantity::{Angle, AngularSpeed, Force, Length, Quantity, si};

/// A ball or roller bearing and its place on the shaft.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(extend("x-at-most-one" = ["axial_offset", "preload", "spring_preload"]))]
pub struct BearingInput {
    /// Designation of a bearing that `jeffcott catalogue` lists, for instance "7205C" or "6205-2RS/C3". Without
    /// it `[bearing.ratings]` or `[bearing.geometry]` is needed.
    #[schemars(extend("examples" = designations()))]
    pub catalogue: Option<String>,
    /// Position along the shaft, from the centre of mass towards +Z, or, of a shaft that bends, from its left end.
    /// Default: "0 m".
    #[serde(default)]
    #[schemars(extend("examples" = ["-30 mm"]))]
    pub position: Quantity<Length>,
    /// Rollers in place of balls: what their bearing is, or what differs from that of `catalogue` or `ratings`.
    pub roller: Option<RollerInput>,
    /// Makes a set of two bearings of this one, symmetric about the position and `spacing` apart:
    /// "back-to-back", "face-to-face" or "tandem".
    pub arrangement: Option<Arrangement>,
    /// Distance of the two bearings of a set, for instance "15 mm".
    #[schemars(extend("examples" = ["15 mm"], "x-above" = 0.0))]
    pub spacing: Option<Quantity<Length>>,
    /// Which way along Z the shaft must move to load the bearing, or both bearings of a tandem
    /// set; of a deep-groove bearing, the way its preload moves the inner ring. Default: "+z".
    pub facing: Option<Facing>,
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
    /// Axial preset by a soft spring that presses the floating outer ring with this force
    /// wherever the shaft is, for instance "200 N"; instead of axial_offset and preload.
    #[schemars(extend("examples" = ["200 N"], "x-above" = 0.0))]
    pub spring_preload: Option<Quantity<Force>>,
    /// Force law of this bearing. Default: that of `[model]`.
    pub contact: Option<ContactChoice>,
    /// Whether oil films part the surfaces of this bearing. Default: that of `[model]`.
    pub film: Option<bool>,
    /// Race control of this bearing. Default: that of `[model]`.
    pub race_control: Option<RaceControl>,
    /// Ring that turns at the speed of `[speed]`. "outer": the shaft is stationary, the outer ring turns in its place, and the load
    /// is stationary with the shaft; with contact "hertz" or "linear", and of all bearings alike. Default: "inner".
    #[serde(default, skip_serializing_if = "is_inner")]
    pub rotating_ring: Race,
    /// Class of the clearance of a deep-groove bearing of the catalogue, or of rollers with a `bore`, "C2", "CN", "C3", "C4" or
    /// "C5": the middle of its range for the bore (ISO 5753-1). Default: "CN", where no clearance is given.
    pub clearance_class: Option<ClearanceClass>,
    /// Change of the diametral clearance by fits and temperature, for instance "-5 um": negative
    /// tightens and makes the contact angle smaller. Default: "0 m".
    #[serde(default)]
    #[schemars(extend("examples" = ["-5 um"]))]
    pub clearance_change: Quantity<Length>,
    /// Composite root-mean-square roughness of ball and race, for instance "0.1 um"; the film
    /// ratio needs it.
    #[schemars(extend("examples" = ["0.1 um"], "x-above" = 0.0))]
    pub roughness: Option<Quantity<Length>>,
    /// Highest permissible speed by the catalogue, for instance "26000 rpm"; a higher one is warned of.
    /// Default, over the pitch diameter: 1e6 mm/min of balls, 7e5 of cylindrical rollers, 5e5 of needle, tapered and
    /// spherical ones.
    #[schemars(extend("examples" = ["26000 rpm"], "x-above" = 0.0))]
    pub limiting_speed: Option<Quantity<AngularSpeed>>,
    /// Angle from the radial plane at which the shoulders of the races end, for instance
    /// "35 deg"; contacts that reach it are warned of.
    #[schemars(extend("examples" = ["35 deg"], "x-above" = 0.0, "x-maximum" = FRAC_PI_2))]
    pub shoulder_angle: Option<Quantity<Angle>>,
    /// Basic dynamic load rating C, for instance "16.6 kN"; the life needs it. Default: that of
    /// the catalogue.
    #[schemars(extend("examples" = ["16.6 kN"], "x-above" = 0.0))]
    pub dynamic_rating: Option<Quantity<Force>>,
    /// Reliability of the modified life L_nm in per cent, 90 to 99.95. Default: 90.
    #[schemars(range(min = 90.0, max = 99.95))]
    pub reliability: Option<f64>,
    /// Fits and temperatures; clearance, contact angle and preload in operation follow from them.
    pub fit: Option<FitInput>,
    /// Oil in the bearing; without `film` it is known but parts nothing.
    pub oil: Option<OilInput>,
    /// Slots across its races and dents of its balls.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub defect: Vec<DefectInput>,
    /// Waves around its races and balls.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub waviness: Vec<WavinessInput>,
    /// Balls of unequal size.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub ball_sizes: Option<BallSizesInput>,
    /// Rollers of unequal size, those of a second row after the first.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub roller_sizes: Option<BallSizesInput>,
    /// How much slower the cage turns than it would roll, as a part: real cages slip by 1 or 2 %. Default: 0.
    #[serde(default, skip_serializing_if = "is_zero")]
    #[schemars(range(min = 0.0, max = 0.9))]
    pub cage_slip: f64,
    /// Angle that the cage gains or loses by chance with every ball pass. Default: it turns evenly.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub cage_jitter: Option<CageJitterInput>,
    /// The housing that it is mounted in. Default: it is mounted on the ground.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub housing: Option<HousingInput>,
    /// What a maker's catalogue prints of the bearing, instead of `catalogue`.
    pub ratings: Option<RatingsInput>,
    /// Internal dimensions; with a catalogue bearing or ratings, those that differ.
    pub geometry: Option<GeometryInput>,
    /// Material of the rings, and of the balls unless they differ. Default: bearing steel.
    pub material: Option<MaterialInput>,
    /// Material of the balls where it differs from that of the rings.
    pub ball_material: Option<MaterialInput>,
}

fn is_zero(value: &f64) -> bool {
    *value == 0.0
}

fn is_inner(ring: &Race) -> bool {
    *ring == Race::Inner
}

fn designations() -> Vec<&'static str> {
    let designations = CATALOGUE
        .balls
        .iter()
        .map(|entry| entry.designation.as_str());
    designations.collect()
}

impl BearingInput {
    /// Force law of the bearing, where `[model]` has the given one.
    pub fn contact(&self, model: &ModelInput) -> ContactChoice {
        self.contact.unwrap_or(model.contact)
    }

    /// The oil of the bearing, or of both of a set, whether its films are simulated or not.
    pub fn oils(&self) -> impl Iterator<Item = Option<Oil>> + use<> {
        let oil = self.oil.as_ref().map(OilInput::build);
        std::iter::repeat_n(oil, self.count())
    }

    /// Number of bearings: two of a set.
    pub fn count(&self) -> usize {
        1 + usize::from(self.arrangement.is_some())
    }

    /// The mounted bearing, or both of a set, as far as nothing contradicts it.
    pub fn build(
        &self,
        model: &ModelInput,
        freedoms: Freedoms,
        catalogue: &Catalogue,
        problems: &mut Problems<'_>,
    ) -> Option<Vec<MountedBearing>> {
        let mounted = self.build_one(model, freedoms, catalogue, problems);
        let places = self.places(problems);
        let mounted = mounted?;
        let geometry = &mounted.bearing.geometry;
        // of two rows only one has the spalls of the races
        let by_rows = geometry.rows() > 1 && !self.defect.is_empty();
        let is_alike = geometry.is_symmetric() && !by_rows;
        if self.facing.is_some() && is_alike && mounted.preload == Preload::AxialOffset(0.0) {
            problems.warn(format!(
                "`{}` says nothing here: {} without preload is alike in both directions",
                problems.path(".facing"),
                match mounted.bearing.geometry.rollers() {
                    Some(rollers) => format!("a {} roller bearing", rollers.kind.name()),
                    None => "a deep-groove bearing".to_owned(),
                }
            ));
        }
        let place = |(position, facing)| MountedBearing {
            position,
            facing,
            ..mounted.clone()
        };
        let places = places?.into_iter().map(place);
        let Some(input) = &self.fit else {
            return Some(places.collect());
        };
        let (fit, boundary) = input.build(&mounted.bearing, problems)?;
        let fitted = places.map(|mounted| {
            let fitted = mounted.with_fit(&fit, boundary);
            problems.take(fitted.map_err(|error| wrong_fit(&error, &mounted.bearing)))
        });
        let fitted: Vec<_> = fitted.collect();
        fitted.into_iter().collect()
    }

    /// The bearing at its nominal position.
    fn build_one(
        &self,
        model: &ModelInput,
        freedoms: Freedoms,
        catalogue: &Catalogue,
        problems: &mut Problems<'_>,
    ) -> Option<MountedBearing> {
        let of_rollers = |own: &RollerInput, printed, problems: &mut Problems<'_>| {
            own.bearing(self, printed, model, problems)
        };
        let printed = self.identity(catalogue).printed(catalogue, problems)?;
        if printed.as_ref().is_some_and(PrintedBearing::rubs) {
            self.warn_of_seals(problems);
        }
        let bearing = match (printed, &self.roller) {
            (Some(PrintedBearing::Rollers(printed)), own) => {
                of_rollers(&own.clone().unwrap_or_default(), Some(&printed), problems)?
            }
            (_, Some(own)) => of_rollers(own, None, problems)?,
            (Some(PrintedBearing::Balls(printed)), None) => {
                self.ball_bearing(freedoms, Some(printed), problems)?
            }
            (None, None) => self.ball_bearing(freedoms, None, problems)?,
        };
        let ring_material = material(self.material.as_ref(), bearing.ring_material);
        let bearing = Bearing {
            ring_material,
            ball_material: material(self.ball_material.as_ref(), ring_material),
            dynamic_rating: si(&self.dynamic_rating).or(bearing.dynamic_rating),
            roughness: si(&self.roughness),
            limiting_speed: si(&self.limiting_speed),
            shoulder_angle: si(&self.shoulder_angle),
            lubrication: self.oil.as_ref().map(OilInput::lubrication),
            rotating_ring: self.rotating_ring,
            reliability: self.reliability,
            ..bearing
        };
        if let Some(oil) = &self.oil {
            oil.check(problems);
        }
        if self.housing.is_some() {
            self.check_alone(".housing", problems);
        }
        let (law, oil) = match bearing.geometry.rollers() {
            Some(_) => (self.contact(model).without_inertia(), None),
            None => self.ball_law(&bearing, model, problems),
        };
        self.warn_of_idle_keys(&bearing, oil.is_some(), problems);
        Some(MountedBearing {
            law,
            oil,
            position: self.position.si(),
            facing: Facing::PlusZ,
            preload: self.preload(),
            contact_damping: ContactDamping::default(),
            first_ball: self.first_ball.si(),
            imperfections: self.imperfections(&bearing.geometry, model, problems)?,
            housing: problems.given("housing", &self.housing, |housing, problems| {
                problems.take(housing.build(freedoms))
            })?,
            bearing,
        })
    }

    /// Warns of keys that change nothing, as the life or the film that they belong to is not given.
    fn warn_of_idle_keys(&self, bearing: &Bearing, has_film: bool, problems: &mut Problems<'_>) {
        let cleanliness = self.oil.as_ref().and_then(|oil| oil.contamination);
        let idle = [
            (".reliability", self.reliability.is_some()),
            (".oil.contamination", cleanliness.is_some()),
        ];
        for (key, _) in idle.into_iter().filter(|(_, given)| *given) {
            if bearing.dynamic_rating.is_none() {
                problems.warn(format!(
                    "`{}` has no effect: no life is given without `dynamic_rating`; ISO 281 gives {:.0} N by the {}s",
                    problems.path(key),
                    bearing.geometry.dynamic_rating(),
                    bearing.geometry.element()
                ));
            }
        }
        let knows_film = has_film || bearing.geometry.rollers().is_some() && self.oil.is_some();
        if self.roughness.is_some() && !knows_film {
            problems.warn(format!(
                "`{}` has no effect: the film ratio needs [bearing.oil]{}",
                problems.path(".roughness"),
                match bearing.geometry.rollers() {
                    Some(_) => "",
                    None => " and film = true",
                }
            ));
        }
    }

    /// Tells what seals that rub change and no number counts.
    fn warn_of_seals(&self, problems: &mut Problems<'_>) {
        let speed = match self.limiting_speed {
            Some(_) => "",
            None => {
                ", and makers let it run at about half to two thirds of the speed of an open bearing: set `limiting_speed` to theirs"
            }
        };
        problems.warn(format!(
            "`{}` names seals that rub: the friction moment is given without theirs{speed}",
            problems.path(".catalogue")
        ));
    }

    /// Refuses what belongs to one bearing where there are two.
    pub(super) fn check_alone(&self, key: &str, problems: &mut Problems<'_>) {
        if self.arrangement.is_some() {
            let message = "of a set of two bearings it is not clear which one this belongs to";
            let issue = Issue::new(key, message).help(
                "write the set as two tables [[bearing]] with a `position` and a `facing` each",
            );
            problems.refuse(issue.against(".arrangement"));
        }
    }

    fn preload(&self) -> Preload {
        let offset = si(&self.axial_offset).unwrap_or(0.0);
        si(&self.spring_preload)
            .map(Preload::Spring)
            .or_else(|| si(&self.preload).map(Preload::Force))
            .unwrap_or(Preload::AxialOffset(offset))
    }

    /// What says which bearing it is; where rollers are given, what is printed of others.
    fn identity(&self, catalogue: &Catalogue) -> Identity<'_> {
        let has_balls = self.roller.is_none();
        let names_rollers = |name: &&str| {
            let found = catalogue::look_up(catalogue, name);
            matches!(found, Ok((Found::Rollers(_), _)))
        };
        let named = self.catalogue.as_deref();
        let rated = self.ratings.as_ref();
        Identity {
            catalogue: named.filter(|name| has_balls || names_rollers(name)),
            ratings: rated.filter(|own| has_balls || own.kind.is_some()),
            has_dimensions: !has_balls || self.geometry.is_some(),
            clearance_class: self.clearance_class,
        }
    }
}

/// The problem of a race control where no law knows any.
pub fn no_race_control(path: &str) -> Issue {
    let message = "`race_control` needs contact = \"jones\": other laws know no ball inertia";
    Issue::new(path, message).help("remove it, or set contact = \"jones\"")
}

/// The problem of a fit that squeezes the balls too much, or whose preload cannot be reached.
fn wrong_fit(error: &BearingError, bearing: &Bearing) -> Issue {
    let BearingError::Geometry(GeometryError::ClearanceChange {
        change,
        smallest,
        largest,
    }) = error
    else {
        return Issue::new(".fit", error.to_string());
    };
    let message = format!(
        "fits and temperatures change the diametral clearance by {:.1} um, and the bearing allows {:.1} … {:.1} um, from \
         where its balls are squeezed by a tenth of the distance of the groove centres to where its free contact angle \
         reaches 60 deg",
        1e6 * change,
        1e6 * smallest,
        1e6 * largest
    );
    Issue::new(".fit", message).help(match bearing.geometry.is_symmetric() {
        true => "give a wider `clearance_class`, for instance \"C3\", or less interference",
        false => "give less interference, or smaller differences of temperature",
    })
}
