//! What can go wrong between a result and its file, and what is kept of a run that cannot go on.

use std::path::{Path, PathBuf};
use std::{fmt, io};

use serde::Serialize;

use super::FileSet;
use crate::integrate::{Counters, IntegrateError};
use crate::scenario::TableFormat;

/// What was being done to a file or folder.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub enum FileAction {
    /// Create a file or folder.
    Create,
    /// Read a file.
    Read,
    /// Write into a file.
    Write,
    /// See that a file or folder outlives a loss of power.
    Sync,
    /// Give a finished file its name.
    Rename,
    /// Remove the file of an earlier run.
    Remove,
}

impl fmt::Display for FileAction {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Create => "create",
            Self::Read => "read",
            Self::Write => "write",
            Self::Sync => "sync",
            Self::Rename => "rename",
            Self::Remove => "remove",
        })
    }
}

/// Why a result did not get into its file.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum ReportError {
    /// The file system refused.
    #[error("cannot {action} {}: {source}", path.display())]
    File {
        /// What was tried.
        action: FileAction,
        /// On what.
        path: PathBuf,
        /// The answer of the system.
        source: io::Error,
    },
    /// Another process writes to the folder.
    #[error(
        "another process is writing to {}; wait for its end, or write to another folder by --out",
        folder.display()
    )]
    Busy {
        /// The folder.
        folder: PathBuf,
    },
    /// A figure could not be drawn.
    #[error("cannot draw {figure}")]
    Draw {
        /// File name of the figure.
        figure: String,
        /// What the drawing library says.
        source: Box<dyn std::error::Error + Send + Sync>,
    },
}

impl ReportError {
    /// Adds action and path to an answer of the file system.
    pub(super) fn file(action: FileAction, path: &Path) -> impl FnOnce(io::Error) -> Self {
        let path = path.to_owned();
        move |source| Self::File {
            action,
            path,
            source,
        }
    }
}

/// Name of the trace up to the failure in a format.
pub(super) fn until_failure(format: TableFormat) -> String {
    format!("trace.until-failure.{}", format.extension())
}

/// How a run failed.
#[derive(Debug, Clone, Copy)]
pub struct Failure<'a> {
    /// Why it cannot go on, and from when.
    pub error: &'a IntegrateError,
    /// Work done until then.
    pub counters: Counters,
}

/// What `failure.json` says after version, title and scenario.
#[derive(Debug, Serialize)]
pub(super) struct FailureSummary<'a> {
    /// Why the run cannot go on, with what helps.
    error: String,
    /// The same in one word.
    kind: &'static str,
    /// Time up to which it went, s.
    time_s: f64,
    /// Samples up to there.
    samples: u64,
    /// Work done until then.
    counters: Counters,
    /// The file that keeps the trace up to the failure.
    trace: Option<&'a String>,
    /// Files of an earlier run that stand in the same folder.
    of_an_earlier_run: &'a [String],
}

impl<'a> FailureSummary<'a> {
    /// Of a failure after some samples, with the traces that are kept and the files of an earlier run.
    pub fn new(
        failure: &Failure<'_>,
        samples: u64,
        traces: &'a [String],
        earlier: &'a [String],
    ) -> Self {
        Self {
            error: failure.error.to_string(),
            kind: kind(failure.error),
            time_s: failure.error.time(),
            samples,
            counters: failure.counters,
            trace: traces.first(),
            of_an_earlier_run: earlier,
        }
    }
}

/// The kind of failure in one word, for programs.
fn kind(error: &IntegrateError) -> &'static str {
    match error {
        IntegrateError::StepLimit { .. } => "step_limit",
        IntegrateError::StepUnderflow { .. } => "step_underflow",
        IntegrateError::Stiff { .. } => "stiff",
        IntegrateError::NotFinite { .. } => "not_finite",
        IntegrateError::Interrupted { .. } => "interrupted",
    }
}

impl FileSet {
    /// What a run leaves that cannot go on; beside it an earlier run may stand whole.
    pub const FAILURE: Self = Self {
        seal: "failure.json",
        tables: &["trace.until-failure"],
        others: &[],
        spent: &[],
    };
}
