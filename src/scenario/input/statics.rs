//! `[static]`.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::components::{Components, KEYS};
use super::load::LoadInput;
use crate::rotor::FREEDOMS;
use crate::scenario::Issue;
use crate::scenario::problems::Problems;
use crate::scenario::quantity::{Angle, Length};

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
        let Some(displacement) = &self.displacement else {
            return [None; FREEDOMS];
        };
        let given = displacement.values();
        for (index, load) in loads.iter().enumerate() {
            let Some(constant) = &load.constant else {
                continue;
            };
            let loaded = constant.values();
            for (axis, key) in KEYS.into_iter().enumerate() {
                if given[axis].is_some() && loaded[axis].is_some() {
                    refuse_both(key, index, problems);
                }
            }
        }
        given
    }
}

/// Refuses a displacement of a freedom that has a load, too.
fn refuse_both(key: &str, load: usize, problems: &mut Problems<'_>) {
    let message = format!("`{key}` has a load already: give its load or its displacement");
    let issue = Issue::new(format!("static.displacement.{key}"), message).help("keep one of them");
    problems.refuse(issue.against(format!("load[{load}].constant.{key}")));
}
