//! The tree that TOML and JSON (by the letter of RFC 8259) are read into: values with their places in the text.

use std::ops::Range;

use jsonc_parser::ast::{self, Object};
use jsonc_parser::common::Ranged;
use jsonc_parser::{CollectOptions, ParseOptions, parse_to_ast};
use serde_json::{Number, Value};
use toml::Spanned;
use toml::de::{DeTable, DeValue};

use super::key_path::index;
use super::problems::Issue;

/// A value and its place.
#[derive(Debug)]
pub(super) struct Node {
    /// Bytes of the text; for a TOML table, its header.
    pub span: Range<usize>,
    /// The value.
    pub content: Content,
}

/// A value of either format.
#[derive(Debug)]
pub(super) enum Content {
    /// A text, a number, a boolean or null.
    Plain(Value),
    /// An infinite number, or none.
    NotFinite(f64),
    Date,
    List(Vec<Node>),
    Table(Vec<Entry>),
}

/// A key and its value.
#[derive(Debug)]
pub(super) struct Entry {
    /// The key.
    pub key: String,
    /// Its place.
    pub key_span: Range<usize>,
    /// The value.
    pub node: Node,
}

impl From<&Value> for Node {
    /// The tree of a value that no text holds.
    fn from(value: &Value) -> Self {
        let content = match value {
            Value::Array(items) => Content::List(items.iter().map(Self::from).collect()),
            Value::Object(entries) => {
                let entry = |(key, value): (&String, &Value)| Entry {
                    key: key.clone(),
                    key_span: 0..0,
                    node: value.into(),
                };
                Content::Table(entries.iter().map(entry).collect())
            }
            plain => Content::Plain(plain.clone()),
        };
        Self {
            span: 0..0,
            content,
        }
    }
}

impl From<&Node> for Value {
    /// The value without its places; a date and a number that is not finite, which no key takes, are null.
    fn from(node: &Node) -> Self {
        match &node.content {
            Content::Plain(value) => value.clone(),
            Content::Date | Content::NotFinite(_) => Self::Null,
            Content::List(items) => items.iter().map(Self::from).collect(),
            Content::Table(entries) => {
                let entry = |entry: &Entry| (entry.key.clone(), Self::from(&entry.node));
                entries.iter().map(entry).collect()
            }
        }
    }
}

impl Content {
    /// The whole number, or else the number, that a text is.
    pub fn from_number(text: &str) -> Self {
        match text.parse::<i64>() {
            Ok(integer) => Self::Plain(integer.into()),
            Err(_) => Self::from_float(text.parse().unwrap_or(f64::NAN)),
        }
    }

    fn from_float(number: f64) -> Self {
        Number::from_f64(number).map_or(Self::NotFinite(number), |it| Self::Plain(it.into()))
    }

    /// The number, unless it is written as a whole one.
    pub fn float(&self) -> Option<f64> {
        match self {
            Self::Plain(Value::Number(number)) if number.is_f64() => number.as_f64(),
            Self::NotFinite(number) => Some(*number),
            _ => None,
        }
    }

    /// What the value is called in messages.
    pub fn kind(&self) -> &'static str {
        match self {
            Self::Plain(Value::String(_)) => "a string",
            Self::Plain(Value::Bool(_)) => "a boolean",
            Self::Plain(Value::Number(_)) | Self::NotFinite(_) => "a number",
            Self::Plain(_) => "null",
            Self::Date => "a date",
            Self::List(_) => "a list",
            Self::Table(_) => "a table",
        }
    }
}

impl Node {
    /// An empty table.
    pub fn table(span: Range<usize>) -> Self {
        Self {
            span,
            content: Content::Table(Vec::new()),
        }
    }

    /// This node with its values at other places of the text.
    pub fn moved(mut self, to: impl Fn(usize) -> usize + Copy) -> Self {
        let place = |span: &Range<usize>| to(span.start)..to(span.end);
        self.span = place(&self.span);
        self.content = match self.content {
            Content::List(items) => {
                Content::List(items.into_iter().map(|item| item.moved(to)).collect())
            }
            Content::Table(entries) => {
                let entry = |entry: Entry| Entry {
                    key_span: place(&entry.key_span),
                    node: entry.node.moved(to),
                    ..entry
                };
                Content::Table(entries.into_iter().map(entry).collect())
            }
            plain => plain,
        };
        self
    }

    /// The value of a path such as `bearing[1].geometry.balls`.
    pub fn find(&self, path: &str) -> Option<&Self> {
        path.split(['.', '['])
            .try_fold(self, |node, step| node.child(step))
    }

