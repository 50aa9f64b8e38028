//! The two springs that a lubricated contact is made of, elastic bodies and oil film: its tangent, one at a time.
//!
//! Both are taken at the loads and angles that the whole law has at the place:
//! - contacts: the law's own tangent with each contact's stiffness that of the elastic bodies,
//!   `3/2 K^(2/3) Q^(1/3)`, the films rigid. The geometric part (Q/d, from the turning of the
//!   line of contact under load) and, with inertia, the yielding of the ball's centre stay in it.
//! - films: `k n nᵀ` with n the normal at the inner race and `1/k = 0.067 (h_i/Q_i + h_o/Q_o)`,
//!   both films in series, the contacts rigid. No geometric part: that is counted once.
//!
//! Along the normal the compliances of both add up to that of the law exactly without inertia.

use super::{Ball, BallContact, BallForce, BallLaw, BallTangent, ForceLaw, RaceFilms};
use crate::bearing::number::{Differentiable, Function, Number, Plain};

/// One of the two springs of a law with films as a law by itself, of which nothing but the slopes count.
pub(in crate::bearing) struct Share<'a, L> {
    law: &'a L,
    /// 0: the contacts; 1: the films.
    part: usize,
    speed: f64,
}

impl<'a, L: BallLaw> Share<'a, L> {
    /// The contacts and the films at a speed in rad/s; none without films, or at rest.
    pub fn of(law: &'a L, speed: f64) -> Option<[Self; 2]> {
        let share = |part| Self { law, part, speed };
        (law.films().is_some() && speed != 0.0).then(|| [share(0), share(1)])
    }
}

impl<L: BallLaw> Function<2, 3> for Share<'_, L> {
    fn values(&self, _at: [f64; 2]) -> [f64; 3] {
        [0.0; 3]
    }
}

impl<L: BallLaw> Differentiable<2, 3> for Share<'_, L> {
    fn with_slopes(&self, [axial, radial]: [f64; 2]) -> ([f64; 3], BallTangent) {
        let ball = Ball::at(axial, radial);
        let tangents = self.law.share_tangents(&ball, self.speed);
        ([0.0; 3], tangents.unwrap_or_default()[self.part])
    }
}

impl<L: BallLaw> ForceLaw for Share<'_, L> {
    const HAS_COUPLE: bool = L::HAS_INERTIA;

    fn force<T: Number>(&self, ball: &Ball<T>, _speed: f64) -> BallForce<T> {
        let [axial, radial, couple] = T::apply(self, [ball.axial, ball.radial]);
        BallForce {
            axial,
            radial,
            couple,
        }
    }

    fn distance_past_lift_off<T: Plain>(&self, ball: &Ball<T>, _speed: f64) -> T {
        ball.axial.constant(f64::INFINITY)
    }
}

/// Tangent of the films of both races with rigid contacts.
pub(super) fn film_tangent(films: &RaceFilms, contact: &BallContact, speed: f64) -> BallTangent {
    let loads = [contact.load_inner, contact.load_outer];
    let stiffness = in_series(films.stiffness(loads, speed));
    spring_tangent(contact.angle_inner, stiffness, 0.0)
}

fn in_series(stiffness: [f64; 2]) -> f64 {
    // 1/k = 1/k_i + 1/k_o
    1.0 / (1.0 / stiffness[0] + 1.0 / stiffness[1])
}

/// `k n nᵀ + k_t t tᵀ`, n = (sin α, cos α), t = (cos α, −sin α).
pub(super) fn spring_tangent(angle: f64, along: f64, across: f64) -> BallTangent {
    let (sin, cos) = angle.sin_cos();
    let mixed = (along - across) * sin * cos;
    [
        [along * sin * sin + across * cos * cos, mixed],
        [mixed, along * cos * cos + across * sin * sin],
        [0.0, 0.0],
    ]
}
