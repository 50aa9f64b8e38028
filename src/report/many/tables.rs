//! The tables of a study: a row a run, a row a line of its spectrum, a row a point.

use std::io::{self, Write};

use crate::analysis::Channel;
use crate::report::bytes::{Put, Take};
use crate::report::spectra::amplitude_column;
use crate::report::study::column_name;
use crate::report::table::{cell, number};
use crate::study::Variable;
use crate::study::many::{BearingStiffness, Keep, NumberColumn, RunRecord, TraceSeal};

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

    /// Whether a study has it.
    pub fn is_kept(self, keep: &Keep) -> bool {
        match self {
            Self::Runs => true,
            Self::Spectra => keep.highest_order.is_some(),
            Self::Points => keep.section.is_some(),
            Self::Stiffness => keep.bearing_stiffness,
            Self::Traces => keep.traces,
        }
    }
}

/// What the tables of a study hold.
#[derive(Debug, Clone, Copy)]
pub struct Layout<'a> {
    /// What varies.
    pub variables: &'a [Variable],
    /// Numbers of a run.
    pub columns: &'a [NumberColumn],
    /// Number of freedoms that move.
    pub freedoms: usize,
    /// What is kept.
    pub keep: Keep,
}

impl Layout<'_> {
    /// The line of names.
    pub(super) fn header(&self, table: Table) -> Vec<String> {
        let displacements = (0..self.freedoms).map(Channel::Displacement);
        let run = std::iter::once("run".to_owned());
        match table {
            Table::Runs => {
                let turn = ["direction".to_owned()];
                let variables = self.variables.iter().map(column_name);
                let numbers = self.columns.iter().map(|column| column.name.clone());
                let ends = ["status", "error", "warnings"].map(str::to_owned);
                let start = run.chain(turn).chain(variables);
                start.chain(numbers).chain(ends).collect()
            }
            Table::Spectra => {
                let frequency = ["frequency_Hz", "order"].map(str::to_owned);
                let amplitudes = displacements.map(amplitude_column);
                run.chain(frequency).chain(amplitudes).collect()
            }
            Table::Points => {
                let time = ["time_s".to_owned()];
                run.chain(time)
                    .chain(displacements.map(Channel::column))
                    .collect()
            }
            Table::Stiffness => run.chain(stiffness_columns()).collect(),
            Table::Traces => {
                let known = ["bytes", "checksum"].map(str::to_owned);
                run.chain(known).collect()
            }
        }
    }

    /// The rows of some runs in all tables, as a journal holds them.
    pub(super) fn content(&self, records: &[RunRecord]) -> io::Result<Vec<u8>> {
        let mut content = Vec::new();
        for table in Table::ALL {
            content.put_text(&self.rows(table, records)?);
        }
        Ok(content)
    }

    fn rows(&self, table: Table, records: &[RunRecord]) -> io::Result<String> {
        let mut writer = csv::Writer::from_writer(Vec::new());
        for record in records {
            match table {
                Table::Runs => writer.write_record(self.run_row(record))?,
                Table::Spectra => {
                    for row in spectrum_rows(record) {
                        writer.write_record(row)?;
                    }
                }
                Table::Points => {
                    for row in point_rows(record) {
                        writer.write_record(row)?;
                    }
                }
                Table::Stiffness => {
                    for row in stiffness_rows(record) {
                        writer.write_record(row)?;
                    }
                }
                Table::Traces => {
                    if let Some(row) = trace_row(record) {
                        writer.write_record(row)?;
                    }
                }
            }
        }
        let bytes = writer.into_inner().map_err(|error| error.into_error())?;
        String::from_utf8(bytes).map_err(io::Error::other)
    }

    fn run_row(&self, record: &RunRecord) -> Vec<String> {
        let mut row = vec![
            record.turn.number.to_string(),
            record.direction().name().to_owned(),
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
                row.extend(self.columns.iter().map(|_| String::new()));
                let message = message.replace(['\n', '\r'], " ");
                row.extend(["failed".to_owned(), message, String::new()]);
            }
        }
        row
    }
}

fn spectrum_rows(record: &RunRecord) -> impl Iterator<Item = Vec<String>> {
    let lines = record.outcome.as_ref().ok().into_iter();
    let lines = lines.flat_map(|outcome| &outcome.spectrum);
    lines.map(|line| {
        let start = [
            record.turn.number.to_string(),
            number(line.frequency),
            cell(line.order),
        ];
        let amplitudes = line.amplitudes.iter().map(|value| number(*value));
        start.into_iter().chain(amplitudes).collect()
    })
}

fn point_rows(record: &RunRecord) -> impl Iterator<Item = Vec<String>> {
    let points = record.outcome.as_ref().ok().into_iter();
    let points = points.flat_map(|outcome| &outcome.points);
    points.map(|point| {
        let start = [record.turn.number.to_string(), number(point.time)];
        let places = point.displacement.iter().map(|value| number(*value));
        start.into_iter().chain(places).collect()
    })
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

fn stiffness_rows(record: &RunRecord) -> impl Iterator<Item = Vec<String>> {
    let bearings = record.outcome.as_ref().ok().into_iter();
    let bearings = bearings.flat_map(|outcome| &outcome.stiffness);
    bearings.map(|bearing| {
        let start = [
            record.turn.number.to_string(),
            bearing.bearing.to_string(),
            number(bearing.speed),
        ];
        let entries = bearing.stiffness.iter().chain(&bearing.damping);
        let entries = entries.map(|entry| number(*entry));
        start.into_iter().chain(entries).collect()
    })
}

fn trace_row(record: &RunRecord) -> Option<[String; 3]> {
    let TraceSeal { bytes, checksum } = record.outcome.as_ref().ok()?.trace?;
    Some([
        record.turn.number.to_string(),
        bytes.to_string(),
        format!("{checksum:016x}"),
    ])
}

/// Writes the rows that a journal holds of a table.
pub(super) fn write_rows(content: &[u8], table: Table, out: &mut impl Write) -> io::Result<()> {
    let mut take = Take(content);
    for held in Table::ALL {
        let length = take.u64();
        let rows = length.and_then(|length| take.bytes(length));
        let rows = rows.ok_or_else(|| io::Error::from(io::ErrorKind::InvalidData))?;
        if held == table {
            return out.write_all(rows);
        }
    }
    Ok(())
}

/// Writes the line of names of a table.
pub(super) fn write_header(header: &[String], out: &mut impl Write) -> io::Result<()> {
    let mut writer = csv::Writer::from_writer(out);
    writer.write_record(header)?;
    writer.flush()
}
