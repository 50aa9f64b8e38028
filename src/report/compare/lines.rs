//! Compares two spectra by their strongest lines, wherever these stand on the frequency axes.

use super::rule::{Scales, distance, judgement};
use super::table::Table;
use super::{ColumnComparison, CompareError, Difference, Rules, TableComparison, Tolerance};

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

/// A spectrum in memory.
struct Lined {
    path: std::path::PathBuf,
    names: Vec<String>,
    columns: Vec<Vec<f64>>,
}

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
    let columns = table.columns();
    ["f_Hz", "order"].contains(&columns[0].as_str()) && columns.iter().any(|name| has_lines(name))
}

/// Compares the `count` strongest lines of every column of amplitudes of either spectrum with the
/// strongest line of the other within one bin, that of the coarser axis.
///
/// A line is a maximum between its neighbours that is beyond what is allowed of the column.
pub(super) fn compare_lines(
    name: String,
    tables: [Table; 2],
    count: usize,
    rules: &Rules,
) -> Result<TableComparison, CompareError> {
    let [first, second] = tables;
    let spectra = [Lined::read(first)?, Lined::read(second)?];
    let bin = spectra[0].bin().max(spectra[1].bin()) * (1.0 + ROUND_OFF);
    let (mut columns, mut differences, mut partial) = (Vec::new(), Vec::new(), Vec::new());
    for (own, other) in [(0, 1), (1, 0)] {
        let names = spectra[own].names.iter().filter(|name| has_lines(name));
        for name in names {
            if spectra[other].column(name).is_none() {
                partial.push(Difference::Column {
                    name: name.clone(),
                    only_in: spectra[own].path.clone(),
                });
            } else if own == 0 {
                let mut column = ColumnComparison::new(name, rules.worst);
                let alone = compare_column(&spectra, bin, count, rules, &mut column);
                differences.extend(alone);
                columns.push(column);
            }
        }
    }
    let mut known = spectra[0].names.clone();
    known.extend(spectra[1].names.iter().cloned());
    Ok(TableComparison::new(
        name,
        columns,
        known,
        differences,
        partial,
        rules,
    ))
}

/// Takes the pairs of one column; returns the lines without a partner.
fn compare_column(
    spectra: &[Lined; 2],
    bin: f64,
    count: usize,
    rules: &Rules,
    column: &mut ColumnComparison,
) -> Vec<Difference> {
    let name = column.name.clone();
    let scale = spectra.each_ref().map(|spectrum| spectrum.largest(&name));
    let scale = scale[0].max(scale[1]);
    let tolerance = rules.tolerances.of(&name);
    let allowed = tolerance.allowed(scale) + floor(spectra, &name, tolerance);
    let lines = spectra
        .each_ref()
        .map(|spectrum| spectrum.lines(&name, allowed));
    let (mut taken, mut alone) = (Vec::new(), Vec::new());
    for (own, other) in [(0, 1), (1, 0)] {
        for (rank, line) in (1..).zip(lines[own].iter().take(count)) {
            let Some(partner) = partner(line, &lines[other], bin) else {
                // the other may have it too, though as no maximum of its own or too weak for a line
                let near = spectra[other].near(&name, line.frequency, bin);
                if line.amplitude - near > allowed {
                    alone.push(line.only_in(&spectra[own], &name));
                }
                continue;
            };
            let pair = if own == 0 {
                [*line, partner]
            } else {
                [partner, *line]
            };
            if !taken.contains(&pair) {
                taken.push(pair);
                take_pair(column, rank, pair, tolerance, scale);
            }
        }
    }
    alone
}

/// Amplitude of a column that is round-off, by all columns of both spectra.
fn floor(spectra: &[Lined; 2], name: &str, tolerance: Tolerance) -> f64 {
    let columns = spectra
        .iter()
        .flat_map(|spectrum| spectrum.names.iter().map(String::as_str));
    let largest = |name: &str| spectra[0].largest(name).max(spectra[1].largest(name));
    Scales::of(columns.map(|name| (name, name)), largest, 0.0).floor(name, tolerance)
}

impl Line {
    fn only_in(&self, spectrum: &Lined, column: &str) -> Difference {
        Difference::Line {
            column: column.to_owned(),
            frequency: self.frequency,
            amplitude: self.amplitude,
            only_in: spectrum.path.clone(),
        }
    }
}

fn take_pair(
    column: &mut ColumnComparison,
    rank: u64,
    [first, second]: [Line; 2],
    tolerance: Tolerance,
    scale: f64,
) {
    let values = [first.amplitude, second.amplitude];
    let judgement = judgement(distance(values[0], values[1]), tolerance, scale, 0.0);
    column.take(rank, first.frequency, values, judgement);
}

/// The strongest of `others`, which stand in that order, within a bin of a line.
fn partner(line: &Line, others: &[Line], bin: f64) -> Option<Line> {
    let near = |other: &&Line| (other.frequency - line.frequency).abs() <= bin;
    others.iter().find(near).copied()
}

impl Lined {
    fn read(mut table: Table) -> Result<Self, CompareError> {
        let names = table.columns().to_vec();
        let mut columns = vec![Vec::new(); names.len()];
        let mut row = Vec::new();
        while table.read(&mut row)? {
            for (column, value) in columns.iter_mut().zip(&row) {
                column.push(*value);
            }
        }
        let path = table.path().to_owned();
        if columns[0].is_empty() {
            return Err(CompareError::Empty { path });
        }
        Ok(Self {
            path,
            names,
            columns,
        })
    }

    fn column(&self, name: &str) -> Option<&[f64]> {
        let place = self.names.iter().position(|known| known == name)?;
        Some(&self.columns[place])
    }

    /// Width of a bin, Hz.
    fn bin(&self) -> f64 {
        match self.columns[0][..] {
            [first, second, ..] => second - first,
            _ => 0.0,
        }
    }

    fn largest(&self, name: &str) -> f64 {
        let values = self.column(name).unwrap_or_default().iter();
        let finite = values.filter(|value| value.is_finite());
        finite.fold(0.0, |largest: f64, value| largest.max(*value))
    }

    /// Largest value of a column within a bin of a frequency.
    fn near(&self, name: &str, frequency: f64, bin: f64) -> f64 {
        let values = self.column(name).unwrap_or_default();
        let near = |(at, _): &(&f64, &f64)| (*at - frequency).abs() <= bin;
        let near = self.columns[0].iter().zip(values).filter(near);
        near.fold(0.0, |largest, (_, value)| f64::max(largest, *value))
    }

    /// Maxima beyond a limit, the strongest first; the first and the last have one neighbour.
    fn lines(&self, name: &str, limit: f64) -> Vec<Line> {
        let values = self.column(name).unwrap_or_default();
        let at = |place: Option<usize>| place.and_then(|place| values.get(place)).copied();
        let stands_out = |place: usize| {
            let before = at(place.checked_sub(1)).unwrap_or(f64::NEG_INFINITY);
            let after = at(place.checked_add(1)).unwrap_or(f64::NEG_INFINITY);
            values[place] > limit && values[place] > before && values[place] >= after
        };
        let places = (0..values.len()).filter(|place| stands_out(*place));
        let line = |place: usize| Line {
            frequency: self.columns[0][place],
            amplitude: values[place],
        };
        let mut lines: Vec<Line> = places.map(line).collect();
        lines.sort_by(|a, b| b.amplitude.total_cmp(&a.amplitude));
        lines
    }
}
