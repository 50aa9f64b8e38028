//! The two springs that a lubricated contact is made of: elastic bodies and oil film.

use super::ball_law::{BallLaw, BallTangent};
use super::{HertzFilmLaw, JonesFilmLaw};

/// A law whose balls bear by elastic contacts behind oil films: its tangent, one spring at a time.
///
/// Both are taken at the loads and angles that the whole law has at the place:
/// - contacts: the law's own tangent with each contact's stiffness that of the elastic bodies,
///   `3/2 K^(2/3) Q^(1/3)`, the films rigid. The geometric part (Q/d, from the turning of the
///   line of contact under load) and, with inertia, the yielding of the ball's centre stay in it.
/// - films: `k n nᵀ` with n the normal at the inner race and `1/k = 0.067 (h_i/Q_i + h_o/Q_o)`,
///   both films in series, the contacts rigid. No geometric part: that is counted once.
///
/// Along the normal the compliances of both add up to that of the law exactly without inertia.
pub(super) trait FilmShares: BallLaw {
    /// Tangent with rigid films.
    fn contact_tangent(&self, axial: f64, radial: f64, speed: f64) -> BallTangent;

    /// Tangent with rigid contacts.
    fn film_tangent(&self, axial: f64, radial: f64, speed: f64) -> BallTangent;
}

impl FilmShares for HertzFilmLaw {
    fn contact_tangent(&self, axial: f64, radial: f64, speed: f64) -> BallTangent {
        let contact = self.contact(axial, radial, speed);
        let distance = axial.hypot(radial).max(f64::MIN_POSITIVE);
        let stiffness = self.elastic_stiffness(contact.load_inner);
        spring_tangent(
            contact.angle_inner,
            stiffness,
            contact.load_inner / distance,
        )
    }

    fn film_tangent(&self, axial: f64, radial: f64, speed: f64) -> BallTangent {
        let contact = self.contact(axial, radial, speed);
        let loads = [contact.load_inner, contact.load_outer];
        let stiffness = in_series(self.films().stiffness(loads, speed));
        spring_tangent(contact.angle_inner, stiffness, 0.0)
    }
}

impl FilmShares for JonesFilmLaw {
    fn contact_tangent(&self, axial: f64, radial: f64, speed: f64) -> BallTangent {
        self.rigid_film_tangent(axial, radial, speed)
    }

    fn film_tangent(&self, axial: f64, radial: f64, speed: f64) -> BallTangent {
        let contact = self.contact(axial, radial, speed);
        let loads = [contact.load_inner, contact.load_outer];
        let stiffness = in_series(self.films().stiffness(loads, speed));
        spring_tangent(contact.angle_inner, stiffness, 0.0)
    }
}

fn in_series(stiffness: [f64; 2]) -> f64 {
    // 1/k = 1/k_i + 1/k_o
    1.0 / (1.0 / stiffness[0] + 1.0 / stiffness[1])
}

/// `k n nᵀ + k_t t tᵀ`, n = (sin α, cos α), t = (cos α, −sin α).
fn spring_tangent(angle: f64, along: f64, across: f64) -> BallTangent {
    let (sin, cos) = angle.sin_cos();
    let mixed = (along - across) * sin * cos;
    [
        [along * sin * sin + across * cos * cos, mixed],
        [mixed, along * cos * cos + across * sin * sin],
        [0.0, 0.0],
    ]
}
