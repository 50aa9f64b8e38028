//! Number and sizes of rollers, their clearance, and what they need of room.

use super::super::geometry::{dimensions_message, millimetres, needed};
use super::super::identity::Printed;
use super::RollerInput;
use crate::bearing::{
    ClearanceClass, EstimateError, Geometry, GeometryError, RollerEstimate, RollerKind, RollerLine,
    Rollers,
};
use crate::scenario::Issue;
use crate::scenario::problems::Problems;
use crate::scenario::quantity::si;

/// Rollers as their table, and else the catalogue, has them; lengths in m.
pub(super) struct Known {
    pub kind: RollerKind,
    pub rollers: usize,
    pub diameter: f64,
    pub length: f64,
    pub pitch_diameter: f64,
    pub contact_angle: f64,
    pub bore: Option<f64>,
    pub outside_diameter: Option<f64>,
    pub width: Option<f64>,
    pub estimate: Option<RollerEstimate>,
}

impl RollerInput {
    /// The dimensions, where all that are needed are given or follow from what is printed.
    pub(super) fn known(
        &self,
        printed: Option<&Printed<RollerLine>>,
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
                let estimate = line.estimate();
                Some(problems.take(estimate.map_err(|error| match error {
                    EstimateError::Geometry(error) => wrong(&error),
                    error => printed.wrong(&error),
                }))?)
            }
            None => None,
        };
        let found = estimate.as_ref().map(|estimate| estimate.best);
        let mut need = |key: &str, value| needed(".roller", key, value, problems);
        let pitch = pitch.or(estimate.as_ref().map(|estimate| estimate.pitch_diameter));
        let dimensions = [
            need("diameter", diameter.or(found.map(|found| found.diameter))),
            need("length", length.or(found.map(|found| found.length))),
            need("pitch_diameter", pitch),
        ];
        let count = rollers.or(found.map(|found| found.rollers));
        let count = needed(".roller", "rollers", count, problems);
        let kind = self.kind.or(line.map(|line| line.kind));
        // a kind that is missing is the last to be reported
        let kind = needed(".roller", "kind", kind, problems)?;
        let [Some(diameter), Some(length), Some(pitch_diameter)] = dimensions else {
            return None;
        };
        let boundary = line.map(|line| line.boundary);
        let angle = line.map_or(0.0, |line| line.contact_angle);
        Some(Known {
            kind,
            rollers: count?,
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

    /// The clearance, m, and the class whose middle it is; of tapered rollers none where it is not given.
    pub(super) fn clearance(
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

    /// The checked geometry of the rollers with a clearance in m.
    pub(super) fn geometry(
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
        let boundary = known.bore.zip(known.outside_diameter);
        let checked = built.and_then(|geometry| match boundary {
            Some((bore, outside)) => geometry.check_section([bore, outside]).map(|()| geometry),
            None => Ok(geometry),
        });
        problems.take(checked.map_err(|error| wrong(&error)))
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

/// The problem of dimensions that make no bearing.
fn wrong(error: &GeometryError) -> Issue {
    let key = match error {
        GeometryError::RollerAngle { .. } => ".roller.contact_angle",
        GeometryError::RollerClearance { .. } => ".roller.diametral_clearance",
        GeometryError::Laminae { .. } => ".roller.laminae",
        GeometryError::Section { .. } => ".roller.pitch_diameter",
        _ => ".roller.rollers",
    };
    Issue::new(key, dimensions_message("rollers", error)).against(".roller.kind")
}
