//! What a verb has found, in every form in which it is reported, and the document that says what it rests on.

use std::path::{Path, PathBuf};

use serde::Serialize;
use serde_json::{Value, json};

use super::contact_choice::add_contact_choice;
use super::figure::Figure;
use super::page::Page;
use super::terminal::Lines;
use super::{FileSet, ReportError, RunFolder, WholeFile};
use crate::scenario::{Output, Scenario};
use crate::table::Table;

/// What a verb has found, in every form in which it is reported.
#[derive(Debug, Clone)]
pub struct Findings {
    /// The files that it is made of.
    pub(super) set: FileSet,
    /// Which files are written.
    pub(super) output: Output,
    /// Tables by their names without ending.
    pub(super) tables: Vec<(&'static str, Table<'static>)>,
    /// Tables that are too long for the page.
    pub(super) long_tables: Vec<(String, Table<'static>)>,
    /// Figures, in the order of the page.
    pub(super) figures: Vec<Figure>,
    /// What the page shows in motion.
    pub(super) film: Option<Value>,
    /// Names and contents of further files.
    pub(super) files: Vec<(&'static str, Vec<u8>)>,
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
            output: scenario.output.clone(),
            ..Self::of_document(set, document, text)
        }
    }

    /// Findings without tables and figures that a document holds.
    pub(super) fn of_document(set: FileSet, document: Value, text: Lines) -> Self {
        Self {
            set,
            output: Output::default(),
            tables: Vec::new(),
            long_tables: Vec::new(),
            figures: Vec::new(),
            film: None,
            files: Vec::new(),
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

    /// All tables with their names without ending.
    pub fn tables(&self) -> impl Iterator<Item = (&str, &Table<'static>)> {
        let short = self.tables.iter().map(|(name, table)| (*name, table));
        let long = self.long_tables.iter();
        short.chain(long.map(|(name, table)| (&**name, table)))
    }

    /// The figures that have a file.
    fn drawn(&self) -> impl Iterator<Item = &Figure> {
        self.figures.iter().filter(|figure| !figure.only_on_page)
    }

    /// Names of the figures, without ending.
    pub fn figures(&self) -> impl Iterator<Item = &str> {
        self.drawn().map(|figure| figure.name.as_str())
    }

    /// A figure by its name as SVG; none where no figure is called so.
    pub fn figure(&self, name: &str) -> Option<String> {
        let found = self.drawn().find(|figure| figure.name == name);
        found.map(Figure::svg)
    }

    /// The text of a further file by its name; none where no file of text is called so.
    pub fn file(&self, name: &str) -> Option<&str> {
        let (_, content) = self.files.iter().find(|(known, _)| *known == name)?;
        std::str::from_utf8(content).ok()
    }

    /// Writes tables, figures and page into a folder, and the document last.
    ///
    /// # Errors
    /// [`ReportError`] where a file cannot be written.
    pub fn write(&self, folder: &Path) -> Result<WrittenFindings, ReportError> {
        let folder = RunFolder::open(folder, self.set)?;
        let folder = folder.with_tables(&self.output.formats, &self.document["scenario"]);
        self.write_beside(folder, Vec::new())
    }

    /// Writes them into an open folder, beside files that are written already.
    ///
    /// # Errors
    /// [`ReportError`] where a file cannot be written.
    pub(super) fn write_beside(
        &self,
        folder: RunFolder,
        mut files: Vec<WholeFile>,
    ) -> Result<WrittenFindings, ReportError> {
        for (stem, table) in self.tables() {
            files.extend(folder.write_table(stem, table)?);
        }
        for (name, content) in &self.files {
            files.push(folder.write(name, content)?);
        }
        for figure in self.drawn().filter(|_| self.output.figures) {
            files.push(folder.write_figure(figure)?);
        }
        if self.output.report {
            let page = Page {
                title: self.document["title"].as_str().unwrap_or_default(),
                sealed: self.set.seal,
                text: &self.text,
                figures: &self.figures,
                film: self.film.as_ref(),
                tables: &self.tables,
                document: &self.document,
            };
            files.push(folder.write_with(&self.set.page(), |file| page.write(file))?);
        }
        let (files, document) = folder.commit(files, self.document.clone())?;
        Ok(WrittenFindings {
            files,
            document,
            text: self.text.clone(),
            incomplete: self.incomplete,
        })
    }
}

/// What a verb has found, whose files are written.
#[derive(Debug)]
pub struct WrittenFindings {
    /// Paths of the files.
    pub files: Vec<PathBuf>,
    /// The document, which lists the files; of a part of a study its title alone.
    pub document: Value,
    pub(super) text: Lines,
    /// Whether a part of what was asked for is missing.
    pub incomplete: bool,
}

impl WrittenFindings {
    /// What people read, with or without details on how it was computed.
    pub fn text(&self, details: bool) -> String {
        self.text.text(details)
    }

    /// What the reader should know.
    pub fn warnings(&self) -> impl Iterator<Item = &str> {
        warnings(&self.document)
    }
}

/// Version of the keys of the documents: it grows where a key goes or changes its meaning.
const SCHEMA_VERSION: u32 = 1;

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
