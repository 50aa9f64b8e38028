//! What the table of runs says as a whole.

use std::collections::BTreeMap;
use std::path::Path;

use serde::Serialize;
use serde_json::Value;

use super::each_row;
use super::statistics::{ResponsePeak, Sensitivity, peaks, sensitivities};
use super::tables::BETWEEN_WARNINGS;
use crate::report::ReportError;
use crate::report::study::{axis_label, unit_of_column};
use crate::report::terminal::shown_unit;
use crate::scenario::written_unit;

/// Most rows that are looked at for quantiles and figures: of more, every so many.
const MOST_ROWS: u64 = 20_000;
/// Most kinds of warnings that are told.
const MOST_WARNINGS: usize = 20;
/// Most failed runs that are named.
const MOST_FAILURES: usize = 20;
/// Runs whose rows are shown.
const MOST_SHOWN: usize = 100;
/// What changes by less than this part of it does not change.
const CONSTANT: f64 = 1e-9;
/// Quantiles that are told.
const QUANTILES: [f64; 5] = [0.05, 0.25, 0.5, 0.75, 0.95];

/// A run that failed.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct FailedRun {
    /// Its number.
    pub run: u64,
    /// Values of the axes, in the units of their columns.
    pub values: Vec<f64>,
    /// Why, in words.
    pub error: String,
}

/// A warning of one run or more, in the words of the first of them.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct RunsWarned {
    /// Number of the first run.
    pub run: u64,
    /// Number of runs that have the same one but for its numbers, of one bearing and race.
    pub runs: u64,
    /// The latest of them that was counted.
    #[serde(skip)]
    latest: u64,
    /// Its words.
    pub warning: String,
}

/// A row of the table.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Row {
    pub run: u64,
    /// Whether it was come to from the value above.
    pub down: bool,
    /// Values of the axes.
    pub values: Vec<f64>,
    /// Its numbers, NaN where it has none.
    pub numbers: Vec<f64>,
}

/// One number over all runs.
#[derive(Debug, Clone, PartialEq, Default, Serialize)]
pub(super) struct ColumnDigest {
    #[serde(skip)]
    pub name: String,
    /// Runs that have it.
    pub known: u64,
    mean: f64,
    pub lowest: f64,
    /// The run that has the lowest value.
    lowest_in_run: u64,
    pub highest: f64,
    highest_in_run: u64,
    /// Quantiles by their shares, where the runs were drawn.
    quantiles: Option<BTreeMap<String, f64>>,
}

/// The digest as it stands in `runs.json`.
#[derive(Debug, Serialize)]
pub struct DigestSummary<'a> {
    /// Number of runs.
    runs: u64,
    /// Number of those that failed.
    failed: u64,
    /// The first of them.
    failures: &'a [FailedRun],
    /// Warnings of the runs; those that differ by their numbers alone are one.
    warnings: &'a [RunsWarned],
    /// The largest measured error of all runs that have one.
    largest_measured_error: Option<f64>,
    runs_with_measured_error: u64,
    /// Every number by its name.
    numbers: BTreeMap<&'a str, &'a ColumnDigest>,
    /// Quantiles rest on every so many runs; null where the runs were not drawn.
    quantiles_of_every: Option<u64>,
    /// Peaks of numbers along the only axis.
    resonances: &'a [ResponsePeak],
    /// How the numbers follow the axes.
    sensitivities: &'a [Sensitivity],
}

/// The table of runs in short.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Digest {
    /// Number of runs.
    pub runs: u64,
    /// Number of those that failed.
    pub failed: u64,
    /// The first of them.
    pub failures: Vec<FailedRun>,
    /// Warnings of the runs.
    pub warnings: Vec<RunsWarned>,
    /// The line of names.
    pub(super) names: csv::StringRecord,
    /// The first rows as they stand in the table.
    pub(super) first: Vec<csv::StringRecord>,
    /// Names of the axes as columns.
    pub(super) axes: Vec<String>,
    /// What the axes are called for people, and by what their values are multiplied for that.
    pub(super) labels: Vec<(String, f64)>,
    pub(super) columns: Vec<ColumnDigest>,
    /// Rows that are drawn, every `stride`-th of those that were done.
    pub(super) rows: Vec<Row>,
    stride: u64,
    /// Names of the numbers that the study keeps, where it names any.
    pub(super) named: Option<Vec<String>>,
    /// Whether the runs were drawn instead of standing on a grid.
    pub(super) drawn: bool,
    pub(super) sensitivities: Vec<Sensitivity>,
    peaks: Vec<ResponsePeak>,
}

impl Digest {
    /// Reads the table of runs of a study.
    pub(super) fn of(runs: &Path, identity: &Value) -> Result<Self, ReportError> {
        let study = &identity["study"];
        let mut digest = None;
        each_row(runs, |names, record| {
            let digest = digest.get_or_insert_with(|| Self::empty(names.clone(), study));
            digest.read(record);
        })?;
        let mut digest = digest.unwrap_or_else(|| Self::empty(csv::StringRecord::new(), study));
        digest.finish();
        Ok(digest)
    }

