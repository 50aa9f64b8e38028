//! Steady motions: files of a single one, and of their branches along a parameter.

mod figure;
mod json;
mod line_table;
mod response_figure;
mod response_tables;
mod text;

use std::path::{Path, PathBuf};

use serde_json::Value;

pub use self::json::{response_json, steady_json};
pub use self::text::{response_text, steady_text};
use super::{FileSet, PartialFile, ReportError, RunFolder, TraceCsv, TraceFigure};
use crate::simulate::{Model, TraceSink};
use crate::steady::{Response, Steady};
use crate::study::Variable;

/// Writes `steady_trace.csv`, `steady_spectrum.csv`, two figures and, last, `steady.json` into `folder`;
/// returns their paths.
///
/// # Errors
/// [`ReportError`] where a file cannot be written or drawn.
pub fn write_steady(
    folder: &Path,
    title: &str,
    scenario: &Value,
    model: &Model,
    steady: &Steady,
) -> Result<Vec<PathBuf>, ReportError> {
    let folder = RunFolder::open(folder, FileSet::STEADY)?;
    let mut figure = TraceFigure::new(model.rotor.shaft.freedoms.count());
    steady.trace.iter().for_each(|sample| figure.sample(sample));
    let trace = |file: &mut PartialFile| {
        let mut csv = TraceCsv::new(file)?;
        for sample in &steady.trace {
            csv.sample(sample)?;
        }
        csv.finish().map(|_| ())
    };
    let mut files = vec![
        folder.write_with("steady_trace.csv", trace)?,
        folder.write_table(
            "steady_spectrum",
            &line_table::lines(steady, model.rotor.speed),
        )?,
    ];
    for figure in [
        figure.figure("steady_trace.svg", title),
        figure::spectrum(title, &steady.lines),
    ] {
        files.push(folder.write_figure(&figure)?);
    }
    let json = steady_json(title, scenario, model, steady);
    folder.commit(files, format!("{json:#}\n").as_bytes())
}

/// Writes `response.csv`, `response_specials.csv`, `response.svg` and, last, `response.json` into
/// `folder`; returns their paths.
///
/// # Errors
/// [`ReportError`] where a file cannot be written or drawn.
pub fn write_response(
    folder: &Path,
    title: &str,
    scenario: &Value,
    variable: &Variable,
    branches: &[Response],
) -> Result<Vec<PathBuf>, ReportError> {
    let folder = RunFolder::open(folder, FileSet::RESPONSE)?;
    let mut files = vec![
        folder.write_table("response", &response_tables::points(variable, branches))?,
        folder.write_table(
            "response_specials",
            &response_tables::specials(variable, branches),
        )?,
    ];
    let figure = response_figure::response(title, variable, branches);
    files.push(folder.write_figure(&figure)?);
    let json = response_json(title, scenario, variable, branches);
    folder.commit(files, format!("{json:#}\n").as_bytes())
}
