//! Where balls lift off: the event surfaces, at which the equations of motion are not smooth. A ball's event function
//! is how far it is pressed past its lift-off, m; balls count bearing by bearing from ball 0 on, and those of a bearing
//! whose law is smooth across lift-off do not.

use super::motion::AttachedBearing;
use super::motion_scale::add_sizes;
use super::{Rotation, Rotor};
use crate::bearing::Support;

impl Rotor {
    /// Whether a ball may part from a race, or meet it again, on the motion to come: whether its amplitudes about the
    /// static equilibrium, as they are estimated from unbalance, loads, passing balls, the initial state and the free
    /// vibrations of a start beside the forced motion, reach the lift-off of any ball at any position of the cage; at
    /// the start's speed, at those of the profile and at the highest.
    pub(super) fn balls_may_part(&self) -> bool {
        let cage_turns = self.cage.turns();
        self.balls_that_lift_off > 0
            && self.speeds().any(|speed| {
                let mut amplitudes = self.amplitude_estimate(speed);
                add_sizes(&mut amplitudes, &self.forced_amplitudes(speed));
                self.bearings().any(|bearing| {
                    let place = bearing.displacement(&self.rest[..self.dofs()]);
                    let reach = bearing.attachment.reach(&amplitudes);
                    let reached = std::array::from_fn(|axis| place[axis] + reach[axis]);
                    let support = bearing.support;
                    support.may_part([&place, &reached], speed, cage_turns)
                })
            })
    }

    /// Writes how far every ball is pressed past its lift-off, m.
    pub(super) fn lift_off_distances(
        &self,
        rotation: &Rotation,
        place: &[f64],
        values: &mut [f64],
    ) {
        let mut first = 0;
        for (bearing, seen) in self.bearings_at(rotation) {
            let (support, displacement) = (bearing.support, bearing.displacement(place));
            let last = (first + support.balls_that_lift_off()).min(values.len());
            if first < last {
                support.past_lift_offs(&displacement, &seen, &mut values[first..last]);
            }
            first = last;
        }
    }

    /// Writes the accelerations that a ball so far past its lift-off gives the degrees of freedom at most, m/s² and
    /// rad/s², as the rates of their velocities.
    pub(super) fn lift_off_jump(&self, ball: usize, speed: f64, distance: f64, rate: &mut [f64]) {
        rate.fill(0.0);
        if let Some(bearing) = self.bearing_of_ball(ball) {
            let load = bearing.support.load_past_lift_off(distance, speed);
            self.add_acceleration_by_ball(bearing, load, rate);
        }
    }

    /// The bearing of a ball that lifts off.
    pub(super) fn bearing_of_ball(&self, mut ball: usize) -> Option<AttachedBearing<'_>> {
        self.bearings().find(|bearing| {
            let rest = ball.checked_sub(bearing.support.balls_that_lift_off());
            ball = rest.unwrap_or(ball);
            rest.is_none()
        })
    }

    /// Adds the accelerations that a load of a ball in N gives the degrees of freedom at most.
    pub(super) fn add_acceleration_by_ball(
        &self,
        bearing: AttachedBearing<'_>,
        load: f64,
        rate: &mut [f64],
    ) {
        let moment = load * tilting_arm(bearing.support);
        let bound = [load, load, load, moment, moment];
        let accelerations = &mut rate[self.dofs()..2 * self.dofs()];
        bearing.attachment.add_force(1.0, &bound, accelerations);
        self.mass.accelerate(accelerations);
    }
}

/// Largest arm of a ball's load about the centre of mass, m.
pub(super) fn tilting_arm(support: &Support) -> f64 {
    let definition = support.definition();
    definition.position.abs() + definition.bearing.geometry.inner_groove_radius()
}
