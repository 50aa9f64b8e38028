//! Where balls lift off: the surfaces at which the equations of motion are not smooth.

use super::{CageMotion, FREEDOMS, Rotation, Rotor};
use crate::bearing::{Support, Vector5};
use crate::integrate::{Sides, Surroundings};

impl Rotor {
    /// Whether a ball may part from a race, or meet it again, on the motion to come: whether its amplitudes about the
    /// static equilibrium, as they are estimated from unbalance, loads, passing balls and the initial state, reach
    /// the lift-off of any ball at any position of the cage; at the start's speed, at those of the profile and at the
    /// highest.
    pub(super) fn balls_may_part(&self) -> bool {
        let place = self.equilibrium.displacement;
        let speeds = self.speed.points().map(|point| point.speed);
        let mut speeds = speeds.chain([self.highest_speed()]);
        self.balls_that_lift_off > 0
            && speeds.any(|speed| {
                let amplitude = self.amplitude_estimate(speed);
                let reached = std::array::from_fn(|axis| place[axis] + amplitude[axis]);
                let cage_turns = self.cage == CageMotion::Rolling;
                let may_part =
                    |support: &Support| support.may_part([&place, &reached], speed, cage_turns);
                self.supports.iter().any(may_part)
            })
    }

    /// Leaves how far each ball is pressed past its lift-off, m, in `past`: bearing by bearing from ball 0 on, none of a
    /// bearing whose law is smooth across lift-off.
    fn past_lift_offs(&self, rotation: &Rotation, place: &[f64], past: &mut [f64]) {
        let displacement = self.full(&self.equilibrium.displacement, place);
        let mut first = 0;
        self.for_each_support(rotation, &self.phases(rotation), |support, rotation| {
            let last = (first + support.balls_that_lift_off()).min(past.len());
            if first < last {
                support.past_lift_offs(&displacement, rotation, &mut past[first..last]);
            }
            first = last;
        });
    }

    /// The balls about their lift-off, a bit for each that is pressed, counted as in [`Rotor::past_lift_offs`].
    pub(super) fn lift_offs(&self, rotation: &Rotation, place: &[f64]) -> Surroundings {
        let mut seen = Surroundings::SMOOTH;
        if self.balls_that_lift_off == 0 {
            return seen;
        }
        let mut past = [0.0; Sides::BITS as usize];
        let count = self.balls_that_lift_off.min(past.len());
        self.past_lift_offs(rotation, place, &mut past[..count]);
        for (group, past) in past[..count].chunks(u32::BITS as usize).enumerate() {
            let mut sides = 0;
            for (ball, past) in past.iter().enumerate() {
                sides |= u32::from(past.is_sign_positive()) << ball;
                seen.nearest = seen.nearest.min(past.abs());
            }
            seen.sides |= Sides::from(sides) << (u32::BITS * group as u32);
        }
        seen
    }

    /// How far a ball, counted as there, is pressed past its lift-off, m.
    pub(super) fn past_lift_off(&self, ball: u32, rotation: &Rotation, place: &[f64]) -> f64 {
        let displacement = self.full(&self.equilibrium.displacement, place);
        let (mut past, mut first) = (f64::INFINITY, 0);
        self.for_each_support(rotation, &self.phases(rotation), |support, rotation| {
            let next = first + support.balls_that_lift_off();
            if (first..next).contains(&(ball as usize)) {
                past = support.past_lift_off(ball as usize - first, &displacement, rotation);
            }
            first = next;
        });
        past
    }

    /// No ball comes nearer to its lift-off by more than this from one place of the shaft to another.
    pub(super) fn approach_to_lift_off(
        &self,
        [from, to]: [&Rotation; 2],
        places: [&[f64]; 2],
    ) -> f64 {
        let ends = places.map(|place| self.full(&self.equilibrium.displacement, place));
        let (speeds, turn) = ([from.speed, to.speed], to.angle - from.angle);
        let approach = |support: &Support| {
            let turn = self.cage_ratio(support) * turn;
            support.approach_to_lift_off(ends.each_ref(), speeds, turn)
        };
        self.supports.iter().map(approach).fold(0.0, f64::max)
    }

    /// Accelerations that a ball so far past its lift-off gives the kept freedoms at most, m/s² and
    /// rad/s².
    pub(super) fn added_past_lift_off(&self, ball: u32, speed: f64, distance: f64) -> Vector5 {
        let mut first = 0;
        for support in &self.supports {
            let count = support.balls_that_lift_off();
            if (first..first + count).contains(&(ball as usize)) {
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
