//! Why an integration ends early.

/// Why an integration cannot go on; the samples up to `time` have been handed out.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum IntegrateError {
    /// The limit on the number of steps is reached.
    #[error(
        "{limit} steps are used up at t = {time:.6e} s; raise integrator.step_limit, loosen the \
         tolerance or shorten the duration"
    )]
    StepLimit {
        /// Where the integration stands, s.
        time: f64,
        /// The limit.
        limit: u64,
    },
    /// The step became smaller than the resolution of time.
    #[error(
        "the step size fell below round-off at t = {time:.6e} s; loosen the tolerance, or look for \
         a jump in the forces there"
    )]
    StepUnderflow {
        /// Where the integration stands, s.
        time: f64,
    },
    /// An explicit method is limited by stability, not by accuracy.
    #[error(
        "the problem is stiff at t = {time:.6e} s: an explicit method needs steps far below what \
         the accuracy asks for; set integrator.method = \"rodas\", or lower the damping or the \
         stiffness that causes it"
    )]
    Stiff {
        /// Where stiffness was detected, s.
        time: f64,
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
        /// Where the integration stands, s.
        time: f64,
    },
}