    fn empty(names: csv::StringRecord, study: &Value) -> Self {
        let keys = study["axis"].as_array().map_or(&[][..], Vec::as_slice);
        let axes = keys.len();
        let columns = names.iter().skip(2);
        let labels = keys.iter().zip(columns).map(|(axis, column)| {
            let key = axis["key"].as_str().unwrap_or_default();
            let si = unit_of_column(key, column);
            let (unit, factor) = unit_of_axis(axis, si).unwrap_or_else(|| shown_unit(si));
            (axis_label(key, &unit), factor)
        });
        let own = |name: &str| name.to_owned();
        let numbers = names.len().saturating_sub(5 + axes);
        let columns = names.iter().skip(2 + axes).take(numbers);
        let named = study["keep"]["numbers"].as_array();
        Self {
            axes: names.iter().skip(2).take(axes).map(own).collect(),
            labels: labels.collect(),
            columns: columns.map(ColumnDigest::new).collect(),
            stride: 1,
            named: named.map(|names| names.iter().filter_map(Value::as_str).map(own).collect()),
            drawn: study["sampling"] != "grid",
            names,
            ..Self::default()
        }
    }

    /// Takes a row of the table.
    fn read(&mut self, record: csv::StringRecord) {
        let number = |cell: &str| cell.parse().unwrap_or(f64::NAN);
        let run = record.get(0).and_then(|run| run.parse().ok()).unwrap_or(0);
        let mut cells = record.iter().skip(2);
        let values = cells.by_ref().take(self.axes.len()).map(number).collect();
        let numbers = cells.by_ref().take(self.columns.len());
        let numbers = numbers.map(number).collect();
        let (status, error, warnings) = (cells.next(), cells.next(), cells.next());
        match status {
            Some("failed") => {
                self.runs += 1;
                self.failed += 1;
                if self.failures.len() < MOST_FAILURES {
                    let error = error.unwrap_or_default().to_owned();
                    self.failures.push(FailedRun { run, values, error });
                }
            }
            _ => {
                let warnings = warnings.unwrap_or_default().split(BETWEEN_WARNINGS);
                for warning in warnings.filter(|warning| !warning.is_empty()) {
                    self.warn(run, warning);
                }
                self.add(Row {
                    run,
                    down: record.get(1) == Some("down"),
                    values,
                    numbers,
                });
            }
        }
        if self.first.len() < MOST_SHOWN {
            self.first.push(record);
        }
    }

    fn warn(&mut self, run: u64, warning: &str) {
        let has_room = self.warnings.len() < MOST_WARNINGS;
        let same = |known: &&mut RunsWarned| words(&known.warning).eq(words(warning));
        match self.warnings.iter_mut().find(same) {
            // a run counts once, however often it has the warning
            Some(known) => {
                known.runs += u64::from(known.latest != run);
                known.latest = run;
            }
            None if has_room => self.warnings.push(RunsWarned {
                run,
                runs: 1,
                latest: run,
                warning: warning.to_owned(),
            }),
            None => {}
        }
    }

    fn add(&mut self, row: Row) {
        self.runs += 1;
        for (column, value) in self.columns.iter_mut().zip(&row.numbers) {
            column.add(row.run, *value);
        }
        let done = self.runs - self.failed - 1;
        if done.is_multiple_of(self.stride) {
            self.rows.push(row);
        }
        if self.rows.len() as u64 > MOST_ROWS {
            self.stride *= 2;
            let rows = std::mem::take(&mut self.rows).into_iter();
            self.rows = rows.step_by(2).collect();
        }
    }

    fn finish(&mut self) {
        if !self.drawn {
            self.peaks = peaks(self);
            return;
        }
        for (index, column) in self.columns.iter_mut().enumerate() {
            let found = quantiles(self.rows.iter().map(|row| row.numbers[index]));
            let shares = QUANTILES.map(|share| share.to_string());
            column.quantiles = found.map(|values| shares.into_iter().zip(values).collect());
        }
        self.sensitivities = sensitivities(self);
    }

    /// Whether all runs are among the rows.
    pub(super) fn is_complete(&self) -> bool {
        self.stride == 1
    }

    /// A column by its name.
    pub(super) fn column(&self, name: &str) -> Option<usize> {
        self.columns.iter().position(|column| column.name == name)
    }

    /// The row of a run, if it is among those that are drawn.
    pub(super) fn row(&self, run: u64) -> Option<&Row> {
        let found = self.rows.binary_search_by_key(&run, |row| row.run);
        found.ok().map(|place| &self.rows[place])
    }

    /// The largest measured error of all runs that have one.
    pub fn largest_error(&self) -> Option<f64> {
        let column = &self.columns[self.column("measured_error")?];
        (column.known > 0).then_some(column.highest)
    }

    /// Numbers of runs whose error was measured.
    pub fn measured(&self) -> u64 {
        let column = self.column("measured_error");
        column.map_or(0, |column| self.columns[column].known)
    }

