//! Compares two spectra by their strongest lines, wherever these stand on the frequency axes.

use super::rows::{Scales, distance};
use super::rules::Allowance;
use super::table::Table;
use super::text::short;
use super::{ColumnComparison, Difference, Rules, TableComparison};

/// What a column of amplitudes, powers or densities has in its name.
const SCALINGS: [&str; 6] = [
    "_amplitude_",
    "_peak_",
    "_rms_",
    "_peak_to_peak_",
    "_power_",
    "_density_",
];

/// Round-off of frequencies that are a bin apart.
const ROUND_OFF: f64 = 1e-9;

/// A maximum of an amplitude.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Line {
    frequency: f64,
    amplitude: f64,
}

/// Whether a column has lines.
fn has_lines(name: &str) -> bool {
    SCALINGS.iter().any(|scaling| name.contains(scaling))
}

/// Whether a table has amplitudes, powers or densities over frequency or order.
pub(super) fn is_spectrum(table: &Table) -> bool {
    let names = &table.names;
    ["f_Hz", "order"].contains(&names[0].as_str()) && names.iter().any(|name| has_lines(name))
}

/// Compares the `count` strongest lines of every column of amplitudes of either spectrum with the
/// strongest line of the other within one bin, that of the coarser axis.
///
/// A line is a maximum between its neighbours that is beyond what is allowed of the column.
pub(super) fn compare_lines(
    name: String,
    spectra: &[Table; 2],
    count: usize,
    rules: &Rules,
) -> TableComparison {
    let mut differences = Table::alone(spectra, has_lines);
    let scales = Scales::of(spectra);
    let names = spectra[0].names.iter().filter(|name| has_lines(name));
    let shared = names.filter(|name| spectra[1].column(name).is_some());
    let mut columns = Vec::new();
    for name in shared {
        let mut column = ColumnComparison::new(name, rules);
        differences.extend(compare_column(spectra, &scales, count, rules, &mut column));
        columns.push(column);
    }
    TableComparison::new(name, columns, Table::known(spectra), differences, rules)
}

/// Takes the pairs of one column; returns the lines without a partner.
fn compare_column(
    spectra: &[Table; 2],
    scales: &Scales<'_>,
    count: usize,
    rules: &Rules,
    column: &mut ColumnComparison,
) -> Vec<Difference> {
    let name = column.name.clone();
    let allowed = scales.allowance(&name, rules).total();
    let allowance = Allowance {
        more: 0.0,
        ..scales.allowance(&name, rules)
    };
    let lines = spectra.each_ref().map(|table| lines(table, &name, allowed));
    let [first_bin, second_bin] = spectra.each_ref().map(bin);
    let bin = first_bin.max(second_bin) * (1.0 + ROUND_OFF);
    let (mut taken, mut alone) = (Vec::new(), Vec::new());
    for (own, other) in [(0, 1), (1, 0)] {
        for (rank, line) in (1..).zip(lines[own].iter().take(count)) {
            // the strongest stands first
            let is_near = |other: &&Line| (other.frequency - line.frequency).abs() <= bin;
            let Some(partner) = lines[other].iter().find(is_near).copied() else {
                // the other may have it too, though as no maximum of its own or too weak for a line
                if line.amplitude - near(&spectra[other], &name, line.frequency, bin) > allowed {
                    alone.push(line.only_in(&spectra[own], &name));
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
                column.take(rank, first.frequency, values, apart, allowance);
            }
        }
    }
    alone
}

impl Line {
    fn only_in(&self, spectrum: &Table, column: &str) -> Difference {
        Difference::new(format!(
            "{column}: only {} has the line at {} Hz, {:.4e}",
            spectrum.path.display(),
            short(self.frequency),
            self.amplitude
        ))
    }
}

/// Width of a bin, Hz.
fn bin(spectrum: &Table) -> f64 {
    match spectrum.axis() {
        [first, second, ..] => second - first,
        _ => 0.0,
    }
}

/// Largest value of a column within a bin of a frequency.
fn near(spectrum: &Table, name: &str, frequency: f64, bin: f64) -> f64 {
    let values = spectrum.column(name).unwrap_or_default();
    let near = |(at, _): &(&f64, &f64)| (*at - frequency).abs() <= bin;
    let near = spectrum.axis().iter().zip(values).filter(near);
    near.fold(0.0, |largest, (_, value)| f64::max(largest, *value))
}

/// Maxima beyond a limit, the strongest first; the first and the last have one neighbour.
fn lines(spectrum: &Table, name: &str, limit: f64) -> Vec<Line> {
    let values = spectrum.column(name).unwrap_or_default();
    let at = |place: Option<usize>| place.and_then(|place| values.get(place)).copied();
    let stands_out = |place: &usize| {
        let before = at(place.checked_sub(1)).unwrap_or(f64::NEG_INFINITY);
        let after = at(place.checked_add(1)).unwrap_or(f64::NEG_INFINITY);
        let value = values[*place];
        value > limit && value > before && value >= after
    };
    let places = (0..values.len()).filter(stands_out);
    let line = |place: usize| Line {
        frequency: spectrum.axis()[place],
        amplitude: values[place],
    };
    let mut lines: Vec<Line> = places.map(line).collect();
    lines.sort_by(|a, b| b.amplitude.total_cmp(&a.amplitude));
    lines
}
