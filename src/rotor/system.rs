//! The shaft as a system of equations: what its states are, and what an integration asks of them.

use nalgebra::DMatrix;

use super::coordinate::Coordinate;
use super::energy::Works;
use super::{InitialPosition, MotionScale, Rotation, Rotor};
use crate::bearing::{Support, Vector5};
use crate::integrate::{Scaling, Separated, System};

/// The states are
///
/// ```text
/// (q, q̇, [ψ, ω], [W_1 … W_9])
/// ```
///
/// with the angle and the speed of the shaft where a drive turns it, and the works of [`Works`] where a drive does or
/// [`Rotor::account_for_energy`] asked for them: integrals that are kept as exactly as the motion itself.
impl System for Rotor {
    fn states(&self) -> usize {
        let works = if self.is_augmented() { Works::COUNT } else { 0 };
        self.first_work() + works
    }

    #[inline]
    fn derivative(&self, time: f64, state: &[f64], rate: &mut [f64]) {
        if self.is_augmented() {
            self.augmented_derivative(time, state, rate);
        } else {
            self.motion_derivative(time, state, rate);
        }
    }

    fn linearisation(&self, time: f64, state: &[f64], jacobian: &mut DMatrix<f64>) {
        if self.is_augmented() {
            self.linearise_by_differences(time, state, jacobian);
        } else {
            self.linearise(time, state, jacobian);
        }
    }

    fn rate_by_time(&self, time: f64, state: &[f64], by_time: &mut [f64]) {
        if self.is_augmented() {
            self.find_rate_by_time_differences(time, state, by_time);
        } else {
            self.find_rate_by_time(time, state, by_time);
        }
    }

    fn separated(&self, time: f64, state: &[f64]) -> Option<Separated> {
        self.separation(time, state)
    }

    fn forces(&self, time: f64, state: &[f64], forces: &mut [f64]) {
        self.few_forces(time, state, forces);
    }

    fn force_slopes(
        &self,
        time: f64,
        state: &[f64],
        seen: &[usize],
        acting: &[usize],
    ) -> DMatrix<f64> {
        self.few_force_slopes(time, state, seen, acting)
    }

    fn next_break(&self, after: f64) -> f64 {
        self.excitation
            .next_break(after)
            .min(self.next_passing(after))
    }

    fn event_count(&self) -> usize {
        let bearings = self.elements.balls_that_lift_off + self.passing_event_count();
        bearings + self.elements.law_event_count
    }

    fn events(&self, time: f64, state: &[f64], values: &mut [f64]) {
        let rotation = self.rotation(time, state);
        let at = self.instant(state, &rotation);
        let (balls, others) = values.split_at_mut(self.elements.balls_that_lift_off);
        let (kinks, laws) = others.split_at_mut(others.len() - self.elements.law_event_count);
        self.lift_off_distances(&at, balls);
        self.passing_distances(&at, kinks);
        self.law_events(&at, laws);
    }

    fn event(&self, event: usize, time: f64, state: &[f64]) -> f64 {
        if let EventKind::LiftOff(ball) = self.event_kind(event) {
            let rotation = self.rotation(time, state);
            return self.lift_off_distance(&self.instant(state, &rotation), ball);
        }
        let mut values = vec![0.0; self.event_count()];
        self.events(time, state, &mut values);
        values[event]
    }

    fn force_jump(&self, event: usize, time: f64, distance: f64, rate: &mut [f64]) {
        // the speed that a drive is meant for: a bound does not ask for more
        let speed = match self.is_driven() {
            false => self.excitation.speed.at(time).speed,
            true => self.highest_speed(),
        };
        match self.event_kind(event) {
            EventKind::LiftOff(ball) => self.lift_off_jump(ball, speed, distance, rate),
            EventKind::Passing(kink) => self.passing_jump(kink, speed, distance, rate),
            EventKind::Law(law) => self.law_jump(law, distance, rate),
        }
    }

    fn event_exponent(&self, event: usize) -> f64 {
        let bearing = match self.event_kind(event) {
            EventKind::LiftOff(ball) => self.bearing_of_ball(ball).map(|(bearing, _)| bearing),
            EventKind::Passing(kink) => self.bearing_of_kink(kink),
            EventKind::Law(_) => None,
        };
        bearing.map_or(1.0, |bearing| bearing.support.lift_off_exponent())
    }
}

/// What an event surface is of, with its number among its like.
enum EventKind {
    /// A ball that lifts off.
    LiftOff(usize),
    /// A ball that passes a kink of a surface.
    Passing(usize),
    /// A law of force that is not smooth there.
    Law(usize),
}

impl Rotor {
    fn event_kind(&self, event: usize) -> EventKind {
        let Some(behind_balls) = event.checked_sub(self.elements.balls_that_lift_off) else {
            return EventKind::LiftOff(event);
        };
        let law = behind_balls.checked_sub(self.passing_event_count());
        law.map_or(EventKind::Passing(behind_balls), EventKind::Law)
    }

