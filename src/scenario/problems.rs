//! What is wrong with a scenario: collected while it is read and checked, shown with their lines.

use std::ops::Range;
use std::path::Path;

use annotate_snippets::{AnnotationKind, Group, Level, Origin, Renderer, Snippet};
use serde_json::{Value, json};

use super::key_path::{entry, join};
use super::node::Node;
use super::visible;

/// Everything found so far, with the keys that later checks must not be believed about.
pub(super) struct Problems<'a> {
    /// The whole tree.
    pub root: &'a Node,
    /// The folder that the files named in the scenario are relative to.
    pub folder: &'a Path,
    /// What messages call the file as a whole.
    pub subject: &'static str,
    table: String,
    /// What is wrong so far.
    pub issues: Vec<Issue>,
    faulty: Vec<String>,
    /// What the user should know although the scenario can be run.
    pub warnings: Vec<String>,
}

impl<'a> Problems<'a> {
    /// Nothing found yet in a scenario whose file lies in `folder`.
    pub fn new(root: &'a Node, folder: &'a Path) -> Self {
        Self {
            root,
            folder,
            subject: "the scenario",
            table: String::new(),
            issues: Vec::new(),
            faulty: Vec::new(),
            warnings: Vec::new(),
        }
    }

    /// Nothing found yet in another kind of file.
    pub fn about(self, subject: &'static str) -> Self {
        Self { subject, ..self }
    }

    /// Adds a problem of one key; what it stands for is not trusted from here on.
    pub fn add(&mut self, issue: Issue) {
        self.mark_faulty(&issue.path);
        let place = issue.span.clone();
        let place = place.or_else(|| self.root.locate(&issue.path));
        self.issues.push(issue.at(place));
    }

    /// Leaves a key out of later checks: it is known to be wrong or misspelled.
    pub fn mark_faulty(&mut self, path: &str) {
        self.faulty.push(path.to_owned());
    }

    /// Whether a key, or a table that holds it, has a problem already.
    pub fn is_faulty(&self, path: &str) -> bool {
        self.faulty.iter().any(|faulty| holds(faulty, path))
    }

    /// Whether a key, a table that holds it, or anything in it has a problem already.
    pub fn has_fault(&self, path: &str) -> bool {
        self.is_faulty(path) || self.faulty.iter().any(|faulty| holds(path, faulty))
    }

    /// Checks a table inside of the present one: there a path that begins with a point is one of its keys.
    pub fn inside<T>(&mut self, table: impl AsRef<str>, check: impl FnOnce(&mut Self) -> T) -> T {
        let inner = join(&self.table, table.as_ref());
        let outer = std::mem::replace(&mut self.table, inner);
        let checked = check(self);
        self.table = outer;
        checked
    }

    /// Checks what a key of the present table holds: `Some(None)` where it is not given, `None` where it has no result.
    pub fn given<I, T>(
        &mut self,
        key: &str,
        input: &Option<I>,
        build: impl FnOnce(&I, &mut Self) -> Option<T>,
    ) -> Option<Option<T>> {
        match input {
            Some(input) => self
                .inside(key, |problems| build(input, problems))
                .map(Some),
            None => Some(None),
        }
    }

    /// Checks every entry of a list of the present table; there is no result where one entry has none.
    pub fn each<I, T>(
        &mut self,
        key: &str,
        inputs: &[I],
        mut build: impl FnMut(&I, &mut Self) -> Option<T>,
    ) -> Option<Vec<T>> {
        let build =
            |(index, input)| self.inside(entry(key, index), |problems| build(input, problems));
        let built: Vec<_> = inputs.iter().enumerate().map(build).collect();
        built.into_iter().collect()
    }

    /// The whole path of a key of the present table, which begins with a point, or of any other.
    pub fn path(&self, path: &str) -> String {
        match path.strip_prefix('.') {
            Some("") => self.table.clone(),
            Some(key) => join(&self.table, key),
            None => path.to_owned(),
        }
    }

