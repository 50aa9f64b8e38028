//! The spectra of a run: tables of values and of named peaks, and what is shown of them.

use std::borrow::Cow;
use std::f64::consts::TAU;
use std::io;
use std::io::Write;

use serde::Serialize;

use super::shown::{FREQUENCY, ShownPeak, ShownSpectrum};
use crate::analysis::{Peak, Spectrum};
use crate::report::figure::Figure;
use crate::report::table::CsvTable;
use crate::report::terminal::{MICRO, MILLI, shown_column, shown_unit};
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
    let named = peaks
        .iter()
        .map(|peak| NamedPeak::new(peak, Some(spectrum)));
    let named: Vec<NamedPeak> = named.collect();
    let peaks = || named.iter();
    let mut table = Table::default();
    table.words("channel", peaks().map(|peak| peak.channel));
    table.words("unit", peaks().map(|peak| peak.unit));
    table.add(Column::frequency(), peaks().map(|peak| peak.frequency));
    table.add(Column::order(), peaks().map(|peak| peak.order));
    table.numbers("amplitude", "", peaks().map(|peak| peak.amplitude));
    table.numbers("phase", "rad", peaks().map(|peak| peak.phase));
    table.words(
        "name",
        peaks().map(|peak| peak.name.as_deref().unwrap_or_default()),
    );
    table.numbers("name_f", "Hz", peaks().map(|peak| peak.name_frequency));
    table.numbers("distance", "Hz", peaks().map(|peak| peak.distance));
    table.numbers("distance_bins", "", peaks().map(|peak| peak.distance_bins));
    table.numbers("nominal_f", "Hz", peaks().map(|peak| peak.nominal));
    table.words(
        "other_names",
        peaks().map(|peak| peak.other_names.join("; ")),
    );
    table
}

/// A peak, the line that it is named after, and how far it is from it.
#[derive(Debug, Serialize)]
pub(in crate::report) struct NamedPeak<'a> {
    pub channel: &'a str,
    pub unit: &'a str,
    #[serde(rename = "frequency_Hz")]
    pub frequency: f64,
    /// Multiple of the shaft's frequency; none where it stands still or its speed changes.
    pub order: Option<f64>,
    pub amplitude: f64,
    #[serde(rename = "phase_rad")]
    pub phase: f64,
    pub name: Option<String>,
    #[serde(rename = "name_Hz")]
    pub name_frequency: Option<f64>,
    /// Of the peak from the line that it is named after.
    #[serde(rename = "distance_Hz")]
    pub distance: Option<f64>,
    pub distance_bins: Option<f64>,
    /// Where the same line is by the nominal contact angle.
    #[serde(rename = "nominal_Hz")]
    pub nominal: Option<f64>,
    /// What else the peak could be called, nearest first.
    pub other_names: Vec<String>,
}

impl<'a> NamedPeak<'a> {
    /// Of a spectrum.
    pub fn new(peak: &'a Peak, spectrum: Option<&Spectrum>) -> Self {
        let turning = spectrum.filter(|spectrum| spectrum.shaft_frequency > 0.0);
        let distance = peak.line.map(|line| peak.frequency - line.frequency);
        let bins = |(distance, spectrum): (f64, &Spectrum)| distance / spectrum.resolution;
        let others = peak.others.iter();
        Self {
            channel: peak.channel.name(),
            unit: peak.channel.unit(),
            frequency: peak.frequency,
            order: turning.map(|spectrum| peak.frequency / spectrum.shaft_frequency),
            amplitude: peak.amplitude,
            phase: peak.phase,
            name: peak.line.map(|line| line.kind.to_string()),
            name_frequency: peak.line.map(|line| line.frequency),
            distance,
            distance_bins: distance.zip(spectrum).map(bins),
            nominal: peak.line.and_then(|line| line.nominal),
            other_names: others.map(|line| line.kind.to_string()).collect(),
        }
    }
}

/// What a group of channels is called, and their unit.
const GROUPS: [(&str, &str); 4] = [
    ("displacement", "m"),
    ("tilt", "rad"),
    ("force", "N"),
    ("moment", "N m"),
];

