//! Where balls lift off: the event surfaces, at which the equations of motion are not smooth. A ball's event function
//! is how far it is pressed past its lift-off, m; balls count bearing by bearing from ball 0 on, and those of a bearing
//! whose law is smooth across lift-off do not.

use super::Rotor;
use super::element::{AttachedBearing, Instant, seen_by};

impl Rotor {
    /// Writes how far every ball is pressed past its lift-off, m.
    pub(super) fn lift_off_distances(&self, at: &Instant<'_>, values: &mut [f64]) {
        let mut rest = values;
        for bearing in self.elements.bearings() {
            let support = bearing.support;
            let (own, others) = rest.split_at_mut(support.balls_that_lift_off());
            rest = others;
            if !own.is_empty() {
                let displacement = bearing.attachment.displacement(at.place, at.rest);
                let rotation = seen_by(support, at.rotation, &at.phases);
                support.past_lift_offs(&displacement, &rotation, own);
            }
        }
    }

    /// How far one of the balls is pressed past its lift-off, m.
    pub(super) fn lift_off_distance(&self, at: &Instant<'_>, ball: usize) -> f64 {
        let Some((bearing, own)) = self.bearing_of_ball(ball) else {
            return f64::INFINITY;
        };
        let displacement = bearing.attachment.displacement(at.place, at.rest);
        let rotation = seen_by(bearing.support, at.rotation, &at.phases);
        bearing.support.past_lift_off(&displacement, &rotation, own)
    }

    /// Writes the accelerations that a ball so far past its lift-off gives the degrees of freedom at most, m/s² and
    /// rad/s², as the rates of their velocities.
    pub(super) fn lift_off_jump(&self, ball: usize, speed: f64, distance: f64, rate: &mut [f64]) {
        rate.fill(0.0);
        if let Some((bearing, _)) = self.bearing_of_ball(ball) {
            let load = bearing.support.load_past_lift_off(distance, speed);
            self.add_acceleration_by_ball(bearing, load, rate);
        }
    }

    /// The bearing of a ball that lifts off, and the number of the ball there.
    pub(super) fn bearing_of_ball(&self, mut ball: usize) -> Option<(AttachedBearing<'_>, usize)> {
        let mut bearings = self.elements.bearings();
        let bearing = bearings.find(|bearing| {
            let rest = ball.checked_sub(bearing.support.balls_that_lift_off());
            ball = rest.unwrap_or(ball);
            rest.is_none()
        })?;
        Some((bearing, ball))
    }

    /// Adds the accelerations that a load of a ball in N gives the degrees of freedom at most.
    pub(super) fn add_acceleration_by_ball(
        &self,
        bearing: AttachedBearing<'_>,
        load: f64,
        rate: &mut [f64],
    ) {
        let geometry = &bearing.support.definition().bearing.geometry;
        let moment = load * geometry.lever();
        let bound = [load, load, load, moment, moment];
        let accelerations = &mut rate[self.dofs()..2 * self.dofs()];
        bearing.attachment.add_force_bound(&bound, accelerations);
        self.linear.mass.accelerate(accelerations);
    }
}
