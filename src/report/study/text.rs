//! A study as a person reads it: one row a value.

use std::path::PathBuf;

use super::super::terminal::{Lines, digits};
use super::{axis_name, shown};
use crate::report::units::{MICRO, MILLI};
use crate::study::{Study, StudyRow};

/// Most rows shown.
const MOST_ROWS: usize = 24;

/// The values with place and stiffness of the shaft; of many, some. Then the files written.
pub fn study_text(title: &str, study: &Study, rows: &[StudyRow], files: &[PathBuf]) -> String {
    let mut out = Lines::titled(title);
    let varied = study.variable.key.rsplit('.').next().unwrap_or_default();
    let units = format!("{varied}\n{}", study.variable.shown_unit);
    let header = [
        units.as_str(),
        "x\nµm",
        "y\nµm",
        "z\nµm",
        "Kx\nN/µm",
        "Ky\nN/µm",
        "Kz\nN/µm",
        "Kθx\nN m/mrad",
        "Kθy\nN m/mrad",
    ];
    let step = rows.len().div_ceil(MOST_ROWS).max(1);
    let cells = rows.iter().step_by(step).map(|row| cells(study, row));
    out.table(header, cells);
    let name = axis_name(&study.variable);
    out.line("varied", format!("{name}: {} values", rows.len()));
    out.wrote(files)
}

fn cells(study: &Study, row: &StudyRow) -> Vec<String> {
    let value = shown(&study.variable, row.value);
    let value = value.split(' ').next().unwrap_or_default().to_owned();
    let [x, y, z, ..] = row.answer.displacement;
    let places = [x, y, z].map(|place| format!("{:.3}", MICRO * place));
    let stiffness = (0..5).map(|axis| {
        let scale = if axis < 3 { MICRO } else { MILLI };
        digits(row.answer.stiffness[(axis, axis)] / scale)
    });
    std::iter::once(value)
        .chain(places)
        .chain(stiffness)
        .collect()
}
