//! Checks the tree against the schema, finding every problem in one pass.
//!
//! What passes is a JSON value that the structs of [`super::spec`] deserialise from without
//! error. A required value that is wrong is replaced by its example, so that the checks that
//! follow can go on; [`Problems`] keeps them from speaking about it.

use serde_json::{Map, Number, Value};

use super::Issue;
use super::node::{Content, Entry, Node};
use super::problems::Problems;
use super::range::Range;
use super::walk_quantity::quantity;

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
        return choice(node, &choices, path, problems);
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

/// The known word nearest to what was written, if any is near.
pub(super) fn nearest<'a>(
    written: &str,
    known: impl IntoIterator<Item = &'a str>,
) -> Option<&'a str> {
    known
        .into_iter()
        .map(|word| (strsim::jaro_winkler(written, word), word))
        .filter(|(likeness, _)| *likeness > 0.75)
        .max_by(|a, b| a.0.total_cmp(&b.0))
        .map(|(_, word)| word)
}

fn wrong_type(expected: &str, content: &Content, path: &str) -> Issue {
    let key = last(path);
    let (due, help) = match (expected, content) {
        ("object", Content::List(_)) => ("a table", Some(format!("there is one: `[{key}]`"))),
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
    let key = if key.is_empty() { "scenario" } else { key };
    let mut issue = Issue::new(
        path,
        format!("`{key}` must be {due}, not {}", content.kind()),
    );
    issue.help = help;
    issue
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
fn choices(schema: &Value) -> Vec<&str> {
    let plain = schema["enum"].as_array().into_iter().flatten();
    let documented = schema["oneOf"].as_array().into_iter().flatten();
    plain
        .chain(documented.map(|variant| &variant["const"]))
        .filter_map(Value::as_str)
        .collect()
}

fn choice(node: &Node, choices: &[&str], path: &str, problems: &mut Problems<'_>) -> Option<Value> {
    let quoted: Vec<_> = choices.iter().map(|word| format!("\"{word}\"")).collect();
    let key = last(path);
    let written = match &node.content {
        Content::Text(text) if choices.contains(&text.as_str()) => {
            return Some(Value::String(text.clone()));
        }
        Content::Text(text) => text,
        _ => "",
    };
    let message = format!("`{key}` must be one of {}", quoted.join(", "));
    let mut issue = Issue::new(path, message).at(Some(node.span.clone()));
    issue.help =
        nearest(written, choices.iter().copied()).map(|word| format!("did you mean \"{word}\"?"));
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

fn table(
    node: &Node,
    entries: &[Entry],
    schema: &Value,
    path: &str,
    problems: &mut Problems<'_>,
) -> Option<Value> {
    let properties = schema["properties"].as_object()?;
    let mut values = Map::new();
    for entry in entries {
        match properties.get(&entry.key) {
            Some(property) => {
                let inner = join(path, &entry.key);
                if let Some(value) = value(&entry.node, property, &inner, problems) {
                    values.insert(entry.key.clone(), value);
                }
            }
            None => unknown_key(entry, entries, properties, path, problems),
        }
    }
    exclusive_keys(node, entries, schema, path, problems);
    if entries.is_empty() && schema["minProperties"].as_u64() == Some(1) {
        let known: Vec<_> = properties.keys().map(String::as_str).collect();
        let message = format!(
            "{} needs at least one of {}",
            table_name(path),
            quoted(&known, ", ")
        );
        problems.add(Issue::new(path, message).at(place_of(node, path)));
    }
    let required = schema["required"].as_array().into_iter().flatten();
    let mut complete = true;
    for key in required.filter_map(Value::as_str) {
        let inner = join(path, key);
        if !entries.iter().any(|entry| entry.key == key) && !problems.distrusts(&inner) {
            problems.add(missing_key(&inner, path, &properties[key]).at(place_of(node, path)));
        }
        if !values.contains_key(key) {
            match example(&properties[key]) {
                Some(example) => drop(values.insert(key.to_owned(), example)),
                None => complete = false,
            }
        }
    }
    complete.then_some(Value::Object(values))
}

fn join(path: &str, key: &str) -> String {
    if path.is_empty() {
        key.to_owned()
    } else {
        format!("{path}.{key}")
    }
}

/// What a table is called: `[shaft]`, or the scenario as a whole.
fn table_name(path: &str) -> String {
    if path.is_empty() {
        "the scenario".to_owned()
    } else {
        format!("`{path}`")
    }
}

/// The place to underline for what a table lacks; the whole file has none.
fn place_of(node: &Node, path: &str) -> Option<std::ops::Range<usize>> {
    (!path.is_empty()).then(|| node.span.clone())
}

fn unknown_key(
    entry: &Entry,
    entries: &[Entry],
    properties: &Map<String, Value>,
    path: &str,
    problems: &mut Problems<'_>,
) {
    let key = &entry.key;
    let message = format!("{} has no key `{key}`", table_name(path));
    let free: Vec<_> = properties
        .keys()
        .map(String::as_str)
        .filter(|known| !known.starts_with('$') && !entries.iter().any(|entry| entry.key == *known))
        .collect();
    let help = match nearest(key, free.iter().copied()) {
        Some(known) => {
            problems.distrust(&join(path, known));
            format!("did you mean `{known}`?")
        }
        None if free.is_empty() => "all keys that it knows are given".to_owned(),
        None => format!("it knows {}", quoted(&free, ", ")),
    };
    let issue = Issue::new(join(path, key), message).help(help);
    problems.add(issue.at(Some(entry.key_span.clone())));
}

fn missing_key(inner: &str, path: &str, schema: &Value) -> Issue {
    let key = last(inner);
    let message = format!("{} needs `{key}`", table_name(path));
    let issue = Issue::new(inner, message);
    match (schema["type"].as_str(), example(schema)) {
        (Some("object"), _) => issue.help(format!("add a table `[{inner}]`")),
        (Some("array"), _) => issue.help(format!("add a table `[[{inner}]]`")),
        (_, Some(example)) => issue.help(format!("for instance: {key} = {example}")),
        _ => issue,
    }
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
            let message = format!("{} needs one of {}", table_name(path), quoted(&group, ", "));
            problems.add(Issue::new(path, message).at(place_of(node, path)));
        }
        if given.len() > 1 {
            let keys: Vec<_> = given.iter().map(|entry| entry.key.as_str()).collect();
            let message = format!(
                "{} cannot have {} together",
                table_name(path),
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
