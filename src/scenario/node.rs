//! The tree that both formats are read into: values with their places in the text.

use std::ops::Range;

use serde_json::Value;

/// A value and where it stands.
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
    Text(String),
    Integer(i64),
    Number(f64),
    Switch(bool),
    Date,
    Null,
    List(Vec<Node>),
    Table(Vec<Entry>),
}

/// A key and its value.
#[derive(Debug)]
pub(super) struct Entry {
    /// The key.
    pub key: String,
    /// Where the key stands.
    pub key_span: Range<usize>,
    /// The value.
    pub node: Node,
}

impl From<&Value> for Node {
    /// The tree of a value that no text holds.
    fn from(value: &Value) -> Self {
        let content = match value {
            Value::Null => Content::Null,
            Value::Bool(switch) => Content::Switch(*switch),
            Value::Number(number) => number.as_i64().map_or_else(
                || Content::Number(number.as_f64().unwrap_or(f64::NAN)),
                Content::Integer,
            ),
            Value::String(text) => Content::Text(text.clone()),
            Value::Array(items) => Content::List(items.iter().map(Self::from).collect()),
            Value::Object(entries) => {
                let entry = |(key, value): (&String, &Value)| Entry {
                    key: key.clone(),
                    key_span: 0..0,
                    node: value.into(),
                };
                Content::Table(entries.iter().map(entry).collect())
            }
        };
        Self {
            span: 0..0,
            content,
        }
    }
}

impl Content {
    /// What the value is called in messages.
    pub fn kind(&self) -> &'static str {
        match self {
            Self::Text(_) => "a string",
            Self::Integer(_) | Self::Number(_) => "a number",
            Self::Switch(_) => "a boolean",
            Self::Date => "a date",
            Self::Null => "null",
            Self::List(_) => "a list",
            Self::Table(_) => "a table",
        }
    }
}

impl Node {
    /// The value of a path such as `bearing[0].geometry.balls`.
    pub fn find(&self, path: &str) -> Option<&Self> {
        path.split(['.', '['])
            .try_fold(self, |node, step| node.child(step))
    }

    /// Where the value of a path stands; of a value that is missing, the innermost table that
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
            Content::List(items) => items.get(step.strip_suffix(']')?.parse::<usize>().ok()?),
            _ => None,
        }
    }
}
