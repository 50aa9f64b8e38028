//! What a simulation asks of a shaft in motion, whatever its states are.

use super::{BallContacts, FREEDOMS, MotionScale, Rotor, Sample};
use crate::integrate::{Linearised, Scaling};

/// A rotor as a system of N equations: by itself, or with more that is integrated beside it.
///
/// The first states are the kept displacements and their velocities.
pub trait Moving<const N: usize>: Linearised<N> {
    /// The rotor that moves.
    fn rotor(&self) -> &Rotor;

    /// State at t = 0.
    fn start(&self) -> [f64; N];

    /// Scaling under which deviations from the static equilibrium are numbers of order one.
    fn scaling(&self, scale: &MotionScale) -> Scaling<N>;

    /// What is observed in a state at a time; of the balls in `contacts`, which must be this rotor's own
    /// [`Rotor::ball_contacts`].
    fn sample(&self, time: f64, state: &[f64; N], contacts: &mut BallContacts) -> Sample;

    /// Second time derivatives of x, y, z, θx, θy in a state at a time: those of the equations
    /// themselves. One evaluation of them, for whoever asks.
    fn acceleration(&self, time: f64, state: &[f64; N]) -> [f64; FREEDOMS] {
        let kept = self.rotor().kept();
        let mut rate = [0.0; N];
        self.derivative(time, state, &mut rate);
        std::array::from_fn(|axis| if axis < kept { rate[kept + axis] } else { 0.0 })
    }
}

impl<const N: usize> Moving<N> for Rotor {
    fn rotor(&self) -> &Rotor {
        self
    }

    fn start(&self) -> [f64; N] {
        let [displacement, velocity] = self.initial_state();
        std::array::from_fn(|index| {
            if index < N / 2 {
                displacement[index]
            } else {
                velocity[index - N / 2]
            }
        })
    }

    fn scaling(&self, scale: &MotionScale) -> Scaling<N> {
        let place = &self.equilibrium().displacement;
        Scaling {
            origin: std::array::from_fn(|index| if index < N / 2 { place[index] } else { 0.0 }),
            scale: self.state_scale(scale),
            time: 1.0 / scale.frequency,
        }
    }

    fn sample(&self, time: f64, state: &[f64; N], contacts: &mut BallContacts) -> Sample {
        Self::sample(self, time, state, contacts)
    }
}
