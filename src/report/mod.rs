//! From results to files: CSV, JSON, SVG figures, a few lines for the terminal, and comparison.

pub(crate) mod accuracy;
mod accuracy_figures;
pub(crate) mod campbell;
mod catalogue;
pub mod compare;
mod contact_choice;
mod defects;
mod digits;
mod envelope;
mod error;
mod estimate;
mod figure;
mod film;
pub(crate) mod findings;
mod fit;
mod folder;
mod histories;
mod linear_response;
mod linear_response_figures;
pub(crate) mod many;
mod matrices;
mod measured;
mod method_use;
mod motion;
mod npz;
mod order_tracks;
mod page;
mod raster;
pub(crate) mod recorded;
pub(crate) mod response;
mod roller_catalogue;
mod rolling_elements;
mod run_answer;
mod run_report;
pub(crate) mod run_tables;
mod run_up;
pub(crate) mod scene;
mod sensitivity;
mod shaft_shapes;
mod spectra;
pub(crate) mod statics;
pub(crate) mod steady;
pub(crate) mod table;
mod terminal;
pub(crate) mod text;
mod variable;
mod whole_file;

pub(crate) use accuracy::accuracy_findings;
pub(crate) use campbell::campbell_findings;
pub(crate) use catalogue::catalogue_text;
#[cfg(test)]
pub(crate) use envelope::Decimator;
pub(crate) use error::FileAction;
pub use error::ReportError;
pub(crate) use estimate::{entry_json, entry_text, estimate_json, estimate_text};
pub(crate) use findings::{Findings, versioned};
pub(crate) use fit::fit_findings;
pub(crate) use folder::{FileSet, RunFolder, write_whole};
#[cfg(test)]
pub(crate) use histories::Histories;
pub(crate) use linear_response::linear_response_findings;
pub(crate) use matrices::matrices_findings;
pub(crate) use response::{ResponseError, response_findings};
pub(crate) use roller_catalogue::{
    add_roller_table, roller_entry_json, roller_entry_text, roller_estimate_json,
    roller_estimate_text,
};
pub(crate) use whole_file::{PartialFile, WholeFile};

pub(crate) use measured::{listed_record, measured_findings, record_json};

pub use findings::WrittenFindings;
pub(crate) use run_report::KeptFiles;
pub use run_report::RunReport;
#[cfg(test)]
pub(crate) use run_tables::{
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
