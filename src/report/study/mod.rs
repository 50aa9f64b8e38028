//! A study: one row a value, and the bearings all around at every value.

mod around_csv;
mod csv;
mod figures;
mod json;
mod text;

use std::path::{Path, PathBuf};

use serde_json::Value;

pub use self::json::study_json;
pub use self::text::study_text;
use super::{FileSet, ReportError, RunFolder};
use crate::study::{Study, StudyRow, Variable};

/// Writes `study.csv`, `around.csv`, three figures and, last, `study.json` into `folder`; returns
/// their paths.
///
/// # Errors
/// [`ReportError`] where a file cannot be written or drawn.
pub fn write_study(
    folder: &Path,
    title: &str,
    scenario: &Value,
    study: &Study,
    rows: &[StudyRow],
) -> Result<Vec<PathBuf>, ReportError> {
    let folder = RunFolder::open(folder, FileSet::STUDY)?;
    let variable = &study.variable;
    let mut files = vec![
        folder.write_with("study.csv", |file| csv::write(variable, rows, file))?,
        folder.write_with("around.csv", |file| around_csv::write(variable, rows, file))?,
    ];
    for figure in [
        figures::stiffness(title, variable, rows),
        figures::deformation(title, variable, rows),
        figures::contact_angle(title, variable, rows),
    ] {
        files.push(folder.write_figure(&figure)?);
    }
    let cover = json::cover(title, scenario, study, rows);
    folder.commit(files, format!("{cover:#}\n").as_bytes())
}

/// The variable as the name of a column: `load_0_constant_z_N`.
pub(super) fn column_name(variable: &Variable) -> String {
    let words: Vec<_> = variable
        .key
        .split(['.', '[', ']'])
        .filter(|word| !word.is_empty())
        .collect();
    let name = words.join("_");
    if variable.unit.is_empty() {
        name
    } else {
        format!("{name}_{}", crate::analysis::column_unit(variable.unit))
    }
}

/// The variable as the name of an axis: `load[0].constant.z in N`.
pub(super) fn axis_name(variable: &Variable) -> String {
    if variable.shown_unit.is_empty() {
        variable.key.clone()
    } else {
        format!("{} in {}", variable.key, variable.shown_unit)
    }
}

/// A value of the variable in the unit that it was written in: `200 N`.
pub(super) fn shown(variable: &Variable, value: f64) -> String {
    let number = variable.shown(value);
    let rounded: f64 = format!("{number:.5e}").parse().unwrap_or(number);
    format!("{rounded} {}", variable.shown_unit)
        .trim_end()
        .to_owned()
}
