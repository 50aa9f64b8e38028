//! Compares two results by their strongest lines, whatever bins these are in.

use std::path::Path;

use super::rows::{Scales, distance};
use super::rules::Allowance;
use super::table::Source;
use super::text::short;
use super::{
    ColumnComparison, CompareError, Difference, LineRules, LinesBy, Rules, TableComparison, Worst,
};
use crate::table::Column;

/// Round-off of frequencies that are a bin apart.
const ROUND_OFF: f64 = 1e-9;

/// The lines of a quantity of a result.
#[derive(Debug)]
pub(super) struct Lines<'a> {
    pub column: Column,
    /// Where it comes from.
    pub path: &'a Path,
    /// All of them, the strongest first.
    pub lines: Vec<Line>,
    /// Distance of bins in the unit of their places.
    pub bin: f64,
    /// Places and values around the lines, where the whole spectrum is known.
    curve: Vec<(f64, f64)>,
}

/// A maximum of an amplitude.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Line {
    /// Frequency in Hz, or order.
    pub at: f64,
    pub amplitude: f64,
    pub name: Option<String>,
}

/// Whether a table has amplitudes, powers or densities over frequency or order.
pub(super) fn is_spectrum(table: &Source<'_>) -> bool {
    let axes = [Column::frequency(), Column::order()];
    axes.contains(table.axis().0) && table.columns().any(Column::has_lines)
}

