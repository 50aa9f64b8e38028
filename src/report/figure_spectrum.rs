//! The spectra of the displacements as a figure, with the strongest peaks named.

use std::ops::Range;

use plotters::prelude::*;
use plotters::style::text_anchor::{HPos, Pos, VPos};

use super::figure::{Area, CURVE_BUCKETS, DrawError, INK, LINE, PALETTE, font, px, svg};
use super::figure_lines::{
    self, AMPLITUDE_OVER_FREQUENCY, LineChart, draw_legend, legend_stroke, line_chart,
};
use super::{Bucket, Decimator, ReportError};
use crate::analysis::{Channel, ChannelSpectrum, Peak, Spectrum};
use crate::report::units::MICRO;
use crate::simulate::Run;

/// Height, px.
const HEIGHT: u32 = 600;
/// Largest number of names in the figure.
const MOST_NAMES: usize = 10;

/// Draws the SVG: amplitudes of x, y and z (those that move) against frequency.
///
/// # Errors
/// [`ReportError::Draw`] where the drawing library fails.
pub fn spectrum_figure(
    title: &str,
    spectrum: &Spectrum,
    peaks: &[Peak],
) -> Result<String, ReportError> {
    svg("spectrum.svg", HEIGHT, title, |area| {
        draw(area, spectrum, peaks)
    })
}

fn draw(area: &Area, spectrum: &Spectrum, peaks: &[Peak]) -> Result<(), DrawError> {
    let limit = frequency_limit(spectrum, peaks);
    let amplitudes = amplitude_range(spectrum);
    let floor = amplitudes.start;
    let mut chart = line_chart(area, 0.0..limit, amplitudes, AMPLITUDE_OVER_FREQUENCY)?;
    for (entry, colour) in lengths(spectrum).zip(PALETTE) {
        let curve = curve(spectrum, entry, limit, floor);
        chart
            .draw_series(LineSeries::new(curve, colour.stroke_width(LINE)))?
            .label(entry.channel.name())
            .legend(move |from| legend_stroke(from, colour));
    }
    draw_names(area, &chart, spectrum, peaks)?;
    draw_legend(&mut chart)
}

/// Spectra of the displacements that are lengths.
fn lengths(spectrum: &Spectrum) -> impl Iterator<Item = &ChannelSpectrum> {
    let all = spectrum.channels.iter();
    all.filter(|entry| is_length(entry.channel))
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

/// Some decades below the strongest line other than the mean, µm.
fn amplitude_range(spectrum: &Spectrum) -> Range<f64> {
    let strongest = lengths(spectrum)
        .flat_map(|entry| entry.amplitude.iter().skip(1))
        .fold(0.0, |largest: f64, amplitude| {
            largest.max(MICRO * amplitude)
        });
    figure_lines::amplitude_range(strongest)
}

/// Envelope of a channel's amplitudes up to `limit`, without the mean, not below `floor`.
fn curve(spectrum: &Spectrum, entry: &ChannelSpectrum, limit: f64, floor: f64) -> Vec<(f64, f64)> {
    let mut envelope = Decimator::new(CURVE_BUCKETS);
    for (k, amplitude) in entry.amplitude.iter().enumerate().skip(1) {
        let frequency = spectrum.frequency(k);
        if frequency > limit {
            break;
        }
        envelope.push(frequency, (MICRO * amplitude).max(floor));
    }
    let points = envelope.buckets();
    points
        .flat_map(|Bucket { first, last }| [first, last])
        .collect()
}

/// Marks the strongest named peaks, each name once and only where it covers no other.
fn draw_names(
    area: &Area,
    chart: &LineChart,
    spectrum: &Spectrum,
    peaks: &[Peak],
) -> Result<(), DrawError> {
    let (left, top) = area.get_base_pixel();
    let visible = chart.y_range();
    let mut placed = Vec::<Placed>::new();
    for (peak, name) in strongest_named(peaks) {
        let height = MICRO * shown_amplitude(spectrum, peak);
        if !chart.x_range().contains(&peak.frequency) || !visible.contains(&height) {
            continue;
        }
        let (x, y) = chart.backend_coord(&(peak.frequency, height));
        let label = Placed::above((x - left, y - top), name);
        if placed.len() == MOST_NAMES || placed.iter().any(|other| other.covers(&label)) {
            continue;
        }
        label.draw(area)?;
        placed.push(label);
    }
    Ok(())
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

/// The place that a name takes, drawing units.
struct Placed {
    name: String,
    point: (i32, i32),
    half_width: i32,
}

impl Placed {
    /// Estimated from the number of characters: the true font is the viewer's.
    fn above(point: (i32, i32), name: String) -> Self {
        let half_width = (px(7) as usize * name.chars().count() / 2) as i32;
        Self {
            name,
            point,
            half_width,
        }
    }

    fn draw(&self, area: &Area) -> Result<(), DrawError> {
        let (x, y) = self.point;
        let style = font(12).pos(Pos::new(HPos::Center, VPos::Bottom));
        area.draw(&Circle::new((x, y), px(2), INK.filled()))?;
        let above = (x, y - px(5) as i32);
        area.draw(&Text::new(self.name.as_str(), above, style))?;
        Ok(())
    }

    fn covers(&self, other: &Self) -> bool {
        (self.point.0 - other.point.0).abs() < self.half_width + other.half_width
            && (self.point.1 - other.point.1).abs() < px(15) as i32
    }
}
