//! Spectra: that of a run with its named peaks, and those that a scenario asks for.

mod estimated;
mod run;
mod shown;

pub(super) use estimated::{estimated_figures, estimated_json, estimated_table, table_name};
pub(crate) use run::spectrum_figure;
pub use run::write_spectrum;
pub(super) use run::{
    content_limit, frequency_limit, frequency_limit_of, measured_figures, peak_table,
    spectra_figures, spectrum_table,
};
