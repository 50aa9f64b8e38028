//! One spectrum as CSV.

use std::io::{self, Write};

use super::names;
use crate::analysis::{Axis, EstimatedSpectrum};

/// Writes one row a bin: `f_Hz` and, where the shaft turns steadily, `order`, in the other order over
/// orders; then every column.
///
/// # Errors
/// What the writer answers.
pub fn write_estimated(spectrum: &EstimatedSpectrum, writer: impl Write) -> io::Result<()> {
    let mut csv = csv::WriterBuilder::new()
        .has_headers(false)
        .from_writer(writer);
    csv.write_record(header(spectrum))?;
    let mut row = Vec::new();
    for k in 0..spectrum.bins() {
        row.clear();
        row.extend(axes(spectrum, k).into_iter().flatten());
        row.extend(spectrum.columns.iter().map(|column| column.values[k]));
        csv.serialize(&row)?;
    }
    csv.flush()
}

/// The places of a row, that of the axis first.
fn axes(spectrum: &EstimatedSpectrum, k: usize) -> [Option<f64>; 2] {
    let (frequency, order) = (spectrum.frequency(k), spectrum.order(k));
    match spectrum.request.axis {
        Axis::Frequency => [frequency, order],
        Axis::Order => [order, frequency],
    }
}

fn header(spectrum: &EstimatedSpectrum) -> Vec<String> {
    let names = match spectrum.request.axis {
        Axis::Frequency => ["f_Hz", "order"],
        Axis::Order => ["order", "f_Hz"],
    };
    let axes = names.into_iter().zip(axes(spectrum, 0));
    let axes = axes.filter_map(|(name, place)| place.map(|_| name.to_owned()));
    let columns = spectrum.columns.iter();
    axes.chain(columns.map(|column| names::column(spectrum, column.quantity)))
        .collect()
}
