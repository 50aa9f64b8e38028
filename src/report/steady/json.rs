//! Steady motions as JSON.

use serde::Serialize;
use serde_json::Value;

use super::super::Destination;
use crate::simulate::Model;
use crate::steady::{Measured, Response, Steady};
use crate::study::Variable;

/// A steady motion, whether it is stable, and its error.
#[derive(Serialize)]
struct SteadySummary<'a> {
    #[serde(flatten)]
    steady: &'a Steady,
    stable: bool,
    lines: usize,
    measured_error: Option<ErrorSummary>,
}

/// The measured error beside what was asked for.
#[derive(Serialize)]
struct ErrorSummary {
    #[serde(flatten)]
    error: Measured,
    tolerance: f64,
}

/// The branches of a response: their ends and where they turn.
#[derive(Serialize)]
struct ResponseSummary<'a> {
    over: &'a str,
    unit: &'a str,
    branches: &'a [Response],
}

/// Everything about a steady motion except its trace and its spectrum. The same question gives the same
/// bytes.
pub fn steady_json(destination: &Destination<'_>, model: &Model, steady: &Steady) -> Value {
    let measured = |error| ErrorSummary {
        error,
        tolerance: model.integrator.tolerance,
    };
    let summary = SteadySummary {
        steady,
        stable: steady.is_stable(),
        lines: steady.lines.lines.len(),
        measured_error: steady.measured.map(measured),
    };
    destination.document(summary)
}

/// The branches of a response; the motions stand in `response.csv`.
pub fn response_json(
    destination: &Destination<'_>,
    variable: &Variable,
    branches: &[Response],
) -> Value {
    let summary = ResponseSummary {
        over: &variable.key,
        unit: variable.unit,
        branches,
    };
    destination.document(summary)
}