    /// Adds a problem of a checked value, unless a key that it rests on has one already.
    pub fn refuse(&mut self, mut issue: Issue) {
        let paths = std::iter::once(&mut issue.path);
        for path in paths.chain(issue.related.iter_mut().map(|(path, _)| path)) {
            *path = self.path(path);
            if self.has_fault(path) {
                return;
            }
        }
        issue.span = self.root.locate(&issue.path);
        for (path, place) in &mut issue.related {
            *place = self.node(path).map(|node| node.span.clone());
        }
        let own = issue.span.as_ref();
        issue
            .related
            .retain(|(_, place)| place.is_some() && place.as_ref() != own);
        self.issues.push(issue);
    }

    /// The value, unless there is a problem instead, which is refused.
    pub fn take<T>(&mut self, checked: Result<T, Issue>) -> Option<T> {
        checked.map_err(|issue| self.refuse(issue)).ok()
    }

    /// The value of a path as it was written.
    pub fn node(&self, path: &str) -> Option<&'a Node> {
        self.root.find(path)
    }

    /// Notes what the user should know although the scenario can be run.
    pub fn warn(&mut self, warning: impl Into<String>) {
        let warning = warning.into();
        if !self.warnings.contains(&warning) {
            self.warnings.push(warning);
        }
    }
}

/// Whether a path is that of a table or list, or one inside of it.
fn holds(table: &str, path: &str) -> bool {
    let rest = path.strip_prefix(table).filter(|_| !table.is_empty());
    rest.is_some_and(|rest| rest.is_empty() || rest.starts_with(['.', '[']))
}

/// A problem of a scenario file, or of a value on the command line; it is shown in one line with what to do about it.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error("{message}{}", help.as_ref().map_or_else(String::new, |help| format!("; {help}")))]
#[non_exhaustive]
pub struct Issue {
    /// Key path, for instance `bearing[1].geometry.balls`; empty for the file as a whole.
    pub path: String,
    /// What is wrong and which rule it breaks.
    pub message: String,
    /// Bytes of the text to underline, where one place is to blame.
    pub span: Option<Range<usize>>,
    /// Further keys that take part in a contradiction: they are shown too, and nothing is said where one of them is
    /// wrong itself.
    pub related: Vec<(String, Option<Range<usize>>)>,
    /// What to do about it.
    pub help: Option<String>,
}

impl Issue {
    /// A problem of a key that has no place yet.
    pub(crate) fn new(path: impl Into<String>, message: impl Into<String>) -> Self {
        Self {
            path: path.into(),
            message: message.into(),
            span: None,
            related: Vec::new(),
            help: None,
        }
    }

    /// Adds its place in the text.
    pub(super) fn at(mut self, span: Option<Range<usize>>) -> Self {
        self.span = span;
        self
    }

    /// Adds advice.
    pub(crate) fn help(mut self, advice: impl Into<String>) -> Self {
        self.help = Some(advice.into());
        self
    }

    /// Adds the nearest of the known words as advice, or other advice where none is near.
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

    /// Makes it a contradiction to another key.
    pub(super) fn against(self, path: impl Into<String>) -> Self {
        self.against_all([path])
    }

    /// Makes it a contradiction to some keys.
    pub(super) fn against_all(
        mut self,
        paths: impl IntoIterator<Item = impl Into<String>>,
    ) -> Self {
        let paths = paths.into_iter().map(|path| (path.into(), None));
        self.related.extend(paths);
        self
    }
}

/// The known word nearest to what was written, if any is near; letter case does not matter.
pub(super) fn nearest<'a>(
    written: &str,
    known: impl IntoIterator<Item = &'a str>,
) -> Option<&'a str> {
    let written = written.to_lowercase();
    known
        .into_iter()
        .map(|word| (strsim::jaro_winkler(&written, &word.to_lowercase()), word))
        .filter(|(likeness, _)| *likeness > 0.75)
        .max_by(|a, b| a.0.total_cmp(&b.0))
        .map(|(_, word)| word)
}

