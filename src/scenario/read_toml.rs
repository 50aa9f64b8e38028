//! TOML text to the tree.

use toml::Spanned;
use toml::de::{DeString, DeTable, DeValue};

use super::issue::Issue;
use super::node::{Content, Entry, Node};

/// Reads the text, or says everything that keeps it from being TOML.
pub(super) fn read(text: &str) -> Result<Node, Vec<Issue>> {
    let (root, errors) = DeTable::parse_recoverable(text);
    if errors.is_empty() {
        return Ok(Node {
            span: root.span(),
            content: table(root.get_ref()),
        });
    }
    let issues = errors.iter().map(|error| {
        let message = error.message().lines().collect::<Vec<_>>().join(", ");
        Issue::new("", format!("this is not TOML: {message}")).at(error.span())
    });
    Err(issues.collect())
}

fn table(table: &DeTable<'_>) -> Content {
    Content::Table(table.iter().map(entry).collect())
}

fn entry((key, value): (&Spanned<DeString<'_>>, &Spanned<DeValue<'_>>)) -> Entry {
    Entry {
        key: key.get_ref().to_string(),
        key_span: key.span(),
        node: node(value),
    }
}

fn node(value: &Spanned<DeValue<'_>>) -> Node {
    let content = match value.get_ref() {
        DeValue::String(text) => Content::Text(text.to_string()),
        DeValue::Integer(integer) => integer_content(integer.as_str(), integer.radix()),
        DeValue::Float(float) => Content::Number(float.as_str().parse().unwrap_or(f64::NAN)),
        DeValue::Boolean(switch) => Content::Switch(*switch),
        DeValue::Datetime(_) => Content::Date,
        DeValue::Array(items) => Content::List(items.iter().map(node).collect()),
        DeValue::Table(entries) => table(entries),
    };
    Node {
        span: value.span(),
        content,
    }
}

/// An integer beyond 64 bits is kept as the nearest number: the range check refuses it.
fn integer_content(digits: &str, radix: u32) -> Content {
    match i64::from_str_radix(digits, radix) {
        Ok(integer) => Content::Integer(integer),
        Err(_) => Content::Number(digits.parse().unwrap_or(f64::INFINITY)),
    }
}
