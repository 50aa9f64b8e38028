//! Values that a study or a fit puts in place of those of its scenario.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use serde_json::Value;

use super::Issue;
use super::axis::Scalar;
use super::key::{self, Key, all_keys};
use super::key_path::{KeyPaths, entry};
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
    /// Puts values into a scenario; the keys that were set.
    pub fn apply(
        all: &[Self],
        scenario: &mut Value,
        problems: &mut Problems<'_>,
    ) -> Option<Vec<Key>> {
        let known = all_keys(scenario, &[]);
        Self::put(all, &known, scenario, problems)
    }

    /// Puts values of known keys into a scenario; the keys that were set.
    pub fn put(
        all: &[Self],
        known: &[Key],
        scenario: &mut Value,
        problems: &mut Problems<'_>,
    ) -> Option<Vec<Key>> {
        let mut keys: Vec<Key> = Vec::new();
        problems.each("set", all, |set, problems| {
            let key = problems.take(key::find(known, set.key.all(), ".key"))?;
            // one of several keys may have another value than the rest
            let before = keys.iter().filter(|before| key.covers(before));
            if let Some(path) = before.filter_map(|before| key.shared_with(before)).next() {
                let message = format!("`{path}` is set already, and that value has no effect");
                problems.refuse(Issue::new(".key", message).help("remove one of them"));
                return None;
            }
            let value = key.read(&problems.path(".value"), problems)?;
            key.set(scenario, &value);
            keys.push(key);
            Some(())
        })?;
        Some(keys)
    }

    /// Refuses values of keys that are decided otherwise, as `why` says: they would have no effect.
    pub fn refuse_decided(set: &[Key], decided: &[Key], why: &str, problems: &mut Problems<'_>) {
        for (index, own) in set.iter().enumerate() {
            if let Some(path) = decided.iter().find_map(|key| own.shared_with(key)) {
                let issue = Issue::new(
                    format!(".{}.key", entry("set", index)),
                    format!("`{path}` {why}, and the value here has no effect"),
                );
                problems.refuse(issue.help("remove one of them"));
            }
        }
    }
}
