//! The spectra of the displacements as a figure, with the strongest peaks named.

use super::ReportError;
use super::figure::{Axis, Curve, Figure, Name, Panel, distinct};
use crate::analysis::{Channel, ChannelSpectrum, Peak, Spectrum};
use crate::report::units::MICRO;
use crate::simulate::Run;

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
