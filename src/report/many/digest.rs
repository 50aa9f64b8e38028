//! What the rows of a study say as a whole.

use std::collections::BTreeMap;

use serde::Serialize;
use serde_json::{Value, json};

use super::column_digest::{ColumnDigest, QUANTILES, quantiles};
use super::head::StudyHead;
use super::statistics::{ResponsePeak, Sensitivity, peaks, sensitivities};
use crate::report::figure::Figure;
use crate::report::findings::versioned;
use crate::report::terminal::{Lines, digits, or_dash, shown_column};
use crate::report::variable::axis_label;
use crate::report::{FileSet, Findings};
use crate::study::many::{Direction, RunRecord};

/// Most rows that are looked at for quantiles and figures: of more, every so many.
const MOST_ROWS: u64 = 8_000;

/// Most kinds of warnings that are told.
const MOST_WARNINGS: usize = 20;

/// Most failed runs that are named.
const MOST_FAILURES: usize = 20;

/// A run that failed.
#[derive(Debug, Clone, PartialEq, Serialize)]
struct FailedRun {
    /// Its number.
    run: u64,
    /// Values of the axes, in the units of their columns.
    values: Vec<f64>,
    /// Why, in words.
    error: String,
}

/// A warning of one run or more, in the words of the first of them.
#[derive(Debug, Clone, PartialEq)]
struct RunsWarned {
    /// Number of the first run.
    run: u64,
    /// Number of runs that have the same one but for its numbers, of one bearing and race.
    runs: u64,
    /// The latest of them that was counted.
    latest: u64,
    /// Its words.
    warning: String,
}

/// What the rows of a study say as a whole.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Digest {
    /// What they are rows of.
    pub(super) head: StudyHead,
    /// Number of runs.
    runs: u64,
    /// Number of those that failed.
    failed: u64,
    /// The first of them.
    failures: Vec<FailedRun>,
    /// Warnings of the runs.
    warnings: Vec<RunsWarned>,
    pub(super) columns: Vec<ColumnDigest>,
    /// Rows that are drawn, without spectra and points: every `stride`-th of those that were done.
    pub(super) rows: Vec<RunRecord>,
    stride: u64,
    /// Highest frequency of all spectra, Hz.
    pub(super) highest_frequency: f64,
    /// Number of points of all runs.
    pub(super) points: usize,
    pub(super) sensitivities: Vec<Sensitivity>,
    peaks: Vec<ResponsePeak>,
}

impl Digest {
    /// Of no rows yet.
    pub(super) fn new(head: &StudyHead) -> Self {
        Self {
            columns: head
                .numbers
                .iter()
                .cloned()
                .map(ColumnDigest::new)
                .collect(),
            head: head.clone(),
            runs: 0,
            failed: 0,
            failures: Vec::new(),
            warnings: Vec::new(),
            rows: Vec::new(),
            stride: 1,
            highest_frequency: 0.0,
            points: 0,
            sensitivities: Vec::new(),
            peaks: Vec::new(),
        }
    }

    /// Takes the row of the next run.
    pub(super) fn add(&mut self, mut row: RunRecord) {
        self.runs += 1;
        if let Ok(outcome) = &mut row.outcome {
            let spectrum = std::mem::take(&mut outcome.spectrum);
            let highest = spectrum.last().map_or(0.0, |line| line.frequency);
            self.highest_frequency = self.highest_frequency.max(highest);
            self.points += std::mem::take(&mut outcome.points).len();
            outcome.peaks.clear();
        }
        match &mut row.outcome {
            Err(error) => {
                self.failed += 1;
                if self.failures.len() < MOST_FAILURES {
                    self.failures.push(FailedRun {
                        run: row.run,
                        values: row.values,
                        error: error.replace(['\n', '\r'], " "),
                    });
                }
            }
            Ok(outcome) => {
                for warning in std::mem::take(&mut outcome.warnings) {
                    self.warn(row.run, &warning);
                }
                for (column, value) in self.columns.iter_mut().zip(&outcome.numbers) {
                    column.add(row.run, *value);
                }
                outcome.numbers.shrink_to_fit();
                self.keep(row);
            }
        }
    }

