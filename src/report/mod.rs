//! From results to files: CSV, JSON, SVG figures, a few lines for the terminal, and comparison.

mod accuracy;
mod ball_trace_csv;
mod columns;
pub mod compare;
mod contact_choice;
mod decimator;
mod error;
mod events_csv;
mod failure;
mod figure;
mod figure_curves;
mod figure_lines;
mod figure_spectrum;
mod figure_trace;
mod folder;
mod histories;
mod method_use;
mod restart;
mod run_report;
mod sample_table;
mod spectrum_csv;
mod statics;
mod steady;
mod study;
mod summary;
mod text;
mod trace_csv;

pub use accuracy::{accuracy_json, accuracy_text, write_accuracy};
pub use ball_trace_csv::BallTraceCsv;
pub use contact_choice::{contact_choice_json, contact_choice_text};
pub use decimator::{Bucket, Decimator};
pub use error::{FileAction, ReportError};
pub use events_csv::{EVENT_COLUMNS, EventsCsv};
pub use failure::Failure;
pub use figure_spectrum::spectrum_figure;
pub use figure_trace::TraceFigure;
pub use folder::{FileSet, PartialFile, RunFolder, WholeFile};
pub use restart::{RestartError, RestartReader, RestartWriter, RunIdentity, restart_path};
pub use run_report::{KeptFiles, Outputs, RunReport};
pub use spectrum_csv::write_spectrum;
pub use statics::{answer_json, answer_text, write_answer};
pub use steady::{
    response_json, response_text, steady_json, steady_text, write_response, write_steady,
};
pub use study::{study_json, study_text, write_study};
pub use summary::summary;
pub use text::text;
pub use trace_csv::{TRACE_COLUMNS, TraceCsv};
