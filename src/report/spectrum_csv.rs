//! The spectra as a table, and as CSV.

use std::io::{self, Write};

use super::columns::{amplitude_column, phase_column};
use super::table::{Column, CsvTable};
use crate::analysis::Spectrum;

/// Writes one row a frequency: `f_Hz`, `order` (where the shaft turns), then amplitude and phase of
/// every channel.
///
/// # Errors
/// What the writer answers.
pub fn write_spectrum(spectrum: &Spectrum, writer: impl Write) -> io::Result<()> {
    let mut csv = CsvTable::new(writer, &spectrum_columns(spectrum))?;
    spectrum_rows(spectrum, |row| csv.row(row))?;
    csv.finish().map(drop)
}

/// Columns of the table.
pub(super) fn spectrum_columns(spectrum: &Spectrum) -> Vec<Column> {
    let mut columns = vec![Column::number("f_Hz")];
    columns.extend(spectrum.order(0).map(|_| Column::number("order")));
    for entry in &spectrum.channels {
        columns.push(Column::number(amplitude_column(entry.channel)));
        columns.push(Column::number(phase_column(entry.channel)));
    }
    columns
}

/// Gives the rows of the table one by one.
pub(super) fn spectrum_rows(
    spectrum: &Spectrum,
    mut take: impl FnMut(&[f64]) -> io::Result<()>,
) -> io::Result<()> {
    let mut row = Vec::new();
    for k in 0..spectrum.bins() {
        row.clear();
        row.push(spectrum.frequency(k));
        row.extend(spectrum.order(k));
        let channels = spectrum.channels.iter();
        row.extend(channels.flat_map(|channel| [channel.amplitude[k], channel.phase[k]]));
        take(&row)?;
    }
    Ok(())
}
