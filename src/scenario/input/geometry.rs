//! `[bearing.geometry]`.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::identity::Printed;
use crate::bearing::{
    CatalogueLine, ClearanceClass, Estimate, EstimateError, FreePosition, Geometry, GeometryError,
    REFERENCE_GROOVES,
};
use crate::rotor::Freedoms;
use crate::scenario::Issue;
use crate::scenario::problems::Problems;
use crate::scenario::quantity::{Angle, ContactStiffness, Length, Quantity, si, significant};

/// Groove factor of a model in which the contact angle, and with it the groove, plays no part.
const ANY_GROOVE_FACTOR: f64 = 0.52;

/// Relative difference of load ratings that sizes in rounded figures make.
const SAME_RATING: f64 = 1e-3;

/// Internal dimensions of a bearing. With a catalogue bearing each key overrides its value, and C follows as ISO 281 has it;
/// without, balls, ball_diameter, pitch_diameter and one of contact_angle, diametral_clearance,
/// radial_clearance are needed.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(extend("x-at-most-one" = ["contact_angle", "diametral_clearance", "radial_clearance"]))]
pub struct GeometryInput {
    /// Number of balls, 3 to 200.
    #[schemars(range(min = 3, max = 200))]
    pub balls: Option<u32>,
    /// Ball diameter, for instance "7.938 mm".
    #[schemars(extend("examples" = ["7.938 mm"], "x-minimum" = 1e-5))]
    pub ball_diameter: Option<Quantity<Length>>,
    /// Diameter of the circle of ball centres, for instance "38.5 mm".
    #[schemars(extend("examples" = ["38.5 mm"], "x-minimum" = 1e-5))]
    pub pitch_diameter: Option<Quantity<Length>>,
    /// Contact angle of the unloaded bearing, "0 deg" to "60 deg".
    #[schemars(extend("x-minimum" = 0.0, "x-maximum" = Geometry::LARGEST_CONTACT_ANGLE))]
    pub contact_angle: Option<Quantity<Angle>>,
    /// Diametral clearance of a deep-groove bearing, for instance "10 um"; negative where the balls are squeezed between the
    /// races without load.
    #[schemars(extend("examples" = ["10 um"]))]
    pub diametral_clearance: Option<Quantity<Length>>,
    /// Radial clearance (half the diametral one) of a literature model that knows no contact
    /// angle, for instance "3 um": the balls roll as at 0°.
    #[schemars(extend("examples" = ["3 um"], "x-minimum" = 0.0))]
    pub radial_clearance: Option<Quantity<Length>>,
    /// Radius of the inner groove over the ball diameter, above 0.5, at most 1. Default: 0.52, with a warning.
    #[schemars(extend("exclusiveMinimum" = 0.5, "maximum" = 1.0))]
    pub groove_factor_inner: Option<f64>,
    /// Radius of the outer groove over the ball diameter, above 0.5, at most 1. Default: 0.53, with a warning.
    #[schemars(extend("exclusiveMinimum" = 0.5, "maximum" = 1.0))]
    pub groove_factor_outer: Option<f64>,
    /// Load–deflection constant of a ball between both races, for instance
    /// "1.334e10 N/m^1.5". Default: from Hertz's theory.
    #[schemars(extend("x-above" = 0.0))]
    pub contact_stiffness: Option<Quantity<ContactStiffness>>,
}

/// Where the dimensions of one bearing come from.
pub struct Sources<'a> {
    /// The table of the file, or an empty one.
    pub input: &'a GeometryInput,
    /// What a catalogue prints of the bearing, its name and the key that gives it; the table overrides it.
    pub printed: Option<Printed>,
    /// Class of the clearance, where it is given.
    pub clearance_class: Option<ClearanceClass>,
}