    /// The digest for people.
    pub fn text(&self) -> String {
        let mut text = format!("  runs          {} done", self.runs - self.failed);
        if self.failed > 0 {
            text += &format!(", {} failed; alone again by --only I", self.failed);
        }
        text.push('\n');
        for FailedRun { run, error, .. } in &self.failures {
            text += &format!("    run {run}: {error}\n");
        }
        if let Some(error) = self.largest_error() {
            let runs = self.measured();
            let noun = if runs == 1 { "run" } else { "runs" };
            text += &format!(
                "  error         at most {error:.1e} of the motion in the {runs} {noun} that measured it\n"
            );
        }
        text
    }

    /// The digest for `runs.json`.
    pub fn summary(&self) -> DigestSummary<'_> {
        let known = self.columns.iter().filter(|column| column.known > 0);
        DigestSummary {
            runs: self.runs,
            failed: self.failed,
            failures: &self.failures,
            warnings: &self.warnings,
            largest_measured_error: self.largest_error(),
            runs_with_measured_error: self.measured(),
            numbers: known.map(|column| (column.name.as_str(), column)).collect(),
            quantiles_of_every: self.drawn.then_some(self.stride),
            resonances: &self.peaks,
            sensitivities: &self.sensitivities,
        }
    }
}

/// The unit that the values of an axis are written in, and how many of it make one of `si`.
fn unit_of_axis(axis: &Value, si: &str) -> Option<(String, f64)> {
    let listed = axis["values"].get(0).and_then(Value::as_str);
    let bound = ["from", "mean"].iter().find_map(|key| axis[*key].as_str());
    let (symbol, size) = written_unit(listed.or(bound)?, si)?;
    Some((symbol.replacen("um", "µm", 1), size.recip()))
}

/// The words of a warning that are no numbers, but for the number of a bearing, bare of punctuation.
fn words(warning: &str) -> impl Iterator<Item = &str> {
    let mut follows_bearing = false;
    warning.split_whitespace().filter_map(move |word| {
        let names_bearing = std::mem::replace(&mut follows_bearing, word == "bearing");
        let is_number = word.contains(|letter: char| letter.is_ascii_digit());
        match is_number {
            false => Some(word),
            true => names_bearing.then(|| word.trim_end_matches([',', ':'])),
        }
    })
}

impl std::fmt::Display for RunsWarned {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let (run, warning) = (self.run, &self.warning);
        match self.runs {
            1 => write!(f, "run {run}: {warning}"),
            runs => write!(f, "run {run} and {} more: {warning}", runs - 1),
        }
    }
}

impl ColumnDigest {
    fn new(name: &str) -> Self {
        Self {
            name: name.to_owned(),
            lowest: f64::INFINITY,
            highest: f64::NEG_INFINITY,
            ..Self::default()
        }
    }

    /// Whether more than one run has it and it is not the same in all.
    pub(super) fn varies(&self) -> bool {
        let size = self.lowest.abs().max(self.highest.abs());
        self.known > 1 && self.highest - self.lowest > CONSTANT * size
    }

    fn add(&mut self, run: u64, value: f64) {
        if value.is_nan() {
            return;
        }
        self.known += 1;
        self.mean += (value - self.mean) / self.known as f64;
        if value < self.lowest {
            (self.lowest, self.lowest_in_run) = (value, run);
        }
        if value > self.highest {
            (self.highest, self.highest_in_run) = (value, run);
        }
    }
}

/// Quantiles by linear interpolation between the order statistics, type 7 of Hyndman & Fan (1996).
fn quantiles(values: impl Iterator<Item = f64>) -> Option<[f64; QUANTILES.len()]> {
    let mut sorted: Vec<f64> = values.filter(|value| !value.is_nan()).collect();
    sorted.sort_by(f64::total_cmp);
    let last = sorted.len().checked_sub(1)?;
    Some(QUANTILES.map(|share| {
        let place = share * last as f64;
        let below = place as usize;
        let above = (below + 1).min(last);
        let part = place - below as f64;
        sorted[below] * (1.0 - part) + sorted[above] * part
    }))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_run_counts_once_in_a_warning_and_bearings_have_their_own() {
        let mut digest = Digest::empty(csv::StringRecord::new(), &Value::Null);
        for run in [0, 1] {
            for bearing in [1, 2] {
                for load in [310, 320] {
                    let warning =
                        format!("bearing {bearing}, ball pressed with {load} N on the inner race");
                    digest.warn(run, &warning);
                }
            }
        }
        let counts: Vec<_> = digest.warnings.iter().map(|warned| warned.runs).collect();
        assert_eq!(counts, [2, 2]);
        let second = digest.warnings[1].to_string();
        assert!(
            second.starts_with("run 0 and 1 more: bearing 2,"),
            "{second}"
        );
    }

    #[test]
    fn quantiles_are_those_of_numpy() {
        let found = quantiles([3.0, 1.0, 2.0, 4.0].into_iter()).unwrap();
        // numpy.quantile([1, 2, 3, 4], [.05, .25, .5, .75, .95])
        let numpy = [1.15, 1.75, 2.5, 3.25, 3.85];
        for (found, numpy) in found.iter().zip(numpy) {
            assert!((found - numpy).abs() < 1e-12);
        }
    }
}
