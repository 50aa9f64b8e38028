//! `[[bearing]]` with its materials, its oil and its arrangement in sets.

use std::f64::consts::FRAC_PI_2;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::fit::FitInput;
use super::geometry::{GeometryInput, Printed, Sources};
use super::imperfections::{BallSizesInput, CageJitterInput, DefectInput, WavinessInput};
use super::oil::OilInput;
use super::ratings::RatingsInput;
use super::roller::{PrintedRollers, RollerInput};
use super::settings::{ContactChoice, ModelInput};
use super::support::HousingInput;
use crate::bearing::catalogue::{CATALOGUE, Catalogue};
use crate::bearing::{
    Bearing, BearingError, ClearanceClass, ContactDamping, ContactLaw, Estimate, Facing, Geometry,
    GeometryError, Imperfections, MountedBearing, Oil, Preload, catalogue,
};
use crate::physics::{Material, Race, RaceControl, SkfFriction};
use crate::rotor::Freedoms;
use crate::scenario::Issue;
use crate::scenario::problems::Problems;
use crate::scenario::quantity::{
    Angle, AngularSpeed, Density, Force, Length, Pressure, Quantity, si,
};

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
    /// Ring that turns at the speed of `[speed]`. "outer": the shaft stands, the outer ring turns in its place, and the load
    /// stands with the shaft; with contact "hertz" or "linear", and of all bearings alike. Default: "inner".
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
    /// Highest permissible speed by the catalogue, for instance "26000 rpm"; a higher one is told.
    /// Default: 1e6 mm/min over the pitch diameter.
    #[schemars(extend("examples" = ["26000 rpm"], "x-above" = 0.0))]
    pub limiting_speed: Option<Quantity<AngularSpeed>>,
    /// Angle from the radial plane at which the shoulders of the races end, for instance
    /// "35 deg"; contacts that reach it are told.
    #[schemars(extend("examples" = ["35 deg"], "x-above" = 0.0, "x-maximum" = FRAC_PI_2))]
    pub shoulder_angle: Option<Quantity<Angle>>,
    /// Basic dynamic load rating C, for instance "16.6 kN"; the life needs it. Default: that of
    /// the catalogue.
    #[schemars(extend("examples" = ["16.6 kN"], "x-above" = 0.0))]
    pub dynamic_rating: Option<Quantity<Force>>,
    /// Reliability of the modified life L_nm in per cent, 90 to 99. Default: 90.
    #[schemars(range(min = 90.0, max = 99.0))]
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
    /// The housing that it stands in. Default: it stands on the ground.
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
        let is_symmetric = mounted.bearing.geometry.is_symmetric();
        if self.facing.is_some() && is_symmetric && mounted.preload == Preload::AxialOffset(0.0) {
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
        let printed = self.printed_rollers(catalogue, problems)?;
        let bearing = match (&self.roller, printed.as_ref()) {
            (None, None) => self.ball_bearing(freedoms, catalogue, problems)?,
            (own, printed) => {
                let own = own.clone().unwrap_or_default();
                own.bearing(self, printed, model, problems)?
            }
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

    /// What a catalogue prints of the bearing, `Some(None)` where that is no roller bearing.
    fn printed_rollers(
        &self,
        catalogue: &Catalogue,
        problems: &mut Problems<'_>,
    ) -> Option<Option<PrintedRollers>> {
        let rated = self.ratings.as_ref().filter(|own| own.kind.is_some());
        if let Some(ratings) = rated {
            return ratings.roller_line(problems).map(|line| {
                Some(PrintedRollers {
                    line,
                    name: "the bearing of these ratings".to_owned(),
                    key: ".ratings",
                    class: None,
                })
            });
        }
        // a bearing of the user's own comes first
        let named = self.catalogue.as_deref();
        let named = named.filter(|name| catalogue::look_up(catalogue, name).is_err());
        let found = named.and_then(|name| catalogue::look_up_rollers(catalogue, name));
        Some(found.map(|(entry, class)| PrintedRollers {
            line: entry.line,
            name: entry.designation.clone(),
            key: ".catalogue",
            class,
        }))
    }

    /// Balls and races of the bearing, and what is known with them.
    fn ball_bearing(
        &self,
        freedoms: Freedoms,
        catalogue: &Catalogue,
        problems: &mut Problems<'_>,
    ) -> Option<Bearing> {
        let printed = self.identity().printed(catalogue, problems)?;
        let known = printed.as_ref();
        let line = known.map(|printed| printed.line);
        let skf_friction = known.and_then(|printed| SkfFriction::from_designation(&printed.name));
        let class = known.and_then(|printed| printed.class);
        let input = self.geometry.clone().unwrap_or_default();
        let sources = Sources {
            input: &input,
            printed,
            clearance_class: self.clearance_class.or(class),
        };
        let change = self.clearance_change.si();
        let (geometry, estimate) = sources.build(freedoms, change, problems)?;
        if let Some(estimate) = estimate.as_ref().filter(|own| !own.notes.is_empty()) {
            problems.warn(format!(
                "`{}`: {} balls of {:.3} mm are estimated from the ratings: {}",
                problems.path("."),
                estimate.internal.balls,
                1e3 * estimate.internal.ball_diameter,
                estimate.notes.join("; ")
            ));
        }
        Some(Bearing {
            contact_stiffness: si(&input.contact_stiffness),
            dynamic_rating: line.map(|line| line.dynamic_rating),
            clearance_class: sources.class_taken(),
            boundary: line.map(|line| [line.bore, line.outside_diameter]),
            estimated: estimate.as_ref().is_some_and(Estimate::is_estimated),
            skf_friction,
            ..Bearing::of_steel(geometry)
        })
    }

    /// The force law of a ball bearing and the oil that parts its surfaces, as far as nothing contradicts them.
    fn ball_law(
        &self,
        bearing: &Bearing,
        model: &ModelInput,
        problems: &mut Problems<'_>,
    ) -> (ContactLaw, Option<Oil>) {
        if let Err(error) = bearing.load_deflection_constant() {
            let key = match error {
                BearingError::Contact { race: "inner", .. } => ".geometry.groove_factor_inner",
                _ => ".geometry.groove_factor_outer",
            };
            problems.refuse(Issue::new(key, error.to_string()));
        }
        self.check_law(model, problems);
        let control = self.race_control.or(model.race_control);
        let law = match (self.contact(model), bearing.contact_stiffness) {
            // a stiffness of both races together knows no ball inertia
            (ContactChoice::Auto, Some(_)) => ContactChoice::Hertz.law(control),
            (contact, _) => contact.law(control),
        };
        (law, self.film_oil(model, problems))
    }

    /// What makes its surfaces differ from perfect ones, as far as it fits.
    fn imperfections(
        &self,
        geometry: &Geometry,
        model: &ModelInput,
        problems: &mut Problems<'_>,
    ) -> Option<Imperfections> {
        for (key, given) in [
            (".defect", !self.defect.is_empty()),
            (".waviness", !self.waviness.is_empty()),
            (".ball_sizes", self.ball_sizes.is_some()),
            (".roller_sizes", self.roller_sizes.is_some()),
            (".cage_jitter", self.cage_jitter.is_some()),
        ] {
            if given {
                self.check_imperfect(key, model, problems);
            }
        }
        let defects = problems.each("defect", &self.defect, |defect, problems| {
            problems.take(defect.build(geometry))
        });
        let waves = problems.each("waviness", &self.waviness, |waviness, problems| {
            waviness.build(geometry, problems)
        });
        let all = [
            ("ball_sizes", &self.ball_sizes),
            ("roller_sizes", &self.roller_sizes),
        ];
        let (own, other) = match geometry.rollers() {
            Some(_) => (all[1], all[0]),
            None => (all[0], all[1]),
        };
        if other.1.is_some() {
            let message = format!("this bearing has {}s", geometry.element());
            let issue = Issue::new(format!(".{}", other.0), message);
            problems.refuse(issue.help(format!("call it `{}`", own.0)));
        }
        let oversizes = problems.given(own.0, own.1, |sizes, problems| {
            sizes.build(geometry, problems)
        });
        let cage_steps = problems.given("cage_jitter", &self.cage_jitter, |jitter, problems| {
            problems.take(jitter.build(geometry))
        });
        Some(Imperfections {
            defects: defects?,
            waves: waves?.into_iter().flatten().collect(),
            oversizes: oversizes?.unwrap_or_default(),
            cage_slip: self.cage_slip,
            cage_steps: cage_steps?.unwrap_or_default(),
        })
    }

    /// Refuses imperfect surfaces where no ball rolls over them, and where it is not clear on which bearing they are.
    fn check_imperfect(&self, key: &str, model: &ModelInput, problems: &mut Problems<'_>) {
        if self.contact(model) == ContactChoice::Linear {
            let message = "contact = \"linear\" freezes the force of the bearing, and no ball rolls over its surfaces";
            let issue = Issue::new(key, message).help("remove it, or set contact = \"hertz\"");
            problems.refuse(issue.against_all([".contact", "model.contact"]));
        }
        self.check_alone(key, problems);
    }

    /// Refuses what belongs to one bearing where there are two.
    fn check_alone(&self, key: &str, problems: &mut Problems<'_>) {
        if self.arrangement.is_some() {
            let message = "of a set of two bearings it is not clear which one this belongs to";
            let issue = Issue::new(key, message).help(
                "write the set as two tables [[bearing]] with a `position` and a `facing` each",
            );
            problems.refuse(issue.against(".arrangement"));
        }
    }

    /// Refuses what the force law of the bearing does not know.
    fn check_law(&self, model: &ModelInput, problems: &mut Problems<'_>) {
        let contact = self.contact(model);
        let law = [".contact", "model.contact"];
        if self.race_control.is_some() && !contact.knows_inertia() {
            problems.refuse(no_race_control(".race_control").against_all(law));
        }
        if self.rotating_ring == Race::Outer && contact.knows_inertia() {
            let message = "the inertia of balls is known under a turning inner ring only";
            let issue = Issue::new(".rotating_ring", message).help("set contact = \"hertz\"");
            problems.refuse(issue.against_all(law));
        }
        let given = self.geometry.as_ref();
        let stiffness = given.and_then(|input| input.contact_stiffness.as_ref());
        if contact == ContactChoice::Jones && stiffness.is_some() {
            let message = "`contact_stiffness` is that of both races together, and \"jones\" \
                           loads them differently";
            let issue = Issue::new(".geometry.contact_stiffness", message)
                .help("remove it, or set contact = \"hertz\"");
            problems.refuse(issue.against_all(law));
        }
    }

    /// The oil, where its films part the surfaces.
    fn film_oil(&self, model: &ModelInput, problems: &mut Problems<'_>) -> Option<Oil> {
        if self.contact(model) == ContactChoice::Auto && self.film.is_none() {
            // films are considered where there is oil
            return self.oil.as_ref().map(OilInput::build);
        }
        if !self.film.unwrap_or(model.film) {
            return None;
        }
        if self.oil.is_none() {
            let message = format!("`{}` needs `oil` where film = true", problems.path("."));
            let issue = Issue::new(".oil", message).help(
                "add [bearing.oil] with viscosity = \"0.04 Pa s\" and pressure_viscosity = \
                 \"22 1/GPa\", or set film = false",
            );
            problems.refuse(issue.against(".film").against("model.film"));
        }
        self.oil.as_ref().map(OilInput::build)
    }

    fn preload(&self) -> Preload {
        let offset = si(&self.axial_offset).unwrap_or(0.0);
        si(&self.spring_preload)
            .map(Preload::Spring)
            .or_else(|| si(&self.preload).map(Preload::Force))
            .unwrap_or(Preload::AxialOffset(offset))
    }

    /// Position in m and orientation of the bearing, or of both of a set.
    fn places(&self, problems: &mut Problems<'_>) -> Option<Vec<(f64, Facing)>> {
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

    /// What says which bearing it is.
    fn identity(&self) -> Identity<'_> {
        Identity {
            catalogue: self.catalogue.as_deref(),
            ratings: self.ratings.as_ref(),
            has_geometry: self.geometry.is_some(),
            clearance_class: self.clearance_class,
        }
    }
}

/// What says which bearing it is.
pub struct Identity<'a> {
    /// Its designation.
    pub catalogue: Option<&'a str>,
    /// What a catalogue prints of it.
    pub ratings: Option<&'a RatingsInput>,
    /// Whether dimensions are given.
    pub has_geometry: bool,
    /// Class of the clearance, where it is given.
    pub clearance_class: Option<ClearanceClass>,
}

