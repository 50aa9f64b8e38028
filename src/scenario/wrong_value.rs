//! What is said of a value that is not what its key asks for, and of a key that is missing.

use serde_json::Value;

use super::Issue;
use super::node::Content;
use super::quantity::{self, Dimension, QuantityError, names, parse};
use super::range::Range;
use super::reader::{choices, last};

pub(super) fn wrong_type(expected: &str, content: &Content, schema: &Value, path: &str) -> Issue {
    let key = last(path);
    if key.is_empty() {
        let message = format!("a scenario is a table, not {}", content.kind());
        return Issue::new(path, message);
    }
    let (due, help) = match (expected, content) {
        ("object", Content::List(_)) => ("a table", Some(format!("write `[{key}]`, once"))),
        ("object", Content::Plain(value)) => ("a table", table_of(key, value, schema)),
        ("object", _) => ("a table", None),
        ("array", Content::Table(_)) => {
            let advice = format!("write `[[{key}]]`, once for each");
            ("a list of tables", Some(advice))
        }
        ("array", _) => ("a list", None),
        ("boolean", _) => ("true or false", None),
        ("integer", _) => ("a whole number", None),
        ("number", Content::Plain(Value::String(text))) => {
            ("a number", Some(plain_number(key, text, schema)))
        }
        ("number", _) => ("a number", None),
        _ => ("a string", Some("write it in quotes".to_owned())),
    };
    let given = content.float().map(|number| number.to_string());
    let given = given.unwrap_or_else(|| content.kind().to_owned());
    let mut issue = Issue::new(path, format!("`{key}` must be {due}, not {given}"));
    issue.help = help;
    issue
}

/// How to write a table whose keys all have a value; none where it has other keys or many.
pub(super) fn table_of(key: &str, value: &Value, schema: &Value) -> Option<String> {
    let properties = schema["properties"].as_object()?;
    let fits = |property: &Value| check(value.as_str().unwrap_or_default(), property, "").is_ok();
    let fits = (1..=3).contains(&properties.len()) && properties.values().all(fits);
    let entries = properties.keys().map(|key| format!("{key} = {value}"));
    let entries: Vec<_> = entries.collect();
    fits.then(|| format!("write {key} = {{ {} }}", entries.join(", ")))
}

/// How to write the number that a text ends with, as "VG 68" does; a number with a unit after it may mean another one.
pub(super) fn plain_number(key: &str, text: &str, schema: &Value) -> String {
    let number = text.trim_start_matches(|c: char| c.is_alphabetic() || c.is_whitespace());
    let number = number.trim_end().parse::<f64>().ok();
    match number.filter(|number| Range::from_schema(schema).contains(*number)) {
        Some(number) => format!("write it without quotes: {key} = {number}"),
        None => "write a plain number, without quotes and unit".to_owned(),
    }
}

/// What keeps a text from being the quantity that the schema asks for.
pub(super) fn check(text: &str, schema: &Value, path: &str) -> Result<(), Issue> {
    let dimensions = Dimension::from_key(schema);
    let parsed = match parse(text, &dimensions) {
        Ok(parsed) => parsed,
        Err(QuantityError::NoUnit) => {
            return Err(needs_unit(schema, path).help(units_of(&dimensions)));
        }
        Err(QuantityError::NoNumber) => {
            let message = format!(
                "`{}` needs a number and a unit, {}",
                last(path),
                as_in(schema)
            );
            return Err(Issue::new(path, message));
        }
        Err(error) => return Err(no_quantity(error, text.trim(), &dimensions, path)),
    };
    let range = Range::from_schema(schema);
    if range.contains(parsed.si) {
        return Ok(());
    }
    let words = range.words(|limit| parsed.unit.readable(limit));
    let (key, unit, text) = (last(path), parsed.unit.symbol, text.trim());
    let message = format!("`{key}` must be {words} {unit}, not {text}");
    Err(Issue::new(path, message))
}

