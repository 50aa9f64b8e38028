//! The tables of a study: a row a run, a row a line of its spectrum, a row a point.

use std::io;
use std::path::PathBuf;

use super::rows::StudyHead;
use crate::analysis::Channel;
use crate::report::table::{cell, number};
use crate::report::variable::variable_column;
use crate::report::{FileAction, PartialFile, ReportError, RunFolder, WholeFile};
use crate::study::many::{AROUND, Ask, BearingStiffness, Outcome, RunRecord, TraceSeal};
use crate::table::Column;

/// Separator of two warnings of a run.
const BETWEEN_WARNINGS: &str = " | ";

/// The cells of a row, as texts.
type Cells = Vec<String>;

/// A table of a study.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Table {
    /// Values and numbers of every run.
    Runs,
    /// Amplitudes of every run.
    Spectra,
    /// Named peaks of every run.
    Peaks,
    /// Places of the shaft in every run.
    Points,
    /// Stiffness of every bearing in every run.
    Stiffness,
    /// Every bearing all around in every static answer.
    Around,
    /// What the trace of every run is known by.
    Traces,
}

impl Table {
    const ALL: [Self; 7] = [
        Self::Runs,
        Self::Spectra,
        Self::Peaks,
        Self::Points,
        Self::Stiffness,
        Self::Around,
        Self::Traces,
    ];

    fn is_kept(self, head: &StudyHead) -> bool {
        let keep = &head.keep;
        match self {
            Self::Runs => true,
            Self::Spectra | Self::Peaks => keep.highest_order.is_some(),
            Self::Points => keep.section.is_some(),
            Self::Stiffness => keep.bearing_stiffness,
            Self::Around => head.ask == Ask::Bearing,
            Self::Traces => keep.traces,
        }
    }

    fn file(self) -> &'static str {
        match self {
            Self::Runs => "runs.csv",
            Self::Spectra => "spectra.csv",
            Self::Peaks => "peaks.csv",
            Self::Points => "poincare.csv",
            Self::Stiffness => "stiffness.csv",
            Self::Around => "around.csv",
            Self::Traces => "traces.csv",
        }
    }

    fn columns(self, head: &StudyHead) -> Vec<Column> {
        let displacements = head.displacements.iter();
        let own = match self {
            Self::Runs => return run_columns(head),
            Self::Spectra => {
                let axes = [Column::frequency(), Column::order()];
                let amplitudes = displacements.map(|channel| channel.measure("amplitude"));
                axes.into_iter().chain(amplitudes).collect()
            }
            Self::Peaks => {
                let [channel, unit, name] =
                    ["channel", "unit", "name"].map(|quantity| Column::words(quantity, NO_WORDS));
                let amplitude = Column::number("amplitude", "");
                vec![
                    channel,
                    unit,
                    Column::frequency(),
                    Column::order(),
                    amplitude,
                    name,
                ]
            }
            Self::Points => {
                let time = [Channel::Time.column()].into_iter();
                time.chain(displacements.map(|channel| channel.column()))
                    .collect()
            }
            Self::Stiffness => stiffness_columns(),
            Self::Around => {
                let numbers = AROUND.map(|(quantity, unit, _)| Column::number(quantity, unit));
                let start = [Column::count("bearing"), Column::count("position")];
                start.into_iter().chain(numbers).collect()
            }
            Self::Traces => vec![Column::count("bytes"), Column::words("checksum", NO_WORDS)],
        };
        [vec![Column::count("run")], own].concat()
    }

    /// The rows of a run, but for the table of runs, each without the number of the run.
    fn rows(self, outcome: &Outcome) -> Vec<Cells> {
        let row = |start: Cells, numbers: &[f64]| -> Cells {
            let numbers = numbers.iter().copied().map(number);
            start.into_iter().chain(numbers).collect()
        };
        match self {
            Self::Runs => Vec::new(),
            Self::Spectra => (outcome.spectrum.iter())
                .map(|line| {
                    let start = vec![number(line.frequency), cell(line.order)];
                    row(start, &line.amplitudes)
                })
                .collect(),
            Self::Peaks => (outcome.peaks.iter())
                .map(|peak| {
                    let [of, unit] = [peak.channel.name(), peak.channel.unit()];
                    vec![
                        of.to_owned(),
                        unit.to_owned(),
                        number(peak.frequency),
                        cell(peak.order),
                        number(peak.amplitude),
                        peak.name.clone().unwrap_or_default(),
                    ]
                })
                .collect(),
            Self::Points => (outcome.points.iter())
                .map(|point| row(vec![number(point.time)], &point.displacement))
                .collect(),
            Self::Stiffness => (outcome.stiffness.iter())
                .map(|of| {
                    let start = vec![of.bearing.to_string(), number(of.speed)];
                    row(start, &[of.stiffness, of.damping].concat())
                })
                .collect(),
            Self::Around => (outcome.around.iter())
                .map(|place| {
                    let start = vec![place.bearing.to_string(), place.position.to_string()];
                    row(start, &place.numbers)
                })
                .collect(),
            Self::Traces => (outcome.trace.iter())
                .map(|TraceSeal { bytes, checksum }| {
                    vec![bytes.to_string(), format!("{checksum:08x}")]
                })
                .collect(),
        }
    }
}

