//! What can keep a study from being made or put together.

use std::path::PathBuf;

use crate::report::ReportError;
use crate::study::many::Unmade;

/// Why a study did not come to its end, in words.
#[derive(Debug, thiserror::Error)]
pub enum StudyError {
    /// The rows in the file belong to other runs.
    #[error(
        "{} holds runs of another study: `{key}` was {there} there and is {here} now; undo the change, or \
         begin anew with --restart",
        path.display()
    )]
    Other {
        /// The file of the rows.
        path: PathBuf,
        /// What differs.
        key: String,
        /// There.
        there: String,
        /// Here.
        here: String,
    },
    /// The file holds no rows of a study.
    #[error("{} holds no rows of a study; remove it, or begin anew with --restart", _0.display())]
    NoRows(PathBuf),
    /// It was to stop, or the trace of a run cannot be kept.
    #[error(transparent)]
    Unmade(#[from] Unmade),
    /// There is no part to be put together.
    #[error(
        "{} holds no part of a study; `jeffcott study FILE --shard 1/N` writes the first of N",
        _0.display()
    )]
    NoParts(PathBuf),
    /// Some parts are missing.
    #[error("{missing} of {count} parts are missing: {}", listed(first, *missing))]
    Missing {
        /// How many.
        missing: u64,
        /// Numbers of the first of them.
        first: Vec<u64>,
        /// Of how many.
        count: u64,
    },
    /// Two parts are of different wholes.
    #[error(
        "{} and {} are parts of different studies: `{key}` is {there} in one and {here} in the other",
        a.display(),
        b.display()
    )]
    Different {
        /// One.
        a: PathBuf,
        /// The other.
        b: PathBuf,
        /// What differs.
        key: String,
        /// In the one.
        there: String,
        /// In the other.
        here: String,
    },
    /// A part is not whole.
    #[error("{} is not whole: {reason}; make that part again", path.display())]
    Broken {
        /// The file.
        path: PathBuf,
        /// What is wrong.
        reason: String,
    },
    /// The trace of a run is not what it should be.
    #[error(
        "run {run} has a trace that is not whole, {}: {reason}; copy it again, or make its part again with \
         --restart",
        path.display()
    )]
    Trace {
        /// Number of the run.
        run: u64,
        /// The file.
        path: PathBuf,
        /// What is wrong.
        reason: String,
    },
    /// The file system refused.
    #[error(transparent)]
    Report(#[from] ReportError),
}

impl StudyError {
    /// Whether what was asked for is wrong, and not something on the way.
    pub fn is_wrong_input(&self) -> bool {
        !matches!(self, Self::Unmade(_) | Self::Report(_))
    }
}

/// The first of some numbers, and whether there are more.
fn listed(first: &[u64], count: u64) -> String {
    let shown: Vec<_> = first.iter().map(u64::to_string).collect();
    let more = if count > first.len() as u64 {
        ", …"
    } else {
        ""
    };
    shown.join(", ") + more
}
