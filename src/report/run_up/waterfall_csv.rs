//! `waterfall.csv`: one row a short-time spectrum and frequency.

use std::io::{self, Write};

use super::super::columns::amplitude_column;
use crate::analysis::Waterfall;

/// Writes time, mean speed and frequency, then the amplitude of every channel.
pub(super) fn write(waterfall: &Waterfall, writer: impl Write) -> io::Result<()> {
    let mut csv = csv::WriterBuilder::new()
        .has_headers(false)
        .from_writer(writer);
    let names = ["t_s", "speed_rad_s", "f_Hz"].map(str::to_owned);
    let channels = waterfall.channels.iter();
    let columns = channels.map(|channel| amplitude_column(*channel));
    csv.write_record(names.into_iter().chain(columns))?;
    let mut row = Vec::new();
    for slice in &waterfall.slices {
        for k in 0..waterfall.bins() {
            row.clear();
            row.extend([slice.time, slice.speed, k as f64 * waterfall.resolution]);
            row.extend(slice.amplitude.iter().map(|amplitude| amplitude[k]));
            csv.serialize(&row)?;
        }
    }
    csv.flush()
}
