//! Speed against error: what each method and tolerance buys on a scene, and what each rung of the
//! physics costs and changes.
//!
//! Errors are distances from a reference that two different methods agree on, both as exact as the scene
//! allows; their own distance is the uncertainty of every error. Times are those of the integration by
//! itself, on one core: the shortest of some runs.

mod error;
mod grid;
mod ladder;
mod reference;
mod trace;
mod trial;

use std::sync::atomic::AtomicBool;

use serde::Serialize;

pub use error::Errors;
pub use grid::{Measured, Row};
pub use ladder::{Configuration, Ladder, LadderRow};
pub use reference::Agreement;
pub use trace::Statistics;
pub use trial::Cost;

use self::reference::Reference;
use self::trace::View;
use crate::bearing::Oil;
use crate::integrate::{IntegrateError, Method};
use crate::rotor::Rotor;
use crate::simulate::{Model, Sampling, SimulateError};

/// A method and the name that scenarios call it by.
#[derive(Debug, Clone, PartialEq, Eq)]
#[non_exhaustive]
pub struct NamedMethod {
    /// Its name.
    pub name: String,
    /// The method.
    pub(crate) method: Method,
}

/// What to measure.
#[derive(Debug, Clone, PartialEq)]
pub struct Question<'a> {
    /// The scene.
    pub model: &'a Model,
    /// Oil that each bearing has, whether the scene simulates its films or not.
    pub oils: &'a [Option<Oil>],
    /// All methods there are, to name them.
    pub known: &'a [NamedMethod],
    /// Methods to measure.
    pub methods: &'a [NamedMethod],
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
    /// The physics.
    pub ladder: Ladder,
    /// Simulated time, s.
    #[serde(rename = "duration_s")]
    pub duration: f64,
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

/// How the measurement is watched and stopped from outside.
pub struct Watch<'a> {
    /// Set to end it.
    pub stop: &'a AtomicBool,
    /// Called with the part that is done, 0 … 1.
    pub progress: &'a mut dyn FnMut(f64),
}

impl Question<'_> {
    /// Measures everything, one run after the other.
    ///
    /// # Errors
    /// [`AccuracyError`] where the scene cannot be run, or no two methods can be compared on it. A single
    /// method or rung that fails is told of in its row.
    pub fn measure(&self, watch: &mut Watch<'_>) -> Result<Accuracy, AccuracyError> {
        let rotor = Rotor::assemble(&self.model.rotor).map_err(SimulateError::from)?;
        let scale = rotor.motion_scale(self.model.integrator.tolerance);
        let view = View::new(
            &rotor,
            &scale,
            self.model.settle,
            samples(self.model, &rotor),
        );
        let climbs = ladder::plan(self.model, self.oils);
        let parts = (2 + self.methods.len() + climbs.len()) as f64;
        let mut done = 0.0;
        let mut advance = |watch: &mut Watch<'_>, by: f64| {
            done += by;
            (watch.progress)(done / parts);
        };
        let reference = Reference::find(
            self.model,
            &rotor,
            &scale,
            view,
            self.known,
            self.longest,
            watch.stop,
        )?;
        advance(watch, 2.0);
        let mut rows = Vec::new();
        for method in self.methods {
            rows.extend(grid::rows(self, method, &reference, view, watch.stop)?);
            advance(watch, 1.0);
        }
        let stop = watch.stop;
        let ladder = ladder::measure(self.model.settle, climbs, stop, || advance(watch, 1.0))?;
        Ok(Accuracy {
            agreement: reference.agreement,
            rows,
            ladder,
            duration: self.model.duration,
        })
    }
}

/// Number of samples of a run, about.
fn samples(model: &Model, rotor: &Rotor) -> f64 {
    let rate = match model.sampling {
        Sampling::Rate(rate) => rate,
        Sampling::PerRevolution(samples) => {
            f64::from(samples) * rotor.highest_speed() / std::f64::consts::TAU
        }
    };
    rate * model.duration
}

/// Whether somebody asked the run to stop.
fn is_interrupted(error: &SimulateError) -> bool {
    matches!(
        error,
        SimulateError::Integrate(IntegrateError::Interrupted { .. })
    )
}
