//! The spectra of a run: tables of values and of named peaks, and what is shown of them.

use std::borrow::Cow;
use std::io;
use std::io::Write;

use super::shown::{NamedLine, ShownPeak, ShownSpectrum};
use crate::analysis::{Peak, Rate, Spectrum, velocity_rate};
use crate::report::figure::Figure;
use crate::report::table::CsvTable;
use crate::report::terminal::MILLI;
use crate::simulate::Run;
use crate::table::{Column, Table};

/// Writes one row a frequency: `f_Hz`, `order` (where the shaft turns), then amplitude and phase of
/// every channel.
///
/// # Errors
/// What the writer answers.
pub fn write_spectrum(spectrum: &Spectrum, writer: impl Write) -> io::Result<()> {
    let table = spectrum_table(spectrum);
    let mut csv = CsvTable::new(writer, &table.columns())?;
    table.rows().try_for_each(|row| csv.row(&row))?;
    csv.finish().map(drop)
}

/// Frequency, order (where the shaft turns), then amplitude and phase of every channel.
pub(in crate::report) fn spectrum_table(spectrum: &Spectrum) -> Table<'_> {
    let bins = || 0..spectrum.bins();
    let mut table = Table::default();
    table.add(Column::frequency(), bins().map(|k| spectrum.frequency(k)));
    if spectrum.order(0).is_some() {
        table.add(Column::order(), bins().map(|k| spectrum.order(k)));
    }
    for entry in &spectrum.channels {
        let [amplitude, phase] = entry.channel.lines();
        table.borrowed(amplitude, &entry.amplitude);
        table.borrowed(phase, &entry.phase);
    }
    table
}

/// One row a peak, channel by channel, strongest first.
///
/// `distance` is that of the peak from its name's frequency, `nominal_f_Hz` where the same line
/// is by the nominal contact angle.
pub(in crate::report) fn peak_table(peaks: &[Peak], spectrum: &Spectrum) -> Table<'static> {
    let name = |peak: &Peak| peak.line.map(|line| line.kind.to_string());
    let order = |peak: &Peak| {
        (spectrum.shaft_frequency > 0.0).then(|| peak.frequency / spectrum.shaft_frequency)
    };
    let distance = |peak: &Peak| Some(peak.frequency - peak.line?.frequency);
    let others = |peak: &Peak| {
        let names = peak.others.iter().map(|line| line.kind.to_string());
        names.collect::<Vec<_>>().join("; ")
    };
    Table::from_items(peaks)
        .word("channel", |peak| peak.channel.name())
        .word("unit", |peak| peak.channel.unit())
        .column(Column::frequency(), |peak| peak.frequency)
        .column(Column::order(), order)
        .number("amplitude", "", |peak| peak.amplitude)
        .number("phase", "rad", |peak| peak.phase)
        .word("name", |peak| name(peak).unwrap_or_default())
        .number("name_f", "Hz", |peak| Some(peak.line?.frequency))
        .number("distance", "Hz", distance)
        .number("distance_bins", "", |peak| {
            Some(distance(peak)? / spectrum.resolution)
        })
        .number("nominal_f", "Hz", |peak| peak.line?.nominal)
        .word("other_names", others)
        .end()
}

/// What a group of channels is called, and their unit.
const GROUPS: [(&str, &str); 6] = [
    ("displacement", "m"),
    ("velocity", "m/s"),
    ("acceleration", "m/s^2"),
    ("tilt", "rad"),
    ("force", "N"),
    ("moment", "N m"),
];

/// What channels of another unit are called.
const OTHERS: &str = "signal";

/// Name of what shows how the housings move.
const HOUSINGS: &str = "housing_velocity";

