//! `[bearing.ratings]`.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::bearing::{CatalogueLine, Geometry, RollerKind, RollerLine};
use crate::scenario::Issue;
use crate::scenario::problems::Problems;
use crate::scenario::quantity::{Angle, Force, Length, Quantity, si};

/// What a maker's catalogue prints of a bearing: balls and grooves, or with `kind` rollers, are estimated from it, by the ratings of ISO 281 and
/// ISO 76 (`jeffcott estimate` shows how).
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct RatingsInput {
    /// Kind of a roller bearing. Default: a ball bearing.
    pub kind: Option<RollerKind>,
    /// Width of the inner ring, for instance "18 mm"; rollers need it.
    #[schemars(extend("examples" = ["18 mm"], "x-minimum" = 1e-4))]
    pub width: Option<Quantity<Length>>,
    /// Bore, for instance "40 mm".
    #[schemars(extend("examples" = ["40 mm"], "x-minimum" = 1e-4))]
    pub bore: Quantity<Length>,
    /// Outside diameter, for instance "80 mm".
    #[schemars(extend("examples" = ["80 mm"], "x-minimum" = 1e-4))]
    pub outside_diameter: Quantity<Length>,
    /// Nominal contact angle; "0 deg" of a deep-groove bearing or cylindrical rollers. Where e is printed of tapered or
    /// spherical rollers, it is atan(e/1.5).
    #[schemars(extend("examples" = ["0 deg"], "x-minimum" = 0.0, "x-maximum" = Geometry::LARGEST_CONTACT_ANGLE))]
    pub contact_angle: Quantity<Angle>,
    /// Basic dynamic load rating C, for instance "29.1 kN".
    #[schemars(extend("examples" = ["29.1 kN"], "x-above" = 0.0))]
    pub dynamic: Quantity<Force>,
    /// Basic static load rating C0, for instance "17.9 kN".
    #[serde(rename = "static")]
    #[schemars(extend("examples" = ["17.9 kN"], "x-above" = 0.0))]
    pub statical: Quantity<Force>,
    /// Number of balls, where it is printed, 3 to 200.
    #[schemars(range(min = 3, max = 200))]
    pub balls: Option<u32>,
    /// Ball diameter, where it is printed.
    #[schemars(extend("examples" = ["11.906 mm"], "x-minimum" = 1e-5))]
    pub ball_diameter: Option<Quantity<Length>>,
    /// Pitch diameter, where it is printed. Default: the mean of bore and outside diameter.
    #[schemars(extend("examples" = ["60 mm"], "x-minimum" = 1e-5))]
    pub pitch_diameter: Option<Quantity<Length>>,
    /// Factor f0 that catalogues print beside the ratings, for instance 14.2, or 14 where it is rounded; it helps to settle which
    /// balls they are.
    #[schemars(extend("exclusiveMinimum" = 0.0, "maximum" = 30.0))]
    pub f0: Option<f64>,
}

impl RatingsInput {
    /// The line of a catalogue of roller bearings of a kind, where nothing contradicts it.
    pub fn roller_line(&self, kind: RollerKind, problems: &mut Problems<'_>) -> Option<RollerLine> {
        for (key, given) in [
            (".ratings.balls", self.balls.is_some()),
            (".ratings.ball_diameter", self.ball_diameter.is_some()),
            (".ratings.f0", self.f0.is_some()),
        ] {
            if given {
                let issue = Issue::new(key, "this belongs to balls").help("remove it");
                problems.refuse(issue.against(".ratings.kind"));
            }
        }
        let missing = || {
            Issue::new(".ratings.width", "the ratings of rollers need `width`")
                .help("for instance: width = \"18 mm\"")
                .against(".ratings.kind")
        };
        let width = problems.take(si(&self.width).ok_or_else(missing))?;
        Some(RollerLine {
            kind,
            boundary: [self.bore.si(), self.outside_diameter.si(), width],
            contact_angle: self.contact_angle.si(),
            dynamic_rating: self.dynamic.si(),
            static_rating: self.statical.si(),
            rollers: None,
            diameter: None,
            length: None,
            pitch_diameter: si(&self.pitch_diameter),
        })
    }

    /// The line of the catalogue.
    pub fn line(&self) -> CatalogueLine {
        CatalogueLine {
            static_factor: self.f0,
            balls: self.balls.map(|balls| balls as usize),
            ball_diameter: si(&self.ball_diameter),
            pitch_diameter: si(&self.pitch_diameter),
            ..CatalogueLine::printed(
                [self.bore.si(), self.outside_diameter.si()],
                self.contact_angle.si(),
                self.dynamic.si(),
                self.statical.si(),
            )
        }
    }
}
