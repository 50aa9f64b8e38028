//! The second pass, which measures the error of the first.

use serde::{Deserialize, Serialize};

use super::{MeasuredError, Model};
use crate::integrate::{
    Checkpoint, CheckpointMismatch, IntegrateError, Integration, Settings, States,
};
use crate::rotor::{MotionScale, Rotor};

/// Factor between the tolerances of the two passes.
const REFERENCE_FACTOR: f64 = 0.1;
/// Below this tolerance the second pass is the looser one: round-off allows none that is tighter.
const TIGHTEST_WITH_REFERENCE: f64 = 1e-12;

/// Settings of the second pass: another tolerance.
pub(super) fn reference_settings(model: &Model) -> Settings {
    let tolerance = model.integrator.tolerance;
    let factor = if tolerance >= TIGHTEST_WITH_REFERENCE {
        REFERENCE_FACTOR
    } else {
        1.0 / REFERENCE_FACTOR
    };
    Settings {
        tolerance: tolerance * factor,
        ..model.integrator
    }
}

/// Where the second pass stands, and how far the first has been from it.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct ReferenceStanding {
    /// The integration.
    pub pass: Checkpoint,
    /// Largest difference of a displacement so far, m.
    pub difference: f64,
    /// Largest distance from the static equilibrium so far, m.
    pub excursion: f64,
    /// Why the pass cannot go on, where it cannot.
    pub failure: Option<String>,
}

/// The second pass, and how far the first is from it.
pub(super) struct Reference<'a> {
    integration: Integration<'a>,
    states: States,
    difference: f64,
    excursion: f64,
    failure: Option<String>,
}

impl<'a> Reference<'a> {
    pub fn new(integration: Integration<'a>, states: usize) -> Self {
        Self {
            integration,
            states: States::new(states),
            difference: 0.0,
            excursion: 0.0,
            failure: None,
        }
    }

    /// What it takes to go on from here another time.
    pub fn standing(&self) -> ReferenceStanding {
        ReferenceStanding {
            pass: self.integration.checkpoint().clone(),
            difference: self.difference,
            excursion: self.excursion,
            failure: self.failure.clone(),
        }
    }

    /// Goes on from where another second pass of the same run stood.
    pub fn go_on_from(&mut self, standing: &ReferenceStanding) -> Result<(), CheckpointMismatch> {
        self.integration.go_on_from(&standing.pass)?;
        self.difference = standing.difference;
        self.excursion = standing.excursion;
        self.failure.clone_from(&standing.failure);
        Ok(())
    }

    /// Why the pass cannot go on, where it cannot.
    pub fn failure(&self) -> Option<&str> {
        self.failure.as_deref()
    }

    /// Goes on over as many samples as `states` has and compares displacements. A pass that cannot
    /// go on leaves the error of the run unknown.
    ///
    /// # Errors
    /// [`IntegrateError::Interrupted`] where somebody asked the run to stop.
    pub fn compare(
        &mut self,
        states: &States,
        rotor: &Rotor,
        scale: &MotionScale,
    ) -> Result<(), IntegrateError> {
        if self.failure.is_some() {
            return Ok(());
        }
        self.states.clear();
        match self.integration.advance(states.len(), &mut self.states) {
            Err(interrupted @ IntegrateError::Interrupted { .. }) => return Err(interrupted),
            result => self.failure = result.err().map(|error| error.to_string()),
        }
        let place = &rotor.equilibrium().displacement;
        for (state, reference) in states.iter().zip(self.states.iter()) {
            for axis in 0..rotor.active_freedoms() {
                let lever = scale.lever(axis);
                self.difference = self
                    .difference
                    .max(lever * (state[axis] - reference[axis]).abs());
                self.excursion = self
                    .excursion
                    .max(lever * (reference[axis] - place[axis]).abs());
            }
            for freedom in rotor.housing_freedoms() {
                let apart = (state[freedom] - reference[freedom]).abs();
                self.difference = self.difference.max(apart);
            }
        }
        Ok(())
    }

    pub fn measured(
        &self,
        model: &Model,
        rotor: &Rotor,
        scale: &MotionScale,
    ) -> Option<MeasuredError> {
        let displacement = self.difference + rotor.displacement_round_off();
        self.failure.is_none().then(|| MeasuredError {
            displacement,
            relative: displacement / self.excursion.max(scale.length),
            reference_tolerance: reference_settings(model).tolerance,
            counters: self.integration.counters(),
        })
    }
}