/// The words of columns whose cells are texts.
const NO_WORDS: [&str; 0] = [];

/// The columns of the table of runs.
fn run_columns(head: &StudyHead) -> Vec<Column> {
    let text = |quantity: &'static str| Column::words(quantity, NO_WORDS);
    let mut columns = vec![Column::count("run"), text("direction")];
    columns.extend(head.axes.iter().map(variable_column));
    columns.extend(head.numbers.iter().cloned());
    columns.extend(["status", "error", "warnings"].map(text));
    columns
}

/// A row of the table of runs.
fn run_row(head: &StudyHead, record: &RunRecord) -> Cells {
    let mut row = vec![record.run.to_string(), record.direction.name().to_owned()];
    let values = head.axes.iter().zip(&record.values);
    row.extend(values.map(|(axis, value)| match axis.word(*value) {
        Some(word) => word.to_owned(),
        None => number(*value),
    }));
    match &record.outcome {
        Ok(outcome) => {
            // what a run does not have is an empty cell
            let known = |value: &f64| cell(Some(*value).filter(|value| !value.is_nan()));
            row.extend(outcome.numbers.iter().map(known));
            let warnings = outcome.warnings.join(BETWEEN_WARNINGS);
            row.extend(["done".to_owned(), String::new(), warnings]);
        }
        Err(message) => {
            row.extend(vec![String::new(); head.numbers.len()]);
            let message = message.replace(['\n', '\r'], " ");
            row.extend(["failed".to_owned(), message, String::new()]);
        }
    }
    row
}

/// Bearing, speed, and the entries of K and C: `kxy_N_m`, `cxy_N_s_m`.
fn stiffness_columns() -> Vec<Column> {
    let mut columns = vec![Column::count("bearing"), Channel::Speed.column()];
    for (letter, unit) in [('k', "N/m"), ('c', "N s/m")] {
        let entries = BearingStiffness::ENTRIES.iter();
        columns.extend(entries.map(|(entry, ..)| Column::number(format!("{letter}{entry}"), unit)));
    }
    columns
}

/// The tables of a study while they are written.
pub(super) struct Tables<'a> {
    head: &'a StudyHead,
    files: Vec<(Table, PathBuf, csv::Writer<PartialFile>)>,
}

impl<'a> Tables<'a> {
    /// Begins the tables that the study keeps.
    pub fn begin(folder: &RunFolder, head: &'a StudyHead) -> Result<Self, ReportError> {
        let kept = Table::ALL.into_iter().filter(|table| table.is_kept(head));
        let begin = |table: Table| {
            let file = folder.create(table.file())?;
            let path = file.path().to_owned();
            let mut writer = csv::Writer::from_writer(file);
            let written = writer.write_record(table.columns(head).iter().map(Column::name));
            written.map_err(refused(&path))?;
            Ok((table, path, writer))
        };
        let files = kept.map(begin).collect::<Result<_, _>>()?;
        Ok(Self { head, files })
    }

    /// Adds the rows of a run.
    pub fn add(&mut self, record: &RunRecord) -> Result<(), ReportError> {
        let run = record.run.to_string();
        for (table, path, writer) in &mut self.files {
            let written = match (&table, &record.outcome) {
                (Table::Runs, _) => writer.write_record(run_row(self.head, record)),
                (_, Err(_)) => Ok(()),
                (_, Ok(outcome)) => table
                    .rows(outcome)
                    .iter()
                    .try_for_each(|row| writer.write_record(std::iter::once(&run).chain(row))),
            };
            written.map_err(refused(path))?;
        }
        Ok(())
    }

    /// Ends them.
    pub fn end(self) -> Result<Vec<WholeFile>, ReportError> {
        let end = |(_, path, writer): (Table, PathBuf, csv::Writer<PartialFile>)| {
            let file = writer.into_inner();
            let file = file.map_err(|error| refused(&path)(error.into_error().into()))?;
            file.close()
        };
        self.files.into_iter().map(end).collect()
    }
}

fn refused(path: &std::path::Path) -> impl FnOnce(csv::Error) -> ReportError {
    let refused = ReportError::file(FileAction::Write, path);
    move |error| refused(io::Error::from(error))
}
