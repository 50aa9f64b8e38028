//! What a simulation asks of a shaft in motion, whatever its states are.

use super::{BallContacts, FREEDOMS, MotionScale, Rotor, Sample};
use crate::integrate::{Scaling, System};

/// A rotor as a system of equations: by itself, or with more that is integrated beside it.
///
/// The first states are the kept displacements and their velocities.
pub trait Moving: System {
    /// The rotor that moves.
    fn rotor(&self) -> &Rotor;

    /// State at t = 0.
    fn start(&self) -> Vec<f64>;

    /// Scaling under which deviations from the static equilibrium are numbers of order one.
    fn scaling(&self, scale: &MotionScale) -> Scaling;

    /// What is observed in a state at a time; of the balls in `contacts`, which must be this rotor's own
    /// [`Rotor::ball_contacts`].
    fn sample(&self, time: f64, state: &[f64], contacts: &mut BallContacts) -> Sample;

    /// Second time derivatives of x, y, z, θx, θy in a state at a time: those of the equations
    /// themselves. One evaluation of them, for whoever asks; `rate` is room for the derivative.
    fn acceleration(&self, time: f64, state: &[f64], rate: &mut Vec<f64>) -> [f64; FREEDOMS] {
        let kept = self.rotor().kept();
        rate.resize(state.len(), 0.0);
        self.derivative(time, state, rate);
        std::array::from_fn(|axis| if axis < kept { rate[kept + axis] } else { 0.0 })
    }
}

impl Moving for Rotor {
    fn rotor(&self) -> &Rotor {
        self
    }

    fn start(&self) -> Vec<f64> {
        let [displacement, velocity] = self.initial_state();
        [&displacement[..self.kept], &velocity[..self.kept]].concat()
    }

    fn scaling(&self, scale: &MotionScale) -> Scaling {
        let mut origin = self.equilibrium().displacement[..self.kept].to_vec();
        origin.resize(2 * self.kept, 0.0);
        Scaling {
            origin,
            scale: self.state_scale(scale),
            time: 1.0 / scale.frequency,
        }
    }

    fn sample(&self, time: f64, state: &[f64], contacts: &mut BallContacts) -> Sample {
        Self::sample(self, time, state, contacts)
    }
}
