//! Where the files of a result go, and the document that says what they rest on.

use std::path::{Path, PathBuf};

use serde::Serialize;
use serde_json::Value;

use super::figure::Figure;
use super::page::AnswerPage;
use super::terminal::Lines;
use super::{FileSet, ReportError, RunFolder};
use crate::scenario::TableFormat;
use crate::table::Table;

/// Where the files of a result go, and what they say of where it comes from.
#[derive(Debug, Clone, Copy)]
pub struct Destination<'a> {
    /// Folder of the result.
    pub folder: &'a Path,
    /// Title of the scenario.
    pub title: &'a str,
    /// The scenario with its defaults.
    pub scenario: &'a Value,
    /// Formats of the tables.
    pub formats: &'a [TableFormat],
    /// Whether a page shows the result.
    pub page: bool,
}

impl Destination<'_> {
    /// A result as a JSON document.
    pub fn document(&self, result: impl Serialize) -> Value {
        document(self.title, self.scenario, result)
    }

    /// Writes tables and figures, and the document last.
    ///
    /// # Errors
    /// [`ReportError`] where a file cannot be written or drawn.
    pub fn write(&self, findings: Findings) -> Result<Written, ReportError> {
        let folder = RunFolder::open(self.folder, findings.set)?;
        let folder = folder.with_tables(self.formats, self.scenario);
        let mut files = Vec::new();
        for (stem, table) in &findings.tables {
            files.extend(folder.write_table(stem, table)?);
        }
        for figure in &findings.figures {
            files.push(folder.write_figure(figure)?);
        }
        if self.page {
            let page = AnswerPage {
                title: self.title,
                sealed: findings.set.seal,
                parts: findings.text.parts(),
                figures: &findings.figures,
                tables: &findings.tables,
                document: &findings.document,
            };
            files.push(folder.write_with(&findings.set.page(), |file| page.write(file))?);
        }
        let document = findings.document;
        let files = folder.commit(files, format!("{document:#}\n").as_bytes())?;
        Ok(Written {
            text: findings.text.wrote(&files),
            json: document,
            files,
        })
    }
}

/// What a verb has found, in every form in which it is told.
#[derive(Debug, Clone)]
pub struct Findings {
    /// The files that it is made of.
    pub(super) set: FileSet,
    /// Tables by their names without ending.
    pub tables: Vec<(&'static str, Table<'static>)>,
    /// Figures.
    pub(super) figures: Vec<Figure>,
    /// The document that seals the files.
    pub document: Value,
    /// What people read.
    pub(super) text: Lines,
}

impl Findings {
    /// What people read.
    pub fn text(&self) -> &str {
        self.text.as_str()
    }

    /// Names of the figures, without ending.
    pub fn figures(&self) -> impl Iterator<Item = &str> {
        self.figures.iter().map(|figure| figure.name.as_str())
    }

    /// A figure by its name as SVG; none where no figure is called so.
    pub fn figure(&self, name: &str) -> Option<String> {
        let found = self.figures.iter().find(|figure| figure.name == name);
        found.map(Figure::svg)
    }
}

/// Findings whose files are written.
#[derive(Debug)]
pub struct Written {
    /// For people, with the files.
    pub text: String,
    /// The document.
    pub json: Value,
    /// Paths of the files.
    pub files: Vec<PathBuf>,
}

/// What every document begins with.
#[derive(Serialize)]
struct Document<'a, T> {
    jeffcott: &'static str,
    title: &'a str,
    scenario: &'a Value,
    #[serde(flatten)]
    result: T,
}

/// A result with version, title and the scenario as it is, every number with its unit in its name.
///
/// The fields of the result's type describe the keys. What is missing is `null`. The same result gives the
/// same bytes: there is no date in it, and no wall time but where that is the result.
pub fn document(title: &str, scenario: &Value, result: impl Serialize) -> Value {
    value(Document {
        jeffcott: env!("CARGO_PKG_VERSION"),
        title,
        scenario,
        result,
    })
}

/// A part of a document with further keys.
pub(super) fn with_keys(result: impl Serialize, further: Value) -> Value {
    let mut json = value(result);
    if let (Value::Object(keys), Value::Object(further)) = (&mut json, further) {
        keys.extend(further);
    }
    json
}

/// A part of a document.
pub(super) fn value(result: impl Serialize) -> Value {
    serde_json::to_value(result).expect("the keys of results are texts")
}
