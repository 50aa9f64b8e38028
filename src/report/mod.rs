//! From results to files: CSV, JSON, SVG figures, a few lines for the terminal, and comparison.

mod accuracy;
mod ball_table;
mod bytes;
mod campbell;
mod columns;
pub mod compare;
mod contact_choice;
mod decimator;
mod document;
mod error;
mod events_table;
mod failure;
mod figure;
mod figure_spectrum;
mod figure_trace;
mod folder;
mod histories;
pub mod many;
mod method_use;
mod motion;
mod named_peak;
mod page;
mod peak_table;
mod restart;
mod run_report;
mod run_up;
mod sample_table;
mod spectra;
mod spectrum_csv;
mod statics;
mod steady;
mod study;
mod summary;
mod table;
mod table_use;
mod terminal;
mod text;
mod units;

pub use accuracy::{accuracy_text, write_accuracy};
pub use ball_table::{ball_columns, ball_row};
pub use campbell::{campbell_json, campbell_text, write_campbell};
pub use contact_choice::contact_choice_text;
pub use decimator::{Bucket, Decimator};
pub use document::document;
pub use error::{FileAction, ReportError};
pub use events_table::{EVENT_COLUMNS, event_columns, event_row};
pub use failure::Failure;
pub use figure_spectrum::spectrum_figure;
pub use figure_trace::TraceFigure;
pub use folder::{FileSet, PartialFile, RunFolder, WholeFile, write_whole};
pub use restart::{RestartError, RestartReader, RestartWriter, RunIdentity, restart_path};
pub use run_report::{KeptFiles, Outputs, RunReport};
pub use sample_table::{TraceCsv, trace_columns};
pub use spectrum_csv::write_spectrum;
pub use statics::{answer_text, write_answer};
pub use steady::{
    response_json, response_text, steady_json, steady_text, write_response, write_steady,
};
pub use study::{study_json, study_text, write_study};
pub use summary::RunSummary;
#[cfg(feature = "parquet")]
pub use table::ParquetTable;
pub use table::{Column, ColumnKind, CsvTable, MatTable, Origin};
pub use terminal::wrapped;
pub use text::text;
