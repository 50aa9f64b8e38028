//! Slopes of the shaft's equations of motion, for implicit methods.

use nalgebra::{ArrayStorage, DMatrix};

use super::{FREEDOMS, Rotation, Rotor};
use crate::bearing::{Geometry, Matrix5, Support, Vector5};
use crate::integrate::System;

/// Time over which the change of a load is looked at, s.
const LOAD_RATE_STEP: f64 = 1e-8;
/// Steps over which the damping of the contacts is looked at, m and m/s: short against the approach
/// of a contact and its rate, long against round-off.
const PLACE_STEP: f64 = 1e-10;
const RATE_STEP: f64 = 1e-7;

/// Relative step of the differences that stand for slopes: the cube root of round-off.
const STEP: f64 = 6e-6;
/// Time over which the change of the right-hand side is looked at, s.
const TIME_STEP: f64 = 1e-8;
/// A usual approach of a contact, m.
const APPROACH: f64 = 1e-5;
/// A usual angular frequency, rad/s.
const RATE: f64 = 1e3;

/// Slopes of the force against the damping of the contacts.
struct DampingSlopes {
    /// ∂F/∂q at a fixed velocity.
    by_place: Matrix5,
    /// ∂F/∂q̇.
    by_rate: Matrix5,
    /// ∂F/∂t at a fixed place and velocity: the cage turns.
    by_time: Vector5,
}

impl Rotor {
    /// Writes the slopes of the derivative by the state and by the time.
    pub(super) fn linearise(
        &self,
        time: f64,
        state: &[f64],
        jacobian: &mut DMatrix<f64>,
        by_time: &mut [f64],
    ) {
        let kept = self.kept;
        let displacement = self.full(&self.equilibrium.displacement, &state[..kept]);
        let rotation = self.speed.at(time);
        let (stiffness, force_rate) = self.bearing_slopes(&displacement, &rotation);
        let push_rate = self.push_rate(time, &rotation);
        jacobian.fill(0.0);
        by_time.fill(0.0);
        for row in 0..kept {
            let inverse_mass = self.inverse_mass[row];
            jacobian[(row, kept + row)] = 1.0;
            for column in 0..kept {
                let rate = self.rate_entry(row, column, rotation.speed);
                jacobian[(kept + row, column)] = -stiffness[(row, column)] * inverse_mass;
                jacobian[(kept + row, kept + column)] = -rate * inverse_mass;
            }
            by_time[kept + row] = (push_rate[row] - force_rate[row]) * inverse_mass;
        }
        if kept == FREEDOMS {
            let change = self.inertia_polar * self.inverse_mass[3] * rotation.acceleration;
            by_time[kept + 3] -= change * state[kept + 4];
            by_time[kept + 4] += change * state[kept + 3];
        }
        if self.contacts_damped {
            let velocity = self.full(&[0.0; FREEDOMS], &state[kept..]);
            let slopes = self.contact_damping_slopes(time, &displacement, &velocity);
            for row in 0..kept {
                let inverse_mass = self.inverse_mass[row];
                for column in 0..kept {
                    jacobian[(kept + row, column)] -= slopes.by_place[(row, column)] * inverse_mass;
                    jacobian[(kept + row, kept + column)] -=
                        slopes.by_rate[(row, column)] * inverse_mass;
                }
                by_time[kept + row] -= slopes.by_time[row] * inverse_mass;
            }
        }
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

    /// K of all bearings, and the rate at which their force changes as the cages turn. What a change
    /// of speed does to the inertia of the balls is left out: it is slow beside the passing of a ball.
    fn bearing_slopes(&self, displacement: &Vector5, rotation: &Rotation) -> (Matrix5, Vector5) {
        let (mut stiffness, mut rate) = (Matrix5::zeros(), [0.0; FREEDOMS]);
        self.for_each_support(rotation, &self.phases(rotation), |support, rotation| {
            let (tangent, by_cage_angle) = support.slopes(displacement, rotation);
            stiffness += tangent;
            for axis in 0..FREEDOMS {
                rate[axis] += by_cage_angle[axis] * rotation.cage_speed;
            }
        });
        (stiffness, rate)
    }

    /// Slopes of the force against the damping of all contacts, by central differences: the force is smooth and, until
    /// a contact parts, linear in the rate.
    fn contact_damping_slopes(
        &self,
        time: f64,
        displacement: &Vector5,
        velocity: &Vector5,
    ) -> DampingSlopes {
        let rotation = self.speed.at(time);
        let arm = Support::largest(&self.supports, Geometry::inner_groove_radius);
        let lever = |axis: usize| if axis < 3 { 1.0 } else { arm };
        let moved = |vector: &Vector5, axis: usize, step: f64| {
            let mut moved = *vector;
            moved[axis] += step;
            moved
        };
        let slope = |up: Vector5, down: Vector5, step: f64| -> Vector5 {
            std::array::from_fn(|row| (up[row] - down[row]) / (2.0 * step))
        };
        let by_place = |axis: usize| {
            let step = PLACE_STEP / lever(axis);
            let at =
                |step| self.contact_damping(&moved(displacement, axis, step), velocity, &rotation);
            slope(at(step), at(-step), step)
        };
        let by_rate = |axis: usize| {
            let step = RATE_STEP / lever(axis);
            let at =
                |step| self.contact_damping(displacement, &moved(velocity, axis, step), &rotation);
            slope(at(step), at(-step), step)
        };
        let later =
            |step: f64| self.contact_damping(displacement, velocity, &self.speed.at(time + step));
        let (now, half, full) = (
            later(0.0),
            later(0.5 * LOAD_RATE_STEP),
            later(LOAD_RATE_STEP),
        );
        let columns = |column: &dyn Fn(usize) -> Vector5| {
            Matrix5::from_array_storage(ArrayStorage(std::array::from_fn(column)))
        };
        DampingSlopes {
            by_place: columns(&by_place),
            by_rate: columns(&by_rate),
            by_time: std::array::from_fn(|axis| {
                (4.0 * half[axis] - 3.0 * now[axis] - full[axis]) / LOAD_RATE_STEP
            }),
        }
    }

    /// Time derivative of the forces on the shaft that do not come from bearings: unbalance exactly,
    /// varying loads by a difference over a time that is short against all that they do.
    fn push_rate(&self, time: f64, rotation: &Rotation) -> Vector5 {
        let [x, y] = self.unbalance.force_rate(rotation);
        let mut rate = [x, y, 0.0, 0.0, 0.0];
        for (rate, change) in rate.iter_mut().zip(self.load_rate(time)) {
            *rate += change;
        }
        rate
    }

    /// Rate of change of the varying loads, N/s and N m/s: forward, so that it does not reach back
    /// over a break that the present step begins at.
    fn load_rate(&self, time: f64) -> Vector5 {
        if self.loads.is_empty() {
            return [0.0; FREEDOMS];
        }
        let at = |time: f64| {
            let (angle, mut sum) = (self.speed.at(time).angle, [0.0; FREEDOMS]);
            for load in &self.loads {
                load.add(time, angle, self.mass[0], &mut sum);
            }
            sum
        };
        let step = LOAD_RATE_STEP;
        let (now, half, full) = (at(time), at(time + 0.5 * step), at(time + step));
        std::array::from_fn(|axis| (4.0 * half[axis] - 3.0 * now[axis] - full[axis]) / step)
    }
}