/// Why a text with a number and a unit is no quantity of some dimensions.
pub(super) fn no_quantity(
    error: QuantityError,
    text: &str,
    dimensions: &[Dimension],
    path: &str,
) -> Issue {
    let (key, due) = (last(path), names(dimensions));
    let refuse = |message: String| Issue::new(path, format!("`{key}`{message}"));
    let units = || units_of(dimensions);
    let alike = |unit: &str| {
        let alike = quantity::alike(unit, dimensions);
        let alike = (!alike.is_empty()).then(|| quoted(alike.iter().map(String::as_str), " or "));
        alike.map_or_else(units, |alike| format!("did you mean {alike}? {}", units()))
    };
    match error {
        QuantityError::NoNumber | QuantityError::NoUnit => {
            refuse(" needs a number and a unit".to_owned()).help(units())
        }
        QuantityError::NotFinite => refuse(format!(" must be finite, not `{text}`")),
        QuantityError::NotOneNumber => {
            let rule = "the decimal sign is a point, and nothing groups the digits";
            refuse(format!(": `{text}` does not begin with one number: {rule}"))
        }
        QuantityError::UnknownUnit(unit) => {
            refuse(format!(": `{unit}` is not a unit of {due}")).help(alike(&unit))
        }
        QuantityError::Ambiguous(unit, advice) => {
            refuse(format!(": `{unit}` can mean two units of different size")).help(advice)
        }
        QuantityError::WrongDimension(unit, Some(found)) => {
            let [due, found] = [due.as_str(), found.name()].map(with_article);
            refuse(format!(" is {due}, but `{text}` is {found}")).help(alike(&unit))
        }
        QuantityError::WrongDimension(unit, None) => {
            let due = with_article(&due);
            refuse(format!(" is {due}, and `{unit}` measures something else")).help(alike(&unit))
        }
    }
}

pub(super) fn with_article(name: &str) -> String {
    let article = if name.starts_with('a') { "an" } else { "a" };
    format!("{article} {name}")
}

pub(super) fn units_of(dimensions: &[Dimension]) -> String {
    let units = quantity::units(dimensions).join(", ");
    format!("units of {}, for instance: {units}", names(dimensions))
}

pub(super) fn needs_unit(schema: &Value, path: &str) -> Issue {
    let message = format!("`{}` needs a unit, {}", last(path), as_in(schema));
    Issue::new(path, message)
}

pub(super) fn as_in(schema: &Value) -> String {
    format!("as in {}", schema["examples"][0])
}

pub(super) fn missing_key(inner: &str, table: &str, schema: &Value) -> Issue {
    let key = last(inner);
    let message = format!("{table} needs `{key}`");
    let issue = Issue::new(inner, message);
    // in TOML the tables of a list bear the name of the list
    let table = inner.split('.').map(last).collect::<Vec<_>>().join(".");
    match (schema["type"].as_str(), example(schema)) {
        (Some("object"), _) => issue.help(format!("add a table `[{table}]`")),
        (_, Some(example)) if !example[0].is_object() => {
            issue.help(format!("for instance: {key} = {example}"))
        }
        (Some("array"), _) => issue.help(format!("add a table `[[{table}]]`")),
        _ => issue,
    }
}

/// A value that the schema shows as valid.
pub(super) fn example(schema: &Value) -> Option<Value> {
    let shown = schema["examples"].get(0).cloned();
    shown.or_else(|| choices(schema).first().map(|word| Value::from(*word)))
}

/// What stands for a wrong value of a key that has no default: an example, or a number in its range.
pub(super) fn stand_in(schema: &Value) -> Option<Value> {
    if !schema["default"].is_null() {
        return None;
    }
    let number = || match schema["type"].as_str()? {
        "number" => Some(Range::from_schema(schema).inside().into()),
        "integer" => Some((Range::from_schema(schema).inside().ceil() as i64).into()),
        _ => None,
    };
    example(schema).or_else(number)
}

/// Keys in quotes, joined.
pub(super) fn quoted<'a>(keys: impl Iterator<Item = &'a str>, between: &str) -> String {
    let quoted: Vec<_> = keys.map(|key| format!("`{key}`")).collect();
    quoted.join(between)
}
