//! The tables of a study: a row a run, a row a line of its spectrum, a row a point.

use std::io::{self, Write};

use crate::analysis::Channel;
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

    /// The rows of some runs in all tables, as a journal holds them: the text of each in one line of JSON.
    pub(super) fn content(&self, records: &[RunRecord]) -> io::Result<String> {
        let texts: io::Result<Vec<_>> = Table::ALL
            .iter()
            .map(|table| self.rows(*table, records))
            .collect();
        Ok(serde_json::to_string(&texts?)?)
    }

    fn rows(&self, table: Table, records: &[RunRecord]) -> io::Result<String> {
        let mut writer = csv::Writer::from_writer(Vec::new());
        for record in records {
            for row in self.rows_of(table, record) {
                writer.write_record(row)?;
            }
        }
        let bytes = writer.into_inner().map_err(|error| error.into_error())?;
        String::from_utf8(bytes).map_err(io::Error::other)
    }

    /// The rows of a run in a table, each behind the number of the run.
    fn rows_of(&self, table: Table, record: &RunRecord) -> Vec<Vec<String>> {
        if table == Table::Runs {
            return vec![self.run_row(record)];
        }
        let Ok(outcome) = &record.outcome else {
            return Vec::new();
        };
        let run = record.turn.number.to_string();
        let row = |start: &[String], numbers: &mut dyn Iterator<Item = &f64>| {
            let start = std::iter::once(&run).chain(start).cloned();
            start.chain(numbers.map(|value| number(*value))).collect()
        };
        match table {
            Table::Runs => Vec::new(),
            Table::Spectra => {
                let lines = outcome.spectrum.iter();
                let rows = lines.map(|line| {
                    let start = [number(line.frequency), cell(line.order)];
                    row(&start, &mut line.amplitudes.iter())
                });
                rows.collect()
            }
            Table::Points => {
                let points = outcome.points.iter();
                let rows =
                    points.map(|point| row(&[number(point.time)], &mut point.displacement.iter()));
                rows.collect()
            }
            Table::Stiffness => {
                let bearings = outcome.stiffness.iter();
                let rows = bearings.map(|of| {
                    let start = [of.bearing.to_string(), number(of.speed)];
                    row(&start, &mut of.stiffness.iter().chain(&of.damping))
                });
                rows.collect()
            }
            Table::Traces => {
                let traces = outcome.trace.iter();
                let rows = traces.map(|TraceSeal { bytes, checksum }| {
                    let known = [bytes.to_string(), format!("{checksum:016x}")];
                    row(&known, &mut std::iter::empty())
                });
                rows.collect()
            }
        }
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
    let held = Table::ALL
        .iter()
        .zip(texts)
        .find(|(held, _)| **held == table);
    let (_, rows) = held.ok_or(io::ErrorKind::InvalidData)?;
    out.write_all(rows.as_bytes())
}

/// Writes the line of names of a table.
pub(super) fn write_header(header: &[String], out: &mut impl Write) -> io::Result<()> {
    let mut writer = csv::Writer::from_writer(out);
    writer.write_record(header)?;
    writer.flush()
}
