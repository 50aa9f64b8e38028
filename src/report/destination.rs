//! Where the files of a result go.

use std::path::Path;

use serde::Serialize;
use serde_json::Value;

use super::table::Origin;
use super::{FileSet, ReportError, RunFolder, document};
use crate::scenario::TableFormat;

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
}

impl Destination<'_> {
    /// A result as a JSON document.
    pub fn document(&self, result: impl Serialize) -> Value {
        document(self.title, self.scenario, result)
    }

    /// Opens the folder for a set of files.
    pub(super) fn open(&self, set: FileSet) -> Result<RunFolder, ReportError> {
        let origin = Origin {
            scenario: self.scenario.to_string(),
        };
        Ok(RunFolder::open(self.folder, set)?.with_tables(self.formats, origin))
    }
}
