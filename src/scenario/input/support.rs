//! The housing of a bearing, `[bearing.housing]`, and a bearing of constant stiffness, `[bearing.linear]`.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::components::{Axes, Components, PerFreedom};
use crate::bearing::{Housing, Resonator};
use crate::rotor::{FREEDOMS, Freedoms, LinearBearing};
use crate::scenario::Issue;
use crate::scenario::quantity::{
    Damping, Mass, Measure, Quantity, Stiffness, TiltDamping, TiltStiffness, si,
};

/// The housing that a bearing stands in: a mass on springs and dampers to the ground, where sensors sit. It moves along x and
/// y, and along z where the shaft does; its displacement counts from where its own weight has put it. Base accelerations
/// act on it.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct HousingInput {
    /// Mass, for instance "3 kg".
    #[schemars(extend("examples" = ["3 kg"], "x-minimum" = 1e-6))]
    pub mass: Quantity<Mass>,
    /// Stiffness to the ground along each axis, for instance { x = "200 N/um", y = "300 N/um", z = "100 N/um" }.
    #[schemars(extend("examples" = [{ "x": "200 N/um", "y": "300 N/um" }]))]
    pub stiffness: Axes<Stiffness>,
    /// Damping to the ground along each axis, for instance { x = "500 N s/m", y = "500 N s/m" }. Default: none.
    pub damping: Option<Axes<Damping>>,
    /// What vibrates on it: a sensor with its mount, whose resonance rings at every impact. Its motion has columns of its
    /// own, `resonator1_x_acceleration` …
    pub resonator: Option<ResonatorInput>,
}

/// A mass on a spring and a damper on the housing, alike along x, y and z.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ResonatorInput {
    /// Mass, for instance "0.1 kg".
    #[schemars(extend("examples" = ["0.1 kg"], "x-minimum" = 1e-6))]
    pub mass: Quantity<Mass>,
    /// Stiffness to the housing, for instance "1e8 N/m".
    #[schemars(extend("examples" = ["1e8 N/m"], "x-minimum" = 1.0))]
    pub stiffness: Quantity<Stiffness>,
    /// Damping to the housing, for instance "500 N s/m". Default: none.
    #[schemars(extend("x-minimum" = 0.0))]
    pub damping: Option<Quantity<Damping>>,
}

impl HousingInput {
    /// The housing, unless it is free along an axis that it moves along.
    pub fn build(&self, freedoms: Freedoms) -> Result<Housing, Issue> {
        let stiffness = self.stiffness.values();
        let free = stiffness[..freedoms.lengths()]
            .iter()
            .position(|value| *value <= 0.0);
        if let Some(axis) = free {
            let axis = ["x", "y", "z"][axis];
            let message =
                format!("the housing moves along {axis} and nothing holds it to the ground");
            let help = format!("give stiffness.{axis}, for instance \"200 N/um\"");
            return Err(Issue::new(".stiffness", message).help(help));
        }
        Ok(Housing {
            mass: self.mass.si(),
            stiffness,
            damping: self.damping.as_ref().map_or([0.0; 3], Axes::values),
            resonator: self.resonator.as_ref().map(|own| Resonator {
                mass: own.mass.si(),
                stiffness: own.stiffness.si(),
                damping: own.damping.as_ref().map_or(0.0, Quantity::si),
            }),
        })
    }
}

/// Springs and dampers in place of balls, to the ground or to the bearing's housing. What is left out is zero.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct LinearInput {
    /// Stiffness, for instance { x = "1e6 N/m", y = "1e6 N/m" }. `xy` is the force along X that a displacement along Y takes,
    /// `yx` that along Y by one along X; one that is left out is like the other, as of springs whose axes are inclined. A
    /// film or seal has both with opposite signs, and drives a forward whirl where `xy` is the positive one.
    #[schemars(extend("examples" = [{ "x": "1 N/um", "y": "1 N/um" }]))]
    pub stiffness: Coupled<Stiffness, TiltStiffness>,
    /// Damping, for instance { x = "100 N s/m", y = "100 N s/m" }, by velocities in the same way. Default: none.
    pub damping: Option<Coupled<Damping, TiltDamping>>,
}

/// Values along the axes (`T`) and about them (`R`), and across between x and y.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(bound(
    serialize = "T: Measure + Clone, R: Measure + Clone",
    deserialize = "T: Measure + Clone, R: Measure + Clone"
))]
#[schemars(bound = "T: Measure, R: Measure", deny_unknown_fields, extend("minProperties" = 1))]
pub struct Coupled<T, R> {
    /// Along the axes and about them.
    #[serde(flatten)]
    pub direct: Components<T, R>,
    /// Force along X that a displacement, or velocity, along Y takes.
    pub xy: Option<Quantity<T>>,
    /// Force along Y that one along X takes. Default: that of `xy`, springs whose axes are inclined; a film or seal that
    /// drives a whirl has both with opposite signs.
    pub yx: Option<Quantity<T>>,
}

impl<T, R> Coupled<T, R> {
    /// Values of x, y, z and the tilts, SI.
    fn direct(&self) -> [f64; FREEDOMS] {
        self.direct.values().map(Option::unwrap_or_default)
    }

    /// Those of xy and yx.
    fn across(&self) -> [f64; 2] {
        let [xy, yx] = [&self.xy, &self.yx].map(si);
        [xy.or(yx), yx.or(xy)].map(Option::unwrap_or_default)
    }
}

impl LinearInput {
    /// Whether it holds the shaft along z.
    pub fn holds_z(&self) -> bool {
        si(&self.stiffness.direct.z).is_some_and(|stiffness| stiffness > 0.0)
    }

    /// The bearing at its place among all of them, and its position in m.
    pub fn build(&self, place: usize, position: f64) -> LinearBearing {
        let damping = self.damping.as_ref();
        LinearBearing {
            place,
            position,
            stiffness: self.stiffness.direct(),
            damping: damping.map(Coupled::direct).unwrap_or_default(),
            cross_stiffness: self.stiffness.across(),
            cross_damping: damping.map(Coupled::across).unwrap_or_default(),
            housing: None,
        }
    }
}
