//! Compares two spectra by their strongest lines, whatever bins these are in.

use super::rows::{Scales, distance};
use super::rules::Allowance;
use super::table::Source;
use super::text::short;
use super::{ColumnComparison, Difference, Rules, TableComparison};
use crate::table::Column;

/// Round-off of frequencies that are a bin apart.
const ROUND_OFF: f64 = 1e-9;

/// A maximum of an amplitude.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Line {
    frequency: f64,
    amplitude: f64,
}

/// Whether a table has amplitudes, powers or densities over frequency or order.
pub(super) fn is_spectrum(table: &Source<'_>) -> bool {
    let axes = [Column::frequency(), Column::order()];
    axes.contains(table.axis().0) && table.columns().any(Column::has_lines)
}

/// Compares the `count` strongest lines of every column of amplitudes of either spectrum with the
/// strongest line of the other within one bin, that of the coarser axis.
///
/// A line is a maximum between its neighbours that is beyond what is allowed of the column.
pub(super) fn compare_lines(
    name: String,
    spectra: &[Source<'_>; 2],
    count: usize,
    rules: &Rules,
) -> TableComparison {
    let mut differences = Source::alone(spectra, Column::has_lines);
    let scales = Scales::from_tables(spectra);
    let shared = spectra[0].columns().filter(|column| column.has_lines());
    let shared = shared.filter(|column| spectra[1].values(column).is_some());
    let mut columns = Vec::new();
    for column in shared {
        let mut column = ColumnComparison::new(column, rules);
        differences.extend(compare_column(spectra, &scales, count, rules, &mut column));
        columns.push(column);
    }
    TableComparison::new(name, columns, Source::known(spectra), differences, rules)
}

/// Takes the pairs of one column; returns the lines without a partner.
fn compare_column(
    spectra: &[Source<'_>; 2],
    scales: &Scales<'_>,
    count: usize,
    rules: &Rules,
    found: &mut ColumnComparison,
) -> Vec<Difference> {
    let column = found.column.clone();
    let allowance = scales.allowance(&column, rules);
    let allowed = allowance.total();
    let allowance = Allowance {
        more: 0.0,
        ..allowance
    };
    let beyond = |limit| spectra.each_ref().map(|table| lines(table, &column, limit));
    let mut lines = beyond(allowed);
    if lines.iter().all(Vec::is_empty) {
        // none is significant; how strong they are is told all the same
        lines = beyond(0.0);
    }
    let [first_bin, second_bin] = spectra.each_ref().map(bin);
    let bin = first_bin.max(second_bin) * (1.0 + ROUND_OFF);
    let (mut taken, mut alone) = (Vec::new(), Vec::new());
    for (own, other) in [(0, 1), (1, 0)] {
        for (rank, line) in (1..).zip(lines[own].iter().take(count)) {
            // the strongest first
            let is_near = |other: &&Line| (other.frequency - line.frequency).abs() <= bin;
            let Some(partner) = lines[other].iter().find(is_near).copied() else {
                // the other may have it too, though as no maximum of its own or too weak for a line
                if line.amplitude - near(&spectra[other], &column, line.frequency, bin) > allowed {
                    alone.push(line.only_in(&spectra[own], &column));
                }
                continue;
            };
            let [first, second] = match own {
                0 => [*line, partner],
                _ => [partner, *line],
            };
            if !taken.contains(&[first, second]) {
                taken.push([first, second]);
                let values = [first.amplitude, second.amplitude];
                let apart = distance(values[0], values[1]);
                found.take(rank, first.frequency, values, apart, allowance);
            }
        }
    }
    alone
}

impl Line {
    fn only_in(&self, spectrum: &Source<'_>, column: &Column) -> Difference {
        Difference::new(format!(
            "{}: only {} has the line at {} Hz, {:.4e}",
            column.name(),
            spectrum.path.display(),
            short(self.frequency),
            self.amplitude
        ))
    }
}

/// Width of a bin, Hz.
fn bin(spectrum: &Source<'_>) -> f64 {
    match spectrum.axis().1 {
        [first, second, ..] => second - first,
        _ => 0.0,
    }
}

/// Largest value of a column within a bin of a frequency.
fn near(spectrum: &Source<'_>, column: &Column, frequency: f64, bin: f64) -> f64 {
    let values = spectrum.values(column).unwrap_or_default();
    let near = |(at, _): &(&f64, &f64)| (*at - frequency).abs() <= bin;
    let near = spectrum.axis().1.iter().zip(values).filter(near);
    near.fold(0.0, |largest, (_, value)| f64::max(largest, *value))
}

/// Maxima beyond a limit, the strongest first; the first and the last have one neighbour.
fn lines(spectrum: &Source<'_>, column: &Column, limit: f64) -> Vec<Line> {
    let values = spectrum.values(column).unwrap_or_default();
    let at = |place: Option<usize>| place.and_then(|place| values.get(place)).copied();
    let stands_out = |place: &usize| {
        let before = at(place.checked_sub(1)).unwrap_or(f64::NEG_INFINITY);
        let after = at(place.checked_add(1)).unwrap_or(f64::NEG_INFINITY);
        let value = values[*place];
        value > limit && value > before && value >= after
    };
    let places = (0..values.len()).filter(stands_out);
    let line = |place: usize| Line {
        frequency: spectrum.axis().1[place],
        amplitude: values[place],
    };
    let mut lines: Vec<Line> = places.map(line).collect();
    lines.sort_by(|a, b| b.amplitude.total_cmp(&a.amplitude));
    lines
}
