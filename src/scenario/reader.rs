//! Checks the tree against the schema, finding every problem in one pass.
//!
//! What passes is a JSON value that the structs of [`super::input`] deserialise from without
//! error. A required value that is wrong is replaced by its example, so that the checks that
//! follow can go on; [`Problems`] keeps them from speaking about it.

use std::collections::HashSet;

use serde::de::DeserializeOwned;
use serde_json::{Map, Number, Value};

use super::Issue;
use super::key::join;
use super::node::{Content, Entry, Node};
use super::problems::{Problems, nearest};
use super::quantity::{Dimension, QuantityError, parse};

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
        return quantity(node, schema, path, problems);
    }
    let choices = choices(schema);
    if !choices.is_empty() {
        return choice(node, &choices, &schema["successors"], path, problems);
    }
    if schema["type"].is_array() {
        return scalar(node, path, problems);
    }
    match (schema["type"].as_str()?, &node.content) {
        ("object", Content::Table(entries)) => table(node, entries, schema, path, problems),
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

/// Limits of a number.
#[derive(Debug, Clone, Copy, Default)]
pub(in crate::scenario) struct Range {
    minimum: Option<f64>,
    above: Option<f64>,
    maximum: Option<f64>,
}

impl Range {
    /// Limits of a plain number.
    pub fn of_number(schema: &Value) -> Self {
        Self {
            minimum: schema["minimum"].as_f64(),
            above: schema["exclusiveMinimum"].as_f64(),
            maximum: schema["maximum"].as_f64(),
        }
    }

    /// Limits of a quantity, in SI units.
    pub fn of_quantity(schema: &Value) -> Self {
        let above = schema["x-above"].as_f64();
        Self {
            minimum: schema["x-minimum"].as_f64().filter(|_| above.is_none()),
            above,
            maximum: schema["x-maximum"].as_f64(),
        }
    }

    /// Whether the number is inside.
    pub fn contains(&self, number: f64) -> bool {
        self.minimum.is_none_or(|minimum| number >= minimum)
            && self.above.is_none_or(|above| number > above)
            && self.maximum.is_none_or(|maximum| number <= maximum)
    }

    /// The range in words, each limit converted for the reader, with the unit.
    pub fn words(&self, convert: impl Fn(f64) -> f64, unit: &str) -> String {
        let unit = if unit.is_empty() {
            String::new()
        } else {
            format!(" {unit}")
        };
        let shown = |limit: f64| readable(convert(limit));
        let lower = match (self.minimum, self.above) {
            (Some(minimum), _) => Some(format!("at least {}", shown(minimum))),
            (None, Some(above)) => Some(format!("above {}", shown(above))),
            (None, None) => None,
        };
        let upper = self
            .maximum
            .map(|maximum| format!("at most {}", shown(maximum)));
        let limits: Vec<_> = lower.into_iter().chain(upper).collect();
        limits.join(" and ") + &unit
    }
}

/// Whole and ordinary numbers plainly, very large and very small ones with an exponent.
fn readable(number: f64) -> String {
    let size = number.abs();
    if number == 0.0 || (1e-3..1e6).contains(&size) {
        format!("{number}")
    } else {
        format!("{number:e}")
    }
}

/// The text of the quantity, if it is one of the right dimension and in its range.
fn quantity(node: &Node, schema: &Value, path: &str, problems: &mut Problems<'_>) -> Option<Value> {
    let checked = match &node.content {
        Content::Text(text) => check(text, schema, path).map(|()| Value::from(text.clone())),
        Content::Integer(_) | Content::Number(_) => Err(needs_unit(schema, path)),
        content => {
            let message = format!(
                "`{}` must be a number and a unit in quotes, not {}",
                last(path),
                content.kind()
            );
            Err(Issue::new(path, message).help(as_in(schema)))
        }
    };
    checked
        .map_err(|issue| problems.add(issue.at(Some(node.span.clone()))))
        .ok()
}

fn check(text: &str, schema: &Value, path: &str) -> Result<(), Issue> {
    let key = last(path);
    let Some(dimension) = schema["x-dimension"].as_str().and_then(Dimension::named) else {
        return Ok(());
    };
    let parsed = parse(text, dimension).map_err(|error| refusal(error, dimension, schema, path))?;
    let range = Range::of_quantity(schema);
    if range.contains(parsed.si) {
        return Ok(());
    }
    let words = range.words(|limit| parsed.unit.readable(limit), parsed.unit.symbol);
    let message = format!("`{key}` must be {words}, not {}", text.trim());
    Err(Issue::new(path, message))
}

fn needs_unit(schema: &Value, path: &str) -> Issue {
    let message = format!("`{}` needs a unit, {}", last(path), as_in(schema));
    Issue::new(path, message)
}

fn as_in(schema: &Value) -> String {
    format!("as in {}", schema["examples"][0])
}

fn refusal(error: QuantityError, dimension: Dimension, schema: &Value, path: &str) -> Issue {
    let key = last(path);
    let units = format!("units of {}: {}", dimension.name(), dimension.unit_list());
    match error {
        QuantityError::NoUnit { .. } => needs_unit(schema, path).help(units),
        QuantityError::NoNumber { .. } => {
            let message = format!("`{key}` needs a number and a unit, {}", as_in(schema));
            Issue::new(path, message)
        }
        QuantityError::NotFinite { text } => {
            Issue::new(path, format!("`{key}` must be finite, not `{text}`"))
        }
        QuantityError::UnknownUnit { unit } => {
            let symbols = dimension.units().iter().map(|unit| unit.symbol);
            let help = match nearest(&unit, symbols) {
                Some(known) => format!("did you mean `{known}`? {units}"),
                None => units,
            };
            Issue::new(
                path,
                format!("`{key}`: `{unit}` is not a unit of {}", dimension.name()),
            )
            .help(help)
        }
        QuantityError::WrongDimension { text, found } => {
            let message = format!(
                "`{key}` is {}, but `{text}` is {}",
                dimension.with_article(),
                found.with_article()
            );
            Issue::new(path, message).help(units)
        }
        QuantityError::DecimalComma { .. } => Issue::new(path, format!("`{key}`: {error}")),
    }
}

/// The table with every key that is right, its required keys filled up by examples.
fn table(
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
