//! `steady_spectrum.csv`: one row a line.

use std::f64::consts::TAU;
use std::io::{self, Write};

use super::super::columns::{amplitude_column, phase_column};
use crate::steady::Steady;

/// Writes frequency, order of the shaft (where it turns), both multiples, then amplitude and phase of
/// every channel.
pub(super) fn write(steady: &Steady, speed: f64, writer: impl Write) -> io::Result<()> {
    let mut csv = csv::WriterBuilder::new()
        .has_headers(false)
        .from_writer(writer);
    let turns = speed > 0.0;
    let mut header = vec!["f_Hz".to_owned()];
    header.extend(turns.then(|| "order".to_owned()));
    header.extend(["multiple_of_first", "multiple_of_second"].map(str::to_owned));
    for channel in &steady.lines.channels {
        header.extend([amplitude_column(*channel), phase_column(*channel)]);
    }
    csv.write_record(header)?;
    for line in &steady.lines.lines {
        let order = turns.then(|| line.frequency * TAU / speed);
        let channels: Vec<[f64; 2]> = line
            .amplitude
            .iter()
            .zip(&line.phase)
            .map(|(amplitude, phase)| [*amplitude, *phase])
            .collect();
        let order: Vec<f64> = order.into_iter().collect();
        csv.serialize((line.frequency, order, line.multiples, channels))?;
    }
    csv.flush()
}
