//! Where balls lift off: the surfaces at which the equations of motion are not smooth.

use super::{CageMotion, FREEDOMS, Rotation, Rotor};
use crate::bearing::{Support, Vector5};
use crate::integrate::Surroundings;

impl Rotor {
    /// Whether a ball may part from a race, or meet it again, on the motion to come: whether its amplitudes about the
    /// static equilibrium, as they are estimated from unbalance, loads, passing balls and the initial state, reach
    /// the lift-off of any ball at any position of the cage; at the start's speed, at those of the profile and at the
    /// highest.
    pub(super) fn balls_may_part(&self) -> bool {
        let place = self.equilibrium.displacement;
        let speeds = self.speed.points().map(|point| point.speed);
        let mut speeds = speeds.chain([self.highest_speed()]);
        self.lifts_off
            && speeds.any(|speed| {
                let amplitude = self.amplitude_estimate(speed);
                let reached = std::array::from_fn(|axis| place[axis] + amplitude[axis]);
                let cage_turns = self.cage == CageMotion::Rolling;
                let may_part =
                    |support: &Support| support.may_part([&place, &reached], speed, cage_turns);
                self.supports.iter().any(may_part)
            })
    }

    /// The balls about their lift-off, a bit for each that is pressed, bearing by bearing from ball 0 on;
    /// of a bearing whose law is smooth across lift-off none.
    pub(super) fn lift_offs(&self, rotation: &Rotation, place: &[f64]) -> Surroundings {
        let mut seen = Surroundings::SMOOTH;
        if !self.lifts_off {
            return seen;
        }
        let displacement = self.full(&self.equilibrium.displacement, place);
        let mut first = 0;
        self.for_each_support(rotation.angle, &self.phases(rotation), |support, cage| {
            let balls = support.lift_offs(&displacement, cage, rotation.speed);
            seen.sides |= balls.pressed.checked_shl(first).unwrap_or(0);
            seen.nearest = seen.nearest.min(balls.nearest);
            first += support.balls_that_lift_off();
        });
        seen
    }

    /// How far a ball, counted as in [`Rotor::lift_offs`], is pressed past its lift-off, m.
    pub(super) fn past_lift_off(&self, ball: u32, rotation: &Rotation, place: &[f64]) -> f64 {
        let displacement = self.full(&self.equilibrium.displacement, place);
        let (mut past, mut first) = (f64::INFINITY, 0);
        self.for_each_support(rotation.angle, &self.phases(rotation), |support, cage| {
            let count = support.balls_that_lift_off();
            if (first..first + count).contains(&ball) {
                let ball = (ball - first) as usize;
                past = support.past_lift_off(ball, &displacement, cage, rotation.speed);
            }
            first += count;
        });
        past
    }

    /// No ball comes nearer to its lift-off by more than this from one place of the shaft to another;
    /// infinite where the speed is not the same, for it has a part in where a ball lifts off.
    pub(super) fn approach_to_lift_off(
        &self,
        rotations: [&Rotation; 2],
        places: [&[f64]; 2],
    ) -> f64 {
        let [from, to] = rotations;
        if from.speed != to.speed {
            return f64::INFINITY;
        }
        let ends = places.map(|place| self.full(&self.equilibrium.displacement, place));
        let turn = to.angle - from.angle;
        let approach = |support: &Support| {
            support.approach_to_lift_off(ends.each_ref(), self.cage_ratio(support) * turn)
        };
        self.supports.iter().map(approach).fold(0.0, f64::max)
    }

    /// Distance that all balls have from their lift-off at a place, wherever the cages stand, m; not positive where
    /// that is not known.
    pub(super) fn clearance(&self, place: &[f64]) -> f64 {
        let displacement = self.full(&self.equilibrium.displacement, place);
        let clearance = |support: &Support| support.clearance(&displacement);
        let all = self.supports.iter().map(clearance);
        all.fold(f64::INFINITY, f64::min)
    }

    /// No ball comes nearer to its lift-off by more than this as the shaft goes from one place to another while the
    /// cages stand, m; infinite where a ring floats.
    pub(super) fn shift_to_lift_off(&self, places: [&[f64]; 2]) -> f64 {
        let ends = places.map(|place| self.full(&self.equilibrium.displacement, place));
        let shift = |support: &Support| support.approach_to_lift_off(ends.each_ref(), 0.0);
        self.supports.iter().map(shift).fold(0.0, f64::max)
    }

    /// Accelerations that a ball so far past its lift-off gives the kept freedoms at most, m/s² and
    /// rad/s².
    pub(super) fn added_past_lift_off(&self, ball: u32, speed: f64, distance: f64) -> Vector5 {
        let mut first = 0;
        for support in &self.supports {
            let count = support.balls_that_lift_off();
            if (first..first + count).contains(&ball) {
                let load = support.load_past_lift_off(distance, speed);
                let arm = tilting_arm(support);
                return std::array::from_fn(|axis| {
                    let lever = if axis < 3 { 1.0 } else { arm };
                    load * lever * self.inverse_mass[axis]
                });
            }
            first += count;
        }
        [0.0; FREEDOMS]
    }
}

/// Largest arm of a ball's load about the centre of mass, m.
fn tilting_arm(support: &Support) -> f64 {
    let definition = support.definition();
    definition.position.abs() + definition.bearing.geometry.inner_groove_radius()
}
