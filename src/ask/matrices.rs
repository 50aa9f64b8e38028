//! The matrices of the linearised shaft.

use super::linear_response::check;
use super::{AskError, Place};
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
    /// Asks at a speed in rad/s, or at that of the start of the scenario, with coordinates for some places of a shaft that
    /// bends besides those that it has anyway.
    ///
    /// # Errors
    /// [`AskError::Asked`] where a place is off the shaft.
    pub fn new(scenario: &'a Scenario, at: &[Place], speed: Option<f64>) -> Result<Self, AskError> {
        let rotor = &scenario.question.rotor;
        let mut rotor = rotor.at_constant_speed(speed.unwrap_or(rotor.speed));
        for pickup in at.iter().flat_map(|place| &place.0) {
            check(pickup, scenario)?;
            rotor.points.push(pickup.position);
        }
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