    /// Keeps the row of a run that was done, if it is one of those that are drawn.
    fn keep(&mut self, row: RunRecord) {
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

    /// Ends the digest: what rests on all rows together.
    pub(super) fn finish(&mut self) {
        if !self.head.drawn {
            self.peaks = peaks(self);
            return;
        }
        for (index, column) in self.columns.iter_mut().enumerate() {
            let found = quantiles(self.rows.iter().map(|row| number(row, index)));
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
        self.head
            .numbers
            .iter()
            .position(|column| column.name() == name)
    }

    /// The largest measured error of all runs that have one.
    fn largest_error(&self) -> Option<f64> {
        let column = &self.columns[self.column("measured_error")?];
        (column.known > 0).then_some(column.highest)
    }

    /// Numbers of runs whose error was measured.
    fn measured(&self) -> u64 {
        let column = self.column("measured_error");
        column.map_or(0, |column| self.columns[column].known)
    }

    /// All that is told of the study, with what is drawn of it.
    pub(super) fn findings(&self, figures: Vec<Figure>) -> Findings {
        let StudyHead {
            title, study, base, ..
        } = &self.head;
        let warnings: Vec<_> = self.warnings.iter().map(RunsWarned::to_string).collect();
        let document = versioned(json!({
            "title": title,
            "study": { "study": study, "base": base },
            "digest": self.json(),
            "warnings": warnings,
        }));
        Findings {
            figures,
            incomplete: self.failed > 0,
            ..Findings::of_document(FileSet::RUNS, document, self.text())
        }
    }

    /// The digest for people.
    fn text(&self) -> Lines {
        let mut out = Lines::titled(&self.head.title);
        let failed = match self.failed {
            0 => String::new(),
            failed => format!(", {failed} failed; alone again by --only I"),
        };
        out.line("runs", format!("{} done{failed}", self.runs - self.failed));
        for FailedRun { run, error, .. } in &self.failures {
            out.more(format!("run {run}: {error}"));
        }
        if let Some(error) = self.largest_error() {
            let runs = self.measured();
            let noun = if runs == 1 { "run" } else { "runs" };
            out.line(
                "error",
                format!("at most {error:.1e} of the motion in the {runs} {noun} that measured it"),
            );
        }
        self.tell_peaks(&mut out);
        out
    }

    /// The peaks along the only axis, a row each.
    fn tell_peaks(&self, out: &mut Lines) {
        let ([axis], [_, ..]) = (&self.head.axes[..], &self.peaks[..]) else {
            return;
        };
        let at = axis_label(axis).to_string();
        let header = [
            "resonance",
            "direction",
            &at,
            "height",
            "half power from",
            "to",
        ];
        let rows = self.peaks.iter().map(|peak| {
            let half_power = [peak.half_power_from, peak.half_power_to];
            let shown = |at: f64| digits(axis.shown(at));
            let [from, to] = half_power.map(|at| or_dash(at.map(shown)));
            let ((number, unit), factor) = shown_column(&peak.number);
            vec![
                number,
                peak.direction.to_owned(),
                shown(peak.at),
                format!("{} {unit}", digits(factor * peak.height)),
                from,
                to,
            ]
        });
        out.table(header, rows);
    }

    /// The digest as it is written into the document.
    fn json(&self) -> Value {
        let known = self.columns.iter().filter(|column| column.known > 0);
        let numbers: BTreeMap<_, _> = known.map(|of| (of.column.name(), of)).collect();
        json!({
            "runs": self.runs,
            "failed": self.failed,
            // the first of them
            "failures": self.failures,
            "largest_measured_error": self.largest_error(),
            "runs_with_measured_error": self.measured(),
            "numbers": numbers,
            // null where the runs were not drawn
            "quantiles_of_every": self.head.drawn.then_some(self.stride),
            // peaks along the only axis
            "resonances": self.peaks,
            // how the numbers follow the axes
            "sensitivities": self.sensitivities,
        })
    }
}

/// A number of a run; NaN where it has none.
pub(super) fn number(row: &RunRecord, column: usize) -> f64 {
    let numbers = row.outcome.as_ref().ok().map(|outcome| &outcome.numbers);
    numbers
        .and_then(|numbers| numbers.get(column).copied())
        .unwrap_or(f64::NAN)
}

/// Whether a run was come to from the value above.
pub(super) fn is_down(row: &RunRecord) -> bool {
    row.direction == Direction::Down
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_run_counts_once_in_a_warning_and_bearings_have_their_own() {
        let mut digest = Digest::new(&StudyHead::of_tests());
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
