//! The spectra of a run: tables of values and of named peaks, and the figure.

use std::io;
use std::io::Write;

use serde::Serialize;

use super::ReportError;
use super::figure::{Axis, Curve, Figure, Name, Panel, distinct};
use super::table::{Column, CsvTable, Table};
use super::terminal::MICRO;
use crate::analysis::{Channel, ChannelSpectrum, Peak, Spectrum, column_unit};
use crate::simulate::Run;

/// Writes one row a frequency: `f_Hz`, `order` (where the shaft turns), then amplitude and phase of
/// every channel.
///
/// # Errors
/// What the writer answers.
pub fn write_spectrum(spectrum: &Spectrum, writer: impl Write) -> io::Result<()> {
    let mut csv = CsvTable::new(writer, &spectrum_columns(spectrum))?;
    spectrum_rows(spectrum, |row| csv.row(row))?;
    csv.finish().map(drop)
}

/// Columns of the table.
pub(super) fn spectrum_columns(spectrum: &Spectrum) -> Vec<Column> {
    let mut columns = vec![Column::number("f_Hz")];
    columns.extend(spectrum.order(0).map(|_| Column::number("order")));
    for entry in &spectrum.channels {
        columns.push(Column::number(amplitude_column(entry.channel)));
        columns.push(Column::number(phase_column(entry.channel)));
    }
    columns
}

/// Gives the rows of the table one by one.
pub(super) fn spectrum_rows(
    spectrum: &Spectrum,
    mut take: impl FnMut(&[f64]) -> io::Result<()>,
) -> io::Result<()> {
    let mut row = Vec::new();
    for k in 0..spectrum.bins() {
        row.clear();
        row.push(spectrum.frequency(k));
        row.extend(spectrum.order(k));
        let channels = spectrum.channels.iter();
        row.extend(channels.flat_map(|channel| [channel.amplitude[k], channel.phase[k]]));
        take(&row)?;
    }
    Ok(())
}

/// `x_amplitude_m`, `force_x_amplitude_N`.
pub(super) fn amplitude_column(channel: Channel) -> String {
    format!("{channel}_amplitude_{}", column_unit(channel.unit()))
}

/// `x_phase_rad`, `force_x_phase_rad`.
pub(super) fn phase_column(channel: Channel) -> String {
    format!("{channel}_phase_rad")
}

/// One row a peak, channel by channel, strongest first.
///
/// `distance` is that of the peak from its name's frequency, `operating_f_Hz` where the same line stands
/// with the cage rolling at the operating contact angle.
pub(super) fn peak_table(peaks: &[Peak], spectrum: &Spectrum) -> Table {
    let named = peaks
        .iter()
        .map(|peak| NamedPeak::new(peak, Some(spectrum)));
    let named: Vec<NamedPeak> = named.collect();
    let peaks = || named.iter();
    let mut table = Table::default();
    table.words("channel", peaks().map(|peak| peak.channel));
    table.words("unit", peaks().map(|peak| peak.unit));
    table.numbers("f_Hz", peaks().map(|peak| peak.frequency));
    table.numbers("order", peaks().map(|peak| peak.order));
    table.numbers("amplitude", peaks().map(|peak| peak.amplitude));
    table.numbers("phase_rad", peaks().map(|peak| peak.phase));
    table.words(
        "name",
        peaks().map(|peak| peak.name.as_deref().unwrap_or_default()),
    );
    table.numbers("name_f_Hz", peaks().map(|peak| peak.name_frequency));
    table.numbers("distance_Hz", peaks().map(|peak| peak.distance));
    table.numbers("distance_bins", peaks().map(|peak| peak.distance_bins));
    table.numbers("operating_f_Hz", peaks().map(|peak| peak.operating));
    table.words(
        "other_names",
        peaks().map(|peak| peak.other_names.join("; ")),
    );
    table
}

/// A peak, the line that it is named after, and how far it is from it.
#[derive(Debug, Serialize)]
pub(super) struct NamedPeak<'a> {
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
    /// Where the same line stands with the cage rolling at the operating contact angle.
    #[serde(rename = "operating_Hz")]
    pub operating: Option<f64>,
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
            operating: peak.line.and_then(|line| line.operating),
            other_names: others.map(|line| line.kind.to_string()).collect(),
        }
    }
}

