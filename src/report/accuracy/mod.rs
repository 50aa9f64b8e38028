//! Speed against error: table for people, CSV, JSON and two figures.
//!
//! These files hold times, and so are the only ones that differ from one measurement to the next.

mod csv;
mod figure;
mod log_axis;
mod text;

use std::path::{Path, PathBuf};

use serde_json::Value;

pub use self::text::accuracy_text;
use super::{FileAction, FileSet, ReportError, RunFolder, document};
use crate::study::accuracy::Accuracy;

/// Writes `accuracy.csv`, `ladder.csv`, `accuracy.svg`, `ladder.svg` and, last, `accuracy.json` into
/// `folder`; returns their paths.
///
/// # Errors
/// [`ReportError`] where a file cannot be written or drawn.
pub fn write_accuracy(
    folder: &Path,
    title: &str,
    scenario: &Value,
    accuracy: &Accuracy,
) -> Result<Vec<PathBuf>, ReportError> {
    let folder = RunFolder::open(folder, FileSet::ACCURACY)?;
    let tables = [
        ("accuracy.csv", csv::methods(accuracy)),
        ("ladder.csv", csv::ladder(accuracy)),
    ];
    let mut files = Vec::new();
    for (name, table) in tables {
        let path = folder.path().join(name);
        let table = table.map_err(ReportError::file(FileAction::Write, &path))?;
        files.push(folder.write(name, &table)?);
    }
    for (name, svg) in [
        ("accuracy.svg", figure::methods(title, accuracy)?),
        ("ladder.svg", figure::ladder(title, accuracy)?),
    ] {
        files.push(folder.write(name, svg.as_bytes())?);
    }
    let json = document(title, scenario, accuracy);
    folder.commit(files, format!("{json:#}\n").as_bytes())
}
