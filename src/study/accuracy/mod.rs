//! Speed against error: what each method and tolerance buys on a scene, and what each fidelity level
//! costs and changes.
//!
//! Errors are distances from a reference that two different methods agree on, both as exact as the scene
//! allows; their own distance is the uncertainty of every error. Times are those of the integration by
//! itself, on one core, the shortest of some runs; of long ones with their observation.

mod levels;
mod reference;
mod rows;
mod trace;
mod trial;
mod truth;

use serde::Serialize;

use crate::bearing::Oil;
use crate::integrate::Method;
use crate::rotor::Rotor;
use crate::simulate::{Model, Monitor, SimulateError, assembled_warnings};
use reference::Reference;

pub use levels::{FidelityLevels, FidelityRow};
pub use reference::Agreement;
pub use rows::Row;
pub use trial::Cost;
pub use truth::Errors;

/// What to measure.
#[derive(Debug, Clone, PartialEq)]
pub struct Question<'a> {
    /// The scene.
    pub model: &'a Model,
    /// Oil that each bearing has, whether the scene simulates its films or not.
    pub oils: &'a [Option<Oil>],
    /// Methods to measure.
    pub methods: &'a [Method],
    /// Tolerances to measure them at, the loosest first.
    pub tolerances: &'a [f64],
    /// A run that would take longer than this is left out, s.
    pub longest: f64,
}

/// Speed against error of a scene.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[non_exhaustive]
pub struct Accuracy {
    /// How far the reference can be trusted.
    #[serde(rename = "reference")]
    pub agreement: Agreement,
    /// Methods and tolerances.
    #[serde(rename = "methods")]
    pub rows: Vec<Row>,
    /// The fidelity levels.
    pub ladder: FidelityLevels,
    /// Simulated time, s.
    #[serde(rename = "duration_s")]
    pub duration: f64,
    /// What the reader should know of the scene.
    pub warnings: Vec<String>,
}

/// Why speed cannot be measured against error.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum AccuracyError {
    /// A run failed, or was interrupted.
    #[error(transparent)]
    Simulate(#[from] SimulateError),
    /// No two methods reach the end of the scene.
    #[error(
        "no two methods reach the end of the run, so there is no reference to measure errors against: \
         {failures}"
    )]
    NoReference {
        /// What each method said.
        failures: String,
    },
}

impl Question<'_> {
    /// Measures everything, one run after the other.
    ///
    /// # Errors
    /// [`AccuracyError`] where the scene cannot be run, or no two methods can be compared on it. A single
    /// method or fidelity level that fails is reported in its row.
    pub fn measure(&self, monitor: &mut Monitor<'_>) -> Result<Accuracy, AccuracyError> {
        let stop = monitor.stop;
        let definition = &self.model.rotor;
        let rotor = Rotor::assemble(definition).map_err(SimulateError::from)?;
        let levels = levels::plan(self.model, self.oils);
        let parts = (2 + self.methods.len() + levels.len()) as f64;
        let mut done = 0.0;
        let mut advance = |by: f64| {
            done += by;
            (monitor.progress)(done / parts);
        };
        let reference = Reference::find(self, &rotor, stop)?;
        advance(2.0);
        let mut measured = Vec::new();
        for method in self.methods {
            measured.extend(rows::rows(self, *method, &reference, stop)?);
            advance(1.0);
        }
        let ladder = levels::measure(self.model.settle, levels, stop, || advance(1.0))?;
        Ok(Accuracy {
            agreement: reference.agreement,
            rows: measured,
            ladder,
            duration: self.model.duration,
            warnings: definition.warnings_with(assembled_warnings(definition, &rotor)),
        })
    }
}
