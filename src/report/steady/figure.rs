//! The spectrum of a steady motion: a stroke a line.

use std::ops::Range;

use plotters::prelude::*;

use super::super::ReportError;
use super::super::figure::{Area, DrawError, LINE, PALETTE, svg};
use super::super::figure_lines::{
    self, AMPLITUDE_OVER_FREQUENCY, draw_legend, legend_stroke, line_chart,
};
use crate::report::units::MICRO;
use crate::steady::SteadyLines;

/// Height, px.
const HEIGHT: u32 = 600;

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
    figure_lines::amplitude_range(strongest)
}

fn draw(area: &Area, lines: &SteadyLines) -> Result<(), DrawError> {
    let amplitudes = range(lines);
    let floor = amplitudes.start;
    let highest = lengths(lines)
        .flat_map(|(index, ..)| strokes(lines, index, floor))
        .map(|(frequency, _)| frequency)
        .fold(0.0, f64::max);
    let limit = if highest > 0.0 { 1.05 * highest } else { 1.0 };
    let mut chart = line_chart(area, 0.0..limit, amplitudes, AMPLITUDE_OVER_FREQUENCY)?;
    for (place, (index, name, colour)) in lengths(lines).enumerate() {
        // strokes of the same frequency stand side by side
        let beside = limit * 1.5e-3 * place as f64;
        let drawn = strokes(lines, index, floor).into_iter();
        let drawn = drawn.map(|(frequency, amplitude)| {
            let ends = [(frequency + beside, floor), (frequency + beside, amplitude)];
            PathElement::new(ends, colour.stroke_width(LINE))
        });
        chart
            .draw_series(drawn)?
            .label(name)
            .legend(move |from| legend_stroke(from, colour));
    }
    draw_legend(&mut chart)
}
