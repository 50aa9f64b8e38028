//! From results to files: CSV, JSON, SVG figures, a few lines for the terminal, and comparison.

mod accuracy;
mod ball_table;
mod bytes;
mod campbell;
mod claim;
mod columns;
pub mod compare;
mod contact_choice;
mod decimator;
mod destination;
mod document;
mod error;
mod events_table;
mod failure;
mod figure;
mod figure_spectrum;
mod figure_trace;
mod folder;
mod histories;
pub(crate) mod many;
mod method_use;
mod motion;
mod named_peak;
mod page;
mod peak_table;
mod restart;
mod run_report;
mod run_up;
pub(crate) mod sample_table;
mod scenario_report;
mod spectra;
mod spectrum_csv;
mod statics;
mod steady;
mod study;
mod summary;
pub(crate) mod table;
mod table_use;
mod terminal;
mod text;
mod units;

pub(crate) use accuracy::{accuracy_text, write_accuracy};
#[cfg(test)]
pub(crate) use ball_table::{ball_columns, ball_row};
#[cfg(test)]
pub(crate) use bytes::Checksum;
pub(crate) use campbell::{campbell_json, campbell_text, write_campbell};
pub(crate) use contact_choice::contact_choice_text;
pub(crate) use decimator::{Bucket, Decimator};
pub(crate) use destination::Destination;
pub(crate) use document::document;
pub use error::{FileAction, ReportError};
pub(crate) use events_table::EVENT_COLUMNS;
#[cfg(test)]
pub(crate) use events_table::{event_columns, event_row};
pub(crate) use failure::Failure;
pub(crate) use figure_spectrum::spectrum_figure;
pub(crate) use figure_trace::TraceFigure;
pub(crate) use folder::{FileSet, PartialFile, RunFolder, WholeFile, write_whole};
pub(crate) use restart::{RestartError, RestartReader, RestartWriter, RunIdentity, restart_path};
pub use run_report::RunReport;
pub(crate) use run_report::{KeptFiles, Outputs};
#[cfg(test)]
pub(crate) use sample_table::{TraceCsv, trace_columns};
pub use spectrum_csv::write_spectrum;
pub(crate) use statics::{answer_text, write_answer};
pub(crate) use steady::{
    response_json, response_text, steady_json, steady_text, write_response, write_steady,
};
pub(crate) use study::{study_json, study_text, write_study};
pub use summary::RunSummary;
#[cfg(all(test, feature = "parquet"))]
pub(crate) use table::ParquetTable;
#[cfg(test)]
pub(crate) use table::{Column, CsvTable, MatTable, Origin};
pub(crate) use terminal::wrapped;
pub(crate) use text::text;
