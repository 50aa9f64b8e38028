//! Slopes of the shaft's equations of motion, for implicit methods.

use nalgebra::SMatrix;

use super::{FREEDOMS, Rotor};
use crate::bearing::{Matrix5, Vector5};
use crate::integrate::Linearised;

impl<const N: usize> Linearised<N> for Rotor {
    fn linearisation(&self, time: f64, state: &[f64; N]) -> (SMatrix<f64, N, N>, [f64; N]) {
        let kept = N / 2;
        let displacement = self.full(&self.equilibrium.displacement, &state[..kept]);
        let (stiffness, force_rate) = self.bearing_slopes(&displacement, time);
        let push_rate = self.push_rate(time);
        let mut jacobian = SMatrix::zeros();
        let mut by_time = [0.0; N];
        for row in 0..kept {
            let inverse_mass = self.inverse_mass[row];
            jacobian[(row, kept + row)] = 1.0;
            for column in 0..kept {
                let damping = self.damping.entry(row, column);
                jacobian[(kept + row, column)] = -stiffness[(row, column)] * inverse_mass;
                jacobian[(kept + row, kept + column)] = -damping * inverse_mass;
            }
            by_time[kept + row] = (push_rate[row] - force_rate[row]) * inverse_mass;
        }
        if kept == FREEDOMS {
            let coupling = self.gyroscopic * self.inverse_mass[3];
            jacobian[(kept + 3, kept + 4)] -= coupling;
            jacobian[(kept + 4, kept + 3)] += coupling;
        }
        (jacobian, by_time)
    }
}

impl Rotor {
    /// K of all bearings, and the rate at which their force changes as the cages turn.
    fn bearing_slopes(&self, displacement: &Vector5, time: f64) -> (Matrix5, Vector5) {
        let (mut stiffness, mut rate) = (Matrix5::zeros(), [0.0; FREEDOMS]);
        self.for_each_support(time, |support, cage| {
            let (tangent, by_cage_angle) = support.slopes(displacement, cage, self.speed);
            let cage_speed = self.cage_speed(support);
            stiffness += tangent;
            for axis in 0..FREEDOMS {
                rate[axis] += by_cage_angle[axis] * cage_speed;
            }
        });
        (stiffness, rate)
    }

    /// Time derivative of the forces on the shaft that do not come from bearings.
    fn push_rate(&self, time: f64) -> Vector5 {
        let (sin, cos) = (self.speed * time).sin_cos();
        let mut rate = [0.0; FREEDOMS];
        rate[0] = -self.unbalance * self.speed * sin;
        rate[1] = self.unbalance * self.speed * cos;
        rate
    }
}
