//! Distances of a run from the reference, and the size of the motion that they are relative to.

use serde::Serialize;

use super::trace::{Distance, Statistics};
use super::trial::Trial;
use crate::rotor::{MotionScale, Rotor};

/// What errors are relative to.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Scale {
    /// Of displacements, m: the largest excursion from the static equilibrium, or the size of the
    /// motion that was estimated where that is larger; tilts count by their arm.
    #[serde(rename = "motion_m")]
    pub displacement: f64,
    /// Of the bearings' force, N: the largest change from that at the static equilibrium, or what the
    /// estimated motion changes it by; moments count by their arm.
    #[serde(rename = "force_in_motion_N")]
    pub force: f64,
}

impl Scale {
    pub(super) fn of(trial: &Trial, rotor: &Rotor, scale: &MotionScale) -> Self {
        let equilibrium = rotor.equilibrium();
        let rest = [
            equilibrium.displacement,
            equilibrium.force.map(|force| -force),
        ];
        let [displacement, force] = trial.trace.excursion(&rest);
        let stiffest = (0..rotor.active_freedoms())
            .map(|axis| equilibrium.stiffness[(axis, axis)] / scale.lever(axis).powi(2))
            .fold(0.0, f64::max);
        Self {
            displacement: displacement.max(scale.length),
            force: force.max(stiffest * scale.length).max(f64::MIN_POSITIVE),
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

/// Which distance of two traces counts.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Norm {
    /// The largest at any instant.
    Largest,
    /// The root mean square over time, about the mean of the difference.
    Vibration,
}

impl Errors {
    /// Distance of a trial from the truth, from a time on.
    pub(super) fn between(
        trial: &Trial,
        truth: &Trial,
        scale: &Scale,
        norm: Norm,
        from: f64,
    ) -> Self {
        let distance = trial.trace.distance(&truth.trace, from);
        Self {
            lines: trial.line_error(truth),
            ..Self::of(&distance, scale, norm)
        }
    }

    fn of(distance: &Distance, scale: &Scale, norm: Norm) -> Self {
        let [displacement, force] = match norm {
            Norm::Largest => distance.largest,
            Norm::Vibration => distance.vibration,
        };
        let [statistics, force_statistics] = distance.statistics;
        Self {
            displacement,
            displacement_relative: displacement / scale.displacement,
            force,
            force_relative: force / scale.force,
            lines: None,
            statistics: statistics.over(scale.displacement),
            force_statistics: force_statistics.over(scale.force),
        }
    }

    /// The larger of each of the statistics of two.
    pub(super) fn widest(&self, other: &Self) -> Self {
        Self {
            statistics: self.statistics.larger(&other.statistics),
            force_statistics: self.force_statistics.larger(&other.force_statistics),
            ..*self
        }
    }

    /// Whether the trace is no farther from the reference than that from the truth.
    pub(super) fn within(&self, uncertainty: &Self) -> bool {
        self.displacement <= uncertainty.displacement
    }

    /// Whether the statistics of the displacements are no farther apart than those of other exact runs.
    pub(super) fn within_scatter(&self, scatter: &Self) -> bool {
        let (own, other) = (&self.statistics, &scatter.statistics);
        own.mean <= other.mean && own.rms <= other.rms && own.peak <= other.peak
    }
}