/// What a page shows beside displacements: their velocities, then amplitudes of channels of one unit together, each a
/// figure.
pub(in crate::report) fn spectra_figures(
    title: &str,
    spectrum: &Spectrum,
    peaks: &[Peak],
) -> Vec<Figure> {
    let groups = GROUPS.iter();
    let groups = groups.filter_map(|(name, unit)| shown_group(spectrum, peaks, name, unit));
    let shown = groups.map(|group| match &*group.name {
        "displacement" => velocity_of(spectrum, &group),
        _ => group,
    });
    let figures = shown.map(|group| {
        let name = format!("{}_spectrum", group.name);
        figure(&name, title, &group, PAGE_HEIGHT).only_on_page()
    });
    figures.collect()
}

/// Velocities of displacements: 2πf times their amplitudes.
fn velocity_of<'a>(spectrum: &Spectrum, group: &ShownSpectrum<'a>) -> ShownSpectrum<'a> {
    let columns = group.columns.iter().map(|(name, values)| {
        let values = values.iter().enumerate();
        let rates = values.map(|(k, value)| TAU * spectrum.frequency(k) * value);
        (name.clone(), Cow::Owned(rates.collect()))
    });
    let peaks = group.peaks.iter().map(|peak| ShownPeak {
        height: MILLI / MICRO * TAU * peak.at * peak.height,
        ..peak.clone()
    });
    ShownSpectrum {
        name: "velocity".to_owned(),
        quantity: "velocity amplitude".to_owned(),
        unit: "mm/s".to_owned(),
        factor: MILLI,
        shown: group.shown.clone(),
        columns: columns.collect(),
        peaks: peaks.collect(),
        ..*group
    }
}

fn shown_group<'a>(
    spectrum: &'a Spectrum,
    peaks: &[Peak],
    name: &str,
    unit: &str,
) -> Option<ShownSpectrum<'a>> {
    let all = spectrum.channels.iter();
    let members: Vec<_> = all.filter(|entry| entry.channel.unit() == unit).collect();
    members.first()?;
    let (unit, factor) = shown_unit(unit);
    let named = peaks.iter().filter_map(|peak| {
        let column = members
            .iter()
            .position(|entry| entry.channel == peak.channel)?;
        Some(ShownPeak {
            column,
            at: peak.frequency,
            height: factor * peak.amplitude,
            name: peak.line?.kind.to_string(),
        })
    });
    let columns = members.iter().map(|entry| {
        let values = Cow::Borrowed(&entry.amplitude[..]);
        (shown_column(&entry.channel.column()).0.0, values)
    });
    Some(ShownSpectrum {
        name: name.to_owned(),
        quantity: format!("{name} amplitude"),
        unit,
        factor,
        over: FREQUENCY,
        first: 0,
        resolution: spectrum.resolution,
        shown: 0.0..frequency_limit(spectrum, peaks),
        columns: columns.collect(),
        peaks: named.collect(),
    })
}

/// Largest frequency shown, Hz: a little above the highest peak, at least ten shaft orders.
pub(in crate::report) fn frequency_limit(spectrum: &Spectrum, peaks: &[Peak]) -> f64 {
    let highest = peaks
        .iter()
        .filter(|peak| peak.channel.unit() == "m")
        .map(|peak| peak.frequency)
        .fold(0.0, f64::max);
    let end = spectrum.frequency(spectrum.bins().saturating_sub(1).max(1));
    let wanted = (1.25 * highest).max(10.0 * spectrum.shaft_frequency);
    if wanted > 0.0 { wanted.min(end) } else { end }
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
    match shown_group(spectrum, peaks, "displacement", "m") {
        Some(shown) => figure("spectrum", title, &shown, HEIGHT),
        None => Figure::new("spectrum", title, 1, Vec::new()),
    }
}

fn figure(name: &str, title: &str, shown: &ShownSpectrum<'_>, height: u32) -> Figure {
    let figure = Figure::new(name, title, 1, vec![shown.panel(height)]);
    figure.with_names(shown.names())
}
