//! `[shaft.torsion]`.

use std::f64::consts::PI;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::quasi_static::{Torsion, TorsionCause};
use crate::scenario::quantity::{Angle, Length, Moment, Pressure, Quantity, SecondMoment, si};

/// Shear modulus of steel, Pa.
const STEEL: f64 = 79.4e9;

/// The segment of the shaft that a moment about its axis twists: in static questions, and in motion
/// under a drive, there by the friction moment of the bearings. Without moment and angle that moment
/// twists it in static questions, too.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(extend(
    "x-exactly-one" = ["diameter", "polar_second_moment"],
    "x-at-most-one" = ["moment", "angle"]
))]
pub struct TorsionInput {
    /// Length of the segment, for instance "200 mm".
    #[schemars(extend("examples" = ["200 mm"], "x-above" = 0.0))]
    pub length: Quantity<Length>,
    /// Shear modulus. Default: "79.4 GPa", steel.
    #[schemars(extend("examples" = ["79.4 GPa"], "x-minimum" = 1e3))]
    pub shear_modulus: Option<Quantity<Pressure>>,
    /// Diameter of a solid round segment, for instance "25 mm".
    #[schemars(extend("examples" = ["25 mm"], "x-minimum" = 1e-5))]
    pub diameter: Option<Quantity<Length>>,
    /// Polar second moment of area of another section, for instance "38000 mm^4".
    #[schemars(extend("examples" = ["38000 mm^4"], "x-above" = 0.0))]
    pub polar_second_moment: Option<Quantity<SecondMoment>>,
    /// Moment about the shaft axis, for instance "2 N m".
    pub moment: Option<Quantity<Moment>>,
    /// Angle of twist, for instance "0.1 mrad".
    #[schemars(extend("examples" = ["0.1 mrad"]))]
    pub angle: Option<Quantity<Angle>>,
}

impl TorsionInput {
    /// The segment and what twists it.
    pub fn build(&self) -> Torsion {
        Torsion {
            length: self.length.si(),
            shear_modulus: si(&self.shear_modulus).unwrap_or(STEEL),
            polar_second_moment: self.polar_second_moment(),
            cause: match (&self.moment, &self.angle) {
                (Some(moment), _) => TorsionCause::Moment(moment.si()),
                (None, Some(angle)) => TorsionCause::Angle(angle.si()),
                (None, None) => TorsionCause::Friction,
            },
        }
    }

    /// `I_p = π d⁴/32` of a solid round segment.
    fn polar_second_moment(&self) -> f64 {
        let round = |diameter: &Quantity<Length>| PI * diameter.si().powi(4) / 32.0;
        let given = si(&self.polar_second_moment);
        given
            .or_else(|| self.diameter.as_ref().map(round))
            .unwrap_or(f64::INFINITY)
    }
}