/// Height of the plot, px.
pub(super) const HEIGHT: u32 = 480;
/// What most spectra are drawn over.
pub(super) const FREQUENCY: &str = "frequency in Hz";
/// What they show.
pub(super) const AMPLITUDE: &str = "amplitude in µm";

/// Draws the SVG: amplitudes of x, y and z (those that move) against frequency.
///
/// # Errors
/// [`ReportError::Draw`] where the drawing library fails.
pub fn spectrum_figure(
    title: &str,
    spectrum: &Spectrum,
    peaks: &[Peak],
) -> Result<String, ReportError> {
    let all = spectrum.channels.iter();
    let lengths: Vec<_> = all.filter(|entry| is_length(entry.channel)).collect();
    let limit = frequency_limit(spectrum, peaks);
    let curve = |(index, entry): (usize, &&ChannelSpectrum)| {
        // without the mean
        let amplitudes = entry.amplitude.iter().enumerate().skip(1);
        let points = amplitudes.map(|(k, value)| (spectrum.frequency(k), MICRO * value));
        Curve::envelope(
            distinct(index),
            points.take_while(|(frequency, _)| *frequency <= limit),
        )
    };
    let amplitudes = lengths
        .iter()
        .flat_map(|entry| &entry.amplitude[1.min(entry.amplitude.len())..]);
    let strongest = amplitudes.fold(0.0, |most: f64, value| most.max(MICRO * value));
    let mut panel = Panel::new(
        Axis::over(FREQUENCY, 0.0..limit),
        Axis::below(AMPLITUDE, strongest),
        HEIGHT,
    );
    panel.curves = lengths.iter().enumerate().map(curve).collect();
    let named = strongest_named(peaks).into_iter();
    panel.peaks = named
        .map(|(peak, name)| {
            (
                (peak.frequency, MICRO * shown_amplitude(spectrum, peak)),
                name,
            )
        })
        .collect();
    let names = Name::each(lengths.iter().map(|entry| entry.channel.name()));
    let figure = Figure::new("spectrum.svg", title, 1, vec![panel]);
    figure.with_names(names).svg()
}

fn is_length(channel: Channel) -> bool {
    channel.unit() == "m"
}

/// Largest frequency shown, Hz: a little above the highest peak, at least ten shaft orders.
pub(super) fn frequency_limit(spectrum: &Spectrum, peaks: &[Peak]) -> f64 {
    let highest = peaks
        .iter()
        .filter(|peak| is_length(peak.channel))
        .map(|peak| peak.frequency)
        .fold(0.0, f64::max);
    let end = spectrum.frequency(spectrum.bins().saturating_sub(1).max(1));
    let wanted = (1.25 * highest).max(10.0 * spectrum.shaft_frequency);
    if wanted > 0.0 { wanted.min(end) } else { end }
}

/// The same of a run; no limit where it has no spectrum.
pub(super) fn frequency_limit_of(run: &Run) -> f64 {
    let spectrum = run.spectrum.as_ref();
    spectrum.map_or(f64::INFINITY, |spectrum| {
        frequency_limit(spectrum, &run.peaks)
    })
}

/// Height of the curve at a peak, m: less than the peak itself where it lies between two bins.
fn shown_amplitude(spectrum: &Spectrum, peak: &Peak) -> f64 {
    let bin = peak.frequency / spectrum.resolution;
    let amplitude = |k: f64| Some(*spectrum.channel(peak.channel)?.amplitude.get(k as usize)?);
    let [below, above] = [bin.floor(), bin.ceil()].map(|k| amplitude(k).unwrap_or(0.0));
    below.max(above)
}

/// Peaks of lengths that have a cause, strongest first, one for each name.
fn strongest_named(peaks: &[Peak]) -> Vec<(&Peak, String)> {
    let mut named: Vec<(&Peak, String)> = peaks
        .iter()
        .filter(|peak| is_length(peak.channel))
        .filter_map(|peak| Some((peak, peak.line?.kind.to_string())))
        .collect();
    named.sort_by(|(a, _), (b, _)| b.amplitude.total_cmp(&a.amplitude));
    let mut seen = std::collections::HashSet::new();
    named.retain(|(_, name)| seen.insert(name.clone()));
    named
}
