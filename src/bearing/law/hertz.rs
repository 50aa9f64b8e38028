//! Ball law of two Hertz contacts in series, ball inertia neglected.

use super::{Ball, BallForce, BallLaw, BallResponse, ForceLaw, HertzSpring, RaceContacts};
use crate::bearing::Geometry;
use crate::bearing::number::{Number, Plain};

/// Hertz contact of a ball with both races, the ball itself without inertia.
///
/// ```text
/// d = √(A1² + A2²)   δ = d − A − h_i − h_o   Q = K_n max(δ, 0)^(3/2)   F_a = Q A1/d   F_r = Q A2/d
/// ```
///
/// `A1`, `A2` position of the inner groove centre from the outer one in m, `A` their unloaded
/// distance in m, `h` drops of the surfaces under the ball in m, `K_n` in N/m^1.5. Holds at speeds where
/// centrifugal force is small against the ball load. A separated ball (δ ≤ 0) carries nothing.
///
/// Source: Harris & Kotzalas, *Rolling Bearing Analysis*, 5th ed. (2007), eqs. 7.5 and 7.20–7.24.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct HertzLaw {
    /// K_n, N/m^1.5.
    pub(crate) load_deflection_constant: f64,
    /// A, m.
    pub(crate) distance: f64,
    /// Part of the approach that the contact with the inner race has.
    inner_share: f64,
}

impl HertzLaw {
    /// From the load–deflection constant K_n of both races in series in N/m^1.5 and the unloaded distance A of the
    /// groove centres in m. The races are taken for alike: each contact has half of the approach.
    pub fn new(load_deflection_constant: f64, distance: f64) -> Self {
        Self {
            load_deflection_constant,
            distance,
            inner_share: 0.5,
        }
    }

    /// From the geometry of a bearing and its contacts.
    pub(super) fn from_contacts(geometry: &Geometry, contacts: &RaceContacts) -> Self {
        // under one load the approaches are as the stiffnesses to the power −1
        let [inner, outer] = contacts.springs().map(|race| race.stiffness_under(1.0));
        Self {
            inner_share: outer / (inner + outer),
            ..Self::new(
                contacts.in_series().stiffness,
                geometry.groove_centre_distance(),
            )
        }
    }
}

/// Distance d of the groove centres, whose unloaded distance is given, and δ, negative where ball and races are apart.
#[inline(always)]
pub(super) fn distance_and_approach<T: Number>(ball: &Ball<T>, unloaded: f64) -> (T, T) {
    let distance = (ball.axial * ball.axial + ball.radial * ball.radial).sqrt();
    let [inner, outer] = ball.drop;
    (distance, (distance - unloaded) - (inner + outer))
}

/// Response of a ball without inertia, both of whose loads lie on the line of the groove centres.
#[inline(always)]
pub(super) fn on_line_of_centres<T: Number>(
    ball: &Ball<T>,
    distance: T,
    load: T,
    approach: T,
) -> BallResponse<T> {
    // centres that meet have no line; any serves, for they press on nothing
    let lateral = load / (distance + f64::MIN_POSITIVE);
    BallResponse {
        force: BallForce {
            axial: lateral * ball.axial,
            radial: lateral * ball.radial,
            couple: load.constant(0.0),
        },
        load: [load; 2],
        approach,
    }
}

impl ForceLaw for HertzLaw {
    const HAS_COUPLE: bool = false;

    #[inline(always)]
    fn force<T: Number>(&self, ball: &Ball<T>, speed: f64) -> BallForce<T> {
        self.response(ball, speed).force
    }

    #[inline(always)]
    fn distance_past_lift_off<T: Plain>(&self, ball: &Ball<T>, _speed: f64) -> T {
        distance_and_approach(ball, self.distance).1
    }
}

impl BallLaw for HertzLaw {
    type Spring = HertzSpring;

    #[inline(always)]
    fn response<T: Number>(&self, ball: &Ball<T>, _speed: f64) -> BallResponse<T> {
        let (distance, approach) = distance_and_approach(ball, self.distance);
        let pressed = approach.positive();
        // Q = K_n δ^(3/2)
        let load = pressed * self.load_deflection_constant * pressed.sqrt();
        on_line_of_centres(ball, distance, load, approach)
    }

    fn spring(&self, _speed: f64) -> HertzSpring {
        HertzSpring {
            stiffness: self.load_deflection_constant,
        }
    }

    #[inline(always)]
    fn elastic_approaches<T: Number>(&self, response: &BallResponse<T>) -> [T; 2] {
        let pressed = response.approach.positive();
        [
            pressed * self.inner_share,
            pressed * (1.0 - self.inner_share),
        ]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn balls_under_thrust_bear_what_others_found() {
        // 7205C under 1000 N of thrust (independent implementations): α = 19.35927°, δz = 31.97643 µm,
        // so each of the 12 balls carries Q = 1000/(12 sin α) = 251.39 N.
        let (distance, angle) = (0.396_9e-3, 15f64.to_radians());
        let law = HertzLaw::new(273_580.37 * 10f64.powf(4.5), distance);
        let ball = Ball::at(distance * angle.sin() + 31.97643e-6, distance * angle.cos());
        let ball = law.contact(&ball, 0.0);
        assert!((ball.load_inner - 251.39).abs() < 5e-3);
        assert!((ball.angle_inner.to_degrees() - 19.35927).abs() < 1e-5);
    }
}
