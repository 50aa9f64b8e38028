//! The shaft in motion with its energy accounted for, and, where it is driven, with its rotation.

use nalgebra::DMatrix;

use super::energy::{EnergyBalance, Works};

use super::{BallContacts, FREEDOMS, MotionScale, Moving, Rotation, Rotor, Sample};
use crate::bearing::Vector5;
use crate::integrate::{Scaling, System};

/// A rotor whose state goes on with the angle and the speed of its shaft, where it is driven, and with
/// the works of [`Works`]:
///
/// ```text
/// (q, q̇, [ψ, ω], W_1 … W_9)
/// ```
///
/// The works are integrals that the integrator keeps as exactly as the motion itself. A scene that
/// asks neither for energy nor for a drive does not pay for it: a [`Rotor`] moves by itself, too.
#[derive(Debug, Clone, Copy)]
pub struct AccountedRotor<'a> {
    pub(super) rotor: &'a Rotor,
}

impl<'a> AccountedRotor<'a> {
    /// The rotor with its accounts.
    pub fn new(rotor: &'a Rotor) -> Self {
        Self { rotor }
    }

    /// Number of states of the rotation.
    pub(super) fn turning(rotor: &Rotor) -> usize {
        if rotor.drive.is_some() { 2 } else { 0 }
    }

    /// Angle and speed; the acceleration of a driven shaft is not known before its moments are.
    pub(super) fn rotation(&self, time: f64, state: &[f64]) -> Rotation {
        match self.rotor.drive {
            None => self.rotor.speed.at(time),
            Some(_) => {
                let first = 2 * self.rotor.kept;
                Rotation {
                    angle: state[first],
                    speed: state[first + 1],
                    acceleration: 0.0,
                }
            }
        }
    }

    pub(super) fn motion(&self, state: &[f64]) -> [Vector5; 2] {
        let (rotor, kept) = (self.rotor, self.rotor.kept);
        [
            rotor.full(&rotor.equilibrium.displacement, &state[..kept]),
            rotor.full(&[0.0; FREEDOMS], &state[kept..2 * kept]),
        ]
    }

    /// Kinetic energy, J.
    fn kinetic(&self, velocity: &Vector5, rotation: &Rotation) -> f64 {
        let rotor = self.rotor;
        let squares =
            (0..rotor.kept).map(|axis| rotor.mass[axis] * velocity[axis] * velocity[axis]);
        let motion = 0.5 * squares.sum::<f64>();
        if rotor.drive.is_none() {
            return motion;
        }
        // of the centre of mass, (ẋ − e ω sin ψ, ẏ + e ω cos ψ), and of the rotation
        let (sin, cos) = rotation.angle.sin_cos();
        let eccentricity = rotor.imbalance * rotor.inverse_mass[0];
        let speed = rotation.speed;
        motion
            + rotor.imbalance * speed * (velocity[1] * cos - velocity[0] * sin)
            + 0.5 * speed * speed * (rotor.inertia_polar + rotor.imbalance * eccentricity)
    }

    fn stored(&self, place: &Vector5, rotation: &Rotation) -> f64 {
        let mut stored = 0.0;
        let phases = self.rotor.phases(rotation);
        self.rotor
            .for_each_support(rotation, &phases, |support, rotation| {
                stored += support.stored_energy(place, rotation);
            });
        stored
    }

    fn balance(&self, time: f64, state: &[f64]) -> EnergyBalance {
        let [place, velocity] = self.motion(state);
        let rotation = self.rotation(time, state);
        let first = 2 * self.rotor.kept + Self::turning(self.rotor);
        let steady = self.rotor.drive.is_none() && self.rotor.speed.is_constant();
        EnergyBalance {
            kinetic: self.kinetic(&velocity, &rotation),
            stored: self.stored(&place, &rotation),
            conservative: self
                .rotor
                .supports
                .iter()
                .all(|support| support.has_potential(steady)),
            works: Works::from_values(&state[first..]),
        }
    }
}

