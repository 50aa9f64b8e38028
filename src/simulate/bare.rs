//! The integration of a run and nothing else: what its time and its work are measured on.

use std::sync::atomic::AtomicBool;

use super::reference::reference_settings;
use super::{BLOCK, Model, SimulateError, sampling};
use crate::integrate::{Counters, Integration, States, System};
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
    /// observation of the bearings, no spectra.
    ///
    /// # Errors
    /// [`SimulateError`] as a run.
    pub fn integrate(&self, stop: &AtomicBool) -> Result<Counters, SimulateError> {
        let [_, whole] = self.integrate_in_parts(1.0, stop)?;
        Ok(whole)
    }

    /// As [`BareRun::integrate`]; the work over the first `part` of the samples, and over all.
    ///
    /// # Errors
    /// [`SimulateError`] as a run.
    pub fn integrate_in_parts(
        &self,
        part: f64,
        stop: &AtomicBool,
    ) -> Result<[Counters; 2], SimulateError> {
        let rotor = &self.rotor;
        let model = self.model;
        let scale = self.rotor.motion_scale(reference_settings(model).tolerance);
        let grid = sampling::grid(model, &self.rotor)?;
        let (scaling, state) = (rotor.scaling(&scale), rotor.start());
        let mut integration =
            Integration::new(rotor, scaling, grid, model.integrator, stop, &state);
        let mut states = States::with_capacity(rotor.states(), BLOCK);
        let mut up_to = |end: u64| {
            while integration.done() < end {
                states.clear();
                let left = usize::try_from(end - integration.done()).unwrap_or(BLOCK);
                integration.advance(BLOCK.min(left), &mut states)?;
            }
            Ok::<_, SimulateError>(integration.counters())
        };
        Ok([
            up_to((part * grid.count as f64) as u64)?,
            up_to(grid.count)?,
        ])
    }
}
