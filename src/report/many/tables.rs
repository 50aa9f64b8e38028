//! The tables of a study: a row a run, a row a line of its spectrum, a row a point.

use std::io::{self, Write};

use super::StudyRuns;
use crate::analysis::Channel;
use crate::report::spectra::amplitude_column;
use crate::report::study::variable_column;
use crate::report::table::{cell, number};
use crate::study::many::{BearingStiffness, Keep, RunRecord, TraceSeal};

/// What stands between two warnings of a run.
pub(super) const BETWEEN_WARNINGS: &str = " | ";

/// A table of a study.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Table {
    /// Values and numbers of every run.
    Runs,
    /// Amplitudes of every run.
    Spectra,
    /// Places of the shaft in every run.
    Points,
    /// Stiffness of every bearing in every run.
    Stiffness,
    /// What the trace of every run is known by.
    Traces,
}

impl Table {
    /// All of them, in the order in which a journal holds them.
    pub const ALL: [Self; 5] = [
        Self::Runs,
        Self::Spectra,
        Self::Points,
        Self::Stiffness,
        Self::Traces,
    ];

    /// File name without ending.
    pub fn stem(self) -> &'static str {
        match self {
            Self::Runs => "runs",
            Self::Spectra => "spectra",
            Self::Points => "poincare",
            Self::Stiffness => "stiffness",
            Self::Traces => "traces",
        }
    }

    /// Those that a study has.
    pub fn kept(keep: &Keep) -> impl Iterator<Item = Self> {
        Self::ALL.into_iter().filter(|table| table.is_kept(keep))
    }

    fn is_kept(self, keep: &Keep) -> bool {
        match self {
            Self::Runs => true,
            Self::Spectra => keep.highest_order.is_some(),
            Self::Points => keep.section.is_some(),
            Self::Stiffness => keep.bearing_stiffness,
            Self::Traces => keep.traces,
        }
    }
}

/// The line of names of a table.
pub(super) fn header(runs: &StudyRuns<'_>, table: Table) -> Vec<String> {
    let axes = runs.first.rotor.shaft.freedoms.axes().iter();
    let displacements = axes.copied().map(Channel::Displacement);
    let mut names = vec!["run".to_owned()];
    match table {
        Table::Runs => {
            names.push("direction".to_owned());
            names.extend(
                runs.study
                    .variables
                    .iter()
                    .map(|of| variable_column(of).name()),
            );
            names.extend(runs.study.columns.iter().map(|number| number.column.name()));
            names.extend(["status", "error", "warnings"].map(str::to_owned));
        }
        Table::Spectra => {
            names.extend(["frequency_Hz", "order"].map(str::to_owned));
            names.extend(displacements.map(|of| amplitude_column(of).name()));
        }
        Table::Points => {
            names.push("time_s".to_owned());
            names.extend(displacements.map(|of| of.column().name()));
        }
        Table::Stiffness => names.extend(stiffness_columns()),
        Table::Traces => names.extend(["bytes", "checksum"].map(str::to_owned)),
    }
    names
}

/// The rows of some runs in all tables, as a journal holds them: the text of each in one line of JSON.
pub(super) fn content(runs: &StudyRuns<'_>, records: &[RunRecord]) -> io::Result<String> {
    let numbers = runs.study.columns.len();
    let texts = Table::ALL.map(|table| rows(table, records, numbers));
    let texts: io::Result<Vec<_>> = texts.into_iter().collect();
    Ok(serde_json::to_string(&texts?)?)
}

fn rows(table: Table, records: &[RunRecord], numbers: usize) -> io::Result<String> {
    let mut writer = csv::Writer::from_writer(Vec::new());
    for record in records {
        for row in rows_of(table, record, numbers) {
            writer.write_record(row)?;
        }
    }
    let bytes = writer.into_inner().map_err(|error| error.into_error())?;
    String::from_utf8(bytes).map_err(io::Error::other)
}

/// The rows of a run in a table, each behind the number of the run; one that failed has `numbers` empty cells.
fn rows_of(table: Table, record: &RunRecord, numbers: usize) -> Vec<Vec<String>> {
    if table == Table::Runs {
        return vec![run_row(record, numbers)];
    }
    let Ok(outcome) = &record.outcome else {
        return Vec::new();
    };
    let run = record.turn.number.to_string();
    let row = |start: &[String], numbers: &[f64]| -> Vec<String> {
        let start = std::iter::once(&run).chain(start).cloned();
        start.chain(numbers.iter().copied().map(number)).collect()
    };
    let spectrum = outcome.spectrum.iter();
    let points = outcome.points.iter();
    let bearings = outcome.stiffness.iter();
    let traces = outcome.trace.iter();
    match table {
        Table::Runs => Vec::new(),
        Table::Spectra => spectrum
            .map(|line| {
                let start = [number(line.frequency), cell(line.order)];
                row(&start, &line.amplitudes)
            })
            .collect(),
        Table::Points => points
            .map(|point| row(&[number(point.time)], &point.displacement))
            .collect(),
        Table::Stiffness => bearings
            .map(|of| {
                let start = [of.bearing.to_string(), number(of.speed)];
                row(&start, &[of.stiffness, of.damping].concat())
            })
            .collect(),
        Table::Traces => traces
            .map(|TraceSeal { bytes, checksum }| {
                row(&[bytes.to_string(), format!("{checksum:016x}")], &[])
            })
            .collect(),
    }
}

fn run_row(record: &RunRecord, numbers: usize) -> Vec<String> {
    let mut row = vec![
        record.turn.number.to_string(),
        record.turn.direction.name().to_owned(),
    ];
    row.extend(record.values.iter().map(|value| number(*value)));
    match &record.outcome {
        Ok(outcome) => {
            // what a run does not have is an empty cell
            let known = |value: &f64| cell(Some(*value).filter(|value| !value.is_nan()));
            row.extend(outcome.numbers.iter().map(known));
            let warnings = outcome.warnings.join(BETWEEN_WARNINGS);
            row.extend(["done".to_owned(), String::new(), warnings]);
        }
        Err(message) => {
            row.extend(vec![String::new(); numbers]);
            let message = message.replace(['\n', '\r'], " ");
            row.extend(["failed".to_owned(), message, String::new()]);
        }
    }
    row
}

/// Bearing, speed, and the entries of K and C: `kxy_N_m`, `cxy_N_s_m`.
fn stiffness_columns() -> impl Iterator<Item = String> {
    let entries = |letter: char, unit: &'static str| {
        let entries = BearingStiffness::ENTRIES.into_iter();
        entries.map(move |(entry, ..)| format!("{letter}{entry}_{unit}"))
    };
    let start = ["bearing", "speed_rad_s"].map(str::to_owned);
    let entries = entries('k', "N_m").chain(entries('c', "N_s_m"));
    start.into_iter().chain(entries)
}

/// Writes the rows that a journal holds of a table.
pub(super) fn write_rows(content: &str, table: Table, out: &mut impl Write) -> io::Result<()> {
    let texts: Vec<String> = serde_json::from_str(content)?;
    let rows = texts.get(table as usize);
    out.write_all(rows.ok_or(io::ErrorKind::InvalidData)?.as_bytes())
}

/// Writes the line of names of a table.
pub(super) fn write_header(header: &[String], out: &mut impl Write) -> io::Result<()> {
    let mut writer = csv::Writer::from_writer(out);
    writer.write_record(header)?;
    writer.flush()
}
