//! The five freedoms as keys of an inline table; `[initial]` and `[static]`, which are made of such.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::load::LoadInput;
use crate::rotor::{FREEDOMS, Freedoms, InitialPosition, InitialState};
use crate::scenario::Issue;
use crate::scenario::problems::Problems;
use crate::scenario::quantity::{Angle, AngularSpeed, Length, Measure, Quantity, Velocity, si};
use crate::scenario::reader::last;

/// Keys of the freedoms, in their order.
pub const KEYS: [&str; FREEDOMS] = ["x", "y", "z", "tilt_x", "tilt_y"];

/// Values along the axes (`T`) and about them (`R`); at least one.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(
    deny_unknown_fields,
    bound(
        serialize = "T: Measure + Clone, R: Measure + Clone",
        deserialize = "T: Measure + Clone, R: Measure + Clone"
    )
)]
#[schemars(bound = "T: Measure, R: Measure", extend("minProperties" = 1))]
pub struct Components<T, R> {
    /// Along X, horizontal.
    pub x: Option<Quantity<T>>,
    /// Along Y, vertical and upward.
    pub y: Option<Quantity<T>>,
    /// Along Z, the shaft.
    pub z: Option<Quantity<T>>,
    /// About X.
    pub tilt_x: Option<Quantity<R>>,
    /// About Y.
    pub tilt_y: Option<Quantity<R>>,
}

/// Values along the axes; one that is left out is zero.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(
    deny_unknown_fields,
    bound(serialize = "T: Measure + Clone", deserialize = "T: Measure + Clone")
)]
#[schemars(bound = "T: Measure", extend("minProperties" = 1))]
pub struct Axes<T> {
    /// Along X, horizontal.
    #[schemars(extend("x-minimum" = 0.0))]
    pub x: Option<Quantity<T>>,
    /// Along Y, vertical and upward.
    #[schemars(extend("x-minimum" = 0.0))]
    pub y: Option<Quantity<T>>,
    /// Along Z, the shaft.
    #[schemars(extend("x-minimum" = 0.0))]
    pub z: Option<Quantity<T>>,
}

impl<T> Axes<T> {
    /// The values in SI units.
    pub fn values(&self) -> [f64; 3] {
        [&self.x, &self.y, &self.z].map(|value| si(value).unwrap_or(0.0))
    }
}

/// A value for each freedom, in an inline table.
pub trait PerFreedom {
    /// The given values in SI units.
    fn values(&self) -> [Option<f64>; FREEDOMS];
}

impl<T, R> PerFreedom for Components<T, R> {
    fn values(&self) -> [Option<f64>; FREEDOMS] {
        [
            si(&self.x),
            si(&self.y),
            si(&self.z),
            si(&self.tilt_x),
            si(&self.tilt_y),
        ]
    }
}

/// Refuses what is given for freedoms that do not move.
pub fn refuse_held(
    given: &[Option<f64>; FREEDOMS],
    path: &str,
    freedoms: Freedoms,
    problems: &mut Problems<'_>,
) {
    for (axis, key) in KEYS.iter().enumerate() {
        if given[axis].is_some() && !freedoms.moves(axis) {
            refuse_held_key(&format!("{path}.{key}"), freedoms, problems);
        }
    }
}

/// Refuses a key of a freedom that does not move.
pub fn refuse_held_key(path: &str, freedoms: Freedoms, problems: &mut Problems<'_>) {
    let key = last(path);
    let wider = match freedoms {
        Freedoms::Radial if key == "z" => "\"translational\" or \"all\"",
        Freedoms::Radial => "\"lateral\" or \"all\"",
        Freedoms::Translational | Freedoms::Lateral => "\"all\"",
        Freedoms::All => return,
    };
    let name = freedoms.name();
    let message = format!("`{key}` has nothing to act on: freedoms = \"{name}\" holds it");
    let help = format!("remove it, or set freedoms = {wider}");
    let issue = Issue::new(path, message).help(help);
    problems.refuse(issue.against("shaft.freedoms"));
}

/// Where the motion starts.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
pub struct InitialInput {
    /// Position at the start. Default: "equilibrium".
    pub from: InitialPosition,
    /// Displacements that replace those of `from`, for instance { x = "1 um" }.
    pub displacement: Option<Components<Length, Angle>>,
    /// Velocities that replace rest, for instance { x = "1 mm/s" }.
    pub velocity: Option<Components<Velocity, AngularSpeed>>,
}

impl InitialInput {
    /// The state at the start.
    pub fn build(&self, freedoms: Freedoms, problems: &mut Problems<'_>) -> InitialState {
        let mut given = |path: &str, values: Option<[Option<f64>; FREEDOMS]>| {
            let values = values.unwrap_or_default();
            refuse_held(&values, path, freedoms, problems);
            values
        };
        let displacement = self.displacement.as_ref().map(Components::values);
        let velocity = self.velocity.as_ref().map(Components::values);
        InitialState {
            from: self.from,
            displacement: given("initial.displacement", displacement),
            velocity: given("initial.velocity", velocity),
        }
    }
}

/// What only static questions (`jeffcott bearing`) ask.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
pub struct StaticInput {
    /// Displacements that are given instead of loads, for instance { z = "10 um" }; the force
    /// that holds the shaft there is part of the answer.
    #[schemars(extend("examples" = [{ "z": "10 um" }]))]
    pub displacement: Option<Components<Length, Angle>>,
    /// Whether the unbalance force, mass times eccentricity times speed squared, acts as a static
    /// load along +X. Default: false.
    pub unbalance: bool,
}

impl StaticInput {
    /// The given displacements, m and rad.
    pub fn displacement(
        &self,
        loads: &[LoadInput],
        problems: &mut Problems<'_>,
    ) -> [Option<f64>; FREEDOMS] {
        let given = self.displacement.as_ref().map(Components::values);
        let given = given.unwrap_or_default();
        for (index, load) in loads.iter().enumerate() {
            let loaded = load.constant.as_ref().map(Components::values);
            let loaded = loaded.unwrap_or_default();
            let keys = KEYS.iter().zip(given).zip(loaded);
            for ((key, _), _) in keys.filter(|((_, given), loaded)| given.and(*loaded).is_some()) {
                let message =
                    format!("`{key}` has a load already: give its load or its displacement");
                let issue = Issue::new(format!("static.displacement.{key}"), message);
                let issue = issue.help("keep one of them");
                problems.refuse(issue.against(format!("load[{}].constant.{key}", index + 1)));
            }
        }
        given
    }
}
