//! The answer to a static question: text for people, JSON, CSV and a figure of the balls.

mod ball_table;
mod figure;
mod text;

use std::path::{Path, PathBuf};

use serde_json::Value;

pub use self::text::answer_text;
use super::{FileSet, ReportError, RunFolder, document};
use crate::quasi_static::QuasiStatic;

/// Writes `balls.csv`, `balls.svg` and, last, `bearing.json` into `folder`; returns their paths.
///
/// # Errors
/// [`ReportError`] where a file cannot be written or drawn.
pub fn write_answer(
    folder: &Path,
    title: &str,
    scenario: &Value,
    answer: &QuasiStatic,
) -> Result<Vec<PathBuf>, ReportError> {
    let folder = RunFolder::open(folder, FileSet::BEARING)?;
    let files = vec![
        folder.write_table("balls", &ball_table::balls(answer))?,
        folder.write_figure(&figure::balls(title, answer))?,
    ];
    let json = document(title, scenario, answer);
    folder.commit(files, format!("{json:#}\n").as_bytes())
}
