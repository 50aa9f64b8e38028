//! `steady_spectrum.csv`: one row a line.

use std::f64::consts::TAU;

use super::super::columns::{amplitude_column, phase_column};
use super::super::table::Table;
use crate::steady::Steady;

/// Frequency, order of the shaft (where it turns), both multiples, then amplitude and phase of every
/// channel.
pub(super) fn lines(steady: &Steady, speed: f64) -> Table {
    let lines = || steady.lines.lines.iter();
    let mut table = Table::default();
    table.numbers("f_Hz", lines().map(|line| line.frequency));
    if speed > 0.0 {
        table.numbers("order", lines().map(|line| line.frequency * TAU / speed));
    }
    for (place, name) in ["multiple_of_first", "multiple_of_second"]
        .into_iter()
        .enumerate()
    {
        table.counts(name, lines().map(|line| f64::from(line.multiples[place])));
    }
    for (index, channel) in steady.lines.channels.iter().enumerate() {
        table.numbers(
            amplitude_column(*channel),
            lines().map(|line| line.amplitude[index]),
        );
        table.numbers(
            phase_column(*channel),
            lines().map(|line| line.phase[index]),
        );
    }
    table
}
