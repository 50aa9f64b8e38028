//! Who takes the samples, who watches the run, and how it can fail.

use std::sync::atomic::AtomicBool;

use super::{BeyondContact, Event};
use crate::integrate::IntegrateError;
use crate::rotor::{BallContacts, RotorError, Sample, UnconstrainedError};

/// Takes the samples of a run one by one, in the order of time.
pub trait TraceSink {
    /// Time from which on it needs the samples, s; those before may be left out.
    fn starts_at(&self) -> f64 {
        0.0
    }

    /// Whether the samples must come with accelerations, which cost an evaluation of the equations of motion each.
    fn needs_acceleration(&self) -> bool {
        false
    }

    /// Whether the balls must come with their contact angles, which cost two arctangents a ball; zero where nobody
    /// needs them.
    fn needs_contact_angles(&self) -> bool {
        false
    }

    /// Takes one sample.
    ///
    /// # Errors
    /// Whatever keeps the sink from taking it; the run ends there.
    fn sample(&mut self, sample: &Sample) -> std::io::Result<()>;

    /// Takes the balls of all bearings at the sample that it has just taken; ignores them by
    /// default.
    ///
    /// # Errors
    /// As [`TraceSink::sample`].
    fn balls(&mut self, _sample: &Sample, _balls: &BallContacts) -> std::io::Result<()> {
        Ok(())
    }

    /// Takes an event between the sample before and the one that it has just taken, in the order
    /// of time; ignores it by default.
    ///
    /// # Errors
    /// As [`TraceSink::sample`].
    fn event(&mut self, _event: &Event) -> std::io::Result<()> {
        Ok(())
    }
}

/// How a run is watched and stopped from outside.
pub struct Monitor<'a> {
    /// Set to end the run at its next step.
    pub stop: &'a AtomicBool,
    /// Called now and then with the part of the run that is done, 0 … 1.
    pub progress: &'a mut dyn FnMut(f64),
}

/// Why a run failed.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum SimulateError {
    /// The rotor cannot be assembled.
    #[error(transparent)]
    Rotor(#[from] RotorError),
    /// Nothing holds the shaft in a freedom, and the scene rests on what does.
    #[error(transparent)]
    Unconstrained(#[from] UnconstrainedError),
    /// The integration cannot go on.
    #[error(transparent)]
    Integrate(#[from] IntegrateError),
    /// A ball is pressed into its races by more than its radius.
    #[error(transparent)]
    BeyondContact(#[from] BeyondContact),
    /// The sink refused a sample.
    #[error("the trace cannot be written: {0}")]
    Sink(#[from] std::io::Error),
    /// No uniform grid of angle exists for a shaft that does not turn.
    #[error("the shaft does not turn: give samples per second instead of samples per revolution")]
    NoRevolution,
}