    /// Place of the value of a path; of a value that is missing, the innermost table that
    /// should hold it. The whole file has no place.
    pub fn locate(&self, path: &str) -> Option<Range<usize>> {
        let mut node = self;
        let mut found = None;
        for step in path.split(['.', '[']) {
            let Some(next) = node.child(step) else { break };
            node = next;
            found = Some(node.span.clone());
        }
        found
    }

    fn child(&self, step: &str) -> Option<&Self> {
        match &self.content {
            Content::Table(entries) => entries
                .iter()
                .find(|entry| entry.key == step)
                .map(|entry| &entry.node),
            Content::List(items) => items.get(index(step)?),
            _ => None,
        }
    }
}

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
pub(super) fn read_json(text: &str) -> Result<Node, Vec<Issue>> {
    let parsed = parse_to_ast(text, &CollectOptions::default(), &STRICT).map_err(|error| {
        let range = error.range();
        let span = clamp(range.start, text)..clamp(range.end, text);
        vec![Issue::new("", format!("this is not JSON: {}", error.kind())).at(Some(span))]
    })?;
    let Some(value) = parsed.value else {
        return Err(vec![Issue::new("", "the file is empty")]);
    };
    let mut duplicates = Vec::new();
    let root = json_node(&value, &mut duplicates);
    match duplicates.is_empty() {
        true => Ok(root),
        false => Err(duplicates),
    }
}

/// The nearest place not after `place` that starts a character.
fn clamp(place: usize, text: &str) -> usize {
    (0..=place.min(text.len()))
        .rev()
        .find(|place| text.is_char_boundary(*place))
        .unwrap_or(0)
}

fn json_node(value: &ast::Value<'_>, duplicates: &mut Vec<Issue>) -> Node {
    let content = match value {
        ast::Value::StringLit(text) => Content::Plain(text.value.as_ref().into()),
        ast::Value::NumberLit(number) => Content::from_number(number.value),
        ast::Value::BooleanLit(switch) => Content::Plain(switch.value.into()),
        ast::Value::NullKeyword(_) => Content::Plain(Value::Null),
        ast::Value::Array(array) => {
            let items = array.elements.iter();
            Content::List(items.map(|item| json_node(item, duplicates)).collect())
        }
        ast::Value::Object(object) => json_table(object, duplicates),
    };
    Node {
        span: value.range().start..value.range().end,
        content,
    }
}

fn json_table(object: &Object<'_>, duplicates: &mut Vec<Issue>) -> Content {
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
        let node = json_node(&property.value, duplicates);
        entries.push(Entry {
            key,
            key_span,
            node,
        });
    }
    Content::Table(entries)
}

/// Reads the text, or says everything that keeps it from being TOML.
pub(super) fn read_toml(text: &str) -> Result<Node, Vec<Issue>> {
    let (root, errors) = DeTable::parse_recoverable(text);
    if errors.is_empty() {
        return Ok(Node {
            span: root.span(),
            content: toml_table(root.get_ref()),
        });
    }
    let issues = errors.iter().map(|error| {
        let message = error.message().lines().collect::<Vec<_>>().join(", ");
        Issue::new("", format!("this is not TOML: {message}")).at(error.span())
    });
    Err(issues.collect())
}

fn toml_table(table: &DeTable<'_>) -> Content {
    let entries = table.iter().map(|(key, value)| Entry {
        key: key.get_ref().to_string(),
        key_span: key.span(),
        node: toml_node(value),
    });
    Content::Table(entries.collect())
}

fn toml_node(value: &Spanned<DeValue<'_>>) -> Node {
    let content = match value.get_ref() {
        DeValue::String(text) => Content::Plain(text.as_ref().into()),
        DeValue::Integer(integer) => {
            let digits = integer.as_str();
            match i64::from_str_radix(digits, integer.radix()) {
                Ok(integer) => Content::Plain(integer.into()),
                // beyond 64 bits it is kept as the nearest number: the range check refuses it
                Err(_) => Content::from_float(digits.parse().unwrap_or(f64::INFINITY)),
            }
        }
        DeValue::Float(float) => Content::from_float(float.as_str().parse().unwrap_or(f64::NAN)),
        DeValue::Boolean(switch) => Content::Plain((*switch).into()),
        DeValue::Datetime(_) => Content::Date,
        DeValue::Array(items) => Content::List(items.iter().map(toml_node).collect()),
        DeValue::Table(entries) => toml_table(entries),
    };
    Node {
        span: value.span(),
        content,
    }
}
