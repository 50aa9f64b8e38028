//! All problems of a file, shown with the lines that they stand on.

use std::fmt;
use std::ops::Range;

use annotate_snippets::{AnnotationKind, Group, Level, Origin, Renderer, Snippet};
use serde_json::{Value, json};

use super::Issue;

/// More problems than this are counted, not shown.
const MOST_SHOWN: usize = 100;

/// A scenario that cannot be run: everything that is wrong with it.
#[derive(Debug, Clone, PartialEq, Eq)]
#[non_exhaustive]
pub struct ScenarioError {
    /// File name as given.
    pub name: String,
    /// Text of the file; empty where it could not be read.
    pub text: String,
    /// The problems in the order of the file, at least one.
    pub issues: Vec<Issue>,
}

impl std::error::Error for ScenarioError {}

impl fmt::Display for ScenarioError {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.write_str(&self.render(false))
    }
}

impl ScenarioError {
    /// Sorts the problems by their place.
    pub(super) fn new(name: &str, text: &str, mut issues: Vec<Issue>) -> Self {
        issues.sort_by_key(|issue| issue.span.as_ref().map_or(0, |span| span.start));
        Self {
            name: name.to_owned(),
            text: text.to_owned(),
            issues,
        }
    }

    /// Every problem with its line, the place underlined, and a closing count. Without colour
    /// the text has no control sequences.
    pub fn render(&self, color: bool) -> String {
        let renderer = if color {
            Renderer::styled()
        } else {
            Renderer::plain()
        };
        let mut rendered = String::new();
        for issue in self.issues.iter().take(MOST_SHOWN) {
            rendered.push_str(&renderer.render(&[self.group(issue)]));
            rendered.push_str("\n\n");
        }
        let noun = if self.issues.len() == 1 {
            "problem"
        } else {
            "problems"
        };
        let hidden = match self.issues.len().saturating_sub(MOST_SHOWN) {
            0 => String::new(),
            count => format!(", {count} of them not shown"),
        };
        rendered + &format!("{}: {} {noun}{hidden}\n", self.name, self.issues.len())
    }

    fn group<'a>(&'a self, issue: &'a Issue) -> Group<'a> {
        let title = Level::ERROR.primary_title(&issue.message);
        let group = match &issue.span {
            Some(span) => title.element(self.snippet(span, &issue.related)),
            None => title.element(Origin::path(&self.name)),
        };
        match &issue.help {
            Some(help) => group.element(Level::HELP.message(help)),
            None => group,
        }
    }

    fn snippet<'a>(
        &'a self,
        span: &Range<usize>,
        related: &[Range<usize>],
    ) -> Snippet<'a, annotate_snippets::Annotation<'a>> {
        let others = related
            .iter()
            .map(|other| AnnotationKind::Context.span(other.clone()));
        Snippet::source(&self.text)
            .path(&self.name)
            .annotation(AnnotationKind::Primary.span(span.clone()))
            .annotations(others)
    }

    /// The same for programs: for each problem its key, message, line, column and help.
    pub fn issues_json(&self) -> Value {
        let newlines = self.text.match_indices('\n').map(|(place, _)| place + 1);
        let lines: Vec<_> = std::iter::once(0).chain(newlines).collect();
        let issues = self.issues.iter().map(|issue| {
            let place = issue.span.as_ref();
            let place = place.map(|span| self.line_column(span.start, &lines));
            json!({
                "key": issue.path,
                "message": issue.message,
                "line": place.map(|(line, _)| line),
                "column": place.map(|(_, column)| column),
                "help": issue.help,
            })
        });
        Value::Array(issues.collect())
    }

    /// Line and column of a byte, both from 1, the column in characters; `lines` holds the byte
    /// that each line starts at.
    fn line_column(&self, byte: usize, lines: &[usize]) -> (usize, usize) {
        let line = lines.partition_point(|start| *start <= byte);
        let before = &self.text.as_bytes()[lines[line - 1]..byte.min(self.text.len())];
        (line, String::from_utf8_lossy(before).chars().count() + 1)
    }
}