/// What a page shows besides displacements: velocities of the housings, where there are any, and of the shaft, then amplitudes
/// of channels of one unit together, each a figure.
pub(in crate::report) fn spectra_figures(
    title: &str,
    spectrum: &Spectrum,
    peaks: &[Peak],
) -> Vec<Figure> {
    let table = spectrum_table(spectrum);
    let lines = named_lines(peaks);
    let figures = shown_groups(&table, spectrum, peaks).map(|(name, group)| {
        let (name, group) = match (name, velocity_rate(group.of)) {
            ("displacement", Some(rate)) => ("velocity", velocity_of(group, &lines, rate, 0.0)),
            (_, Some(rate)) => {
                // a housing rings far above the motion of the shaft
                let own = peaks.iter().filter(|peak| peak.channel.unit() == group.of);
                let shown = 0.0..limit(spectrum, own);
                let group = ShownSpectrum { shown, ..group };
                let lowest = beyond_mean(spectrum);
                (HOUSINGS, velocity_of(group, &lines, rate, lowest))
            }
            (name, None) => (name, group),
        };
        figure(&format!("{name}_spectrum"), title, name, group, PAGE_HEIGHT).only_on_page()
    });
    let mut figures: Vec<_> = figures.collect();
    figures.sort_by_key(|figure| !figure.name.starts_with(HOUSINGS));
    figures
}

/// The lines of all channels that have a name.
fn named_lines(peaks: &[Peak]) -> Vec<NamedLine> {
    let named = peaks.iter().filter_map(|peak| {
        let [column, _] = peak.channel.lines();
        Some(NamedLine {
            column,
            at: peak.frequency,
            value: peak.amplitude,
            name: peak.line?.kind.to_string(),
        })
    });
    named.collect()
}

/// Amplitudes of channels of one unit together, each group with its name.
fn shown_groups<'a>(
    table: &'a Table<'_>,
    spectrum: &Spectrum,
    peaks: &[Peak],
) -> impl Iterator<Item = (&'static str, ShownSpectrum<'a>)> {
    let shown = 0.0..frequency_limit(spectrum, peaks);
    let groups = ShownSpectrum::grouped(table, &named_lines(peaks), &shown);
    groups.into_iter().map(|group| {
        let known = GROUPS.iter().find(|(_, unit)| *unit == group.of);
        (known.map_or(OTHERS, |(name, _)| name), group)
    })
}

/// What is shown of a record: amplitudes of channels of one unit together, each a figure, and on the page the velocities that follow
/// from them from a frequency in Hz on, below which an integrated acceleration shows its noise.
pub(in crate::report) fn measured_figures(
    title: &str,
    spectrum: &Spectrum,
    peaks: &[Peak],
    lowest: f64,
) -> Vec<Figure> {
    let table = spectrum_table(spectrum);
    let lines = named_lines(peaks);
    let groups = shown_groups(&table, spectrum, peaks).enumerate();
    let figures = groups.flat_map(|(place, (name, group))| {
        let file = match place {
            0 => "spectrum".to_owned(),
            _ => format!("spectrum_{}", place + 1),
        };
        let velocity = velocity_rate(group.of).map(|rate| {
            let lowest = lowest.max(beyond_mean(spectrum));
            let velocity = velocity_of(group.clone(), &lines, rate, lowest);
            let name = format!("velocity_{file}");
            figure(&name, title, "velocity", velocity, PAGE_HEIGHT).only_on_page()
        });
        let own = figure(&file, title, name, group, HEIGHT);
        std::iter::once(own).chain(velocity)
    });
    figures.collect()
}

/// Frequency in Hz above which no bin is within the lobe that the window gives the mean: what lines between bins leave of it there
/// would be the largest of integrated accelerations.
fn beyond_mean(spectrum: &Spectrum) -> f64 {
    (spectrum.window.lobe() as f64 - 0.5) * spectrum.resolution
}

/// Velocities in place of displacements or accelerations, from a frequency in Hz on.
///
/// The strongest lines of a velocity are others than those of a displacement or an acceleration: named are the lines that any
/// channel has a name for, where the velocity has them.
fn velocity_of<'a>(
    group: ShownSpectrum<'a>,
    lines: &[NamedLine],
    rate: Rate,
    lowest: f64,
) -> ShownSpectrum<'a> {
    let rate = |at: f64| if at < lowest { 0.0 } else { rate(at) };
    let places = group.over.1;
    let value = |(at, value): (&f64, &f64)| rate(*at) * value;
    let columns = group.columns.iter().map(|(name, values)| {
        let rates: Vec<f64> = places.iter().zip(values.iter()).map(value).collect();
        (name.replace(" acceleration", ""), Cow::Owned(rates))
    });
    let columns: Vec<(String, Cow<'a, [f64]>)> = columns.collect();
    let peaks = lines.iter().flat_map(|line| {
        let own = columns.iter().enumerate();
        own.filter_map(|(column, (_, values))| {
            let height = line_height(places, values, line.at)?;
            Some(ShownPeak {
                column,
                at: line.at,
                height: MILLI * height,
                name: line.name.clone(),
            })
        })
    });
    ShownSpectrum {
        unit: "mm/s".to_owned(),
        factor: MILLI,
        peaks: peaks.collect(),
        columns,
        ..group
    }
}