impl System for AccountedRotor<'_> {
    fn states(&self) -> usize {
        2 * self.rotor.kept + Self::turning(self.rotor) + Works::COUNT
    }

    fn derivative(&self, time: f64, state: &[f64], rate: &mut [f64]) {
        let rotor = self.rotor;
        let kept = rotor.kept;
        let action = self.act(time, state);
        let gyroscopic = rotor.gyroscopic(&action.velocity, action.rotation.speed);
        for axis in 0..kept {
            let push = action.at_centre[axis]
                + action.on_mass[axis]
                + action.unbalance[axis]
                + gyroscopic[axis];
            rate[axis] = action.velocity[axis];
            rate[kept + axis] = push * rotor.inverse_mass[axis];
        }
        let mut next = 2 * kept;
        if action.moments.is_some() {
            rate[next] = action.rotation.speed;
            rate[next + 1] = action.rotation.acceleration;
            next += 2;
        }
        let powers = action.powers(rotor).values();
        rate[next..next + Works::COUNT].copy_from_slice(&powers);
    }

    fn linearisation(
        &self,
        time: f64,
        state: &[f64],
        jacobian: &mut DMatrix<f64>,
        by_time: &mut [f64],
    ) {
        self.linearise(time, state, jacobian, by_time);
    }

    fn next_break(&self, after: f64) -> f64 {
        self.rotor.next_break_after(after)
    }

    fn event_count(&self) -> usize {
        self.rotor.lift_off_count()
    }

    fn events(&self, time: f64, state: &[f64], values: &mut [f64]) {
        let rotation = self.rotation(time, state);
        self.rotor
            .lift_off_distances(&rotation, &state[..self.rotor.kept], values);
    }

    fn event_change(&self, times: [f64; 2], states: [&[f64]; 2]) -> f64 {
        let rotations = [0, 1].map(|end| self.rotation(times[end], states[end]));
        let places = states.map(|state| &state[..self.rotor.kept]);
        self.rotor.lift_off_change(rotations.each_ref(), places)
    }

    fn force_jump(&self, event: usize, time: f64, distance: f64, rate: &mut [f64]) {
        // the speed that a drive is meant for: a bound does not ask for more
        let speed = match self.rotor.drive {
            None => self.rotor.speed.at(time).speed,
            Some(_) => self.rotor.highest_speed(),
        };
        self.rotor.lift_off_jump(event, speed, distance, rate);
    }

    fn expects_crossings(&self) -> bool {
        self.rotor.balls_may_part()
    }
}

impl Moving for AccountedRotor<'_> {
    fn rotor(&self) -> &Rotor {
        self.rotor
    }

    fn start(&self) -> Vec<f64> {
        let mut state = vec![0.0; self.states()];
        let kept = self.rotor.kept;
        let [displacement, velocity] = &self.rotor.initial;
        state[..kept].copy_from_slice(&displacement[..kept]);
        state[kept..2 * kept].copy_from_slice(&velocity[..kept]);
        if self.rotor.drive.is_some() {
            state[2 * kept + 1] = self.rotor.speed();
        }
        state
    }

    fn scaling(&self, scale: &MotionScale) -> Scaling {
        let rotor = self.rotor;
        let (kept, turning) = (rotor.kept, Self::turning(rotor));
        // kinetic energy of the motion
        let energy = rotor.mass[0] * (scale.length * scale.frequency).powi(2);
        let mut scaling = Scaling {
            origin: vec![0.0; self.states()],
            scale: vec![energy; self.states()],
            time: 1.0 / scale.frequency,
        };
        scaling.origin[..kept].copy_from_slice(&rotor.equilibrium.displacement[..kept]);
        for axis in 0..kept {
            let length = scale.length / scale.lever(axis);
            scaling.scale[axis] = length;
            scaling.scale[kept + axis] = length * scale.frequency;
        }
        if turning > 0 {
            scaling.scale[2 * kept] = 1.0;
            scaling.scale[2 * kept + 1] = scale.frequency;
        }
        scaling
    }

    fn sample(&self, time: f64, state: &[f64], contacts: &mut BallContacts) -> Sample {
        let [place, velocity] = self.motion(state);
        let action = self.rotor.drive.map(|_| self.act(time, state));
        let rotation = match &action {
            Some(action) => action.rotation,
            None => self.rotation(time, state),
        };
        Sample {
            energy: Some(self.balance(time, state)),
            drive: action.and_then(|action| action.moments),
            ..self
                .rotor
                .observe(time, &rotation, [place, velocity], contacts)
        }
    }
}
