//! Compares two tables row by row.

use std::f64::consts::{PI, TAU};

use super::lines::is_spectrum;
use super::rules::Allowance;
use super::table::Source;
use super::words::different_words;
use super::{ColumnComparison, Difference, Rules, TableComparison, Worst};
use crate::analysis::{Channel, NoiseFloor};
use crate::table::{Column, ColumnKind};

/// Compares two tables row by row; `name` is what the result calls them.
pub(super) fn compare_rows(
    name: String,
    tables: &[Source<'_>; 2],
    rules: &Rules,
) -> TableComparison {
    let mut differences = Source::alone(tables, |_| true);
    let rows = MatchedRows::from_tables(tables);
    differences.extend(rows.difference(tables));
    differences.extend(different_words(tables, rows.steps));
    let scales = Scales::from_tables(tables);
    let shared = tables[0].columns();
    let shared = shared.filter_map(|column| Some((column, pair(tables, column)?)));
    let columns: Vec<_> = shared
        .map(|(column, values)| {
            let mut found = ColumnComparison::new(column, rules);
            rows.compare(&mut found, tables, values, &scales, rules);
            found
        })
        .collect();
    let known = Source::known(tables);
    let axis = columns.first().filter(|column| !column.agrees());
    if let Some(axis) = axis.filter(|axis| known.first() == Some(&axis.column)) {
        differences.push(Difference::new(format!(
            "the axes {} differ: rows are matched by number and stand for different places",
            axis.column.name()
        )));
    }
    TableComparison::new(name, columns, known, differences, rules)
}

/// A column that both tables have.
fn pair<'a>([first, second]: &'a [Source<'_>; 2], column: &Column) -> Option<[&'a [f64]; 2]> {
    Some([first.values(column)?, second.values(column)?])
}

/// Which rows of two tables are compared: every so many of either.
struct MatchedRows {
    steps: [usize; 2],
    rows: [usize; 2],
}

impl MatchedRows {
    /// More than one of a trace where the other is one of every so many of its samples.
    fn from_tables(tables: &[Source<'_>; 2]) -> Self {
        let rows = tables.each_ref().map(|table| table.axis().1.len());
        let [first, second] = tables.each_ref().map(step);
        let steps = match first.zip(second) {
            Some((first, second)) => [
                thinning(second / first, rows),
                thinning(first / second, [rows[1], rows[0]]),
            ],
            None => [1, 1],
        };
        Self { steps, rows }
    }

    fn difference(&self, tables: &[Source<'_>; 2]) -> Option<Difference> {
        let [first, second] = self.rows;
        match self.steps {
            [1, 1] if first == second => None,
            [1, 1] => Some(Difference::new(format!(
                "{first} rows against {second}: the first {} are compared",
                first.min(second)
            ))),
            [own, other] => Some(Difference::partial(format!(
                "{} holds one of every {} samples: these are compared",
                tables[usize::from(own > 1)].path.display(),
                own.max(other)
            ))),
        }
    }

    /// Judges the values of a column; a phase modulo 2π, where its amplitude is significant.
    fn compare(
        &self,
        found: &mut ColumnComparison,
        tables: &[Source<'_>; 2],
        values: [&[f64]; 2],
        scales: &Scales<'_>,
        rules: &Rules,
    ) {
        let of_lines = scales.allowance(&found.column, rules);
        let of_mean = scales.allowance_of_mean(&found.column, rules);
        let amplitude = amplitude_of(&found.column, tables);
        let amplitude =
            amplitude.map(|(amplitude, sizes)| (sizes, scales.allowance(amplitude, rules).total()));
        let counts = [0, 1].map(|table| self.rows[table].div_ceil(self.steps[table]));
        for row in 0..counts[0].min(counts[1]) {
            let at = self.steps.map(|step| row * step);
            let of = |values: [&[f64]; 2]| [values[0][at[0]], values[1][at[1]]];
            let [a, b] = of(values);
            let place = tables[0].axis().1[at[0]];
            let allowance = if place == 0.0 { of_mean } else { of_lines };
            let (difference, allowance) = match amplitude {
                None => (distance(a, b), allowance),
                Some((sizes, allowed)) => {
                    let [a_size, b_size] = of(sizes);
                    let size = a_size.max(b_size);
                    // the phase of nothing says nothing
                    if size <= allowed || size.is_nan() {
                        continue;
                    }
                    let turned = Allowance {
                        scale: PI,
                        more: allowed / size,
                        ..allowance
                    };
                    (turn(distance(a, b)), turned)
                }
            };
            let place = Worst {
                row: row as u64 + 1,
                at: place,
                first: a,
                second: b,
                difference,
                ..Worst::default()
            };
            found.take(place, allowance);
        }
    }
}

/// The amplitude that a phase belongs to.
fn amplitude_of<'a>(
    column: &Column,
    tables: &'a [Source<'_>; 2],
) -> Option<(&'a Column, [&'a [f64]; 2])> {
    let is_amplitude = |known: &&Column| {
        known.kind == ColumnKind::Measure("amplitude") && known.quantity == column.quantity
    };
    let mut columns = tables[0].columns();
    let found = columns.find(|known| column.kind == ColumnKind::Phase && is_amplitude(known))?;
    Some((found, pair(tables, found)?))
}

/// Time between two samples of a trace, s.
fn step(table: &Source<'_>) -> Option<f64> {
    match table.axis() {
        (axis, [first, second, ..]) if *axis == Channel::Time.column() => Some(second - first),
        _ => None,
    }
}

/// N where the second table can hold the first of every N rows of the first, one otherwise.
fn thinning(ratio: f64, [rows, others]: [usize; 2]) -> usize {
    let every = ratio.round();
    let can_be = every > 1.0 && every < rows as f64 && rows.div_ceil(every as usize) == others;
    if can_be { every as usize } else { 1 }
}

/// What the columns of two tables are measured by.
pub(super) struct Scales<'a> {
    tables: &'a [Source<'a>; 2],
    /// What of them is round-off.
    floor: NoiseFloor,
}

