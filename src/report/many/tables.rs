//! The tables of a study: a row a run, a row a line of its spectrum, a row a point.

use std::io;
use std::path::PathBuf;

use super::head::StudyHead;
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

/// A table with rows of every run that is done, besides that of the runs.
struct Table {
    file: &'static str,
    is_kept: fn(&StudyHead) -> bool,
    /// Its columns behind the number of the run.
    columns: fn(&StudyHead) -> Vec<Column>,
    /// The rows of a run without its number.
    rows: fn(&Outcome) -> Vec<Cells>,
}

/// Amplitudes and named peaks, places of the shaft, stiffness of every bearing, every bearing all around, and what the traces are
/// known by.
static TABLES: [Table; 6] = [
    Table {
        file: "spectra.csv",
        is_kept: |head| head.keep.highest_order.is_some(),
        columns: |head| {
            let amplitudes = head.displacements.iter();
            let amplitudes = amplitudes.map(|channel| channel.measure("amplitude"));
            let axes = [Column::frequency(), Column::order()];
            axes.into_iter().chain(amplitudes).collect()
        },
        rows: |outcome| {
            let lines = outcome.spectrum.iter();
            lines
                .map(|line| {
                    let place = vec![number(line.frequency), cell(line.order)];
                    row(place, &line.amplitudes)
                })
                .collect()
        },
    },
    Table {
        file: "peaks.csv",
        is_kept: |head| head.keep.highest_order.is_some(),
        columns: |_| {
            vec![
                Column::words("channel", NO_WORDS),
                Column::words("unit", NO_WORDS),
                Column::frequency(),
                Column::order(),
                Column::number("amplitude", ""),
                Column::words("name", NO_WORDS),
            ]
        },
        rows: |outcome| {
            let peaks = outcome.peaks.iter();
            peaks
                .map(|peak| {
                    vec![
                        peak.channel.name().to_owned(),
                        peak.channel.unit().to_owned(),
                        number(peak.frequency),
                        cell(peak.order),
                        number(peak.amplitude),
                        peak.name.clone().unwrap_or_default(),
                    ]
                })
                .collect()
        },
    },
    Table {
        file: "poincare.csv",
        is_kept: |head| head.keep.section.is_some(),
        columns: |head| {
            let displacements = head.displacements.iter().map(|channel| channel.column());
            std::iter::once(Channel::Time.column())
                .chain(displacements)
                .collect()
        },
        rows: |outcome| {
            let points = outcome.points.iter();
            points
                .map(|point| row(vec![number(point.time)], &point.displacement))
                .collect()
        },
    },
    Table {
        file: "stiffness.csv",
        is_kept: |head| head.keep.bearing_stiffness,
        columns: |_| stiffness_columns(),
        rows: |outcome| {
            let bearings = outcome.stiffness.iter();
            bearings
                .map(|of| {
                    let start = vec![of.bearing.to_string(), number(of.speed)];
                    row(start, &[of.stiffness, of.damping].concat())
                })
                .collect()
        },
    },
    Table {
        file: "around.csv",
        is_kept: |head| head.ask == Ask::Bearing,
        columns: |_| {
            let numbers = AROUND.map(|(quantity, unit, _)| Column::number(quantity, unit));
            let start = ["bearing", "row", "position"].map(Column::count);
            start.into_iter().chain(numbers).collect()
        },
        rows: |outcome| {
            let places = outcome.around.iter();
            places
                .map(|place| {
                    let start = [place.bearing, place.row, place.position];
                    row(
                        start.map(|number| number.to_string()).into(),
                        &place.numbers,
                    )
                })
                .collect()
        },
    },
    Table {
        file: "traces.csv",
        is_kept: |head| head.keep.traces,
        columns: |_| vec![Column::count("bytes"), Column::words("checksum", NO_WORDS)],
        rows: |outcome| {
            let traces = outcome.trace.iter();
            traces
                .map(|TraceSeal { bytes, checksum }| {
                    vec![bytes.to_string(), format!("{checksum:08x}")]
                })
                .collect()
        },
    },
];

/// Numbers behind the first cells of a row.
fn row(start: Cells, numbers: &[f64]) -> Cells {
    let numbers = numbers.iter().copied().map(number);
    start.into_iter().chain(numbers).collect()
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

/// A table while it is written.
type Writer = (PathBuf, csv::Writer<PartialFile>);

/// The tables of a study while they are written.
pub(super) struct Tables<'a> {
    head: &'a StudyHead,
    runs: Writer,
    others: Vec<(&'static Table, Writer)>,
}

impl<'a> Tables<'a> {
    /// Begins the tables that the study keeps.
    pub fn begin(folder: &RunFolder, head: &'a StudyHead) -> Result<Self, ReportError> {
        let begin = |file, columns: Vec<Column>| {
            let file = folder.create(file)?;
            let path = file.path().to_owned();
            let mut writer = csv::Writer::from_writer(file);
            let written = writer.write_record(columns.iter().map(Column::name));
            written.map_err(refused(&path))?;
            Ok((path, writer))
        };
        let runs = begin("runs.csv", run_columns(head))?;
        let kept = TABLES.iter().filter(|table| (table.is_kept)(head));
        let others = kept.map(|table| {
            let columns = [vec![Column::count("run")], (table.columns)(head)].concat();
            Ok((table, begin(table.file, columns)?))
        });
        let others = others.collect::<Result<_, _>>()?;
        Ok(Self { head, runs, others })
    }

    /// Adds the rows of a run.
    pub fn add(&mut self, record: &RunRecord) -> Result<(), ReportError> {
        let (path, runs) = &mut self.runs;
        let written = runs.write_record(run_row(self.head, record));
        written.map_err(refused(path))?;
        let Ok(outcome) = &record.outcome else {
            return Ok(());
        };
        let run = record.run.to_string();
        for (table, (path, writer)) in &mut self.others {
            let rows = (table.rows)(outcome);
            let mut rows = rows.iter().map(|row| std::iter::once(&run).chain(row));
            let written = rows.try_for_each(|row| writer.write_record(row));
            written.map_err(refused(path))?;
        }
        Ok(())
    }

    /// Ends them.
    pub fn end(self) -> Result<Vec<WholeFile>, ReportError> {
        let others = self.others.into_iter().map(|(_, writer)| writer);
        let end = |(path, writer): Writer| {
            let file = writer.into_inner();
            let file = file.map_err(|error| refused(&path)(error.into_error().into()))?;
            file.close()
        };
        std::iter::once(self.runs).chain(others).map(end).collect()
    }
}

fn refused(path: &std::path::Path) -> impl FnOnce(csv::Error) -> ReportError {
    let refused = ReportError::file(FileAction::Write, path);
    move |error| refused(io::Error::from(error))
}
