//! From results to files: CSV, JSON, SVG figures, a few lines for the terminal, and comparison.

mod accuracy;
mod bytes;
mod campbell;
mod claim;
pub mod compare;
mod destination;
mod error;
mod estimate;
mod figure;
mod figure_trace;
mod folder;
pub(crate) mod many;
mod motion;
mod page;
mod restart;
mod run_report;
pub(crate) mod run_tables;
mod run_up;
mod spectra;
mod spectrum;
mod statics;
mod steady;
mod study;
pub(crate) mod table;
mod terminal;
mod text;

pub(crate) use accuracy::{accuracy_text, write_accuracy};
#[cfg(test)]
pub(crate) use bytes::Checksum;
pub(crate) use campbell::{campbell_json, campbell_text, write_campbell};
pub(crate) use destination::{Destination, document};
pub(crate) use error::Failure;
pub use error::{FileAction, ReportError};
pub(crate) use estimate::{entry_json, entry_text, estimate_json, estimate_text};
pub(crate) use figure_trace::{Bucket, Decimator, TraceFigure};
pub(crate) use folder::{FileSet, PartialFile, RunFolder, WholeFile, write_whole};
pub(crate) use restart::{RestartError, RestartReader, RestartWriter, RunIdentity, restart_path};
pub(crate) use run_report::{KeptFiles, Outputs};
pub use run_report::{RunReport, RunSummary};
pub(crate) use run_tables::EVENT_COLUMNS;
#[cfg(test)]
pub(crate) use run_tables::{
    TraceCsv, ball_columns, ball_row, event_columns, event_row, trace_columns,
};
pub(crate) use spectrum::spectrum_figure;
pub use spectrum::write_spectrum;
pub(crate) use statics::{answer_text, write_answer};
pub(crate) use steady::{
    response_json, response_text, steady_json, steady_text, write_response, write_steady,
};
pub(crate) use study::{study_json, study_text, write_study};
#[cfg(all(test, feature = "parquet"))]
pub(crate) use table::ParquetTable;
#[cfg(test)]
pub(crate) use table::{Column, CsvTable, MatTable, Origin};
pub(crate) use terminal::wrapped;
pub(crate) use text::{contact_choice_text, text};