    /// Has the works integrated with the motion, so that samples tell of energy.
    pub(crate) fn account_for_energy(&mut self) {
        self.energy = true;
    }

    /// Whether more than the motion is integrated.
    pub(super) fn is_augmented(&self) -> bool {
        self.energy || self.is_driven()
    }

    /// Whether the equations are linear: all forces, and nothing but the motion is integrated.
    pub(crate) fn is_linear(&self) -> bool {
        !self.is_augmented() && self.has_linear_forces()
    }

    /// Whether all forces are linear in displacement and rate, with coefficients that do not change.
    pub(crate) fn has_linear_forces(&self) -> bool {
        let linear = |support: &Support| !support.follows_cage() && !support.is_damped();
        self.elements.laws().next().is_none() && self.elements.supports().all(linear)
    }

    /// Index of the first work among the states.
    pub(super) fn first_work(&self) -> usize {
        2 * self.dofs() + if self.is_driven() { 2 } else { 0 }
    }

    /// Angle and speed in a state at a time; the acceleration of a driven shaft is not known before its moments are.
    #[inline(always)]
    pub(super) fn rotation(&self, time: f64, state: &[f64]) -> Rotation {
        match self.excitation.drive {
            None => self.excitation.speed.at(time),
            Some(_) => Rotation {
                angle: state[2 * self.dofs()],
                speed: state[2 * self.dofs() + 1],
                acceleration: 0.0,
            },
        }
    }

    /// State at t = 0: coordinates that do not belong to the shaft start where its own start from, at rest.
    pub(crate) fn start_state(&self) -> Vec<f64> {
        let (dofs, mut state) = (self.dofs(), vec![0.0; self.states()]);
        if self.start.from == InitialPosition::Equilibrium {
            state[..dofs].copy_from_slice(&self.start.rest[..dofs]);
        }
        // what is given moves the shaft from there as a rigid body
        let [displacement, velocity] = &self.start.shaft;
        let from = self.displacement(&state);
        let shaft = self.structure.shaft.coordinates;
        for (axis, motion) in self.structure.rigid_motions.iter().enumerate() {
            if shaft[axis] >= dofs {
                continue;
            }
            let (moved, rate) = (displacement[axis] - from[axis], velocity[axis]);
            for (dof, part) in motion.iter().take(dofs).enumerate() {
                if *part != 0.0 {
                    state[dof] += moved * part;
                    state[dofs + dof] += rate * part;
                }
            }
            state[shaft[axis]] = displacement[axis];
        }
        if self.is_driven() {
            state[2 * dofs + 1] = self.speed();
        }
        state
    }

    /// The state of this rotor that is like one of the same shaft with other modes: coordinates that it lacks are zero.
    pub(crate) fn state_of(&self, other: &Self, state: &[f64]) -> Vec<f64> {
        let mut own = vec![0.0; self.states()];
        let theirs = &other.structure.coordinates[..other.dofs()];
        for (dof, coordinate) in self.structure.coordinates[..self.dofs()].iter().enumerate() {
            let same = |theirs: &Coordinate| theirs.name == coordinate.name;
            if let Some(index) = theirs.iter().position(same) {
                own[dof] = state[index];
                own[self.dofs() + dof] = state[other.dofs() + index];
            }
        }
        own
    }

    /// Scaling under which deviations from the static equilibrium are numbers of order one.
    pub(crate) fn scaling(&self, scale: &MotionScale) -> Scaling {
        let (dofs, states) = (self.dofs(), self.states());
        // works: kinetic energy of the motion
        let energy = self.structure.shaft_mass * (scale.length * scale.frequency).powi(2);
        let mut scaling = Scaling {
            origin: vec![0.0; states],
            scale: vec![energy; states],
            time: 1.0 / scale.frequency,
        };
        scaling.origin[..dofs].copy_from_slice(&self.start.rest[..dofs]);
        let rate = self.velocity_rate(scale);
        for dof in 0..dofs {
            let length = scale.length / self.structure.coordinates[dof].length(scale.arm);
            scaling.scale[dof] = length;
            scaling.scale[dofs + dof] = length * rate;
        }
        if self.is_driven() {
            scaling.scale[2 * dofs] = 1.0;
            scaling.scale[2 * dofs + 1] = scale.frequency;
        }
        scaling
    }

    /// Second time derivatives of x, y, z, θx, θy of the shaft in a state at a time: those of the equations
    /// themselves. One evaluation of them, for whoever asks; `rate` is room for the derivative.
    pub(crate) fn acceleration(&self, time: f64, state: &[f64], rate: &mut Vec<f64>) -> Vector5 {
        rate.resize(state.len(), 0.0);
        self.derivative(time, state, rate);
        let dofs = self.dofs();
        let rates = self.rate_of_all(&rate[dofs..2 * dofs]);
        self.structure.shaft.rate(&rates)
    }
}
