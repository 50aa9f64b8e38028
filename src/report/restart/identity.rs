//! Whose restart file it is.

use std::fmt::Write;

use serde_json::Value;

use crate::report::bytes::Checksum;
use crate::simulate::Model;

/// What makes a run this one and no other.
#[derive(Debug, Clone, Copy)]
pub struct RunIdentity<'a> {
    /// The scenario with its defaults.
    pub scenario: &'a Value,
    /// What it asks for, with the content of the files that it names.
    pub model: &'a Model,
}

impl RunIdentity<'_> {
    /// A number that changes with everything that the integration sees.
    pub(super) fn fingerprint(&self) -> u64 {
        let mut checksum = Checksum::START;
        // writing to a checksum cannot fail
        let _ = write!(checksum, "{:?}", self.model);
        checksum.value()
    }
}

/// Keys of `[output]` that say how samples are written: a restart file holds them all, and a run that
/// goes on writes its files anew from the first sample.
const WRITTEN: [&str; 3] = ["formats", "every", "channels"];

/// The part of a scenario that decides what a restart file holds.
pub(super) fn of_the_motion(scenario: &Value) -> Value {
    let mut motion = scenario.clone();
    if let Some(Value::Object(output)) = motion.get_mut("output") {
        output.retain(|key, _| !WRITTEN.contains(&key.as_str()));
    }
    motion
}

/// The first key in which two scenarios differ, with the values there and here.
pub(in crate::report) fn difference(there: &Value, here: &Value) -> Option<[String; 3]> {
    let (Value::Object(entries), Value::Object(others)) = (there, here) else {
        return (there != here).then(|| [String::new(), there.to_string(), here.to_string()]);
    };
    let absent =
        |value: Option<&Value>| value.map_or_else(|| "absent".to_owned(), Value::to_string);
    let added = others.keys().filter(|key| !entries.contains_key(*key));
    entries
        .keys()
        .chain(added)
        .find_map(|key| match (entries.get(key), others.get(key)) {
            (Some(there), Some(here)) => {
                let [rest, there, here] = difference(there, here)?;
                let dot = if rest.is_empty() { "" } else { "." };
                Some([format!("{key}{dot}{rest}"), there, here])
            }
            (there, here) => Some([key.clone(), absent(there), absent(here)]),
        })
}

#[cfg(test)]
mod tests {
    use super::*;
    use serde_json::json;

    #[test]
    fn the_first_differing_key_is_named_with_its_path() {
        let there = json!({"shaft": {"mass": "5 kg"}, "load": [1, 2]});
        let here = json!({"shaft": {"mass": "6 kg"}, "load": [1, 2]});
        let named =
            |key: &str, there: &str, here: &str| Some([key, there, here].map(str::to_owned));
        let found = difference(&there, &here);
        assert_eq!(found, named("shaft.mass", "\"5 kg\"", "\"6 kg\""));
        let more = json!({"shaft": {"mass": "5 kg"}, "load": [1, 2], "film": true});
        assert_eq!(difference(&there, &more), named("film", "absent", "true"));
        assert_eq!(difference(&more, &there), named("film", "true", "absent"));
        assert_eq!(difference(&there, &there), None);
    }
}
