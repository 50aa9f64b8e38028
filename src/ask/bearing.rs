//! Where the shaft rests.

use std::sync::atomic::AtomicBool;

use super::{AskError, Sensitivity};
use crate::fit::Question;
use crate::quasi_static::{StaticQuestion, quasi_static};
use crate::report::{Findings, answer_findings};
use crate::scenario::Scenario;

/// Where the shaft rests.
#[derive(Debug, Clone)]
pub struct BearingQuestion<'a> {
    scenario: &'a Scenario,
    /// Angles that shaft and cages have turned by, rad.
    turned: Option<(f64, Option<f64>)>,
    /// By what the answer is differentiated.
    pub sensitivity: Option<Sensitivity>,
}

impl<'a> BearingQuestion<'a> {
    /// Asks about a shaft, with shaft and cages turned by angles in rad; cages are where they roll to with the shaft,
    /// unless their angle is given.
    pub fn new(scenario: &'a Scenario, shaft: Option<f64>, cage: Option<f64>) -> Self {
        let is_turned = shaft.or(cage).is_some();
        let turned = is_turned.then(|| (shaft.unwrap_or(0.0), cage));
        Self {
            scenario,
            turned,
            sensitivity: None,
        }
    }

    /// Equilibrium, stiffness and every rolling element.
    ///
    /// # Errors
    /// [`AskError::Failed`] where there is no equilibrium.
    pub fn answer(&self) -> Result<Findings, AskError> {
        let turned = |mut question: StaticQuestion| {
            if let Some((shaft, cage)) = self.turned {
                question.turn(shaft, cage);
            }
            question
        };
        let question = turned(self.scenario.question.clone());
        let found = quasi_static(&question).map_err(AskError::failed)?;
        let mut findings = answer_findings(self.scenario, &question, &found);
        if let Some(asked) = &self.sensitivity {
            let question = |question, _| Question::Bearing(turned(question));
            findings.add_sensitivity(&asked.answer(question, &AtomicBool::new(false))?);
        }
        Ok(findings)
    }
}
