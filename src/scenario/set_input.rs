//! Values that a study or a fit puts in place of those of its scenario.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use serde_json::Value;

use super::axis::Scalar;
use super::key::{self, Key, all_keys};
use super::key_path::KeyPaths;
use super::problems::Problems;

/// One value that all runs have.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(super) struct SetInput {
    /// Path of the key of a number, or of a word out of several; "bearing[*].contact", or a list of paths, sets
    /// several keys.
    #[schemars(extend("examples" = ["time.duration", "model.contact"]))]
    pub key: KeyPaths,
    /// Its value, written as that key is.
    #[schemars(extend("examples" = ["0.5 s"]))]
    pub value: Scalar,
}

impl SetInput {
    /// Puts values into a scenario.
    pub fn apply(all: &[Self], scenario: &mut Value, problems: &mut Problems<'_>) -> Option<()> {
        let known = all_keys(scenario, &[]);
        Self::put(all, &known, scenario, problems)
    }

    /// Puts values of known keys into a scenario.
    pub fn put(
        all: &[Self],
        known: &[Key],
        scenario: &mut Value,
        problems: &mut Problems<'_>,
    ) -> Option<()> {
        let set = problems.each("set", all, |set, problems| {
            let key = problems.take(key::find(known, set.key.all(), ".key"))?;
            let value = key.read(&problems.path(".value"), problems)?;
            key.set(scenario, &value);
            Some(())
        });
        set.map(|_| ())
    }
}
