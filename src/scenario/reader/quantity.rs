//! Checks one quantity of the tree: number, unit, dimension, range.

use serde_json::Value;

use super::last;
use super::range::Range;
use crate::scenario::Issue;
use crate::scenario::dimension::Dimension;
use crate::scenario::nearest::nearest;
use crate::scenario::node::{Content, Node};
use crate::scenario::problems::Problems;
use crate::scenario::quantity::{QuantityError, parse};

/// The text of the quantity, if it is one of the right dimension and in its range.
pub(super) fn quantity(
    node: &Node,
    schema: &Value,
    path: &str,
    problems: &mut Problems<'_>,
) -> Option<Value> {
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
