//! Steady motions: files of a single one, and of their branches along a parameter.

mod figure;
mod json;
mod line_table;
mod response_figure;
mod response_tables;
mod text;

use std::path::PathBuf;

pub use self::json::{response_json, steady_json};
pub use self::text::{response_text, steady_text};
use super::sample_table::SampleTable;
use super::{Destination, FileSet, ReportError, TraceFigure};
use crate::analysis::Channel;
use crate::simulate::Model;
use crate::steady::{Response, Steady};
use crate::study::Variable;

/// Writes `steady_trace.csv`, `steady_spectrum.csv`, two figures and, last, `steady.json`;
/// returns their paths.
///
/// # Errors
/// [`ReportError`] where a file cannot be written or drawn.
pub fn write_steady(
    destination: &Destination<'_>,
    model: &Model,
    steady: &Steady,
) -> Result<Vec<PathBuf>, ReportError> {
    let folder = destination.open(FileSet::STEADY)?;
    let mut figure = TraceFigure::new(model.rotor.shaft.freedoms.count());
    steady.trace.iter().for_each(|sample| figure.sample(sample));
    let mut trace = SampleTable::new(Channel::of_trace());
    let mut files = folder.write_rows("steady_trace", &trace.columns(), |take| {
        let mut samples = steady.trace.iter();
        samples.try_for_each(|sample| take(trace.row(sample)))
    })?;
    let lines = line_table::lines(steady, model.rotor.speed);
    files.extend(folder.write_table("steady_spectrum", &lines)?);
    let title = destination.title;
    for figure in [
        figure.figure("steady_trace.svg", title),
        figure::spectrum(title, &steady.lines),
    ] {
        files.push(folder.write_figure(&figure)?);
    }
    let json = steady_json(destination, model, steady);
    folder.commit(files, format!("{json:#}\n").as_bytes())
}

/// Writes `response.csv`, `response_specials.csv`, `response.svg` and, last, `response.json` ; returns their paths.
///
/// # Errors
/// [`ReportError`] where a file cannot be written or drawn.
pub fn write_response(
    destination: &Destination<'_>,
    variable: &Variable,
    branches: &[Response],
) -> Result<Vec<PathBuf>, ReportError> {
    let folder = destination.open(FileSet::RESPONSE)?;
    let points = response_tables::points(variable, branches);
    let mut files = folder.write_table("response", &points)?;
    let specials = response_tables::specials(variable, branches);
    files.extend(folder.write_table("response_specials", &specials)?);
    let figure = response_figure::response(destination.title, variable, branches);
    files.push(folder.write_figure(&figure)?);
    let json = response_json(destination, variable, branches);
    folder.commit(files, format!("{json:#}\n").as_bytes())
}