impl Sources<'_> {
    /// The checked geometry with its clearance changed, and what of it was estimated.
    pub fn build(
        &self,
        freedoms: Freedoms,
        clearance_change: f64,
        problems: &mut Problems<'_>,
    ) -> Option<(Geometry, Option<Estimate>)> {
        let input = self.input;
        let estimate = match &self.printed {
            Some(printed) => Some(self.estimate(printed, problems)?),
            None => None,
        };
        let entry = estimate.as_ref().map(|estimate| &estimate.internal);
        let balls = input.balls.map(|balls| balls as usize);
        let balls = needed(
            ".geometry",
            "balls",
            balls.or(entry.map(|entry| entry.balls)),
            problems,
        );
        let diameter = si(&input.ball_diameter).or(entry.map(|e| e.ball_diameter));
        let diameter = needed(".geometry", "ball_diameter", diameter, problems);
        let pitch = si(&input.pitch_diameter).or(entry.map(|e| e.pitch_diameter));
        let pitch = needed(".geometry", "pitch_diameter", pitch, problems);
        let free = self.free_position(problems);
        // in a radial scene with given contact stiffness and radial clearance the balls stay in the radial plane
        let flat = input.contact_stiffness.is_some() && input.radial_clearance.is_some();
        let any = (flat && freedoms == Freedoms::Radial).then_some(ANY_GROOVE_FACTOR);
        let known = entry.map(|e| [e.groove_factor_inner, e.groove_factor_outer]);
        let known = known.or(any.map(|any| [any; 2]));
        let [inner, outer] = self.grooves(known, problems);
        let geometry = Geometry::new(balls?, diameter?, pitch?, free?, inner, outer);
        let geometry = problems.take(geometry.map_err(|error| self.wrong(&error)))?;
        let changed = geometry.with_clearance_change(clearance_change);
        let wrong = |error| Issue::new(".clearance_change", self.message(&error));
        Some((problems.take(changed.map_err(wrong))?, estimate))
    }

    /// The internal geometry that belongs to the ratings and to what the table gives of it.
    fn estimate(&self, printed: &Printed, problems: &mut Problems<'_>) -> Option<Estimate> {
        let input = self.input;
        let grooves = input.groove_factor_inner.zip(input.groove_factor_outer);
        let line = CatalogueLine {
            balls: input.balls.map(|n| n as usize).or(printed.line.balls),
            ball_diameter: si(&input.ball_diameter).or(printed.line.ball_diameter),
            pitch_diameter: si(&input.pitch_diameter).or(printed.line.pitch_diameter),
            groove_factors: grooves.map(Into::into).or(printed.line.groove_factors),
            ..printed.line
        };
        problems.take(line.estimate().map_err(|error| match error {
            EstimateError::Geometry(error) => self.wrong(&error),
            error => printed.wrong(&error),
        }))
    }

    /// Basic dynamic load rating C of the printed line, N, in the geometry that is built.
    ///
    /// A catalogue prints C of its own balls: where the table makes them others, C is the printed one times the ratio of both
    /// by ISO 281, which keeps the maker's factor over the standard. Balls that are given for a line that does not know its own
    /// are those of the line if its C fits them as it fits estimated ones. The ratings of [bearing.ratings] are those of the
    /// geometry next to them.
    pub fn dynamic_rating(
        &self,
        geometry: &Geometry,
        estimate: Option<&Estimate>,
        problems: &mut Problems<'_>,
    ) -> Option<f64> {
        let printed = self.printed.as_ref()?;
        let line = &printed.line;
        let own = line.estimate().ok().filter(|_| printed.key == ".catalogue");
        let Some(own) = own else {
            return Some(line.dynamic_rating);
        };
        let is_open = line.balls.is_none() || line.ball_diameter.is_none();
        let fits = |found: &&Estimate| line.is_rated_usually(found.internal.dynamic_rating);
        let estimate = estimate.filter(fits).filter(|_| is_open);
        let reference = estimate.unwrap_or(&own).internal.dynamic_rating;
        let rating = geometry.dynamic_rating();
        let scaled = line.dynamic_rating * (rating / reference);
        if (scaled / line.dynamic_rating - 1.0).abs() > SAME_RATING {
            problems.warn(format!(
                "`{}` changes the load rating of {}: by ISO 281 C is {rating:.0} N here and {reference:.0} N of its own balls, \
                 so that lives rest on {scaled:.0} N instead of the {:.0} N of the catalogue; give `dynamic_rating` where you know it",
                problems.path(".geometry"),
                printed.name,
                line.dynamic_rating,
            ));
        }
        Some(scaled)
    }

    /// Groove factors, inner race first: those given, those known otherwise, or else those of ISO/TS 16281, with a warning.
    fn grooves(&self, known: Option<[f64; 2]>, problems: &mut Problems<'_>) -> [f64; 2] {
        let given = [
            ("groove_factor_inner", self.input.groove_factor_inner),
            ("groove_factor_outer", self.input.groove_factor_outer),
        ];
        let [inner, outer] = known.unwrap_or(REFERENCE_GROOVES);
        let all = [(given[0], inner), (given[1], outer)];
        let assumed = all
            .iter()
            .filter(|((_, given), _)| known.is_none() && given.is_none());
        let assumed: Vec<_> = assumed
            .map(|((key, _), groove)| format!("{key} = {groove}"))
            .collect();
        if !assumed.is_empty() {
            let table = problems.path(".geometry");
            problems.warn(format!(
                "`{table}`: {} assumed, the reference of ISO/TS 16281: contact stiffness and what follows from it rest on that",
                assumed.join(", ")
            ));
        }
        all.map(|((_, given), otherwise)| given.unwrap_or(otherwise))
    }

    /// The class whose middle the clearance is: the one given, or else CN of a deep-groove bearing of the catalogue.
    pub fn class_taken(&self) -> Option<ClearanceClass> {
        let is_open = self.given_position().is_none();
        let printed = self.printed.as_ref();
        let printed = printed.filter(|printed| is_open && printed.line.contact_angle == 0.0);
        printed.map(|_| self.clearance_class.unwrap_or_default())
    }

    fn given_position(&self) -> Option<FreePosition> {
        let input = self.input;
        let angle = si(&input.contact_angle).map(FreePosition::ContactAngle);
        let diametral = si(&input.diametral_clearance).map(FreePosition::DiametralClearance);
        let radial = si(&input.radial_clearance).map(FreePosition::RadialClearance);
        angle.or(diametral).or(radial)
    }

    /// Refuses a class of clearance that says nothing, or something else than the geometry.
    fn check_class(&self, problems: &mut Problems<'_>) {
        if self.clearance_class.is_none() || self.class_taken().is_some() {
            return;
        }
        let keys = ["contact_angle", "diametral_clearance", "radial_clearance"].map(at);
        let (message, help) = match &self.printed {
            _ if self.given_position().is_some() => (
                "the geometry already gives a clearance".to_owned(),
                "remove `clearance_class`, or the clearance or contact angle in the geometry",
            ),
            Some(entry) => (
                format!(
                    "{} is an angular contact bearing, which has no class of clearance",
                    entry.name
                ),
                "remove it; `clearance_change` and `preload` tighten the bearing",
            ),
            None => (
                "a class of clearance needs the bore, which only `catalogue` or [bearing.ratings] gives"
                    .to_owned(),
                "give diametral_clearance in [bearing.geometry] instead, for instance \"12 um\"",
            ),
        };
        let issue = Issue::new(".clearance_class", message).help(help);
        problems.refuse(issue.against_all(keys));
    }

    fn free_position(&self, problems: &mut Problems<'_>) -> Option<FreePosition> {
        self.check_class(problems);
        let class = self.clearance_class.unwrap_or_default();
        let printed = self.printed.as_ref();
        let given = self
            .given_position()
            .or_else(|| printed.and_then(|printed| printed.line.free_position(class)));
        if given.is_none() && printed.is_some() {
            let message = format!(
                "class {} has no clearance for this bore (ISO 5753-1, above 6 mm to 140 mm)",
                class.name()
            );
            let issue = Issue::new(at("diametral_clearance"), message)
                .help("give [bearing.geometry] with diametral_clearance = \"20 um\", for instance");
            problems.refuse(issue.against(".clearance_class"));
        } else if given.is_none() {
            let message = format!(
                "`{}` needs one of `contact_angle`, `diametral_clearance`, `radial_clearance`",
                problems.path(".geometry")
            );
            let others = ["diametral_clearance", "radial_clearance"].map(at);
            let issue = Issue::new(at("contact_angle"), message);
            problems.refuse(issue.against_all(others));
        }
        given
    }

    /// The problem of dimensions that make no bearing.
    fn wrong(&self, error: &GeometryError) -> Issue {
        let (key, others): (_, &[&str]) = match error {
            GeometryError::Clearance { .. } => (self.clearance_key(), &["ball_diameter"]),
            GeometryError::Overlap { .. } => ("balls", &["ball_diameter", "pitch_diameter"]),
            GeometryError::Section { .. } => ("pitch_diameter", &["ball_diameter"]),
            // each number by itself is in its range: schema and catalogue have seen to it
            _ => ("balls", &[]),
        };
        let issue = Issue::new(at(key), self.message(error));
        issue.against_all(others.iter().map(|key| at(key)))
    }

    /// The message of the error, with lengths in the units of a drawing.
    fn message(&self, error: &GeometryError) -> String {
        match *error {
            GeometryError::Clearance {
                clearance,
                smallest,
                largest,
            } => {
                let key = self.clearance_key();
                let part = if key == "radial_clearance" { 0.5 } else { 1.0 };
                if clearance < smallest {
                    return format!(
                        "`{key}` must be at least {}: there the balls are squeezed by a tenth of the distance of the \
                         groove centres",
                        micrometres(part * smallest)
                    );
                }
                format!(
                    "`{key}` must be at most {}: there the free contact angle reaches 60 deg",
                    millimetres(part * largest)
                )
            }
            GeometryError::ClearanceChange {
                smallest, largest, ..
            } => format!(
                "`clearance_change` must be in {} … {}, from where the balls are squeezed by a tenth of the distance of \
                 the groove centres to where the free contact angle reaches 60 deg",
                micrometres(smallest),
                micrometres(largest)
            ),
            _ => dimensions_message("balls", error),
        }
    }

    fn clearance_key(&self) -> &'static str {
        match self.input.radial_clearance {
            Some(_) => "radial_clearance",
            None => "diametral_clearance",
        }
    }
}

