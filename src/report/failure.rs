//! What is kept of a run that cannot go on, under names that do not look whole.

use serde_json::{Value, json};

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

/// The failure as JSON, every number with its unit in its name.
///
/// `trace` names what keeps the trace up to the failure, `earlier` are the files of an earlier run that
/// stand in the same folder.
pub(super) fn failure_json(
    title: &str,
    scenario: &Value,
    failure: &Failure<'_>,
    samples: u64,
    trace: &[String],
    earlier: &[String],
) -> Value {
    json!({
        "jeffcott": env!("CARGO_PKG_VERSION"),
        "title": title,
        "scenario": scenario,
        "error": failure.error.to_string(),
        "kind": kind(failure.error),
        "time_s": failure.error.time(),
        "samples": samples,
        "counters": failure.counters,
        "trace": trace.first(),
        "of_an_earlier_run": earlier,
    })
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
        others: &[
            "trace.until-failure.csv",
            "trace.until-failure.parquet",
            "trace.until-failure.mat",
        ],
        spent: &[],
    };
}
