//! One thing that is wrong with a scenario, and the places that show it.

use std::ops::Range;

/// A problem of a scenario file.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Issue {
    /// Key path, for instance `bearing[0].geometry.balls`; empty for the file as a whole.
    pub path: String,
    /// What is wrong and which rule it breaks.
    pub message: String,
    /// Bytes of the text to underline, where one place is to blame.
    pub span: Option<Range<usize>>,
    /// Further places that take part in a contradiction.
    pub related: Vec<Range<usize>>,
    /// What to do about it.
    pub help: Option<String>,
}

impl Issue {
    /// A problem of a key that has no place yet.
    pub(super) fn new(path: impl Into<String>, message: impl Into<String>) -> Self {
        Self {
            path: path.into(),
            message: message.into(),
            span: None,
            related: Vec::new(),
            help: None,
        }
    }

    /// The same with its place in the text.
    pub(super) fn at(mut self, span: Option<Range<usize>>) -> Self {
        self.span = span;
        self
    }

    /// The same with advice.
    pub(super) fn help(mut self, advice: impl Into<String>) -> Self {
        self.help = Some(advice.into());
        self
    }
}
