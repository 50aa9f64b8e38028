//! The spectra of the displacements as a figure, with the strongest peaks named.

use std::ops::Range;

use plotters::coord::types::RangedCoordf64;
use plotters::prelude::*;
use plotters::style::text_anchor::{HPos, Pos, VPos};

use super::figure::{
    Area, CURVE_BUCKETS, DrawError, GRID, INK, LINE, PALETTE, font, px, svg, tick_format,
};
use super::{Bucket, Decimator, ReportError};
use crate::analysis::{Channel, ChannelSpectrum, Peak, Spectrum};

/// m → µm.
const MICRO: f64 = 1e6;
/// Height, px.
const HEIGHT: u32 = 600;
/// Decades shown below the strongest line.
const DECADES: i32 = 6;
/// Largest number of names in the figure.
const MOST_NAMES: usize = 10;

type Chart<'a, 'b> = ChartContext<'a, SVGBackend<'b>, Cartesian2d<RangedCoordf64, LogCoord<f64>>>;

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
    let mut chart: Chart = ChartBuilder::on(area)
        .margin_top(px(8))
        .margin_left(px(12))
        .margin_right(px(24))
        .set_label_area_size(LabelAreaPosition::Left, px(68))
        .set_label_area_size(LabelAreaPosition::Bottom, px(48))
        .build_cartesian_2d(0.0..limit, amplitudes.log_scale())?;
    draw_axes(&mut chart, limit)?;
    for (entry, colour) in lengths(spectrum).zip(PALETTE) {
        let curve = curve(spectrum, entry, limit, floor);
        chart
            .draw_series(LineSeries::new(curve, colour.stroke_width(LINE)))?
            .label(entry.channel.name())
            .legend(move |(x, y)| {
                PathElement::new(
                    [(x, y), (x + px(20) as i32, y)],
                    colour.stroke_width(2 * LINE),
                )
            });
    }
    draw_names(area, &chart, spectrum, peaks)?;
    chart
        .configure_series_labels()
        .position(SeriesLabelPosition::UpperRight)
        .margin(px(8))
        .legend_area_size(px(28))
        .background_style(WHITE.mix(0.85))
        .border_style(GRID)
        .label_font(font(14))
        .draw()?;
    Ok(())
}

fn draw_axes(chart: &mut Chart, limit: f64) -> Result<(), DrawError> {
    chart
        .configure_mesh()
        .bold_line_style(GRID)
        .light_line_style(TRANSPARENT)
        .x_labels(10)
        .x_label_formatter(&tick_format(limit))
        .y_label_formatter(&power_of_ten)
        .x_desc("frequency in Hz")
        .y_desc("amplitude in µm")
        .axis_style(INK)
        .label_style(font(13))
        .axis_desc_style(font(14))
        .draw()?;
    Ok(())
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
fn frequency_limit(spectrum: &Spectrum, peaks: &[Peak]) -> f64 {
    let highest = peaks
        .iter()
        .filter(|peak| is_length(peak.channel))
        .map(|peak| peak.frequency)
        .fold(0.0, f64::max);
    let end = spectrum.frequency(spectrum.bins().saturating_sub(1).max(1));
    let wanted = (1.25 * highest).max(10.0 * spectrum.shaft_frequency);
    if wanted > 0.0 { wanted.min(end) } else { end }
}

/// Some decades below the strongest line other than the mean, µm.
fn amplitude_range(spectrum: &Spectrum) -> Range<f64> {
    let strongest = lengths(spectrum)
        .flat_map(|entry| entry.amplitude.iter().skip(1))
        .fold(0.0, |largest: f64, amplitude| {
            largest.max(MICRO * amplitude)
        });
    let top = if strongest > 0.0 { strongest } else { 1.0 };
    let decade = top.log10().floor() as i32;
    10f64.powi(decade - DECADES + 1)..4.0 * top
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
    chart: &Chart,
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

/// `10⁻³`.
fn power_of_ten(value: &f64) -> String {
    let exponent = value.log10().round() as i32;
    let superscript = |c: char| match c {
        '-' => '⁻',
        '1' => '¹',
        '2' => '²',
        '3' => '³',
        digit => char::from_u32('⁰' as u32 + digit as u32 - '0' as u32).unwrap_or(digit),
    };
    let exponent: String = exponent.to_string().chars().map(superscript).collect();
    format!("10{exponent}")
}
