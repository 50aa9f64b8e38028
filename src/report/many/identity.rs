//! How two studies differ.

use serde_json::Value;

/// The first key in which two documents differ, with the values there and here.
pub(super) fn first_difference(there: &Value, here: &Value) -> Option<[String; 3]> {
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
                let [rest, there, here] = first_difference(there, here)?;
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
        let found = first_difference(&there, &here);
        assert_eq!(found, named("shaft.mass", "\"5 kg\"", "\"6 kg\""));
        let more = json!({"shaft": {"mass": "5 kg"}, "load": [1, 2], "film": true});
        assert_eq!(
            first_difference(&there, &more),
            named("film", "absent", "true")
        );
        assert_eq!(
            first_difference(&more, &there),
            named("film", "true", "absent")
        );
        assert_eq!(first_difference(&there, &there), None);
    }
}
