//! The integration of a model and nothing else.

use std::sync::atomic::AtomicBool;

use super::passes::{corrected_by, motion_scale, pass};
use super::{BLOCK, Model, SimulateError, sampling};
use crate::integrate::{Counters, States, System};
use crate::rotor::Rotor;

/// The integration of a model and nothing else, ready to be run as often as one likes: what time and work are
/// measured on.
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
    /// observation of the bearings, no spectra.
    ///
    /// # Errors
    /// [`SimulateError`] as a run.
    pub fn integrate(&self, stop: &AtomicBool) -> Result<Counters, SimulateError> {
        let (model, rotor) = (self.model, &self.rotor);
        let grid = sampling::grid(model, rotor)?;
        let scale = motion_scale(model, rotor);
        let begun = |scale| pass(rotor, scale, grid, model.integrator, (stop, None));
        let mut integration = begun(&scale);
        let mut states = States::with_capacity(rotor.states(), BLOCK);
        integration.advance(BLOCK, &mut states)?;
        if let Some(scale) = corrected_by(rotor, &scale, grid, &states) {
            integration = begun(&scale);
        }
        while integration.done() < grid.count {
            states.clear();
            integration.advance(BLOCK, &mut states)?;
        }
        Ok(integration.counters())
    }
}