/// Height of a curve at a line; none where the curve is higher just beyond the main lobe of a window.
fn line_height(places: &[f64], values: &[f64], at: f64) -> Option<f64> {
    const LOBE: usize = 3;
    let above = places.partition_point(|place| *place < at);
    let inside = values.get(above.checked_sub(1)?..=above)?;
    let height = inside.iter().copied().fold(0.0, f64::max);
    let beyond = [above.checked_sub(1 + LOBE)?, above + LOBE];
    let is_line = beyond
        .into_iter()
        .all(|place| values.get(place).is_none_or(|value| *value < height));
    is_line.then_some(height)
}

/// Largest frequency shown, Hz: a little above the highest peak, at least ten shaft orders.
pub(in crate::report) fn frequency_limit(spectrum: &Spectrum, peaks: &[Peak]) -> f64 {
    limit(spectrum, peaks.iter())
}

fn limit<'a>(spectrum: &Spectrum, peaks: impl Iterator<Item = &'a Peak> + Clone) -> f64 {
    let end = spectrum.frequency(spectrum.bins().saturating_sub(1).max(1));
    let peaks = peaks.map(|peak| (peak.channel.unit(), peak.frequency));
    content_limit(peaks, spectrum.shaft_frequency).min(end)
}

/// The frequency, Hz, up to which a spectrum has content, by the units and frequencies of its peaks, those of lengths alone
/// where there are any; no limit where it has no peaks and the shaft is stationary.
pub(in crate::report) fn content_limit<'a>(
    peaks: impl Iterator<Item = (&'a str, f64)> + Clone,
    shaft_frequency: f64,
) -> f64 {
    let has_lengths = peaks.clone().any(|(unit, _)| unit == "m");
    let counted = peaks.filter(|(unit, _)| !has_lengths || *unit == "m");
    let highest = counted.map(|(_, frequency)| frequency).fold(0.0, f64::max);
    match (1.25 * highest).max(10.0 * shaft_frequency) {
        0.0 => f64::INFINITY,
        wanted => wanted,
    }
}

/// Largest frequency shown of a run, Hz; no limit where it has no spectrum.
pub(in crate::report) fn frequency_limit_of(run: &Run) -> f64 {
    let spectrum = run.spectrum.as_ref();
    spectrum.map_or(f64::INFINITY, |spectrum| {
        frequency_limit(spectrum, &run.peaks)
    })
}

/// Height of the plot of a file, px.
const HEIGHT: u32 = 380;
/// Height of one on a page, px.
const PAGE_HEIGHT: u32 = 280;

/// Amplitudes of x, y and z (those that move) against frequency.
pub(crate) fn spectrum_figure(title: &str, spectrum: &Spectrum, peaks: &[Peak]) -> Figure {
    let table = spectrum_table(spectrum);
    let mut groups = shown_groups(&table, spectrum, peaks);
    match groups.find(|(name, _)| *name == "displacement") {
        Some((name, shown)) => figure("spectrum", title, name, shown, HEIGHT),
        None => Figure::new("spectrum", title, 1, Vec::new()),
    }
}

fn figure(name: &str, title: &str, of: &str, mut shown: ShownSpectrum<'_>, height: u32) -> Figure {
    shown.quantity = format!("{} {}", of.replace('_', " "), shown.quantity);
    let figure = Figure::new(name, title, 1, vec![shown.panel(height)]);
    figure.with_names(shown.names())
}

#[cfg(test)]
mod tests {
    use super::line_height;

    #[test]
    fn a_line_has_a_height_where_the_curve_has_a_peak() {
        let places: Vec<f64> = (0..12).map(f64::from).collect();
        let mut values = vec![0.1; 12];
        values[4..7].copy_from_slice(&[1.0, 2.0, 1.0]);
        assert_eq!(line_height(&places, &values, 5.2), Some(2.0));
        assert_eq!(line_height(&places, &values, 8.5), None);
    }
}
