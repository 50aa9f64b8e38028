//! Checks the keys of a table: unknown, missing, excluding each other.

use std::collections::HashSet;

use serde_json::{Map, Value};

use super::{choices, last, value};
use crate::scenario::Issue;
use crate::scenario::key::join;
use crate::scenario::nearest::nearest;
use crate::scenario::node::{Entry, Node};
use crate::scenario::problems::Problems;

/// The table with every key that is right, its required keys filled up by examples.
pub(super) fn table(
    node: &Node,
    entries: &[Entry],
    schema: &Value,
    path: &str,
    problems: &mut Problems<'_>,
) -> Option<Value> {
    let properties = schema["properties"].as_object()?;
    let given: HashSet<_> = entries.iter().map(|entry| entry.key.as_str()).collect();
    let mut values = Map::new();
    for entry in entries {
        match properties.get(&entry.key) {
            Some(property) => {
                let inner = join(path, &entry.key);
                if let Some(value) = value(&entry.node, property, &inner, problems) {
                    values.insert(entry.key.clone(), value);
                }
            }
            None => unknown_key(entry, &given, properties, path, problems),
        }
    }
    exclusive_keys(node, entries, schema, path, problems);
    if entries.is_empty() && schema["minProperties"].as_u64() == Some(1) {
        let known: Vec<_> = properties.keys().map(String::as_str).collect();
        let message = format!(
            "{} needs at least one of {}",
            table_name(path, problems),
            quoted(&known, ", ")
        );
        problems.add(Issue::new(path, message).at(place_of(node, path)));
    }
    let complete = fill_required(node, &given, &mut values, schema, path, problems);
    complete.then_some(Value::Object(values))
}

/// Reports the required keys that are missing and puts examples in place of those that are
/// missing or wrong; false where there is none to put.
fn fill_required(
    node: &Node,
    given: &HashSet<&str>,
    values: &mut Map<String, Value>,
    schema: &Value,
    path: &str,
    problems: &mut Problems<'_>,
) -> bool {
    let required = schema["required"].as_array().into_iter().flatten();
    let mut complete = true;
    for key in required.filter_map(Value::as_str) {
        let inner = join(path, key);
        let property = &schema["properties"][key];
        if !given.contains(key) && !problems.distrusts(&inner) {
            problems.add(
                missing_key(&inner, &table_name(path, problems), property).at(place_of(node, path)),
            );
        }
        if !values.contains_key(key) {
            match example(property) {
                Some(example) => drop(values.insert(key.to_owned(), example)),
                None => complete = false,
            }
        }
    }
    complete
}

/// What a table is called: `[shaft]`, or the file as a whole.
fn table_name(path: &str, problems: &Problems<'_>) -> String {
    if path.is_empty() {
        problems.subject().to_owned()
    } else {
        format!("`{path}`")
    }
}

/// The place to underline for what a table lacks; the whole file has none.
fn place_of(node: &Node, path: &str) -> Option<std::ops::Range<usize>> {
    (!path.is_empty()).then(|| node.span.clone())
}

/// Keys that are gone, and what to do about them.
const GONE: [(&str, &str); 1] = [(
    "side_by_side",
    "leave it out: every run is integrated by itself",
)];

fn unknown_key(
    entry: &Entry,
    given: &HashSet<&str>,
    properties: &Map<String, Value>,
    path: &str,
    problems: &mut Problems<'_>,
) {
    let key = &entry.key;
    let message = format!("{} has no key `{key}`", table_name(path, problems));
    let known = properties.keys().map(String::as_str);
    let known: Vec<_> = known.filter(|known| !known.starts_with('$')).collect();
    let free = known.iter().copied().filter(|known| !given.contains(known));
    let gone = GONE.iter().find(|(gone, _)| gone == key);
    let help = match (gone, nearest(key, free)) {
        (Some((_, help)), _) => (*help).to_owned(),
        (None, Some(known)) => {
            problems.distrust(&join(path, known));
            format!("did you mean `{known}`?")
        }
        (None, None) => format!("it knows {}", quoted(&known, ", ")),
    };
    let issue = Issue::new(join(path, key), message).help(help);
    problems.add(issue.at(Some(entry.key_span.clone())));
}

fn missing_key(inner: &str, table: &str, schema: &Value) -> Issue {
    let key = last(inner);
    let message = format!("{table} needs `{key}`");
    let issue = Issue::new(inner, message);
    // in TOML the tables of a list bear the name of the list
    let table = without_indices(inner);
    match (schema["type"].as_str(), example(schema)) {
        (Some("object"), _) => issue.help(format!("add a table `[{table}]`")),
        (_, Some(example)) if !example[0].is_object() => {
            issue.help(format!("for instance: {key} = {example}"))
        }
        (Some("array"), _) => issue.help(format!("add a table `[[{table}]]`")),
        _ => issue,
    }
}

/// `spectrum[0].band` as `spectrum.band`.
fn without_indices(path: &str) -> String {
    let steps = path.split('.');
    let names = steps.map(|step| step.split('[').next().unwrap_or_default());
    names.collect::<Vec<_>>().join(".")
}

/// A value that the schema shows as valid.
fn example(schema: &Value) -> Option<Value> {
    let shown = schema["examples"].get(0).cloned();
    shown.or_else(|| choices(schema).first().map(|word| Value::from(*word)))
}

/// The keys of which a table may have one only, and those of which it must have one.
fn exclusive_keys(
    node: &Node,
    entries: &[Entry],
    schema: &Value,
    path: &str,
    problems: &mut Problems<'_>,
) {
    for (extension, one_is_due) in [("x-at-most-one", false), ("x-exactly-one", true)] {
        let Some(group) = schema[extension].as_array() else {
            continue;
        };
        let group: Vec<_> = group.iter().filter_map(Value::as_str).collect();
        let given: Vec<_> = entries
            .iter()
            .filter(|entry| group.contains(&entry.key.as_str()))
            .collect();
        let expected = group.iter().any(|key| problems.distrusts(&join(path, key)));
        if given.is_empty() && one_is_due && !expected {
            let message = format!(
                "{} needs one of {}",
                table_name(path, problems),
                quoted(&group, ", ")
            );
            problems.add(Issue::new(path, message).at(place_of(node, path)));
        }
        if given.len() > 1 {
            let keys: Vec<_> = given.iter().map(|entry| entry.key.as_str()).collect();
            let message = format!(
                "{} cannot have {} together",
                table_name(path, problems),
                quoted(&keys, " and ")
            );
            let mut issue = Issue::new(join(path, keys[1]), message).help("keep one of them");
            issue.related = given
                .iter()
                .filter(|entry| entry.key != keys[1])
                .map(|entry| entry.key_span.clone())
                .collect();
            problems.add(issue.at(Some(given[1].key_span.clone())));
        }
    }
}

/// Keys in quotes, joined.
fn quoted(keys: &[&str], between: &str) -> String {
    let quoted: Vec<_> = keys.iter().map(|key| format!("`{key}`")).collect();
    quoted.join(between)
}
