//! Slopes of the shaft's equations of motion, for implicit methods.

use nalgebra::{ArrayStorage, DMatrix};

use super::Rotor;
use super::element::{AttachedBearing, ElementMotion, Instant, seen_by};
use super::excitation::{TIME_STEP, forward_rate};
use crate::bearing::{BearingRotation, Geometry, Matrix5, Support, Vector5};
use crate::integrate::System;

/// Steps over which the damping of the contacts is looked at, m and m/s: short against the approach
/// of a contact and its rate, long against round-off.
const PLACE_STEP: f64 = 1e-10;
const RATE_STEP: f64 = 1e-7;

/// Relative step of the differences taken for slopes: the cube root of round-off.
const STEP: f64 = 6e-6;
/// A usual approach of a contact, m.
const APPROACH: f64 = 1e-5;
/// A usual angular frequency, rad/s.
const RATE: f64 = 1e3;

impl Rotor {
    /// Writes the slopes of the derivative by the state.
    pub(super) fn linearise(&self, time: f64, state: &[f64], jacobian: &mut DMatrix<f64>) {
        let rotation = self.excitation.speed.at(time);
        let at = self.instant(state, &rotation);
        // of what holds the structure: K, the bearings, and the damping of their contacts
        let linear = &self.linear;
        let mut slopes = [
            linear.by_place(rotation.speed),
            linear.by_rate(rotation.speed),
        ];
        for (bearing, motion) in self.elements.bearings_at(&at) {
            self.add_bearing_slopes(&bearing, &motion, &mut slopes);
        }
        self.add_law_slopes(&at, &mut slopes);
        linear.write_state_matrix(&slopes, jacobian);
    }

    /// Writes the slopes of the derivative by the time. What a change of speed does to the inertia of the balls is left out,
    /// as it is slow compared with the passing of a ball.
    pub(super) fn find_rate_by_time(&self, time: f64, state: &[f64], by_time: &mut [f64]) {
        let rotation = self.excitation.speed.at(time);
        let (at, linear) = (self.instant(state, &rotation), &self.linear);
        by_time.fill(0.0);
        let by_time = &mut by_time[self.dofs()..];
        for (bearing, motion) in self.elements.bearings_at(&at) {
            let held = self.bearing_force_rate(time, &bearing, &motion);
            bearing.attachment.add_force(-1.0, &held, by_time);
        }
        if rotation.acceleration != 0.0 {
            self.add_law_force_rates(time, &at, by_time);
        }
        self.excitation.add_force_rates(time, &rotation, by_time);
        let change = rotation.acceleration;
        linear.gyroscopic.add_product(-change, at.velocity, by_time);
        linear.circulatory.add_product(change, at.place, by_time);
        linear.mass.accelerate(by_time);
    }

    /// Adds the slopes of other laws of force by place and by rate of all coordinates.
    pub(super) fn add_law_slopes(
        &self,
        at: &Instant<'_>,
        [by_place, by_rate]: &mut [DMatrix<f64>; 2],
    ) {
        for (attachment, law, motion) in self.elements.laws_at(at) {
            let [stiffness, damping] = law.slopes(&motion);
            attachment.add_stiffness(&stiffness, by_place);
            attachment.add_stiffness(&damping, by_rate);
        }
    }

    /// Adds the rates of change of other forces as the speed changes.
    fn add_law_force_rates(&self, time: f64, at: &Instant<'_>, by_time: &mut [f64]) {
        for (attachment, law, motion) in self.elements.laws_at(at) {
            let rate = forward_rate(|step| {
                let speed = self.excitation.speed.at(time + step).speed;
                law.force(&ElementMotion {
                    rotation: BearingRotation::at_start(speed),
                    ..motion
                })
            });
            attachment.add_force(-1.0, &rate, by_time);
        }
    }

    /// Adds the slopes of the force onto a bearing in a motion, of contacts and their damping, by place and by rate of all
    /// coordinates.
    pub(super) fn add_bearing_slopes(
        &self,
        bearing: &AttachedBearing<'_>,
        motion: &ElementMotion,
        [by_place, by_rate]: &mut [DMatrix<f64>; 2],
    ) {
        let (support, attachment, seen) = (bearing.support, bearing.attachment, &motion.rotation);
        let tangent = support.tangent(&motion.displacement, seen);
        attachment.add_stiffness(&tangent.stiffness, by_place);
        if support.is_damped() {
            self.add_damping_slopes(bearing, motion, [by_place, by_rate]);
        }
    }

