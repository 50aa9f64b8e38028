//! The spectra that a scenario asks for: a table each, and how each was made.

mod csv;
mod json;
mod names;

pub use csv::write_estimated;
pub(super) use json::estimated_json;

use crate::analysis::EstimatedSpectrum;

/// Name of the file of a spectrum.
pub(super) fn file_name(spectrum: &EstimatedSpectrum) -> String {
    format!("spectrum_{}.csv", spectrum.request.name)
}
