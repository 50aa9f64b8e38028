//! Speed against error: what each method and tolerance buys on a scene, and what each fidelity level
//! costs and changes.
//!
//! Errors are distances from a reference that two different methods agree on, both as exact as the scene
//! allows; their own distance is the uncertainty of every error. Times are those of the integration by
//! itself, on one core: the shortest of some runs.

mod levels;
mod reference;
mod trace;

use serde::Serialize;

use crate::analysis::Moments;
use crate::bearing::Oil;
use crate::integrate::{IntegrateError, Method};
use crate::rotor::{MotionScale, Rotor};
use crate::simulate::{Model, Monitor, SimulateError, of_speed};
use reference::{Reference, Trial};
use trace::View;

pub use levels::FidelityLevels;
pub use reference::{Agreement, Cost, Measured, Row};
pub use trace::Statistics;

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
        let scale = rotor.motion_scale(self.model.integrator.tolerance);
        let view = View::new(&rotor, &scale, self.model);
        let levels = levels::plan(self.model, self.oils);
        let parts = (2 + self.methods.len() + levels.len()) as f64;
        let mut done = 0.0;
        let mut advance = |by: f64| {
            done += by;
            (monitor.progress)(done / parts);
        };
        let reference = Reference::find(self, &rotor, &scale, view, stop)?;
        advance(2.0);
        let mut rows = Vec::new();
        for method in self.methods {
            rows.extend(reference::rows(self, *method, &reference, view, stop)?);
            advance(1.0);
        }
        let ladder = levels::measure(self.model.settle, levels, stop, || advance(1.0))?;
        Ok(Accuracy {
            agreement: reference.agreement,
            rows,
            ladder,
            duration: self.model.duration,
            warnings: definition.warnings_with(of_speed(definition, &rotor)),
        })
    }
}

/// A run, or in words why it failed; that somebody stopped it ends all.
fn unless_stopped<T>(result: Result<T, SimulateError>) -> Result<Result<T, String>, SimulateError> {
    match result {
        Err(error @ SimulateError::Integrate(IntegrateError::Interrupted { .. })) => Err(error),
        result => Ok(result.map_err(|error| error.to_string())),
    }
}

/// What errors are relative to.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Scale {
    /// Of displacements, m: the largest distance of a displacement from its mean after the settle time; tilts count by
    /// their arm.
    #[serde(rename = "motion_m")]
    pub displacement: f64,
    /// Of the bearings' force, N: likewise; moments count by their arm.
    #[serde(rename = "force_in_motion_N")]
    pub force: f64,
}

impl Scale {
    fn of(trial: &Trial, rotor: &Rotor, scale: &MotionScale) -> Self {
        let equilibrium = rotor.equilibrium();
        let [displacement, force] = trial.trace.excursion();
        let axes = rotor.freedoms().axes().iter();
        let stiffest = axes
            .map(|&axis| equilibrium.stiffness[(axis, axis)] / scale.lever(axis).powi(2))
            .fold(0.0, f64::max);
        Self {
            displacement: displacement.max(scale.least),
            force: force.max(stiffest * scale.least).max(f64::MIN_POSITIVE),
        }
    }
}

/// How far a run is from the reference.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize)]
#[non_exhaustive]
pub struct Errors {
    /// Of a displacement, m; tilts count by their arm.
    #[serde(rename = "displacement_m")]
    pub displacement: f64,
    /// The same relative to the motion.
    pub displacement_relative: f64,
    /// Of the force of the bearings on the shaft, N; moments count by their arm.
    #[serde(rename = "force_N")]
    pub force: f64,
    /// The same relative to the change of the force in motion.
    pub force_relative: f64,
    /// Largest relative difference of the amplitudes of labelled lines; `None` where there are none.
    #[serde(rename = "lines_relative")]
    pub lines: Option<f64>,
    /// Of mean, rms and peak of the displacements after the settle time, relative to the motion.
    #[serde(rename = "displacement_statistics_relative")]
    pub statistics: Statistics,
    /// Of mean, rms and peak of the forces, relative to their change in motion.
    #[serde(rename = "force_statistics_relative")]
    pub force_statistics: Statistics,
}

impl Errors {
    /// Distance of a trial from the truth, by a norm of their differences from a time on.
    fn between(
        trial: &Trial,
        truth: &Trial,
        scale: &Scale,
        norm: fn(&Moments) -> f64,
        from: f64,
    ) -> Self {
        let (largest, statistics) = trial.trace.distance(&truth.trace, norm, from);
        let ([displacement, force], [statistics, force_statistics]) = (largest, statistics);
        Self {
            displacement,
            displacement_relative: displacement / scale.displacement,
            force,
            force_relative: force / scale.force,
            lines: trial.line_error(truth),
            statistics: statistics.times(1.0 / scale.displacement),
            force_statistics: force_statistics.times(1.0 / scale.force),
        }
    }

    /// The larger of each of the statistics of two.
    fn widest(&self, other: &Self) -> Self {
        Self {
            statistics: self.statistics.larger(&other.statistics),
            force_statistics: self.force_statistics.larger(&other.force_statistics),
            ..*self
        }
    }

    /// Whether the statistics of the displacements are no farther apart than those of other exact runs.
    fn within_scatter(&self, scatter: &Self) -> bool {
        let (own, other) = (&self.statistics, &scatter.statistics);
        own.mean <= other.mean && own.rms <= other.rms && own.peak <= other.peak
    }
}