    /// Adds the slopes of the damping of a bearing's contacts in a motion, by place and by rate of all coordinates.
    fn add_damping_slopes(
        &self,
        bearing: &AttachedBearing<'_>,
        motion: &ElementMotion,
        sums: [&mut DMatrix<f64>; 2],
    ) {
        let (support, seen) = (bearing.support, &motion.rotation);
        let place = [motion.displacement, motion.rate];
        let damping = |[place, rate]: &[Vector5; 2]| support.damped_force(place, rate, seen)[1];
        let slopes = self.damping_slopes(&place, damping);
        for (sum, slopes) in sums.into_iter().zip(slopes) {
            bearing.attachment.add_stiffness(&slopes, sum);
        }
    }

    /// Adds the slopes of the damping of all contacts at rest at the static equilibrium.
    pub(super) fn add_contact_damping(&self, slopes: &mut [DMatrix<f64>; 2]) {
        let rotation = self.excitation.speed.at(0.0);
        let still = vec![0.0; self.start.rest.len()];
        let at = Instant {
            place: &self.start.rest,
            velocity: &still,
            rest: &self.start.rest,
            rotation: &rotation,
            phases: self.elements.phases(&rotation),
        };
        for (bearing, motion) in self.elements.bearings_at(&at) {
            if bearing.support.is_damped() {
                let [by_place, by_rate] = slopes;
                self.add_damping_slopes(&bearing, &motion, [by_place, by_rate]);
            }
        }
    }

    /// Rate of change of the force onto a bearing in a motion that stays, of contacts and their damping.
    fn bearing_force_rate(
        &self,
        time: f64,
        bearing: &AttachedBearing<'_>,
        motion: &ElementMotion,
    ) -> Vector5 {
        let (support, seen) = (bearing.support, &motion.rotation);
        let (place, rate) = (&motion.displacement, &motion.rate);
        let later = |step: f64| {
            let rotation = self.excitation.speed.at(time + step);
            seen_by(support, &rotation, &self.elements.phases(&rotation))
        };
        let elastic = match support.is_imperfect() {
            true => forward_rate(|step| support.force(place, &later(step))),
            false => {
                let by_cage_angle = support.tangent(place, seen).by_cage_angle;
                by_cage_angle.map(|slope| seen.cage_speed * slope)
            }
        };
        if !support.is_damped() {
            return elastic;
        }
        let damping = forward_rate(|step| support.damped_force(place, rate, &later(step))[1]);
        std::array::from_fn(|axis| elastic[axis] + damping[axis])
    }

    /// Slopes of the force against the damping of a bearing's contacts by place and by rate, by central differences: the
    /// force is smooth and, until a contact parts, linear in the rate.
    fn damping_slopes(
        &self,
        motion: &[Vector5; 2],
        damping: impl Fn(&[Vector5; 2]) -> Vector5,
    ) -> [Matrix5; 2] {
        let arm = Support::largest(self.elements.supports(), Geometry::lever);
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

    /// Slopes by all states by central differences: exact slopes of powers are not worth their code.
    pub(super) fn linearise_by_differences(
        &self,
        time: f64,
        state: &[f64],
        jacobian: &mut DMatrix<f64>,
    ) {
        jacobian.fill(0.0);
        // no rate depends on the works
        for column in 0..self.first_work() {
            let step = self.difference_step(column);
            let moved = |step: f64| {
                let mut moved = state.to_vec();
                moved[column] += step;
                self.rate_at(time, &moved)
            };
            let (up, down) = (moved(step), moved(-step));
            for row in 0..state.len() {
                jacobian[(row, column)] = (up[row] - down[row]) / (2.0 * step);
            }
        }
    }

    /// Slopes by the time, of powers too, by forward differences.
    pub(super) fn find_rate_by_time_differences(
        &self,
        time: f64,
        state: &[f64],
        by_time: &mut [f64],
    ) {
        let later = |part: f64| self.rate_at(time + part * TIME_STEP, state);
        let (now, half, full) = (later(0.0), later(0.5), later(1.0));
        for (row, by_time) in by_time.iter_mut().enumerate() {
            *by_time = (4.0 * half[row] - 3.0 * now[row] - full[row]) / TIME_STEP;
        }
    }

    /// The derivative at a time in a state.
    fn rate_at(&self, time: f64, state: &[f64]) -> Vec<f64> {
        let mut rate = vec![0.0; state.len()];
        self.derivative(time, state, &mut rate);
        rate
    }

    /// Step of the difference by a state that moves: short against what the contacts yield.
    fn difference_step(&self, state: usize) -> f64 {
        let dofs = self.dofs();
        if state >= 2 * dofs {
            return STEP;
        }
        let arm = Support::largest(self.elements.supports(), Geometry::lever);
        let lever = self.structure.coordinates[state % dofs].length(arm);
        let unit = if state < dofs { 1.0 } else { RATE };
        STEP * APPROACH * unit / lever
    }
}
