//! Natural frequencies over the speed: tables, figure, text and JSON.

mod figure;
mod json;
mod table;
mod text;

use std::path::PathBuf;

pub use self::json::campbell_json;
pub use self::text::campbell_text;
use super::{Destination, FileSet, ReportError, RunFolder, WholeFile};
use crate::study::campbell::Campbell;

/// Writes `campbell.csv`, `campbell.svg` and, last, `campbell.json`; returns their paths.
///
/// # Errors
/// [`ReportError`] where a file cannot be written or drawn.
pub fn write_campbell(
    destination: &Destination<'_>,
    campbell: &Campbell,
) -> Result<Vec<PathBuf>, ReportError> {
    let folder = destination.open(FileSet::CAMPBELL)?;
    let files = write_files(&folder, destination.title, campbell, true)?;
    let json = campbell_json(destination, campbell);
    folder.commit(files, format!("{json:#}\n").as_bytes())
}

/// The table, and the figure where it is drawn.
pub(super) fn write_files(
    folder: &RunFolder,
    title: &str,
    campbell: &Campbell,
    figure: bool,
) -> Result<Vec<WholeFile>, ReportError> {
    let mut files = folder.write_table("campbell", &table::modes(campbell))?;
    if figure {
        let figure = figure::campbell_figure(title, campbell);
        files.push(folder.write_figure(&figure)?);
    }
    Ok(files)
}
