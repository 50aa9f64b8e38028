//! What a simulation asks of a shaft in motion, whatever its states are.

use super::{BallContacts, MotionScale, Rotor, Sample};
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
