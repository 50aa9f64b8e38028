//! Checks the tree against the schema, finding every problem in one pass.
//!
//! What passes is a JSON value that the structs of [`super::input`] deserialise from without
//! error. A required value that is wrong is replaced by its example, so that the checks that
//! follow can go on; [`Problems`] keeps them from speaking about it.

mod quantity;
mod range;
mod table;

use serde::de::DeserializeOwned;
use serde_json::{Number, Value};

use super::Issue;
use super::nearest::nearest;
use super::node::{Content, Node};
use super::problems::Problems;
pub(super) use range::Range;

/// The whole tree as a struct that `schema` describes; its required values may be examples where
/// [`Problems`] holds an issue about them.
pub(super) fn read<T: DeserializeOwned>(schema: &Value, problems: &mut Problems<'_>) -> Option<T> {
    let value = value(problems.root(), schema, "", problems)?;
    serde_json::from_value(value)
        .map_err(|error| problems.add(Issue::new("", error.to_string())))
        .ok()
}

/// The value of a node, if it is what the schema asks for.
pub(super) fn value(
    node: &Node,
    schema: &Value,
    path: &str,
    problems: &mut Problems<'_>,
) -> Option<Value> {
    if schema.get("x-dimension").is_some() {
        return quantity::quantity(node, schema, path, problems);
    }
    let choices = choices(schema);
    if !choices.is_empty() {
        return choice(node, &choices, &schema["successors"], path, problems);
    }
    if schema["type"].is_array() {
        return scalar(node, path, problems);
    }
    match (schema["type"].as_str()?, &node.content) {
        ("object", Content::Table(entries)) => table::table(node, entries, schema, path, problems),
        ("array", Content::List(items)) => list(node, items, schema, path, problems),
        ("string", Content::Text(text)) => Some(Value::String(text.clone())),
        ("boolean", Content::Switch(switch)) => Some(Value::Bool(*switch)),
        ("integer" | "number", Content::Integer(integer)) => {
            let number = Number::from(*integer);
            in_range(*integer as f64, number, node, schema, path, problems)
        }
        ("integer", Content::Number(number)) if number.fract() == 0.0 && number.abs() < 1e15 => {
            let whole = Number::from(*number as i64);
            in_range(*number, whole, node, schema, path, problems)
        }
        ("number", Content::Number(number)) => match Number::from_f64(*number) {
            Some(finite) => in_range(*number, finite, node, schema, path, problems),
            None => {
                let message = format!("`{}` must be a finite number", last(path));
                problems.add(Issue::new(path, message).at(Some(node.span.clone())));
                None
            }
        },
        (expected, content) => {
            problems.add(wrong_type(expected, content, path).at(Some(node.span.clone())));
            None
        }
    }
}

/// The key at the end of a path.
pub(super) fn last(path: &str) -> &str {
    let key = path.rsplit('.').next().unwrap_or(path);
    key.split('[').next().unwrap_or(key)
}

fn wrong_type(expected: &str, content: &Content, path: &str) -> Issue {
    let key = last(path);
    if key.is_empty() {
        let message = format!("a scenario is a table, not {}", content.kind());
        return Issue::new(path, message);
    }
    let (due, help) = match (expected, content) {
        ("object", Content::List(_)) => ("a table", Some(format!("write `[{key}]`, once"))),
        ("object", _) => ("a table", None),
        ("array", Content::Table(_)) => {
            let advice = format!("write `[[{key}]]`, once for each");
            ("a list of tables", Some(advice))
        }
        ("array", _) => ("a list", None),
        ("boolean", _) => ("true or false", None),
        ("integer", _) => ("a whole number", None),
        ("number", Content::Text(_)) => ("a number", Some("write it without quotes".to_owned())),
        ("number", _) => ("a number", None),
        _ => ("a string", Some("write it in quotes".to_owned())),
    };
    let given = match content {
        Content::Number(number) => number.to_string(),
        content => content.kind().to_owned(),
    };
    let mut issue = Issue::new(path, format!("`{key}` must be {due}, not {given}"));
    issue.help = help;
    issue
}

/// A quantity or a number, whose key is known only later.
fn scalar(node: &Node, path: &str, problems: &mut Problems<'_>) -> Option<Value> {
    let value = match &node.content {
        Content::Text(text) => Some(Value::from(text.clone())),
        Content::Integer(integer) => Some(Value::from(*integer)),
        Content::Number(number) => Number::from_f64(*number).map(Value::Number),
        _ => None,
    };
    if value.is_none() {
        let message = format!(
            "`{}` must be a finite number, or a number and a unit in quotes",
            last(path)
        );
        problems.add(Issue::new(path, message).at(Some(node.span.clone())));
    }
    value
}

fn in_range(
    number: f64,
    value: Number,
    node: &Node,
    schema: &Value,
    path: &str,
    problems: &mut Problems<'_>,
) -> Option<Value> {
    let range = Range::of_number(schema);
    if range.contains(number) {
        return Some(Value::Number(value));
    }
    let message = format!(
        "`{}` must be {}, not {value}",
        last(path),
        range.words(|limit| limit, "")
    );
    problems.add(Issue::new(path, message).at(Some(node.span.clone())));
    None
}

/// The words that an enumeration allows.
pub(super) fn choices(schema: &Value) -> Vec<&str> {
    let plain = schema["enum"].as_array().into_iter().flatten();
    let documented = schema["oneOf"].as_array().into_iter().flatten();
    plain
        .chain(documented.map(|variant| &variant["const"]))
        .filter_map(Value::as_str)
        .collect()
}

/// One of some words; `successors` has those that took the place of words that are gone.
fn choice(
    node: &Node,
    choices: &[&str],
    successors: &Value,
    path: &str,
    problems: &mut Problems<'_>,
) -> Option<Value> {
    let quoted: Vec<_> = choices.iter().map(|word| format!("\"{word}\"")).collect();
    let key = last(path);
    let written = match &node.content {
        Content::Text(text) if choices.contains(&text.as_str()) => {
            return Some(Value::String(text.clone()));
        }
        Content::Text(text) => text.as_str(),
        _ => "",
    };
    let message = format!("`{key}` must be one of {}", quoted.join(", "));
    let mut issue = Issue::new(path, message).at(Some(node.span.clone()));
    issue.help = successors[written]
        .as_str()
        .map(|word| format!("\"{written}\" is no longer there; \"{word}\" takes its place"))
        .or_else(|| {
            let near = nearest(written, choices.iter().copied());
            near.map(|word| format!("did you mean \"{word}\"?"))
        });
    problems.add(issue);
    None
}

fn list(
    node: &Node,
    items: &[Node],
    schema: &Value,
    path: &str,
    problems: &mut Problems<'_>,
) -> Option<Value> {
    if schema["minItems"]
        .as_u64()
        .is_some_and(|least| (items.len() as u64) < least)
    {
        let message = format!("`{}` must have at least one entry", last(path));
        problems.add(Issue::new(path, message).at(Some(node.span.clone())));
        return None;
    }
    if let Some(most) = schema["maxItems"].as_u64()
        && items.len() as u64 > most
    {
        let message = format!("`{}` must have at most {most} entries", last(path));
        problems.add(Issue::new(path, message).at(Some(node.span.clone())));
        return None;
    }
    let read = |(index, item)| {
        value(
            item,
            &schema["items"],
            &format!("{path}[{index}]"),
            problems,
        )
    };
    let values: Vec<_> = items.iter().enumerate().map(read).collect();
    values
        .into_iter()
        .collect::<Option<Vec<_>>>()
        .map(Value::Array)
}
