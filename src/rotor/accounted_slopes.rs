//! Slopes of the equations of an accounted rotor, for implicit methods.

use nalgebra::DMatrix;

use super::FREEDOMS;
use super::accounted::AccountedRotor;
use crate::bearing::{Geometry, Support};
use crate::integrate::System;

/// Relative step of the differences that stand for slopes: the cube root of round-off.
const STEP: f64 = 6e-6;
/// Time over which the change of the right-hand side is looked at, s.
const TIME_STEP: f64 = 1e-8;

impl AccountedRotor<'_> {
    /// By central differences: exact slopes of powers are not worth their code.
    pub(super) fn linearise(
        &self,
        time: f64,
        state: &[f64],
        jacobian: &mut DMatrix<f64>,
        by_time: &mut [f64],
    ) {
        let steps = self.difference_steps();
        let rate_at = |time: f64, state: &[f64]| {
            let mut rate = vec![0.0; state.len()];
            self.derivative(time, state, &mut rate);
            rate
        };
        jacobian.fill(0.0);
        // no rate depends on the works
        let moving = 2 * self.rotor.kept + Self::turning(self.rotor);
        for column in 0..moving {
            let step = steps[column];
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

    /// Steps of the differences by each state that moves: short against what the contacts yield.
    fn difference_steps(&self) -> [f64; 2 * FREEDOMS + 2] {
        let rotor = self.rotor;
        let kept = rotor.kept;
        let arm = Support::largest(&rotor.supports, Geometry::inner_groove_radius);
        let length = STEP * APPROACH;
        std::array::from_fn(|index| match index {
            index if index < 2 * kept => {
                let lever = if index % kept < 3 { 1.0 } else { arm };
                let unit = if index < kept { 1.0 } else { RATE };
                length * unit / lever
            }
            _ => STEP,
        })
    }
}

/// A usual approach of a contact, m.
const APPROACH: f64 = 1e-5;
/// A usual angular frequency, rad/s.
const RATE: f64 = 1e3;
