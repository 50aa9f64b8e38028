//! The spectrum of a steady motion: a stroke a line.

use std::ops::Range;

use plotters::prelude::*;

use super::super::ReportError;
use super::super::figure::{Area, DrawError, GRID, INK, LINE, PALETTE, font, px, svg, tick_format};
use crate::steady::SteadyLines;

/// m → µm.
const MICRO: f64 = 1e6;
/// Height, px.
const HEIGHT: u32 = 600;
/// Decades shown below the strongest line.
const DECADES: i32 = 6;

/// Draws amplitudes of x, y and z (those that move) over frequency.
pub(super) fn spectrum(title: &str, lines: &SteadyLines) -> Result<String, ReportError> {
    svg("steady_spectrum.svg", HEIGHT, title, |area| {
        draw(area, lines)
    })
}

/// Index and colour of the channels that are lengths.
fn lengths(lines: &SteadyLines) -> impl Iterator<Item = (usize, &'static str, RGBColor)> {
    let all = lines.channels.iter().enumerate();
    all.filter(|(_, channel)| channel.unit() == "m")
        .zip(PALETTE)
        .map(|((index, channel), colour)| (index, channel.name(), colour))
}

/// Frequency and amplitude in µm of a channel's lines above a floor.
fn strokes(lines: &SteadyLines, index: usize, floor: f64) -> Vec<(f64, f64)> {
    let moving = lines.lines.iter().filter(|line| line.multiples != [0, 0]);
    moving
        .map(|line| (line.frequency, MICRO * line.amplitude[index]))
        .filter(|(_, amplitude)| *amplitude > floor)
        .collect()
}

fn range(lines: &SteadyLines) -> Range<f64> {
    let all = lengths(lines).flat_map(|(index, ..)| strokes(lines, index, 0.0));
    let strongest = all.map(|(_, amplitude)| amplitude).fold(0.0, f64::max);
    let top = if strongest > 0.0 { strongest } else { 1.0 };
    10f64.powi(top.log10().floor() as i32 - DECADES + 1)..4.0 * top
}

fn draw(area: &Area, lines: &SteadyLines) -> Result<(), DrawError> {
    let amplitudes = range(lines);
    let floor = amplitudes.start;
    let highest = lengths(lines)
        .flat_map(|(index, ..)| strokes(lines, index, floor))
        .map(|(frequency, _)| frequency)
        .fold(0.0, f64::max);
    let limit = if highest > 0.0 { 1.05 * highest } else { 1.0 };
    let mut chart = ChartBuilder::on(area)
        .margin_top(px(8))
        .margin_left(px(12))
        .margin_right(px(24))
        .set_label_area_size(LabelAreaPosition::Left, px(68))
        .set_label_area_size(LabelAreaPosition::Bottom, px(48))
        .build_cartesian_2d(0.0..limit, amplitudes.log_scale())?;
    chart
        .configure_mesh()
        .bold_line_style(GRID)
        .light_line_style(TRANSPARENT)
        .x_labels(10)
        .x_label_formatter(&tick_format(limit))
        .y_label_formatter(&|value| format!("{value:.0e}"))
        .x_desc("frequency in Hz")
        .y_desc("amplitude in µm")
        .axis_style(INK)
        .label_style(font(13))
        .axis_desc_style(font(14))
        .draw()?;
    for (place, (index, name, colour)) in lengths(lines).enumerate() {
        // strokes of the same frequency stand side by side
        let beside = limit * 1.5e-3 * place as f64;
        let drawn = strokes(lines, index, floor).into_iter();
        let drawn = drawn.map(|(frequency, amplitude)| {
            let ends = [(frequency + beside, floor), (frequency + beside, amplitude)];
            PathElement::new(ends, colour.stroke_width(LINE))
        });
        chart.draw_series(drawn)?.label(name).legend(move |(x, y)| {
            PathElement::new(
                [(x, y), (x + px(20) as i32, y)],
                colour.stroke_width(2 * LINE),
            )
        });
    }
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