impl Identity<'_> {
    /// What a catalogue prints of the bearing, `Some(None)` where only the geometry is given; `None` where nothing tells what
    /// the bearing is.
    pub fn printed(
        &self,
        catalogue: &Catalogue,
        problems: &mut Problems<'_>,
    ) -> Option<Option<Printed>> {
        let printed = match (self.catalogue, self.ratings) {
            (Some(_), Some(_)) => {
                let message = "`catalogue` and `ratings` both say what the bearing is";
                let issue = Issue::new(".ratings", message).help("keep one of them");
                Err(issue.against(".catalogue"))
            }
            (None, Some(ratings)) => Ok(Some(Printed {
                line: ratings.line(),
                name: "the bearing of these ratings".to_owned(),
                key: ".ratings",
                class: None,
            })),
            (None, None) if self.has_geometry => Ok(None),
            (None, None) => {
                let message = format!(
                    "`{}` needs `catalogue`, a table `[bearing.ratings]`, `[bearing.geometry]` or `[bearing.roller]`",
                    problems.path(".")
                );
                let issue =
                    Issue::new(".catalogue", message).help("for instance: catalogue = \"7205C\"");
                Err(issue.against_all([".geometry", ".ratings"]))
            }
            (Some(designation), None) => self.found(catalogue, designation, problems).map(Some),
        };
        problems.take(printed)
    }

    fn found(
        &self,
        catalogue: &Catalogue,
        designation: &str,
        problems: &mut Problems<'_>,
    ) -> Result<Printed, Issue> {
        let found = catalogue::look_up(catalogue, designation).map_err(|unknown| {
            let message = format!("the catalogue has no bearing \"{designation}\"");
            Issue::new(".catalogue", message).help(unknown.help)
        })?;
        if let (Some(named), Some(given)) = (found.class, self.clearance_class)
            && named != given
        {
            let message = format!(
                "\"{designation}\" has the clearance {}, and `clearance_class` is {}",
                named.name(),
                given.name()
            );
            let issue = Issue::new(".clearance_class", message).help("keep one of them");
            problems.refuse(issue.against(".catalogue"));
        }
        Ok(Printed {
            line: found.entry.line,
            name: found.entry.designation.clone(),
            key: ".catalogue",
            class: found.class,
        })
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

/// Elastic constants and density.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct MaterialInput {
    /// Young's modulus, for instance "207 GPa" (the default, bearing steel) or "310 GPa"
    /// (silicon nitride).
    #[schemars(extend("x-minimum" = 1e3))]
    pub youngs_modulus: Option<Quantity<Pressure>>,
    /// Poisson's ratio, 0 to 0.5. Default: 0.3.
    #[schemars(range(min = 0.0, max = 0.5))]
    pub poisson_ratio: Option<f64>,
    /// Density, for instance "7800 kg/m^3" (the default) or "3200 kg/m^3" (silicon nitride).
    #[schemars(extend("x-above" = 0.0))]
    pub density: Option<Quantity<Density>>,
}

