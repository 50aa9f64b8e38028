//! What a verb has found, in every form in which it is told, and the document that says what it rests on.

use std::path::{Path, PathBuf};

use serde::Serialize;
use serde_json::{Value, json};

use super::figure::Figure;
use super::page::AnswerPage;
use super::terminal::Lines;
use super::text::add_contact_choice;
use super::{FileSet, ReportError, RunFolder};
use crate::scenario::{Scenario, TableFormat};
use crate::table::Table;

/// What a verb has found, in every form in which it is told.
#[derive(Debug, Clone)]
pub struct Findings {
    /// The files that it is made of.
    pub(super) set: FileSet,
    /// Formats of the tables.
    pub(super) formats: Vec<TableFormat>,
    /// Whether a page shows it.
    pub(super) has_page: bool,
    /// Tables by their names without ending.
    pub tables: Vec<(&'static str, Table<'static>)>,
    /// Figures.
    pub(super) figures: Vec<Figure>,
    /// The document that seals the files.
    pub document: Value,
    /// What people read.
    pub(super) text: Lines,
    /// Whether it leaves out a part of what was asked for, of which a warning tells.
    pub incomplete: bool,
}

impl Findings {
    /// Findings about a scenario without tables and figures; the fields of `result` are keys of the document.
    pub(super) fn new(
        set: FileSet,
        scenario: &Scenario,
        result: impl Serialize,
        mut text: Lines,
    ) -> Self {
        let mut document = document(&scenario.title, &scenario.echo, result);
        if let Some(choice) = &scenario.contact_choice {
            document["contact_choice"] = json!(choice);
            add_contact_choice(&mut text, choice);
        }
        Self {
            set,
            formats: scenario.output.formats.clone(),
            has_page: scenario.output.report,
            tables: Vec::new(),
            figures: Vec::new(),
            document,
            text,
            incomplete: false,
        }
    }

    /// What people read, with or without details on how it was computed.
    pub fn text(&self, details: bool) -> String {
        self.text.text(details)
    }

    /// What the reader should know.
    pub fn warnings(&self) -> impl Iterator<Item = &str> {
        warnings(&self.document)
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

    /// Writes tables and figures into a folder, and the document last; returns the paths of all files, and the
    /// document, which lists them.
    ///
    /// # Errors
    /// [`ReportError`] where a file cannot be written.
    pub fn write(&self, folder: &Path) -> Result<(Vec<PathBuf>, Value), ReportError> {
        let folder = RunFolder::open(folder, self.set)?;
        let folder = folder.with_tables(&self.formats, &self.document["scenario"]);
        let mut files = Vec::new();
        for (stem, table) in &self.tables {
            files.extend(folder.write_table(stem, table)?);
        }
        for figure in &self.figures {
            files.push(folder.write_figure(figure)?);
        }
        if self.has_page {
            let page = AnswerPage {
                title: self.document["title"].as_str().unwrap_or_default(),
                sealed: self.set.seal,
                text: &self.text,
                figures: &self.figures,
                tables: &self.tables,
                document: &self.document,
            };
            files.push(folder.write_with(&self.set.page(), |file| page.write(file))?);
        }
        folder.commit(files, self.document.clone())
    }
}

/// Version of the keys of the documents: it grows where a key goes or changes its meaning.
pub(super) const SCHEMA_VERSION: u32 = 1;

/// What every document begins with.
#[derive(Serialize)]
struct Document<'a, T> {
    jeffcott: &'static str,
    schema_version: u32,
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
        schema_version: SCHEMA_VERSION,
        title,
        scenario,
        result,
    })
}

/// A result that rests on no scenario, with the version of the program and of the keys.
pub fn versioned(result: impl Serialize) -> Value {
    let version =
        json!({ "jeffcott": env!("CARGO_PKG_VERSION"), "schema_version": SCHEMA_VERSION });
    with_keys(version, value(result))
}

/// Warnings of a document.
pub fn warnings(document: &Value) -> impl Iterator<Item = &str> {
    let warnings = document["warnings"].as_array().into_iter().flatten();
    warnings.filter_map(Value::as_str)
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