/// More problems than this are counted, not shown.
const MOST_SHOWN: usize = 100;

/// A scenario that cannot be run: everything that is wrong with it.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error("{}", visible(&self.render(false)))]
#[non_exhaustive]
pub struct ScenarioError {
    /// File name as given.
    pub name: String,
    /// Text of the file; empty where it could not be read.
    pub text: String,
    /// The problems in the order of the file, at least one.
    pub issues: Vec<Issue>,
    /// What a command line sets in place of what is in the file, a line each; places count on behind the text.
    pub options: String,
}

impl ScenarioError {
    /// Sorts the problems by their place.
    pub(crate) fn new(name: &str, text: &str, mut issues: Vec<Issue>) -> Self {
        issues.sort_by_key(|issue| issue.span.as_ref().map_or(0, |span| span.start));
        Self {
            name: name.to_owned(),
            text: text.to_owned(),
            issues,
            options: String::new(),
        }
    }

    /// Every problem with its line, the place underlined, and a closing count. Without colour
    /// the text has no control sequences.
    pub fn render(&self, color: bool) -> String {
        let renderer = match color {
            true => Renderer::styled(),
            false => Renderer::plain(),
        };
        let shown = self.issues.iter().take(MOST_SHOWN);
        let shown = shown.map(|issue| renderer.render(&[self.group(issue)]) + "\n\n");
        let count = self.issues.len();
        let noun = if count == 1 { "problem" } else { "problems" };
        let hidden = match count.saturating_sub(MOST_SHOWN) {
            0 => String::new(),
            count => format!(", {count} of them not shown"),
        };
        shown.collect::<String>() + &format!("{}: {count} {noun}{hidden}\n", visible(&self.name))
    }

    fn group<'a>(&'a self, issue: &'a Issue) -> Group<'a> {
        let title = Level::ERROR.primary_title(visible(&issue.message));
        let group = match &issue.span {
            Some(span) => {
                let is_set = self.is_set(span);
                let (source, name, start) = match is_set {
                    true => (&self.options, "command line", self.text.len()),
                    false => (&self.text, self.name.as_str(), 0),
                };
                let place = |span: &Range<usize>| span.start - start..span.end - start;
                let others = issue.related.iter().filter_map(|(_, other)| other.as_ref());
                let others = others.filter(|other| self.is_set(other) == is_set);
                let others = others.map(|other| AnnotationKind::Context.span(place(other)));
                let snippet = Snippet::source(source)
                    .path(visible(name))
                    .annotation(AnnotationKind::Primary.span(place(span)))
                    .annotations(others);
                title.element(snippet)
            }
            None => title.element(Origin::path(visible(&self.name))),
        };
        match &issue.help {
            Some(help) => group.element(Level::HELP.message(visible(help))),
            None => group,
        }
    }

    /// Whether a place is one of the command line.
    fn is_set(&self, span: &Range<usize>) -> bool {
        !self.options.is_empty() && span.start >= self.text.len()
    }

    /// Every problem for programs: its key, message, line, column and help; line and column count from 1,
    /// the column in characters.
    pub fn issues_json(&self) -> Value {
        let newlines = self.text.match_indices('\n').map(|(place, _)| place + 1);
        let lines: Vec<_> = std::iter::once(0).chain(newlines).collect();
        let issues = self.issues.iter().map(|issue| {
            let place = issue.span.as_ref().filter(|span| !self.is_set(span));
            let place = place.map(|span| {
                let line = lines.partition_point(|start| *start <= span.start);
                let end = span.start.min(self.text.len());
                let before = &self.text.as_bytes()[lines[line - 1]..end];
                (line, String::from_utf8_lossy(before).chars().count() + 1)
            });
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
}
