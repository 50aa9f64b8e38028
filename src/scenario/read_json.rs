//! JSON text to the tree, by the letter of RFC 8259.

use jsonc_parser::ast::{Object, Value};
use jsonc_parser::common::Ranged;
use jsonc_parser::{CollectOptions, ParseOptions, parse_to_ast};

use super::issue::Issue;
use super::node::{Content, Entry, Node};

const STRICT: ParseOptions = ParseOptions {
    allow_comments: false,
    allow_loose_object_property_names: false,
    allow_trailing_commas: false,
    allow_missing_commas: false,
    allow_single_quoted_strings: false,
    allow_hexadecimal_numbers: false,
    allow_unary_plus_numbers: false,
    allow_bare_decimal_point_numbers: false,
    allow_non_finite_numbers: false,
    allow_extended_string_escapes: false,
};

/// Reads the text, or says what keeps it from being JSON.
pub(super) fn read(text: &str) -> Result<Node, Vec<Issue>> {
    let parsed = parse_to_ast(text, &CollectOptions::default(), &STRICT).map_err(|error| {
        let range = error.range();
        let span = clamp(range.start, text)..clamp(range.end, text);
        vec![Issue::new("", format!("this is not JSON: {}", error.kind())).at(Some(span))]
    })?;
    let Some(value) = parsed.value else {
        return Err(vec![Issue::new("", "the file is empty")]);
    };
    let mut duplicates = Vec::new();
    let root = node(&value, &mut duplicates);
    if duplicates.is_empty() {
        Ok(root)
    } else {
        Err(duplicates)
    }
}

/// The nearest place not after `place` that starts a character.
fn clamp(place: usize, text: &str) -> usize {
    (0..=place.min(text.len()))
        .rev()
        .find(|place| text.is_char_boundary(*place))
        .unwrap_or(0)
}

fn node(value: &Value<'_>, duplicates: &mut Vec<Issue>) -> Node {
    let content = match value {
        Value::StringLit(text) => Content::Text(text.value.to_string()),
        Value::NumberLit(number) => number_content(number.value),
        Value::BooleanLit(switch) => Content::Switch(switch.value),
        Value::NullKeyword(_) => Content::Null,
        Value::Array(array) => {
            let items = array.elements.iter();
            Content::List(items.map(|item| node(item, duplicates)).collect())
        }
        Value::Object(object) => table(object, duplicates),
    };
    Node {
        span: value.range().start..value.range().end,
        content,
    }
}

fn number_content(text: &str) -> Content {
    match text.parse() {
        Ok(integer) => Content::Integer(integer),
        Err(_) => Content::Number(text.parse().unwrap_or(f64::NAN)),
    }
}

fn table(object: &Object<'_>, duplicates: &mut Vec<Issue>) -> Content {
    let mut entries: Vec<Entry> = Vec::with_capacity(object.properties.len());
    let mut seen = std::collections::HashSet::new();
    for property in &object.properties {
        let key = property.name.as_str().to_owned();
        let range = property.name.range();
        let key_span = range.start..range.end;
        if !seen.insert(key.clone()) {
            let message = format!("duplicate key `{key}`");
            duplicates.push(Issue::new(&key, message).at(Some(key_span.clone())));
        }
        let node = node(&property.value, duplicates);
        entries.push(Entry {
            key,
            key_span,
            node,
        });
    }
    Content::Table(entries)
}
