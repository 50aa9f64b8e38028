//! The answer to a static question: text for people, JSON, CSV and a figure of the balls.

mod ball_table;
mod figure;
mod text;

use std::path::PathBuf;

pub use self::text::answer_text;
use super::{Destination, FileSet, ReportError};
use crate::quasi_static::QuasiStatic;

/// Writes `balls.csv`, `balls.svg` and, last, `bearing.json`; returns their paths.
///
/// # Errors
/// [`ReportError`] where a file cannot be written or drawn.
pub fn write_answer(
    destination: &Destination<'_>,
    answer: &QuasiStatic,
) -> Result<Vec<PathBuf>, ReportError> {
    let folder = destination.open(FileSet::BEARING)?;
    let mut files = folder.write_table("balls", &ball_table::balls(answer))?;
    files.push(folder.write_figure(&figure::balls(destination.title, answer))?);
    let json = destination.document(answer);
    folder.commit(files, format!("{json:#}\n").as_bytes())
}
