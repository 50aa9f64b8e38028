//! The motion that a shaft settles to.

use std::sync::atomic::{AtomicBool, AtomicU64};

use super::{AskError, motion};
use crate::report::{Findings, steady_findings};
use crate::scenario::Scenario;
use crate::simulate::Model;
use crate::steady;

/// The motion that a shaft settles to.
#[derive(Debug, Clone)]
pub struct SteadyQuestion<'a> {
    scenario: &'a Scenario,
    model: &'a Model,
    /// Periods of the forcing that the motion takes; one, or those of a stable motion beside it, where it is left out.
    multiple: Option<u32>,
}

impl<'a> SteadyQuestion<'a> {
    /// Asks about the motion of a scenario.
    ///
    /// # Errors
    /// [`AskError::Asked`] where nothing moves.
    pub fn new(scenario: &'a Scenario, multiple: Option<u32>) -> Result<Self, AskError> {
        Ok(Self {
            scenario,
            model: motion(scenario)?,
            multiple,
        })
    }

    /// Searches until it is found or `stop` is set, counting the periods that it integrates.
    ///
    /// # Errors
    /// [`AskError::Failed`] where no motion is found.
    pub fn answer(&self, stop: &AtomicBool, integrated: &AtomicU64) -> Result<Findings, AskError> {
        let question = steady::SteadyQuestion {
            model: self.model,
            multiple: self.multiple,
            stop,
            integrated,
        };
        let found = steady::steady(&question).map_err(AskError::failed)?;
        Ok(steady_findings(self.scenario, self.model, &found))
    }
}