/// Whether two spectra have a column of amplitudes in common.
pub(super) fn have_common([first, second]: &[Source<'_>; 2]) -> bool {
    let mut columns = first.columns().filter(|column| column.has_lines());
    columns.any(|column| second.values(column).is_some())
}

/// Compares the strongest lines of every column of amplitudes of either spectrum with the strongest line of the other nearby; the
/// places of either are divided by `units`.
///
/// A line is a maximum between its neighbours that is beyond what is allowed of the column.
pub(super) fn compare_spectra(
    name: String,
    spectra: &[Source<'_>; 2],
    units: [f64; 2],
    line_rules: &LineRules,
    rules: &Rules,
) -> TableComparison {
    let mut differences = Source::alone(spectra, Column::has_lines);
    let scales = Scales::from_tables(spectra);
    let shared = spectra[0].columns().filter(|column| column.has_lines());
    let shared = shared.filter(|column| spectra[1].values(column).is_some());
    let mut columns = Vec::new();
    for column in shared {
        let allowance = scales.allowance(column, rules);
        let lines = |index: usize| Lines::of_column(&spectra[index], column, units[index]);
        let (found, alone) = compare_pair(&[lines(0), lines(1)], allowance, line_rules, rules);
        differences.extend(alone);
        columns.push(found);
    }
    let mut known = Source::known(spectra);
    if line_rules.by == LinesBy::Order {
        known[0] = Column::order();
    }
    TableComparison::new(name, columns, known, differences, rules)
}

/// Compares the strongest lines of quantities that are matched by their columns.
///
/// # Errors
/// [`CompareError::NoCommonLine`] where none has a partner.
pub(super) fn compare_quantities(
    [first, second]: [Vec<Lines<'_>>; 2],
    [first_path, second_path]: [&Path; 2],
    line_rules: &LineRules,
    rules: &Rules,
) -> Result<TableComparison, CompareError> {
    let (mut columns, mut differences, mut second) = (Vec::new(), Vec::new(), second);
    let only = |lines: &Lines<'_>| {
        let (path, column) = (lines.path.display(), lines.column.name());
        Difference::partial(format!("only {path} has lines of {column}"))
    };
    for own in first {
        let partner = second.iter().position(|other| other.column == own.column);
        let Some(partner) = partner else {
            differences.push(only(&own));
            continue;
        };
        let both = [own, second.remove(partner)];
        let strongest = both.iter().flat_map(|lines| lines.lines.first());
        let allowance = Allowance {
            tolerance: rules.tolerances.of_column(&both[0].column.name()),
            scale: strongest.map(|line| line.amplitude).fold(0.0, f64::max),
            more: 0.0,
        };
        let (found, alone) = compare_pair(&both, allowance, line_rules, rules);
        differences.extend(alone);
        columns.push(found);
    }
    differences.extend(second.iter().map(only));
    if columns.iter().all(|column| column.places.is_empty()) {
        let [first, second] = [first_path, second_path].map(Path::to_owned);
        return Err(CompareError::NoCommonLine { first, second });
    }
    let over = match line_rules.by {
        LinesBy::Order => Column::order(),
        _ => Column::frequency(),
    };
    let known = columns.iter().map(|found| found.column.clone());
    let known = std::iter::once(over).chain(known).collect();
    let name = "strongest lines".to_owned();
    Ok(TableComparison::new(
        name,
        columns,
        known,
        differences,
        rules,
    ))
}

/// Takes the pairs of one quantity; also the lines without a partner.
fn compare_pair(
    both: &[Lines<'_>; 2],
    allowance: Allowance,
    line_rules: &LineRules,
    rules: &Rules,
) -> (ColumnComparison, Vec<Difference>) {
    let mut found = ColumnComparison::new(&both[0].column, rules);
    // a ratio says nothing of two lines of round-off
    let threshold = match line_rules.decibels {
        Some(_) => allowance.more,
        None => allowance.total(),
    };
    let beyond = |limit: f64| {
        both.each_ref()
            .map(|own| own.lines.partition_point(|line| line.amplitude > limit))
    };
    let mut counts = beyond(threshold);
    if counts == [0, 0] && line_rules.decibels.is_none() {
        // none is significant; how strong they are is reported all the same
        counts = beyond(0.0);
    }
    let lines = [0, 1].map(|index| &both[index].lines[..counts[index]]);
    let bin = both[0].bin.max(both[1].bin) * (1.0 + ROUND_OFF);
    let reach = |line: &Line| line_rules.reach.map_or(bin, |part| part * line.at);
    let (mut taken, mut alone) = (Vec::new(), Vec::new());
    for (own, other) in [(0, 1), (1, 0)] {
        for (rank, line) in (1..).zip(lines[own].iter().take(line_rules.count)) {
            // the strongest first
            let is_partner = |other: &&Line| match line_rules.by {
                LinesBy::Name => other.name == line.name,
                _ => (other.at - line.at).abs() <= reach(line),
            };
            let Some(partner) = lines[other].iter().find(is_partner) else {
                // the other may have it too, though as no maximum of its own or too weak for a line
                let beside = both[other].largest_near(line.at, reach(line));
                let (apart, allowed) = judged(line.amplitude, beside, allowance, line_rules);
                if line.amplitude > beside && apart > allowed.total() {
                    alone.push(line.only_in(&both[own], line_rules));
                }
                continue;
            };
            let [first, second] = match own {
                0 => [line, partner],
                _ => [partner, line],
            };
            if !taken.contains(&[first, second]) {
                taken.push([first, second]);
                let allowance = Allowance {
                    more: 0.0,
                    ..allowance
                };
                let (difference, allowance) =
                    judged(first.amplitude, second.amplitude, allowance, line_rules);
                let place = Worst {
                    row: rank,
                    at: first.at,
                    first: first.amplitude,
                    second: second.amplitude,
                    difference,
                    second_at: Some(second.at),
                    name: first
                        .name
                        .clone()
                        .filter(|_| line_rules.by == LinesBy::Name),
                    ..Worst::default()
                };
                found.take(place, allowance);
            }
        }
    }
    (found, alone)
}

/// How far two amplitudes are apart, and may be: in dB, or in their unit.
fn judged(a: f64, b: f64, allowance: Allowance, rules: &LineRules) -> (f64, Allowance) {
    match rules.decibels {
        Some(most) => ((20.0 * (b / a).log10()).abs(), Allowance::decibels(most)),
        None => (distance(a, b), allowance),
    }
}

impl Line {
    fn only_in(&self, of: &Lines<'_>, rules: &LineRules) -> Difference {
        let name = self.name.as_ref().map(|name| format!("{name}, "));
        let at = match rules.by {
            LinesBy::Order => format!("order {}", short(self.at)),
            _ => format!("{} Hz", short(self.at)),
        };
        let unit = match of.column.unit.is_empty() {
            true => "",
            false => " ",
        };
        let message = format!(
            "{}: only {} has the line at {at}, {}{:.4e}{unit}{}",
            of.column.name(),
            of.path.display(),
            name.unwrap_or_default(),
            self.amplitude,
            of.column.unit
        );
        Difference {
            only_in_one: self.name.is_some(),
            ..Difference::new(message)
        }
    }
}

impl<'a> Lines<'a> {
    /// Lines that are known one by one; the mean, at zero, is none.
    pub fn new(column: Column, path: &'a Path, mut lines: Vec<Line>, bin: f64) -> Self {
        lines.retain(|line| line.at != 0.0);
        lines.sort_by(|a, b| b.amplitude.total_cmp(&a.amplitude));
        Self {
            column,
            path,
            lines,
            bin,
            curve: Vec::new(),
        }
    }

    /// The maxima of a column of a spectrum, whose places are divided by a unit; the first and the last have one neighbour.
    fn of_column(spectrum: &'a Source<'_>, column: &Column, unit: f64) -> Self {
        let values = spectrum.values(column).unwrap_or_default().iter().copied();
        let places = spectrum.axis().1.iter().map(|place| place / unit);
        let curve: Vec<(f64, f64)> = places.zip(values).filter(|(at, _)| *at != 0.0).collect();
        let at = |place: Option<usize>| {
            let neighbour = place.and_then(|place| curve.get(place));
            neighbour.map_or(f64::NEG_INFINITY, |(_, value)| *value)
        };
        let lines = curve
            .iter()
            .enumerate()
            .filter_map(|(place, &(line, value))| {
                let [before, after] = [at(place.checked_sub(1)), at(place.checked_add(1))];
                (value > before && value >= after).then_some(Line {
                    at: line,
                    amplitude: value,
                    name: None,
                })
            });
        let bin = match curve[..] {
            [first, second, ..] => second.0 - first.0,
            _ => 0.0,
        };
        let lines = Self::new(column.clone(), &spectrum.path, lines.collect(), bin);
        Self { curve, ..lines }
    }

    /// Largest value around a place.
    fn largest_near(&self, at: f64, reach: f64) -> f64 {
        let near = self
            .curve
            .iter()
            .filter(|(place, _)| (place - at).abs() <= reach);
        near.fold(0.0, |largest, (_, value)| largest.max(*value))
    }
}