/// The value of a key of a table of the bearing, which must be there.
pub(super) fn needed<T>(
    table: &str,
    key: &str,
    value: Option<T>,
    problems: &mut Problems<'_>,
) -> Option<T> {
    problems.take(value.ok_or_else(|| {
        let shown = problems.path(table);
        let message = format!("`{shown}` needs `{key}` where no catalogue bearing gives it");
        Issue::new(format!("{table}.{key}"), message)
    }))
}

/// Path of a key, from the bearing.
fn at(key: &str) -> String {
    format!(".geometry.{key}")
}

/// What is wrong with the dimensions of balls or rollers, with lengths in the units of a drawing.
pub(super) fn dimensions_message(parts: &str, error: &GeometryError) -> String {
    match *error {
        GeometryError::Overlap {
            balls,
            ball_diameter,
            pitch_diameter,
            largest,
        } => format!(
            "{balls} {parts} of {} overlap on a pitch circle of {}: at most {largest} fit",
            millimetres(ball_diameter),
            millimetres(pitch_diameter)
        ),
        _ => error.to_string(),
    }
}

/// A length in mm with four significant digits.
pub(super) fn millimetres(length: f64) -> String {
    format!("{} mm", significant(length * 1e3))
}

/// A length in µm with four significant digits.
fn micrometres(length: f64) -> String {
    format!("{} um", significant(length * 1e6))
}
