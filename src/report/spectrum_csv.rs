//! The spectra as CSV.

use std::io::{self, Write};

use super::columns::{amplitude_column, phase_column};
use crate::analysis::Spectrum;

/// Writes one row a frequency: `f_Hz`, `order` (where the shaft turns), then amplitude and phase of
/// every channel.
///
/// # Errors
/// What the writer answers.
pub fn write_spectrum(spectrum: &Spectrum, writer: impl Write) -> io::Result<()> {
    let mut csv = csv::WriterBuilder::new()
        .has_headers(false)
        .from_writer(writer);
    csv.write_record(header(spectrum))?;
    let mut row = Vec::new();
    for k in 0..spectrum.bins() {
        row.clear();
        row.push(spectrum.frequency(k));
        row.extend(spectrum.order(k));
        let channels = spectrum.channels.iter();
        row.extend(channels.flat_map(|channel| [channel.amplitude[k], channel.phase[k]]));
        csv.serialize(&row)?;
    }
    csv.flush()
}

fn header(spectrum: &Spectrum) -> Vec<String> {
    let mut names = vec!["f_Hz".to_owned()];
    names.extend(spectrum.order(0).map(|_| "order".to_owned()));
    for entry in &spectrum.channels {
        names.push(amplitude_column(entry.channel));
        names.push(phase_column(entry.channel));
    }
    names
}
