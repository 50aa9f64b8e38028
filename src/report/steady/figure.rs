//! The spectrum of a steady motion: a stroke a line.

use crate::report::figure::{Axis, Curve, Figure, Name, Panel, Point, distinct};
use crate::report::figure_spectrum::{AMPLITUDE, FREQUENCY, HEIGHT};
use crate::report::units::MICRO;
use crate::steady::SteadyLines;

/// Amplitudes of x, y and z (those that move) over frequency.
pub(super) fn spectrum(title: &str, lines: &SteadyLines) -> Figure {
    let channels = lines.channels.iter().enumerate();
    let lengths: Vec<_> = channels
        .filter(|(_, channel)| channel.unit() == "m")
        .collect();
    let all = || lengths.iter().flat_map(|(index, _)| tips(lines, *index));
    let strongest = all().map(|(_, amplitude)| amplitude).fold(0.0, f64::max);
    let amplitudes = Axis::below(AMPLITUDE, strongest);
    let floor = amplitudes.least();
    let shown = all().filter(|(_, amplitude)| *amplitude > floor);
    let highest = shown.map(|(frequency, _)| frequency).fold(0.0, f64::max);
    let limit = if highest > 0.0 { 1.05 * highest } else { 1.0 };
    let strokes = lengths.iter().enumerate().flat_map(|(place, (index, _))| {
        // strokes of the same frequency stand side by side
        let beside = limit * 1.5e-3 * place as f64;
        let shown = tips(lines, *index).filter(|(_, amplitude)| *amplitude > floor);
        shown.map(move |(frequency, amplitude)| {
            let ends = [floor, amplitude].map(|end| (frequency + beside, end));
            Curve::line(distinct(place), ends.to_vec())
        })
    });
    let panel = Panel {
        curves: strokes.collect(),
        ..Panel::new(Axis::over(FREQUENCY, 0.0..limit), amplitudes, HEIGHT)
    };
    let names = Name::each(lengths.iter().map(|(_, channel)| channel.name()));
    Figure::new("steady_spectrum.svg", title, 1, vec![panel]).with_names(names)
}

/// Frequency and amplitude in µm of a channel's lines but the mean.
fn tips(lines: &SteadyLines, index: usize) -> impl Iterator<Item = Point> {
    let moving = lines.lines.iter().filter(|line| line.multiples != [0, 0]);
    moving.map(move |line| (line.frequency, MICRO * line.amplitude[index]))
}
