//! What is kept of a run that cannot go on, under names that do not look whole.

use serde::Serialize;

use super::FileSet;
use crate::integrate::{Counters, IntegrateError};
use crate::scenario::TableFormat;

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
