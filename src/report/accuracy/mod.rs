//! Speed against error: table for people, CSV, JSON and two figures.
//!
//! These files hold times, and so are the only ones that differ from one measurement to the next.

mod figure;
mod tables;
mod text;

use std::path::{Path, PathBuf};

use serde_json::Value;

pub use self::text::accuracy_text;
use super::{FileSet, ReportError, RunFolder, document};
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
    let mut files = vec![
        folder.write_table("accuracy", &tables::methods(accuracy))?,
        folder.write_table("ladder", &tables::ladder(accuracy))?,
    ];
    for figure in [
        figure::methods(title, accuracy),
        figure::ladder(title, accuracy),
    ] {
        files.push(folder.write_figure(&figure)?);
    }
    let json = document(title, scenario, accuracy);
    folder.commit(files, format!("{json:#}\n").as_bytes())
}
