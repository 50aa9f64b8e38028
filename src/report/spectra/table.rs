//! One spectrum as a table.

use std::io;

use super::super::table::Column;
use super::names;
use crate::analysis::{Axis, EstimatedSpectrum};

/// Gives one row a bin: `f_Hz` and, where the shaft turns steadily, `order`, in the other order over
/// orders; then every column.
pub(in super::super) fn estimated_rows(
    spectrum: &EstimatedSpectrum,
    take: &mut dyn FnMut(&[f64]) -> io::Result<()>,
) -> io::Result<()> {
    let mut row = Vec::new();
    for k in 0..spectrum.bins() {
        row.clear();
        row.extend(axes(spectrum, k).into_iter().flatten());
        row.extend(spectrum.columns.iter().map(|column| column.values[k]));
        take(&row)?;
    }
    Ok(())
}

/// The places of a row, that of the axis first.
fn axes(spectrum: &EstimatedSpectrum, k: usize) -> [Option<f64>; 2] {
    let (frequency, order) = (spectrum.frequency(k), spectrum.order(k));
    match spectrum.request.axis {
        Axis::Frequency => [frequency, order],
        Axis::Order => [order, frequency],
    }
}

/// Columns of the table.
pub(in super::super) fn estimated_columns(spectrum: &EstimatedSpectrum) -> Vec<Column> {
    let names = match spectrum.request.axis {
        Axis::Frequency => ["f_Hz", "order"],
        Axis::Order => ["order", "f_Hz"],
    };
    let axes = names.into_iter().zip(axes(spectrum, 0));
    let axes = axes.filter_map(|(name, place)| place.map(|_| name.to_owned()));
    let columns = spectrum.columns.iter();
    axes.chain(columns.map(|column| names::column(spectrum, column.quantity)))
        .map(Column::number)
        .collect()
}
