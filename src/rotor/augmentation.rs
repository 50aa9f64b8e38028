//! What is integrated beside the motion: the rotation of a driven shaft, and the works of all that acts.

use super::energy::{EnergyBalance, Works};
use super::{Rotation, Rotor};

impl Rotor {
    /// Derivative of all states.
    #[inline(never)]
    pub(super) fn augmented_derivative(&self, time: f64, state: &[f64], rate: &mut [f64]) {
        let dofs = self.dofs();
        rate[..dofs].copy_from_slice(&state[dofs..2 * dofs]);
        let action = self.act(time, state, &mut rate[dofs..2 * dofs]);
        if action.moments.is_some() {
            rate[2 * dofs] = action.rotation.speed;
            rate[2 * dofs + 1] = action.rotation.acceleration;
        }
        rate[self.first_work()..].copy_from_slice(&action.powers(self).values());
    }

    /// Kinetic energy, J.
    fn kinetic(&self, velocity: &[f64], rotation: &Rotation) -> f64 {
        let motion = self.mass.kinetic_energy(velocity);
        if self.drive.is_none() {
            return motion;
        }
        let turning = 0.5 * self.inertia_polar * rotation.speed * rotation.speed;
        let [x, y, ..] = self.structure.shaft.rate(velocity);
        motion + turning + self.unbalance.kinetic_energy([x, y], rotation)
    }

    /// Energy that bearings and elastic parts store, J.
    fn stored(&self, place: &[f64], rotation: &Rotation) -> f64 {
        let mut stored = self.structure.stiffness.half_square(place);
        self.for_each_bearing(rotation, &self.phases(rotation), |bearing, rotation| {
            let displacement = bearing.displacement(place);
            stored += bearing.support.stored_energy(&displacement, rotation);
        });
        stored
    }

    /// Where the energy is in a state at a time, and what has been done since t = 0.
    pub(super) fn energy_balance(&self, time: f64, state: &[f64]) -> EnergyBalance {
        let dofs = self.dofs();
        let (place, velocity) = state[..2 * dofs].split_at(dofs);
        let rotation = self.rotation(time, state);
        let steady = self.drive.is_none() && self.speed.is_constant();
        let mut supports = self.supports.iter();
        EnergyBalance {
            kinetic: self.kinetic(velocity, &rotation),
            stored: self.stored(place, &rotation),
            conservative: supports.all(|support| support.has_potential(steady)),
            works: Works::from_values(&state[self.first_work()..]),
        }
    }
}
