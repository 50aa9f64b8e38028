//! From results to files: CSV, JSON, SVG figures, a few lines for the terminal, and comparison.

pub(crate) mod accuracy;
pub(crate) mod campbell;
mod catalogue;
pub mod compare;
mod contact_choice;
mod digits;
mod envelope;
mod error;
mod figure;
pub(crate) mod findings;
mod fit;
mod folder;
mod linear_response;
pub(crate) mod many;
mod matrices;
mod measured;
mod npz;
mod page;
mod raster;
pub(crate) mod response;
mod rolling_elements;
pub(crate) mod run;
pub(crate) mod scene;
mod sensitivity;
mod shaft_shapes;
mod spectra;
pub(crate) mod statics;
pub(crate) mod steady;
pub(crate) mod table;
mod terminal;
mod variable;
mod whole_file;

pub(crate) use accuracy::accuracy_findings;
pub(crate) use campbell::campbell_findings;
pub(crate) use catalogue::balls::{entry_json, entry_text, estimate_json, estimate_text};
pub(crate) use catalogue::catalogue_text;
pub(crate) use catalogue::rollers::{
    add_roller_table, roller_entry_json, roller_entry_text, roller_estimate_json,
    roller_estimate_text,
};
#[cfg(test)]
pub(crate) use envelope::Decimator;
pub(crate) use error::FileAction;
pub use error::ReportError;
pub(crate) use findings::{Findings, versioned};
pub(crate) use fit::fit_findings;
pub(crate) use folder::{FileSet, RunFolder, write_whole};
pub(crate) use linear_response::linear_response_findings;
pub(crate) use matrices::matrices_findings;
pub(crate) use response::{ResponseError, response_findings};
#[cfg(test)]
pub(crate) use run::histories::Histories;
pub(crate) use whole_file::{PartialFile, WholeFile};

pub(crate) use measured::{listed_record, measured_findings, record_json};

pub use findings::WrittenFindings;
pub(crate) use run::files::KeptFiles;
pub use run::files::RunReport;
#[cfg(test)]
pub(crate) use run::tables::{
    TraceCsv, ball_columns, ball_row, event_columns, event_row, trace_columns,
};
pub(crate) use sensitivity::SensitivityTable;
pub(crate) use spectra::spectrum_figure;
pub use spectra::write_spectrum;
pub(crate) use statics::answer_findings;
pub(crate) use steady::steady_findings;
#[cfg(test)]
pub(crate) use table::CsvTable;
#[cfg(all(test, feature = "parquet"))]
pub(crate) use table::{Origin, ParquetTable};
pub(crate) use terminal::wrote;
