//! What is integrated beside the motion: the rotation of a driven shaft, and the works of all that acts.

use nalgebra::DMatrix;

use super::energy::{EnergyBalance, Works};
use super::{Rotation, Rotor};
use crate::bearing::{Geometry, Support, Vector5};
use crate::integrate::System;

/// Relative step of the differences that stand for slopes: the cube root of round-off.
const STEP: f64 = 6e-6;
/// Time over which the change of the right-hand side is looked at, s.
const TIME_STEP: f64 = 1e-8;
/// A usual approach of a contact, m.
const APPROACH: f64 = 1e-5;
/// A usual angular frequency, rad/s.
const RATE: f64 = 1e3;

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

    /// Slopes of all states by central differences: exact slopes of powers are not worth their code.
    pub(super) fn linearise_by_differences(
        &self,
        time: f64,
        state: &[f64],
        jacobian: &mut DMatrix<f64>,
        by_time: &mut [f64],
    ) {
        let rate_at = |time: f64, state: &[f64]| {
            let mut rate = vec![0.0; state.len()];
            self.derivative(time, state, &mut rate);
            rate
        };
        jacobian.fill(0.0);
        // no rate depends on the works
        for column in 0..self.first_work() {
            let step = self.difference_step(column);
            let moved = |step: f64| {
                let mut moved = state.to_vec();
                moved[column] += step;
                rate_at(time, &moved)
            };
            let (up, down) = (moved(step), moved(-step));
            for row in 0..state.len() {
                jacobian[(row, column)] = (up[row] - down[row]) / (2.0 * step);
            }
        }
        let later = |part: f64| rate_at(time + part * TIME_STEP, state);
        let (now, half, full) = (later(0.0), later(0.5), later(1.0));
        for (row, by_time) in by_time.iter_mut().enumerate() {
            *by_time = (4.0 * half[row] - 3.0 * now[row] - full[row]) / TIME_STEP;
        }
    }

    /// Step of the difference by a state that moves: short against what the contacts yield.
    fn difference_step(&self, state: usize) -> f64 {
        let kept = self.kept;
        if state >= 2 * kept {
            return STEP;
        }
        let arm = Support::largest(&self.supports, Geometry::inner_groove_radius);
        let lever = if state % kept < 3 { 1.0 } else { arm };
        let unit = if state < kept { 1.0 } else { RATE };
        STEP * APPROACH * unit / lever
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
