//! The motion that a shaft settles to.

use std::sync::atomic::{AtomicBool, AtomicU64};

use super::{AskError, Sensitivity, motion};
use crate::fit::Question;
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
    /// By what the answer is differentiated.
    pub sensitivity: Option<Sensitivity>,
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
            sensitivity: None,
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
        let mut findings = steady_findings(self.scenario, self.model, &found);
        if let Some(asked) = &self.sensitivity {
            // of the motion that was found, also where its period is a multiple
            let question = |_, model: Option<Model>| {
                let model = model.unwrap_or_else(|| self.model.clone());
                Question::Steady(model, Some(found.multiple))
            };
            findings.add_sensitivity(&asked.answer(question, stop)?);
        }
        Ok(findings)
    }
}
