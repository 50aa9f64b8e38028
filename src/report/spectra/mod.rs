//! The spectra that a scenario asks for: a table each, and how each was made.

mod figure;
mod json;
mod names;
mod shown;
mod table;

pub(super) use figure::estimated_figure;
pub(super) use json::EstimatedSummary;
pub(super) use shown::{ShownColumns, shown_columns, shown_places};
pub(super) use table::{estimated_columns, estimated_rows};

use crate::analysis::EstimatedSpectrum;

/// Name of the table of a spectrum, without the ending of its format.
pub(super) fn table_name(spectrum: &EstimatedSpectrum) -> String {
    format!("spectrum_{}", spectrum.request.name)
}
