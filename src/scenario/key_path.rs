//! Paths of keys: `bearing[2].preload`, and `bearing[*].preload` of every bearing.

use std::borrow::Cow;

use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};
use serde::{Deserialize, Serialize};
use serde_json::{Map, Value};

/// The path of a key, or the paths of several that change together; `*` stands for every entry of a list.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(untagged)]
pub(super) enum KeyPaths {
    One(String),
    Several(Vec<String>),
}

impl Default for KeyPaths {
    fn default() -> Self {
        Self::Several(Vec::new())
    }
}

impl KeyPaths {
    /// All of them.
    pub fn all(&self) -> &[String] {
        match self {
            Self::One(path) => std::slice::from_ref(path),
            Self::Several(paths) => paths,
        }
    }
}

impl JsonSchema for KeyPaths {
    fn schema_name() -> Cow<'static, str> {
        "key_paths".into()
    }

    fn json_schema(_: &mut SchemaGenerator) -> Schema {
        json_schema!({
            "type": ["string", "array"],
            "items": { "type": "string" },
            "minItems": 1,
            "maxItems": 64,
        })
    }
}

/// The path of a key in a table.
pub(super) fn join(table: &str, key: &str) -> String {
    if table.is_empty() {
        key.to_owned()
    } else {
        format!("{table}.{key}")
    }
}

/// The path of an entry of a list; people count from 1.
pub(super) fn entry(list: &str, index: usize) -> String {
    format!("{list}[{}]", index + 1)
}

/// The index of a step of a path, `2]` for the second entry of a list; none of another step.
pub(super) fn index(step: &str) -> Option<usize> {
    let number: usize = step.strip_suffix(']')?.parse().ok()?;
    number.checked_sub(1)
}

/// Whether a path is one of those that a pattern stands for.
pub(super) fn matches(pattern: &str, path: &str) -> bool {
    let [mut pattern, mut path] = [pattern, path].map(|path| path.split(['.', '[']));
    loop {
        match (pattern.next(), path.next()) {
            (None, None) => return true,
            (Some("*]"), Some(step)) if step.ends_with(']') => {}
            (Some(asked), Some(step)) if asked == step => {}
            _ => return false,
        }
    }
}

/// The value of a path, where there is one.
pub(super) fn value_at<'a>(tree: &'a Value, path: &str) -> Option<&'a Value> {
    let mut steps = path.split(['.', '[']);
    steps.try_fold(tree, |place, step| match index(step) {
        Some(index) => place.get(index),
        None => place.get(step),
    })
}

/// Sets the value of a path, making the tables that lead there.
pub(super) fn set_value(tree: &mut Value, path: &str, value: &Value) {
    let mut place = tree;
    for step in path.split(['.', '[']) {
        place = match index(step) {
            Some(index) => match place.get_mut(index) {
                Some(item) => item,
                None => return,
            },
            None => {
                if !place.is_object() {
                    *place = Value::Object(Map::new());
                }
                &mut place[step]
            }
        };
    }
    *place = value.clone();
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_star_stands_for_every_entry_of_a_list() {
        assert!(matches("bearing[*].preload", "bearing[12].preload"));
        assert!(matches("load[1].constant.z", "load[1].constant.z"));
        assert!(!matches(
            "bearing[*].preload",
            "bearing[1].geometry.preload"
        ));
        assert!(!matches("load[*].constant.z", "load[1].constant"));
        assert!(!matches("bearing.*", "bearing[1]"));
    }
}
