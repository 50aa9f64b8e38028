//! A bearing of balls: its law of contact and what is wrong with its surfaces.

use super::bearing::{BearingInput, no_race_control};
use super::geometry::Sources;
use super::identity::Printed;
use super::oil::OilInput;
use super::settings::{ContactChoice, ModelInput};
use crate::bearing::{Bearing, BearingError, ContactLaw, Estimate, Geometry, Imperfections, Oil};
use crate::physics::{Race, SkfFriction};
use crate::rotor::Freedoms;
use crate::scenario::Issue;
use crate::scenario::problems::Problems;
use crate::scenario::quantity::si;

impl BearingInput {
    /// Balls and races of the bearing, and what is known with them.
    pub(super) fn ball_bearing(
        &self,
        freedoms: Freedoms,
        printed: Option<Printed>,
        problems: &mut Problems<'_>,
    ) -> Option<Bearing> {
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
        let dynamic_rating = match &self.dynamic_rating {
            Some(given) => Some(given.si()),
            None => sources.dynamic_rating(&geometry, estimate.as_ref(), problems),
        };
        Some(Bearing {
            contact_stiffness: si(&input.contact_stiffness),
            dynamic_rating,
            clearance_class: sources.class_taken(),
            boundary: line.map(|line| [line.bore, line.outside_diameter]),
            estimated: estimate.as_ref().is_some_and(Estimate::is_estimated),
            skf_friction,
            ..Bearing::of_steel(geometry)
        })
    }

    /// The force law of a ball bearing and the oil that parts its surfaces, as far as nothing contradicts them.
    pub(super) fn ball_law(
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
    pub(super) fn imperfections(
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
    pub(super) fn check_imperfect(
        &self,
        key: &str,
        model: &ModelInput,
        problems: &mut Problems<'_>,
    ) {
        if self.contact(model) == ContactChoice::Linear {
            let message = "contact = \"linear\" freezes the force of the bearing, and nothing rolls over its surfaces";
            let issue = Issue::new(key, message).help("remove it, or set contact = \"hertz\"");
            problems.refuse(issue.against_all([".contact", "model.contact"]));
        }
        self.check_alone(key, problems);
    }

    /// Refuses what the force law of the bearing does not know.
    pub(super) fn check_law(&self, model: &ModelInput, problems: &mut Problems<'_>) {
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
    pub(super) fn film_oil(&self, model: &ModelInput, problems: &mut Problems<'_>) -> Option<Oil> {
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
}
