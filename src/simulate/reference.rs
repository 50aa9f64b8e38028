//! The second pass, which measures the error of the first.

use nalgebra::Const;

use super::{MeasuredError, Model};
use crate::integrate::{Integration, Settings, Square};
use crate::rotor::{MotionScale, Moving};

/// Factor between the tolerances of the two passes.
const REFERENCE_FACTOR: f64 = 0.1;
/// Below this tolerance the second pass is the looser one: round-off allows none that is tighter.
const TIGHTEST_WITH_REFERENCE: f64 = 1e-12;

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

/// The second pass, and how far the first is from it.
pub(super) struct Reference<'a, S, const N: usize, const M: usize> {
    integration: Integration<'a, S, N, M>,
    states: Vec<[f64; N]>,
    difference: f64,
    excursion: f64,
    failed: bool,
}

impl<'a, S, const N: usize, const M: usize> Reference<'a, S, N, M>
where
    S: Moving<N>,
    Const<N>: Square,
{
    pub fn new(integration: Integration<'a, S, N, M>) -> Self {
        Self {
            integration,
            states: Vec::new(),
            difference: 0.0,
            excursion: 0.0,
            failed: false,
        }
    }

    /// Goes on over as many samples as `states` has and compares displacements.
    pub fn compare(&mut self, states: &[[f64; N]], system: &S, scale: &MotionScale) {
        if self.failed {
            return;
        }
        self.states.clear();
        self.failed = self
            .integration
            .advance(states.len(), &mut self.states)
            .is_err();
        let rotor = system.rotor();
        let place = &rotor.equilibrium().displacement;
        for (state, reference) in states.iter().zip(&self.states) {
            for axis in 0..rotor.kept() {
                let lever = scale.lever(axis);
                self.difference = self
                    .difference
                    .max(lever * (state[axis] - reference[axis]).abs());
                self.excursion = self
                    .excursion
                    .max(lever * (reference[axis] - place[axis]).abs());
            }
        }
    }

    pub fn measured(&self, model: &Model, scale: &MotionScale) -> Option<MeasuredError> {
        let relative = self.difference / self.excursion.max(scale.length);
        (!self.failed).then(|| MeasuredError {
            displacement: self.difference,
            relative,
            reference_tolerance: reference_settings(model).tolerance,
            counters: self.integration.counters(),
        })
    }
}
