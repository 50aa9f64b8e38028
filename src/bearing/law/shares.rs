//! The two springs that a law with films is made of, elastic bodies and oil films, each by itself.

use super::{Ball, BallContact, BallForce, BallTangent, FilmLaw, ForceLaw, RaceFilms};
use crate::bearing::number::{Function, Number};

/// One of the two springs of a law with films, elastic bodies or oil film, as a law by itself, of which nothing but the
/// slopes count.
///
/// Both are taken at the loads and angles that the whole law has at the position of the ball:
/// - contacts: the law's own tangent with each contact's stiffness that of the elastic bodies,
///   `3/2 K^(2/3) Q^(1/3)`, the films rigid. The geometric part (Q/d, from the turning of the
///   line of contact under load) and, with inertia, the yielding of the ball's centre stay in it.
/// - films: `k n nᵀ` with n the normal at the inner race and `1/k = 0.067 (h_i/Q_i + h_o/Q_o)`,
///   both films in series, the contacts rigid. No geometric part: that is counted once.
///
/// Along the normal the compliances of both add up to that of the law exactly without inertia.
pub(in crate::bearing) struct Share<'a, L> {
    law: &'a L,
    /// The films, where they are the part that is asked for.
    films: Option<&'a RaceFilms>,
    speed: f64,
}

impl<'a, L: FilmLaw> Share<'a, L> {
    /// The contacts and the films of a law at a speed in rad/s.
    pub fn both(law: &'a L, films: &'a RaceFilms, speed: f64) -> [Self; 2] {
        [None, Some(films)].map(|films| Self { law, films, speed })
    }
}

impl<L: FilmLaw> Function<2, 3> for Share<'_, L> {
    fn with_slopes(&self, [axial, radial]: [f64; 2]) -> ([f64; 3], BallTangent) {
        let (ball, speed) = (Ball::at(axial, radial), self.speed);
        let tangent = match self.films {
            None => self.law.contact_tangent(&ball, speed),
            Some(films) => film_tangent(films, &self.law.contact(&ball, speed), speed),
        };
        ([0.0; 3], tangent)
    }
}

impl<L: FilmLaw> ForceLaw for Share<'_, L> {
    const HAS_COUPLE: bool = L::HAS_COUPLE;

    fn force<T: Number>(&self, ball: &Ball<T>, _speed: f64) -> BallForce<T> {
        T::apply(self, [ball.axial, ball.radial]).into()
    }
}

/// Tangent of the films of both races with rigid contacts.
fn film_tangent(films: &RaceFilms, contact: &BallContact, speed: f64) -> BallTangent {
    let [inner, outer] = films.stiffness([contact.load_inner, contact.load_outer], speed);
    // 1/k = 1/k_i + 1/k_o
    spring_tangent(contact.angle_inner, 1.0 / (1.0 / inner + 1.0 / outer), 0.0)
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