/// The material; what is not given is that of `base`.
pub fn material(input: Option<&MaterialInput>, base: Material) -> Material {
    let Some(input) = input else { return base };
    Material {
        youngs_modulus: si(&input.youngs_modulus).unwrap_or(base.youngs_modulus),
        poisson_ratio: input.poisson_ratio.unwrap_or(base.poisson_ratio),
        density: si(&input.density).unwrap_or(base.density),
    }
}

/// Warns where all bearings bear or are preloaded axially the same way, and nothing presses against it; there is no axial
/// load.
///
/// `last` is the index of the last table that describes them.
pub fn warn_where_unheld(bearings: &[MountedBearing], last: usize, problems: &mut Problems<'_>) {
    let Some(first) = bearings.first() else {
        return;
    };
    let angular = |mounted: &MountedBearing| {
        let geometry = &mounted.bearing.geometry;
        !geometry.is_symmetric() && geometry.nominal_angle() > 0.0
    };
    let preloaded = |mounted: &MountedBearing| match mounted.preload {
        Preload::AxialOffset(value) | Preload::Force(value) | Preload::Spring(value) => value > 0.0,
    };
    let one_way = |mounted: &MountedBearing| {
        mounted.facing == first.facing && (angular(mounted) || preloaded(mounted))
    };
    if !bearings.iter().all(one_way) {
        return;
    }
    let [way, other, force] = match first.facing {
        Facing::PlusZ => ["+z", "-z", "500 N"],
        Facing::MinusZ => ["-z", "+z", "-500 N"],
    };
    let load = format!("a load along {way}, as in `[[load]]` constant = {{ z = \"{force}\" }}");
    problems.warn(match bearings.len() {
        1 if preloaded(first) => format!(
            "nothing bears the preload of a single bearing, and the shaft gives way along {other}: add a second \
             `[[bearing]]` with facing = \"{other}\", leave the preload out, or add {load}"
        ),
        1 => format!(
            "a single angular contact or tapered bearing bears axially one way only and needs an axial load: with none it \
             hardly holds the shaft; add {load}"
        ),
        count => {
            let turned = match last {
                0 => "set arrangement = \"back-to-back\" in `bearing[1]`".to_owned(),
                last => format!("write facing = \"{other}\" in `bearing[{}]`", last + 1),
            };
            let face = match bearings.iter().all(angular) {
                true => "bearings face",
                false => "bearings face or are preloaded",
            };
            format!(
                "all {count} {face} the same way, {way}: none holds the shaft against the others, and a preload of theirs is \
                 not borne; {turned}, or add {load}"
            )
        }
    });
}
