//! What is integrated beside the motion: the rotation of a driven shaft, and the works of all that acts.

use super::energy::{EnergyBalance, Works};
use super::{Rotation, Rotor};
use crate::bearing::Vector5;

impl Rotor {
    /// Derivative of all states.
    #[inline(never)]
    pub(super) fn augmented_derivative(&self, time: f64, state: &[f64], rate: &mut [f64]) {
        let kept = self.kept;
        let action = self.act(time, state);
        let gyroscopic = self.gyroscopic(&action.velocity, action.rotation.speed);
        for axis in 0..kept {
            let force = action.at_centre[axis]
                + action.on_mass[axis]
                + action.unbalance[axis]
                + gyroscopic[axis];
            rate[axis] = action.velocity[axis];
            rate[kept + axis] = force * self.inverse_mass[axis];
        }
        if action.moments.is_some() {
            rate[2 * kept] = action.rotation.speed;
            rate[2 * kept + 1] = action.rotation.acceleration;
        }
        rate[self.first_work()..].copy_from_slice(&action.powers(self).values());
    }

    /// Kinetic energy, J.
    fn kinetic(&self, velocity: &Vector5, rotation: &Rotation) -> f64 {
        let squares = (0..self.kept).map(|axis| self.mass[axis] * velocity[axis] * velocity[axis]);
        let motion = 0.5 * squares.sum::<f64>();
        if self.drive.is_none() {
            return motion;
        }
        let turning = 0.5 * self.inertia_polar * rotation.speed * rotation.speed;
        let [x, y, ..] = *velocity;
        motion + turning + self.unbalance.kinetic_energy([x, y], rotation)
    }

    fn stored(&self, place: &Vector5, rotation: &Rotation) -> f64 {
        let mut stored = 0.0;
        self.for_each_support(rotation, &self.phases(rotation), |support, rotation| {
            stored += support.stored_energy(place, rotation);
        });
        stored
    }

    /// Where the energy is in a state at a time, and what has been done since t = 0.
    pub(super) fn energy_balance(&self, time: f64, state: &[f64]) -> EnergyBalance {
        let [place, velocity] = self.motion(state);
        let rotation = self.rotation(time, state);
        let steady = self.drive.is_none() && self.speed.is_constant();
        let mut supports = self.supports.iter();
        EnergyBalance {
            kinetic: self.kinetic(&velocity, &rotation),
            stored: self.stored(&place, &rotation),
            conservative: supports.all(|support| support.has_potential(steady)),
            works: Works::from_values(&state[self.first_work()..]),
        }
    }
}
