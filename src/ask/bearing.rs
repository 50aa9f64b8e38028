//! Where the shaft rests.

use super::AskError;
use crate::quasi_static::quasi_static;
use crate::report::{Findings, answer_findings};
use crate::scenario::Scenario;

/// Where the shaft rests.
#[derive(Debug, Clone)]
pub struct BearingQuestion<'a> {
    scenario: &'a Scenario,
    /// Angles that shaft and cages have turned by, rad.
    turned: Option<(f64, Option<f64>)>,
}

impl<'a> BearingQuestion<'a> {
    /// Asks about a shaft, with shaft and cages turned by angles in rad; cages are where they roll to with the shaft,
    /// unless their angle is given.
    pub fn new(scenario: &'a Scenario, shaft: Option<f64>, cage: Option<f64>) -> Self {
        let is_turned = shaft.or(cage).is_some();
        let turned = is_turned.then(|| (shaft.unwrap_or(0.0), cage));
        Self { scenario, turned }
    }

    /// Equilibrium, stiffness and every ball.
    ///
    /// # Errors
    /// [`AskError::Failed`] where there is no equilibrium.
    pub fn answer(&self) -> Result<Findings, AskError> {
        let mut question = self.scenario.question.clone();
        if let Some((shaft, cage)) = self.turned {
            question.turn(shaft, cage);
        }
        let found = quasi_static(&question).map_err(AskError::failed)?;
        Ok(answer_findings(self.scenario, &question, &found))
    }
}
