//! Compares two tables row by row.

use std::f64::consts::{PI, TAU};

use super::rules::Allowance;
use super::table::Table;
use super::{ColumnComparison, Difference, Rules, TableComparison};
use crate::analysis::{Channel, NoiseFloor};
use crate::table::Column;

/// Compares two tables row by row; `name` is what the result calls them.
pub(super) fn compare_rows(name: String, tables: &[Table; 2], rules: &Rules) -> TableComparison {
    let mut differences = Table::alone(tables, |_| true);
    let rows = MatchedRows::of(tables);
    differences.extend(rows.difference(tables));
    let scales = Scales::of(tables);
    let shared = tables[0].names.iter();
    let shared = shared.filter_map(|name| Some((name, pair(tables, name)?)));
    let columns: Vec<_> = shared
        .map(|(name, values)| {
            let mut column = ColumnComparison::new(name, rules);
            rows.compare(&mut column, tables, values, &scales, rules);
            column
        })
        .collect();
    let known = Table::known(tables);
    let axis = columns.first().filter(|column| !column.agrees());
    if let Some(axis) = axis.filter(|axis| known.first() == Some(&axis.name)) {
        differences.push(Difference::new(format!(
            "the axes {} differ: rows are matched by number and stand for different places",
            axis.name
        )));
    }
    TableComparison::new(name, columns, known, differences, rules)
}

/// A column that both tables have.
fn pair<'a>([first, second]: &'a [Table; 2], name: &str) -> Option<[&'a [f64]; 2]> {
    Some([first.column(name)?, second.column(name)?])
}

/// Which rows of two tables stand for each other: every so many of either.
struct MatchedRows {
    steps: [usize; 2],
    rows: [usize; 2],
}

impl MatchedRows {
    /// More than one of a trace where the other is one of every so many of its samples.
    fn of(tables: &[Table; 2]) -> Self {
        let rows = tables.each_ref().map(|table| table.axis().len());
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

    fn difference(&self, tables: &[Table; 2]) -> Option<Difference> {
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
        column: &mut ColumnComparison,
        tables: &[Table; 2],
        values: [&[f64]; 2],
        scales: &Scales<'_>,
        rules: &Rules,
    ) {
        let name = column.name.clone();
        let allowance = scales.allowance(&name, rules);
        let amplitude = amplitude_of(&name, tables);
        let amplitude =
            amplitude.map(|(amplitude, sizes)| (sizes, scales.allowance(amplitude, rules).total()));
        let counts = [0, 1].map(|table| self.rows[table].div_ceil(self.steps[table]));
        for row in 0..counts[0].min(counts[1]) {
            let at = self.steps.map(|step| row * step);
            let of = |values: [&[f64]; 2]| [values[0][at[0]], values[1][at[1]]];
            let [a, b] = of(values);
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
            let place = tables[0].axis()[at[0]];
            column.take(row as u64 + 1, place, [a, b], difference, allowance);
        }
    }
}

/// The amplitude that a phase belongs to.
fn amplitude_of<'a>(name: &str, tables: &'a [Table; 2]) -> Option<(&'a str, [&'a [f64]; 2])> {
    let prefix = format!("{}_amplitude_", name.strip_suffix("_phase_rad")?);
    let mut names = tables[0].names.iter();
    let found = names.find(|name| name.starts_with(&prefix) && pair(tables, name).is_some())?;
    Some((found, pair(tables, found)?))
}

/// Time between two samples of a trace, s.
fn step(table: &Table) -> Option<f64> {
    let is_trace = table.names.first().is_some_and(|axis| axis == "t_s");
    match table.axis() {
        [first, second, ..] if is_trace => Some(second - first),
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
    tables: &'a [Table; 2],
    /// What of them is round-off.
    floor: NoiseFloor,
}

impl<'a> Scales<'a> {
    /// Of all their columns.
    pub fn of(tables: &'a [Table; 2]) -> Self {
        let rates = tables.iter().filter_map(step).filter(|step| *step > 0.0);
        let rate = rates.map(f64::recip).fold(0.0, f64::max);
        let names = tables.iter().flat_map(|table| &table.names);
        let channels = names.filter_map(|name| {
            Some((
                Channel::of_column(&Column::from_name(name))?,
                largest(tables, name),
            ))
        });
        Self {
            floor: NoiseFloor::of(channels, rate),
            tables,
        }
    }

    /// What values of a column may differ by: its tolerance, and round-off unless equal values are asked for.
    pub fn allowance(&self, name: &str, rules: &Rules) -> Allowance {
        let tolerance = rules.tolerances.of(name);
        Allowance {
            tolerance,
            scale: largest(self.tables, name),
            more: match Channel::of_column(&Column::from_name(name)) {
                Some(channel) if !tolerance.is_exact() => self.floor.below(channel),
                _ => 0.0,
            },
        }
    }
}

fn largest([first, second]: &[Table; 2], name: &str) -> f64 {
    first.largest(name).max(second.largest(name))
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