impl<'a> Scales<'a> {
    /// Whether a column is what the rows are matched by.
    fn is_axis(&self, column: &Column) -> bool {
        self.tables.iter().all(|table| table.axis().0 == column)
    }

    /// Of all their columns.
    pub fn from_tables(tables: &'a [Source<'a>; 2]) -> Self {
        let rates = tables.iter().filter_map(step).filter(|step| *step > 0.0);
        let rate = rates.map(f64::recip).fold(0.0, f64::max);
        let columns = tables.iter().flat_map(Source::columns);
        let channels = columns
            .filter_map(|column| Some((Channel::of_column(column)?, largest(tables, column))));
        Self {
            floor: NoiseFloor::new(channels, rate),
            tables,
        }
    }

    /// What values of a column may differ by: its tolerance, and round-off unless equal values are asked for. Lines of a spectrum
    /// are measured by the largest of them, not by the mean, which may be far larger.
    pub fn allowance(&self, column: &Column, rules: &Rules) -> Allowance {
        self.allowance_by(|place| place != 0.0, column, rules)
    }

    /// What the means of two spectra may differ by, measured by the largest value, next to which one may be round-off; of other tables
    /// what any row may.
    fn allowance_of_mean(&self, column: &Column, rules: &Rules) -> Allowance {
        self.allowance_by(|_| true, column, rules)
    }

    /// What values may differ by that are measured by the largest at some places of a spectrum, or of the whole column.
    fn allowance_by(&self, counts: fn(f64) -> bool, column: &Column, rules: &Rules) -> Allowance {
        let sizes = self
            .tables
            .each_ref()
            .map(|table| match has_mean(table, column) {
                true => table.largest_at(column, counts),
                false => table.largest(column),
            });
        let tolerance = match self.is_axis(column) {
            true => rules.tolerances.of_axis(&column.name()),
            false => rules.tolerances.of_column(&column.name()),
        };
        Allowance {
            tolerance,
            scale: sizes[0].max(sizes[1]),
            more: match Channel::of_column(column) {
                Some(channel) if !tolerance.is_exact() => self.floor.below(channel),
                _ => 0.0,
            },
        }
    }
}

/// Whether the row of a table at zero has the mean of a column whose other rows have lines.
fn has_mean(table: &Source<'_>, column: &Column) -> bool {
    is_spectrum(table) && column.has_lines()
}

fn largest([first, second]: &[Source<'_>; 2], column: &Column) -> f64 {
    first.largest(column).max(second.largest(column))
}

/// |a − b|; zero for equal infinities and for two NaN, infinite where only one is a number.
pub(super) fn distance(a: f64, b: f64) -> f64 {
    if a == b || (a.is_nan() && b.is_nan()) {
        return 0.0;
    }
    let difference = (a - b).abs();
    if difference.is_nan() {
        f64::INFINITY
    } else {
        difference
    }
}

/// The shorter way round the circle.
fn turn(angle: f64) -> f64 {
    if angle.is_infinite() {
        return angle;
    }
    let angle = angle.rem_euclid(TAU);
    angle.min(TAU - angle)
}
