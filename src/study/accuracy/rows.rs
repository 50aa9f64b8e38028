//! What every method and tolerance buys: its cost, and its distance from the reference.

use std::sync::atomic::AtomicBool;

use serde::Serialize;

use super::reference::Reference;
use super::trial::{Cost, Trial, unless_stopped, with};
use super::{AccuracyError, Errors, Question};
use crate::integrate::Method;
use crate::keys;
use crate::numerics::digits::to_digits;
use crate::simulate::{Model, SimulateError};

/// How much longer the next tolerance is taken to run where only one has been: an order of three.
const FIRST_GUESS: f64 = 2.2;

/// A method at a tolerance.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[non_exhaustive]
pub struct Row {
    /// Name of the method.
    pub method: String,
    /// Tolerance asked for.
    pub tolerance: f64,
    /// What was measured, or why nothing was.
    #[serde(flatten, serialize_with = "keys::or_note")]
    pub result: Result<Measured, String>,
}

/// What was measured of a method at a tolerance.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Measured {
    /// What the integration costs.
    pub cost: Cost,
    /// Largest distance from the reference.
    #[serde(rename = "error")]
    pub errors: Errors,
    /// Whether the error is not above the uncertainty of the reference; in an irregular motion, whether
    /// the statistics are within the scatter of exact runs.
    pub within_uncertainty: bool,
}

/// The rows of one method; tolerances that would take too long are left out.
pub(super) fn rows(
    question: &Question<'_>,
    method: Method,
    reference: &Reference,
    stop: &AtomicBool,
) -> Result<Vec<Row>, AccuracyError> {
    let mut rows = Vec::new();
    let mut before: Option<f64> = None;
    let mut expected = 0.0;
    for &tolerance in question.tolerances {
        let result = if expected > question.longest {
            Err(format!(
                "left out: would take about {} s, more than {} s",
                to_digits(expected, 2),
                question.longest
            ))
        } else {
            let model = with(question.model, method, tolerance);
            unless_stopped(measured(&model, reference, stop))?
        };
        if let Ok(measured) = &result {
            let seconds = measured.cost.seconds;
            let factor = before.map_or(FIRST_GUESS, |before| (seconds / before).clamp(1.2, 10.0));
            expected = factor * seconds;
            before = Some(seconds);
        }
        rows.push(Row {
            method: method.to_string(),
            tolerance,
            result,
        });
    }
    Ok(rows)
}

fn measured(
    model: &Model,
    reference: &Reference,
    stop: &AtomicBool,
) -> Result<Measured, SimulateError> {
    let trial = Trial::run(model, stop)?;
    let agreement = &reference.agreement;
    let errors = reference.truth.errors(&trial);
    Ok(Measured {
        cost: trial.cost(model, stop)?,
        errors,
        within_uncertainty: if agreement.irregular {
            errors.within_scatter(&agreement.scatter)
        } else {
            errors.displacement <= agreement.uncertainty.displacement
        },
    })
}
