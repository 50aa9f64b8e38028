//! Collects what is wrong with a scenario while it is read and checked.

use std::path::Path;

use super::Issue;
use super::issue::Contradiction;
use super::key::join;
use super::node::Node;

/// Everything found so far, with the keys that later checks must not be believed about.
pub(super) struct Problems<'a> {
    root: &'a Node,
    folder: &'a Path,
    subject: &'static str,
    table: String,
    issues: Vec<Issue>,
    faulty: Vec<String>,
    warnings: Vec<String>,
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

    /// The same about another kind of file.
    pub fn about(self, subject: &'static str) -> Self {
        Self { subject, ..self }
    }

    /// What messages call the file as a whole.
    pub fn subject(&self) -> &'static str {
        self.subject
    }

    /// The folder that the files named in the scenario are relative to.
    pub fn folder(&self) -> &'a Path {
        self.folder
    }

    /// Adds a problem of one key; what it stands for is not trusted from here on.
    pub fn add(&mut self, issue: Issue) {
        self.distrust(&issue.path);
        let place = issue.span.clone();
        let place = place.or_else(|| self.root.locate(&issue.path));
        self.issues.push(issue.at(place));
    }

    /// Leaves a key out of later checks: it is known to be wrong or misspelled.
    pub fn distrust(&mut self, path: &str) {
        self.faulty.push(path.to_owned());
    }

    /// Whether a key, or a table that it stands in, has a problem already.
    pub fn distrusts(&self, path: &str) -> bool {
        let holds = |faulty: &String| {
            path.strip_prefix(faulty.as_str())
                .is_some_and(|rest| rest.is_empty() || rest.starts_with(['.', '[']))
        };
        self.faulty.iter().any(holds)
    }

    /// Checks a table inside of the present one: there a path that begins with a point is one of its keys.
    pub fn inside<T>(&mut self, table: impl AsRef<str>, check: impl FnOnce(&mut Self) -> T) -> T {
        let inner = join(&self.table, table.as_ref());
        let outer = std::mem::replace(&mut self.table, inner);
        let checked = check(self);
        self.table = outer;
        checked
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
    pub fn refuse(&mut self, problem: impl Into<Contradiction>) {
        let Contradiction { mut issue, others } = problem.into();
        issue.path = self.path(&issue.path);
        let others: Vec<_> = others.iter().map(|path| self.path(path)).collect();
        let mut paths = std::iter::once(&issue.path).chain(&others);
        if paths.any(|path| self.distrusts(path)) {
            return;
        }
        issue.span = self.root.locate(&issue.path);
        let given = others.iter().filter_map(|path| self.root.find(path));
        let places = given.map(|node| node.span.clone());
        issue.related = places
            .filter(|place| Some(place) != issue.span.as_ref())
            .collect();
        self.issues.push(issue);
    }

    /// The whole tree.
    pub fn root(&self) -> &'a Node {
        self.root
    }

    /// The value of a path as it was written.
    pub fn node(&self, path: &str) -> Option<&'a Node> {
        self.root.find(path)
    }

    /// Whether nothing is wrong so far.
    pub fn is_clean(&self) -> bool {
        self.issues.is_empty()
    }

    /// Notes what the user should know although the scenario can be run.
    pub fn warn(&mut self, warning: impl Into<String>) {
        self.warnings.push(warning.into());
    }

    /// The problems and the warnings.
    pub fn finish(self) -> (Vec<Issue>, Vec<String>) {
        (self.issues, self.warnings)
    }
}
