//! Speed against error: table for people, CSV, JSON and two figures.
//!
//! These files hold times, and so are the only ones that differ from one measurement to the next.

mod figure;
mod tables;
mod text;

use std::path::PathBuf;

pub use self::text::accuracy_text;
use super::{Destination, FileSet, ReportError};
use crate::study::accuracy::Accuracy;

/// Writes `accuracy.csv`, `ladder.csv`, `accuracy.svg`, `ladder.svg` and, last, `accuracy.json` ; returns their paths.
///
/// # Errors
/// [`ReportError`] where a file cannot be written or drawn.
pub fn write_accuracy(
    destination: &Destination<'_>,
    accuracy: &Accuracy,
) -> Result<Vec<PathBuf>, ReportError> {
    let folder = destination.open(FileSet::ACCURACY)?;
    let mut files = folder.write_table("accuracy", &tables::methods(accuracy))?;
    files.extend(folder.write_table("ladder", &tables::ladder(accuracy))?);
    let title = destination.title;
    for figure in [
        figure::methods(title, accuracy),
        figure::ladder(title, accuracy),
    ] {
        files.push(folder.write_figure(&figure)?);
    }
    let json = destination.document(accuracy);
    folder.commit(files, format!("{json:#}\n").as_bytes())
}
