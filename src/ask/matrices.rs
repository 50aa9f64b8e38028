//! The matrices of the linearised shaft.

use super::AskError;
use super::linear_response::check_on_shaft;
use crate::report::{Findings, matrices_findings};
use crate::rotor::{Rotor, RotorDefinition};
use crate::scenario::Scenario;
use crate::simulate::speed_warnings;

/// Mass, damping, gyroscopic coupling, stiffness and the state matrix about the static equilibrium.
#[derive(Debug, Clone)]
pub struct MatricesQuestion<'a> {
    scenario: &'a Scenario,
    rotor: RotorDefinition,
}

impl<'a> MatricesQuestion<'a> {
    /// Asks at a speed in rad/s, or at that of the start of the scenario, with coordinates at some positions in m along a shaft
    /// that bends besides those that it has anyway.
    ///
    /// # Errors
    /// [`AskError::Asked`] where a position is off the shaft.
    pub fn new(scenario: &'a Scenario, at: &[f64], speed: Option<f64>) -> Result<Self, AskError> {
        let rotor = &scenario.question.rotor;
        let mut rotor = rotor.at_constant_speed(speed.unwrap_or(rotor.speed));
        for position in at {
            check_on_shaft(*position, scenario)?;
        }
        rotor.points.extend(at);
        Ok(Self { scenario, rotor })
    }

    /// The matrices.
    ///
    /// # Errors
    /// [`AskError::Failed`] where the shaft has no equilibrium at the speed.
    pub fn answer(&self) -> Result<Findings, AskError> {
        let rotor = Rotor::assemble(&self.rotor).map_err(AskError::failed)?;
        let warnings = self.rotor.warnings_with(speed_warnings(&self.rotor));
        let found = rotor.linear_matrices();
        Ok(matrices_findings(self.scenario, &found, warnings))
    }
}
