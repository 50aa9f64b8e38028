//! How far a run is from the one that is taken for the truth.

use serde::Serialize;

use super::trace::Statistics;
use super::trial::Trial;
use crate::analysis::Moments;

/// A run that others are compared with, and how.
#[derive(Debug, Clone)]
pub(super) struct Truth {
    pub trial: Trial,
    /// What errors are relative to.
    pub scale: Scale,
    /// Norm of the differences of traces.
    pub norm: fn(&Moments) -> f64,
    /// Time from which on traces are compared, s.
    pub from: f64,
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

/// How far a run is from the truth.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize)]
#[non_exhaustive]
pub struct Errors {
    /// Of a displacement, m; tilts count by their arm.
    #[serde(rename = "displacement_m")]
    pub displacement: f64,
    /// Of a displacement, relative to the motion.
    pub displacement_relative: f64,
    /// Of the force of the bearings on the shaft, N; moments count by their arm.
    #[serde(rename = "force_N")]
    pub force: f64,
    /// Of the force, relative to its change in motion.
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

impl Truth {
    /// Distance of a trial from it.
    pub fn errors(&self, trial: &Trial) -> Errors {
        let trace = &trial.trace;
        let (largest, statistics) = trace.distance(&self.trial.trace, self.norm, self.from);
        let ([displacement, force], [statistics, force_statistics]) = (largest, statistics);
        let scale = &self.scale;
        Errors {
            displacement,
            displacement_relative: displacement / scale.displacement,
            force,
            force_relative: force / scale.force,
            lines: trial.line_error(&self.trial),
            statistics: statistics.times(1.0 / scale.displacement),
            force_statistics: force_statistics.times(1.0 / scale.force),
        }
    }
}

impl Errors {
    /// The larger of each of the statistics of two.
    pub(super) fn widest(&self, other: &Self) -> Self {
        Self {
            statistics: self.statistics.larger(&other.statistics),
            force_statistics: self.force_statistics.larger(&other.force_statistics),
            ..*self
        }
    }

    /// Whether the statistics of the displacements are no farther apart than those of other exact runs.
    pub(super) fn within_scatter(&self, scatter: &Self) -> bool {
        let (own, other) = (&self.statistics, &scatter.statistics);
        own.mean <= other.mean && own.rms <= other.rms && own.peak <= other.peak
    }
}
