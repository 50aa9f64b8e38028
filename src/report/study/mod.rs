//! A study: one row a value, and the bearings all around at every value.

mod figures;
mod json;
mod tables;
mod text;

use std::path::PathBuf;

pub use self::json::study_json;
pub use self::text::study_text;
use super::{Destination, FileSet, ReportError};
use crate::study::{Study, StudyRow, Variable};

/// Writes `study.csv`, `around.csv`, three figures and, last, `study.json`; returns
/// their paths.
///
/// # Errors
/// [`ReportError`] where a file cannot be written or drawn.
pub fn write_study(
    destination: &Destination<'_>,
    study: &Study,
    rows: &[StudyRow],
) -> Result<Vec<PathBuf>, ReportError> {
    let folder = destination.open(FileSet::STUDY)?;
    let variable = &study.variable;
    let mut files = folder.write_table("study", &tables::answers(variable, rows))?;
    files.extend(folder.write_table("around", &tables::around(variable, rows))?);
    let title = destination.title;
    for figure in [
        figures::stiffness(title, variable, rows),
        figures::deformation(title, variable, rows),
        figures::contact_angle(title, variable, rows),
    ] {
        files.push(folder.write_figure(&figure)?);
    }
    let cover = json::cover(destination, study, rows);
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
