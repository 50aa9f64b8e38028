//! What the rows of a study say as a whole.

use std::collections::BTreeMap;

use serde::Serialize;
use serde_json::{Value, json};

use super::column_digest::{ColumnDigest, QUANTILES, quantiles};
use super::head::StudyHead;
use super::rows::Rows;
use super::statistics::{ResponsePeak, Sensitivity, peaks, sensitivity, varies};
use crate::report::figure::Figure;
use crate::report::findings::versioned;
use crate::report::terminal::{Lines, digits, or_dash, shown_column};
use crate::report::variable::axis_label;
use crate::report::{FileSet, Findings, ReportError};
use crate::rotor::load::SplitMix64;
use crate::study::many::{Direction, RunRecord};
use crate::table::Table;

/// Most runs of a grid that are drawn: a map has no finer cells than a screen has places for them.
const MOST_ON_GRID: usize = 100_000;

/// Most runs that are drawn of values that are themselves drawn at random.
const MOST_SCATTERED: usize = 8_000;

/// Most values that are held at once for quantiles and rank correlations, 256 MB.
const MOST_VALUES: usize = 1 << 25;

/// Most kinds of warnings that are reported.
const MOST_WARNINGS: usize = 20;

/// Most numbers whose spread is reported.
const MOST_REPORTED: usize = 8;

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
    /// Rows that are drawn, without spectra and points: of many one of `one_of`, as [`is_drawn`](Self::is_drawn) chooses.
    pub(super) rows: Vec<RunRecord>,
    one_of: u64,
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
            one_of: 1,
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
            outcome.peaks = Vec::new();
            outcome.around = Vec::new();
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
        if self.is_drawn(row.run) {
            self.rows.push(row);
        }
        let most = match self.head.drawn {
            true => MOST_SCATTERED,
            false => MOST_ON_GRID,
        };
        while self.rows.len() > most {
            self.one_of *= 2;
            let mut rows = std::mem::take(&mut self.rows);
            rows.retain(|row| self.is_drawn(row.run));
            self.rows = rows;
        }
    }

    /// Whether a run is among those that are drawn: of a grid every so many; of values drawn at random such as a random number
    /// of its own chooses, as every 2ᵏ-th point of Sobol's sequence fills but a part of the ranges.
    fn is_drawn(&self, run: u64) -> bool {
        let place = match self.head.drawn {
            true => SplitMix64::new(0).bits(run),
            false => run,
        };
        place.is_multiple_of(self.one_of)
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
    ///
    /// # Errors
    /// [`ReportError::File`] where the rows cannot be read.
    pub(super) fn finish(&mut self, rows: &Rows) -> Result<(), ReportError> {
        match self.head.drawn {
            true => self.take_orders(rows),
            false => {
                self.peaks = peaks(self);
                Ok(())
            }
        }
    }

    /// Quantiles and rank correlations of all runs, read as many columns at a time as memory is taken for.
    fn take_orders(&mut self, rows: &Rows) -> Result<(), ReportError> {
        let axes = self.head.axes.len();
        let runs = (self.runs - self.failed).max(1) as usize;
        let at_once = (MOST_VALUES / runs).saturating_sub(axes).max(1);
        let known: Vec<_> = (0..self.columns.len())
            .filter(|column| self.columns[*column].known > 0)
            .collect();
        for group in known.chunks(at_once) {
            let mut values = vec![Vec::new(); axes + group.len()];
            rows.each(|row| {
                let numbers = group.iter().map(|column| number(&row, *column));
                let row = row.values.iter().copied().chain(numbers);
                values
                    .iter_mut()
                    .zip(row)
                    .for_each(|(of, value)| of.push(value));
                Ok::<_, ReportError>(())
            })?;
            let numbers = values.split_off(axes);
            for (column, numbers) in group.iter().zip(&numbers) {
                let found = quantiles(numbers.iter().copied());
                let shares = QUANTILES.map(|share| share.to_string());
                self.columns[*column].quantiles =
                    found.map(|values| shares.into_iter().zip(values).collect());
                let sensitivity = sensitivity(self, *column, &values, numbers);
                self.sensitivities.extend(sensitivity);
            }
        }
        Ok(())
    }

    /// Whether all runs are among the rows.
    pub(super) fn is_complete(&self) -> bool {
        self.one_of == 1
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

    /// All that is reported of the study, with what is drawn of it.
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
        let spread = self.spread_table();
        Findings {
            tables: spread
                .map(|table| ("distributions", table))
                .into_iter()
                .collect(),
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
        if !self.is_complete() {
            out.line("figures", self.drawn_text());
        }
        self.tell_peaks(&mut out);
        self.tell_spread(&mut out);
        out
    }

    /// Which runs the figures show.
    fn drawn_text(&self) -> String {
        let (drawn, done) = (self.rows.len(), self.runs - self.failed);
        match self.head.drawn {
            true => format!(
                "show {drawn} of {done} runs, chosen at random; the numbers rest on all of them"
            ),
            false => format!(
                "show every {}th run alone; with more than {MOST_ON_GRID} there is no map, no table of resonances and no \
                 file for ROSS: divide the study, or take them from runs.csv",
                self.one_of
            ),
        }
    }

    /// How the numbers that figures show are spread over what was drawn, a row each.
    fn tell_spread(&self, out: &mut Lines) {
        let shown = self.shown().into_iter().take(MOST_REPORTED);
        let rows = shown.filter_map(|shown| {
            let of = &self.columns[shown.column];
            let quantiles = of.quantiles.as_ref()?;
            let ((number, unit), factor) = shown_column(&of.column);
            let reported = |value: f64| digits(factor * value);
            let ends = ["0.05", "0.5", "0.95"].map(|share| reported(quantiles[share]));
            let row = [
                number,
                unit,
                reported(of.mean),
                reported(of.standard_deviation?),
            ];
            Some(row.into_iter().chain(ends).collect())
        });
        let rows: Vec<Vec<String>> = rows.collect();
        if !rows.is_empty() {
            out.table(
                [
                    "number",
                    "unit",
                    "mean",
                    "standard\ndeviation",
                    "5 %",
                    "50 %",
                    "95 %",
                ],
                rows,
            );
        }
    }

    /// How every number that varies is spread over what was drawn, in the units of their columns; none of a grid.
    fn spread_table(&self) -> Option<Table<'static>> {
        let varying: Vec<_> = (self.columns.iter())
            .filter(|own| own.quantiles.is_some() && varies(self, own))
            .collect();
        let table = Table::from_items(&varying)
            .word("number", |own| own.column.name())
            .number("mean", "", |own| own.mean)
            .number("standard_deviation", "", |own| own.standard_deviation);
        let shares = QUANTILES.into_iter().fold(table, |table, share| {
            let (name, key) = (
                format!("percentile_{:.0}", 100.0 * share),
                share.to_string(),
            );
            table.number(name, "", move |own| Some(own.quantiles.as_ref()?[&key]))
        });
        (!varying.is_empty()).then(|| shares.end())
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
    use super::super::RowFile;
    use super::*;
    use crate::study::Variable;
    use crate::study::many::Outcome;
    use crate::table::Column;

    /// The sequence of van der Corput, whose even points lie all in the lower half, with round-off of a second number.
    #[test]
    fn statistics_of_many_runs_rest_on_all_of_them() {
        let runs = MOST_SCATTERED as u64 + 1192;
        let folder = tempfile::tempdir().unwrap();
        let variable = Variable {
            key: "load[1].constant.z".to_owned(),
            words: Vec::new(),
            unit: "N".to_owned(),
            shown_unit: "N".to_owned(),
            shown_size: 1.0,
        };
        let head = StudyHead {
            runs: 0..runs,
            axes: vec![variable],
            numbers: ["z_m", "x_m"].map(Column::from_name).to_vec(),
            drawn: true,
            ..StudyHead::of_tests()
        };
        let mut file =
            RowFile::open(&folder.path().join("runs.jsonl"), head.clone(), true).unwrap();
        let mut digest = Digest::new(&head);
        for run in 0..runs {
            let value = run.reverse_bits() as f64 / 2f64.powi(64);
            let row = RunRecord {
                run,
                direction: Direction::Alone,
                values: vec![value],
                outcome: Ok(Outcome {
                    numbers: vec![value * value, 1e-20 * value],
                    ..Outcome::default()
                }),
            };
            file.add(&row).unwrap();
            digest.add(row);
        }
        digest.finish(&Rows::from_one(file)).unwrap();
        let [own, _] = &digest.columns[..] else {
            panic!()
        };
        let median = own.quantiles.as_ref().unwrap()["0.5"];
        assert!((median - 0.25).abs() < 2e-3, "{median}");
        // of u²: mean 1/3, variance 1/5 − 1/9
        let deviation = own.standard_deviation.unwrap();
        assert!(
            (deviation - (4.0_f64 / 45.0).sqrt()).abs() < 1e-3,
            "{deviation}"
        );
        let [only] = &digest.sensitivities[..] else {
            panic!("{:?}", digest.sensitivities)
        };
        let correlation = only.rank_correlation["load_1_constant_z_N"];
        assert!((correlation - 1.0).abs() < 1e-12, "{correlation}");
        // five standard errors of the mean of what is drawn
        let drawn = digest.rows.len() as f64;
        let mean = digest.rows.iter().map(|row| row.values[0]).sum::<f64>() / drawn;
        assert!(
            (mean - 0.5).abs() < 5.0 * (12.0 * drawn).sqrt().recip(),
            "{mean} of {drawn}"
        );
    }

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
