//! The choice of a method for a run that names none.
//!
//! One rule, asked once: where the motion is expected to cross event surfaces, as the lift-off of a ball from a race
//! ([`System::expects_crossings`](super::System::expects_crossings)), the explicit pair `verner76`, whose steps end on
//! them, takes the run; elsewhere the exponential method. And one way back: a run of the exponential method that
//! crosses them again and again goes on with `verner76`, and so does one in which that method can take no step.

use serde::{Deserialize, Serialize};

use super::{IntegrateError, Method, System};

/// Steps of the exponential method that are looked back over, and how many of them that crossed a surface are
/// "again and again".
const LOOKED_BACK: u32 = u64::BITS;
const AGAIN_AND_AGAIN: u32 = LOOKED_BACK / 4;

/// Which method carried a run under [`Method::Auto`], and why.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct MethodUse {
    /// The method of the first step.
    pub first: Method,
    /// Why `verner76` went on from the exponential method, and when, s.
    pub change: Option<(ChangeReason, f64)>,
}

/// Why a run went over from the exponential method to `verner76`.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
pub enum ChangeReason {
    /// The motion crossed surfaces at which the derivative is not smooth again and again.
    Crossings,
    /// The exponential method could take no further step.
    NoStep,
}

impl MethodUse {
    /// The method of the latest step.
    pub fn latest(&self) -> Method {
        match self.change {
            None => self.first,
            Some(_) => Method::Verner76,
        }
    }

    /// By the rule, before the first step.
    pub(super) fn of(system: &dyn System) -> Self {
        let first = if system.expects_crossings() {
            Method::Verner76
        } else {
            Method::Exponential
        };
        Self {
            first,
            change: None,
        }
    }
}

/// The rule applied to a run under way.
#[derive(Debug, Clone, Copy)]
pub(super) struct Choice {
    pub method_use: MethodUse,
    /// The latest steps of the exponential method, a bit for each, set where a step crossed a surface.
    crossings: u64,
}

impl Choice {
    /// Of a run that goes on with what was chosen.
    pub fn new(method_use: MethodUse) -> Self {
        Self {
            method_use,
            crossings: 0,
        }
    }

    /// Whether the exponential method carries the run, which another one may still take over.
    pub fn is_open(&self) -> bool {
        self.method_use.latest() == Method::Exponential
    }

    /// Takes note of how a step of the exponential method ended at a time, s, and whether it crossed an event surface;
    /// whether the explicit pair is to go on from there.
    ///
    /// # Errors
    /// Why the run ends there.
    pub fn is_over(
        &mut self,
        ending: Result<(), IntegrateError>,
        time: f64,
        crossed: bool,
    ) -> Result<bool, IntegrateError> {
        let reason = match ending {
            Err(IntegrateError::StepUnderflow { .. } | IntegrateError::NotFinite { .. }) => {
                ChangeReason::NoStep
            }
            Err(error) => return Err(error),
            Ok(()) => {
                self.crossings = self.crossings << 1 | u64::from(crossed);
                if self.crossings.count_ones() < AGAIN_AND_AGAIN {
                    return Ok(false);
                }
                ChangeReason::Crossings
            }
        };
        self.method_use.change = Some((reason, time));
        Ok(true)
    }
}
