//! The five freedoms as keys of an inline table.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::rotor::{FREEDOMS, Freedoms};
use crate::scenario::Issue;
use crate::scenario::problems::Problems;
use crate::scenario::quantity::{Measure, Quantity, si};
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

impl<T, R> Components<T, R> {
    /// The given values in SI units.
    pub fn values(&self) -> [Option<f64>; FREEDOMS] {
        [
            si(&self.x),
            si(&self.y),
            si(&self.z),
            si(&self.tilt_x),
            si(&self.tilt_y),
        ]
    }

    /// Refuses what is given for the freedoms from `first_held` on: they do not move.
    pub fn refuse_held(
        &self,
        path: &str,
        first_held: usize,
        freedoms: Freedoms,
        problems: &mut Problems<'_>,
    ) {
        for (index, value) in self.values().into_iter().enumerate().skip(first_held) {
            if value.is_some() {
                refuse_held_key(&format!("{path}.{}", KEYS[index]), freedoms, problems);
            }
        }
    }
}

/// Refuses a key of a freedom that does not move.
pub fn refuse_held_key(path: &str, freedoms: Freedoms, problems: &mut Problems<'_>) {
    let key = last(path);
    let (name, wider) = match freedoms {
        Freedoms::Radial if key == "z" => ("radial", "\"translational\" or \"all\""),
        Freedoms::Radial => ("radial", "\"all\""),
        Freedoms::Translational => ("translational", "\"all\""),
        Freedoms::All => return,
    };
    let message = format!("`{key}` has nothing to act on: freedoms = \"{name}\" holds it");
    let help = format!("remove it, or set freedoms = {wider}");
    problems.refuse(
        Issue::new(path, message)
            .help(help)
            .against("shaft.freedoms"),
    );
}
