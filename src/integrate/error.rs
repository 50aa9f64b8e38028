//! Why an integration ends early.

use super::Stiffness;

/// Why an integration cannot go on; the samples up to `time` have been handed out.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum IntegrateError {
    /// The limit on the number of steps is reached.
    #[error(
        "{limit} steps are used up at t = {time:.6e} s; raise integrator.step_limit, loosen the \
         tolerance or shorten the duration"
    )]
    StepLimit {
        /// Time that the integration has come to, s.
        time: f64,
        /// The limit.
        limit: u64,
    },
    /// The step became too small to move time.
    #[error(
        "a step of {step:.1e} s is too small to move time at t = {time:.6e} s, and its error is still \
         above the tolerance: a force jumps there, or grows without bound; look at loads, clearances \
         and damping at that time, loosen the tolerance, or set another method in [integrator]"
    )]
    StepUnderflow {
        /// Time that the integration has come to, s.
        time: f64,
        /// Size of the step, s.
        step: f64,
    },
    /// Stability holds the steps of an explicit method so short that the run would not end within
    /// its limit on steps.
    #[error(
        "the problem is stiff: at t = {:.6e} s stability holds the step at {:.1e} s (largest \
         eigenvalue {:.1e} 1/s), and the run needs about {needed:.1e} steps of the {limit} that \
         integrator.step_limit allows; set method = \"rodas\" in [integrator], which may take longer ones",
        stiffness.time, stiffness.step, stiffness.eigenvalue
    )]
    Stiff {
        /// Where and how.
        stiffness: Stiffness,
        /// Steps that the whole run needs, as it goes on there.
        needed: f64,
        /// The limit.
        limit: u64,
    },
    /// The derivative is not a number.
    #[error(
        "the motion is not finite after t = {time:.6e} s: it grows without bound; check damping, \
         clearances and loads"
    )]
    NotFinite {
        /// Time of the evaluation that failed, s.
        time: f64,
    },
    /// Somebody asked the integration to stop.
    #[error("interrupted at t = {time:.6e} s")]
    Interrupted {
        /// Time that the integration has come to, s.
        time: f64,
    },
}

impl IntegrateError {
    /// Time that the integration has come to, s.
    pub fn time(&self) -> f64 {
        match self {
            Self::Stiff { stiffness, .. } => stiffness.time,
            Self::StepLimit { time, .. }
            | Self::StepUnderflow { time, .. }
            | Self::NotFinite { time }
            | Self::Interrupted { time } => *time,
        }
    }
}
