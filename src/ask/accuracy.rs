//! Speed against error.

use super::{AskError, motion};
use crate::integrate::Method;
use crate::report::{Findings, accuracy_findings};
use crate::scenario::{self, Scenario};
use crate::simulate::{Model, Monitor};
use crate::study::accuracy::Question;

/// Tolerances where none are given.
const TOLERANCES: [f64; 4] = [1e-4, 1e-6, 1e-8, 1e-10];

/// Speed against error of methods at tolerances, and what the levels of the physics cost and change.
#[derive(Debug, Clone)]
pub struct AccuracyQuestion<'a> {
    scenario: &'a Scenario,
    model: &'a Model,
    methods: Vec<Method>,
    tolerances: Vec<f64>,
    longest: f64,
}

impl<'a> AccuracyQuestion<'a> {
    /// Asks about a scenario; all methods and 1e-4, 1e-6, 1e-8 and 1e-10 where none are given. What would run longer than
    /// `longest`, s, is left out.
    ///
    /// # Errors
    /// [`AskError::Asked`] where nothing moves.
    pub fn new(
        scenario: &'a Scenario,
        methods: &[Method],
        tolerances: &[f64],
        longest: f64,
    ) -> Result<Self, AskError> {
        let mut tolerances = match tolerances {
            [] => TOLERANCES.to_vec(),
            given => given.to_vec(),
        };
        // the loosest first
        tolerances.sort_by(|a, b| b.total_cmp(a));
        tolerances.dedup();
        Ok(Self {
            scenario,
            model: motion(scenario)?,
            methods: match methods {
                [] => scenario::methods().to_vec(),
                given => given.to_vec(),
            },
            tolerances,
            longest,
        })
    }

    /// Measures everything, one run after the other.
    ///
    /// # Errors
    /// [`AskError::Failed`] where the scene cannot be run or has no reference.
    pub fn answer(&self, monitor: &mut Monitor<'_>) -> Result<Findings, AskError> {
        let question = Question {
            model: self.model,
            oils: &self.scenario.oils,
            methods: &self.methods,
            tolerances: &self.tolerances,
            longest: self.longest,
        };
        let found = question.measure(monitor).map_err(AskError::failed)?;
        Ok(accuracy_findings(self.scenario, &found))
    }
}
