//! The integration of a run and nothing else: what its time and its work are measured on.

use std::sync::atomic::AtomicBool;

use super::reference::reference_settings;
use super::{BLOCK, Model, SimulateError, sampling};
use crate::integrate::{Counters, Integration, Pace, States, System};
use crate::rotor::Rotor;

/// The integration of a model, assembled and ready to be run as often as one likes.
#[derive(Debug, Clone)]
pub struct BareRun<'a> {
    model: &'a Model,
    rotor: Rotor,
}

impl<'a> BareRun<'a> {
    /// Assembles the rotor of a model.
    ///
    /// # Errors
    /// [`SimulateError::Rotor`] where it cannot be assembled.
    pub fn new(model: &'a Model) -> Result<Self, SimulateError> {
        let mut rotor = Rotor::assemble(&model.rotor)?;
        if model.energy {
            rotor.account_for_energy();
        }
        Ok(Self { model, rotor })
    }

    /// The rotor.
    pub fn rotor(&self) -> &Rotor {
        &self.rotor
    }

    /// Integrates over all samples of the model by its method and forgets the states: no second pass, no
    /// observation of the bearings, no spectra. `pace` takes note of how it gets on.
    ///
    /// # Errors
    /// [`SimulateError`] as a run.
    pub fn integrate(
        &self,
        stop: &AtomicBool,
        pace: Option<&Pace>,
    ) -> Result<Counters, SimulateError> {
        let (model, rotor) = (self.model, &self.rotor);
        let scale = rotor.motion_scale(reference_settings(model).tolerance);
        let grid = sampling::grid(model, rotor)?;
        let (scaling, state) = (rotor.scaling(&scale), rotor.start());
        let mut integration =
            Integration::new(rotor, scaling, grid, model.integrator, stop, &state).watched(pace);
        let mut states = States::with_capacity(rotor.states(), BLOCK);
        while integration.done() < grid.count {
            states.clear();
            integration.advance(BLOCK, &mut states)?;
        }
        Ok(integration.counters())
    }
}
