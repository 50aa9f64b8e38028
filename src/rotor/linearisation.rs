//! Slopes of the shaft's equations of motion, for implicit methods.

use nalgebra::{ArrayStorage, DMatrix};

use super::motion::AttachedBearing;
use super::structure::UnbalancedPoint;
use super::{Rotation, Rotor};
use crate::bearing::{BearingRotation, Geometry, Matrix5, Support, Vector5};
use crate::integrate::System;

/// Steps over which the damping of the contacts is looked at, m and m/s: short against the approach
/// of a contact and its rate, long against round-off.
const PLACE_STEP: f64 = 1e-10;
const RATE_STEP: f64 = 1e-7;

/// Relative step of the differences that stand for slopes: the cube root of round-off.
const STEP: f64 = 6e-6;
/// Time over which the change of a force, or of the right-hand side, is looked at, s.
const TIME_STEP: f64 = 1e-8;
/// A usual approach of a contact, m.
const APPROACH: f64 = 1e-5;
/// A usual angular frequency, rad/s.
const RATE: f64 = 1e3;

impl Rotor {
    /// Writes the slopes of the derivative by the state and by the time.
    pub(super) fn linearise(
        &self,
        time: f64,
        state: &[f64],
        jacobian: &mut DMatrix<f64>,
        by_time: &mut [f64],
    ) {
        let dofs = self.dofs();
        let (place, velocity) = state.split_at(dofs);
        let rotation = self.speed.at(time);
        // of what holds the structure: K, the bearings, and the damping of their contacts; what a change of speed does to
        // the inertia of the balls is left out, as it is slow beside the passing of a ball
        let size = self.structure.coordinates.len();
        let mut by_place = &self.stiffness.entries - &self.circulatory.entries * rotation.speed;
        let (mut by_rate, mut held) = (DMatrix::zeros(size, size), vec![0.0; size]);
        for (bearing, seen) in self.bearings_at(&rotation) {
            let (attachment, support) = (bearing.attachment, bearing.support);
            let motion = bearing.motion(place, velocity);
            let tangent = support.tangent(&motion[0], &seen);
            attachment.add_stiffness(&tangent.stiffness, &mut by_place);
            if support.is_imperfect() {
                let later =
                    |step: f64| support.force(&motion[0], &self.seen_at(time + step, bearing));
                attachment.add_force(1.0, &forward_rate(later), &mut held);
            } else {
                attachment.add_force(seen.cage_speed, &tangent.by_cage_angle, &mut held);
            }
            if support.is_damped() {
                let damping = |[place, rate]: &[Vector5; 2], seen: &BearingRotation| {
                    support.damped_force(place, rate, seen)[1]
                };
                let slopes = self.damping_slopes(&motion, |motion| damping(motion, &seen));
                attachment.add_stiffness(&slopes[0], &mut by_place);
                attachment.add_stiffness(&slopes[1], &mut by_rate);
                let later = |step: f64| damping(&motion, &self.seen_at(time + step, bearing));
                attachment.add_force(1.0, &forward_rate(later), &mut held);
            }
        }
        jacobian.fill(0.0);
        by_time.fill(0.0);
        for column in 0..dofs {
            jacobian[(column, dofs + column)] = 1.0;
            for row in 0..dofs {
                let rate = self.rate_entry(row, column, rotation.speed);
                jacobian[(dofs + row, column)] = -by_place[(row, column)];
                jacobian[(dofs + row, dofs + column)] = -(rate + by_rate[(row, column)]);
            }
        }
        for mut column in jacobian.column_iter_mut() {
            self.mass.accelerate(&mut column.as_mut_slice()[dofs..]);
        }
        let by_time = &mut by_time[dofs..];
        for (by_time, held) in by_time.iter_mut().zip(&held) {
            *by_time -= held;
        }
        self.add_outer_rate(time, &rotation, by_time);
        self.gyroscopic
            .add_product(-rotation.acceleration, velocity, by_time);
        self.circulatory
            .add_product(rotation.acceleration, place, by_time);
        self.mass.accelerate(by_time);
    }

    /// The rotation that a bearing sees at a time.
    fn seen_at(&self, time: f64, bearing: AttachedBearing<'_>) -> BearingRotation {
        let rotation = self.speed.at(time);
        self.seen_by(bearing.support, &rotation, &self.phases(&rotation))
    }

    /// Slopes of the force against the damping of a bearing's contacts by place and by rate, by central differences: the
    /// force is smooth and, until a contact parts, linear in the rate.
    fn damping_slopes(
        &self,
        motion: &[Vector5; 2],
        damping: impl Fn(&[Vector5; 2]) -> Vector5,
    ) -> [Matrix5; 2] {
        let arm = Support::largest(&self.supports, Geometry::inner_groove_radius);
        let column = |which: usize, step: f64, axis: usize| -> Vector5 {
            let step = if axis < 3 { step } else { step / arm };
            let at = |step: f64| {
                let mut moved = *motion;
                moved[which][axis] += step;
                damping(&moved)
            };
            let (up, down) = (at(step), at(-step));
            std::array::from_fn(|row| (up[row] - down[row]) / (2.0 * step))
        };
        [(0, PLACE_STEP), (1, RATE_STEP)].map(|(which, step)| {
            let columns = std::array::from_fn(|axis| column(which, step, axis));
            Matrix5::from_array_storage(ArrayStorage(columns))
        })
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
        let dofs = self.dofs();
        if state >= 2 * dofs {
            return STEP;
        }
        let arm = Support::largest(&self.supports, Geometry::inner_groove_radius);
        let lever = self.structure.coordinates[state % dofs].length(arm);
        let unit = if state < dofs { 1.0 } else { RATE };
        STEP * APPROACH * unit / lever
    }

    /// Adds the time derivative of the forces that do not come from bearings: unbalance exactly,
    /// varying loads by a difference over a time that is short against all that they do.
    fn add_outer_rate(&self, time: f64, rotation: &Rotation, sum: &mut [f64]) {
        for UnbalancedPoint { point, unbalance } in &self.structure.unbalances {
            point.add_force(1.0, &unbalance.force_rate(rotation), sum);
        }
        for (load, place) in self.loads.iter().zip(&self.structure.load_places) {
            let later = |step: f64| {
                let time = time + step;
                load.kind.at(time, self.speed.at(time).angle)
            };
            self.add_load(load, place, &forward_rate(later), sum);
        }
    }
}

/// Rate of change of a force that is given at times after an instant, by a difference forward, so that it does not reach
/// back over a break that the present step begins at.
fn forward_rate(force: impl Fn(f64) -> Vector5) -> Vector5 {
    let step = TIME_STEP;
    let (now, half, full) = (force(0.0), force(0.5 * step), force(step));
    std::array::from_fn(|axis| (4.0 * half[axis] - 3.0 * now[axis] - full[axis]) / step)
}
