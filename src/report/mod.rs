//! From results to files: CSV, JSON, SVG figures, a few lines for the terminal, and comparison.

mod accuracy;
mod bytes;
mod campbell;
mod claim;
pub mod compare;
mod destination;
mod error;
mod figure;
mod figure_trace;
mod folder;
pub(crate) mod many;
mod motion;
mod page;
mod recorded;
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

pub use accuracy::{accuracy_answer, accuracy_text};
#[cfg(test)]
pub(crate) use bytes::Checksum;
pub use campbell::{campbell_answer, campbell_text};
pub(crate) use destination::document;
pub use destination::{Answer, Destination};
pub(crate) use error::Failure;
pub use error::{FileAction, ReportError};
pub(crate) use figure_trace::{Bucket, Decimator, TraceFigure};
pub(crate) use folder::{FileSet, PartialFile, RunFolder, WholeFile, write_whole};
pub use many::{
    Digest, MakeError, Making, MergeError, StudyRuns, StudyWatch, merge as merge_study,
};
pub use recorded::RunAnswer;
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
pub use statics::{answer_text, static_answer};
pub use steady::{response_answer, response_text, steady_answer, steady_text};
pub(crate) use study::study_json;
pub use study::{study_answer, study_text};
#[cfg(all(test, feature = "parquet"))]
pub(crate) use table::ParquetTable;
pub use table::{Column, ColumnKind, Table};
#[cfg(test)]
pub(crate) use table::{CsvTable, MatTable, Origin};
pub(crate) use terminal::wrapped;
pub use text::contact_choice_text;
pub(crate) use text::text;
