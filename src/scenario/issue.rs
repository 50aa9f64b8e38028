//! One thing that is wrong with a scenario, and the places that show it.

use std::fmt;
use std::ops::Range;

use super::nearest::nearest;

/// A problem of a scenario file, or of a value on the command line.
#[derive(Debug, Clone, PartialEq, Eq)]
#[non_exhaustive]
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

impl std::error::Error for Issue {}

impl fmt::Display for Issue {
    /// What is wrong and what to do about it, in one line.
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.write_str(&self.message)?;
        match &self.help {
            Some(help) => write!(formatter, "; {help}"),
            None => Ok(()),
        }
    }
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

    /// The same with the nearest of the known words as advice, or with other advice where none is near.
    pub(super) fn help_nearest<'a>(
        self,
        written: &str,
        known: impl IntoIterator<Item = &'a str>,
        otherwise: &str,
    ) -> Self {
        match nearest(written, known) {
            Some(near) => self.help(format!("did you mean `{near}`?")),
            None => self.help(otherwise),
        }
    }

    /// The same as a contradiction to another key.
    pub(super) fn against(self, path: impl Into<String>) -> Contradiction {
        Contradiction::from(self).against(path)
    }

    /// The same as a contradiction to some keys.
    pub(super) fn against_all(
        self,
        paths: impl IntoIterator<Item = impl Into<String>>,
    ) -> Contradiction {
        paths.into_iter().fold(self.into(), Contradiction::against)
    }
}

/// A problem of one key together with others: these are shown too, and nothing is said where one of them is
/// wrong itself.
pub(super) struct Contradiction {
    /// The problem; its path is the key to change.
    pub issue: Issue,
    /// Paths of the others.
    pub others: Vec<String>,
}

impl From<Issue> for Contradiction {
    fn from(issue: Issue) -> Self {
        let others = Vec::new();
        Self { issue, others }
    }
}

impl Contradiction {
    /// The same to one more key.
    pub fn against(mut self, path: impl Into<String>) -> Self {
        self.others.push(path.into());
        self
    }
}
