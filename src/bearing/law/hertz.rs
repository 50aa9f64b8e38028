//! Ball law of two Hertz contacts in series, dry or behind oil films, ball inertia neglected.

use super::film_spring::LubricatedContact;
use super::shares::spring_tangent;
use super::spring::approaches_under;
use super::{
    Ball, BallForce, BallLaw, BallResponse, BallTangent, ContactSpring, FilmLaw, ForceLaw,
    HertzSpring, PointContacts, PreparedContact, RaceFilms,
};
use crate::bearing::number::{Number, Plain};
use crate::bearing::{Bearing, BearingError, Geometry, Oil};

/// Hertz contact of a ball with both races, the ball itself without inertia.
///
/// ```text
/// d = √(A1² + A2²)   δ = d − A − drops   dry:  Q = K_n max(δ, 0)^(3/2)   F_a = Q A1/d   F_r = Q A2/d
///                                   with oil:  δ = (Q/K_n)^(2/3) − h_i(Q) − h_o(Q)
/// ```
///
/// | symbol | meaning | unit |
/// |---|---|---|
/// | A1, A2 | axial and radial distance of the groove centres | m |
/// | A | their distance in the unloaded bearing | m |
/// | Q | load, the same at both races | N |
/// | K_n | load–deflection constant of both races | N/m^1.5 |
/// | h_i, h_o | central film thickness, [`crate::physics::FilmContact`] | m |
///
/// Holds at speeds where centrifugal force is small against the ball load. A separated ball without oil (δ ≤ 0) carries
/// nothing. Films separate the surfaces, so that the slope `dδ/dQ` is the series rule of Hertz and film stiffness. It then
/// has no kink at lift-off: apart, the load decays as gap^(−15). At rest the law is the dry one. The sense of rotation
/// does not matter.
///
/// Source: Harris & Kotzalas, *Rolling Bearing Analysis*, 5th ed. (2007), eqs. 7.5 and 7.20–7.24; B. J. Hamrock &
/// D. Dowson, *J. Lubrication Technology* 99 (1977) 264–276 (thickness).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct HertzLaw<C = HertzSpring> {
    /// Both races in series.
    pub(crate) contact: C,
    /// A, m.
    pub(crate) distance: f64,
    /// Elastic contacts, inner race first.
    springs: [HertzSpring; 2],
    /// Part of the elastic approach that the contact with the inner race has.
    inner_share: f64,
}

/// The law with oil films.
pub type HertzFilmLaw = HertzLaw<LubricatedContact>;

impl HertzLaw {
    /// From the load–deflection constant K_n of both races in series in N/m^1.5 and the unloaded distance A of the
    /// groove centres in m. The races are taken for alike: each contact has half of the approach.
    pub fn new(load_deflection_constant: f64, distance: f64) -> Self {
        let stiffness = load_deflection_constant;
        Self::between(
            HertzSpring { stiffness },
            HertzSpring::halves(stiffness),
            distance,
        )
    }

    /// From the geometry of a bearing and its contacts.
    pub(super) fn from_contacts(geometry: &Geometry, contacts: &PointContacts) -> Self {
        let distance = geometry.groove_centre_distance();
        Self::between(contacts.in_series(), contacts.springs(), distance)
    }
}

impl HertzFilmLaw {
    /// Law of one ball of a bearing; fastest at `prepared_speed` in rad/s, right at every speed.
    ///
    /// # Errors
    /// [`BearingError`] where ball and race form no contact or the oil is none.
    pub fn with_film(
        bearing: &Bearing,
        oil: Oil,
        prepared_speed: f64,
    ) -> Result<Self, BearingError> {
        let contacts = bearing.point_contacts()?;
        let films = RaceFilms::new(bearing, &contacts, &oil)?;
        // equal loads and equal exponents: the two films add up to one
        let film = films.central_constants().iter().sum();
        let contact = LubricatedContact::new(contacts.in_series(), film, prepared_speed);
        let distance = bearing.geometry.groove_centre_distance();
        Ok(Self::between(contact, contacts.springs(), distance))
    }
}

impl<C: PreparedContact> HertzLaw<C> {
    fn between(contact: C, springs: [HertzSpring; 2], distance: f64) -> Self {
        // under one load the approaches are as the stiffnesses to the power −1
        let [inner, outer] = springs.map(|race| race.stiffness_under(1.0));
        Self {
            contact,
            distance,
            springs,
            inner_share: outer / (inner + outer),
        }
    }

    /// Distance d of the groove centres and δ, negative where ball and races are apart.
    #[inline(always)]
    fn distance_and_approach<T: Number>(&self, ball: &Ball<T>) -> (T, T) {
        let distance = (ball.axial * ball.axial + ball.radial * ball.radial).sqrt();
        let [inner, outer] = ball.drop;
        (distance, (distance - self.distance) - (inner + outer))
    }
}

impl<C: PreparedContact> ForceLaw for HertzLaw<C> {
    const HAS_COUPLE: bool = false;

    #[inline(always)]
    fn force<T: Number>(&self, ball: &Ball<T>, speed: f64) -> BallForce<T> {
        self.response(ball, speed).force
    }

    #[inline(always)]
    fn distance_past_lift_off<T: Plain>(&self, ball: &Ball<T>, _place: usize, _speed: f64) -> T {
        if C::Spring::IS_SMOOTH {
            return ball.axial.constant(f64::INFINITY);
        }
        self.distance_and_approach(ball).1
    }
}

impl<C: PreparedContact> BallLaw for HertzLaw<C> {
    type Spring = C::Spring;

    #[inline(always)]
    fn response<T: Number>(&self, ball: &Ball<T>, speed: f64) -> BallResponse<T> {
        // d and δ, then Q(δ)
        let (distance, approach) = self.distance_and_approach(ball);
        let load = self.contact.at_speed(speed).load(approach);
        // F = Q A/d along the line of the groove centres; centres that meet have none, and any serves, for they press on
        // nothing
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

    fn spring(&self, speed: f64) -> C::Spring {
        self.contact.at_speed(speed)
    }

    #[inline(always)]
    fn elastic_approaches<T: Number>(&self, response: &BallResponse<T>) -> [T; 2] {
        if C::Spring::IS_SMOOTH {
            return approaches_under(&self.springs, response.load);
        }
        let pressed = response.approach.positive();
        [
            pressed * self.inner_share,
            pressed * (1.0 - self.inner_share),
        ]
    }
}

impl FilmLaw for HertzFilmLaw {
    fn contact_tangent(&self, ball: &Ball, speed: f64) -> BallTangent {
        let contact = self.contact(ball, speed);
        let load = contact.load_inner;
        let distance = ball.axial.hypot(ball.radial).max(f64::MIN_POSITIVE);
        let stiffness = self.contact.elastic().stiffness_under(load);
        spring_tangent(contact.angle_inner, stiffness, load / distance)
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

    #[test]
    fn balls_on_films_bear_what_others_found() -> Result<(), Box<dyn std::error::Error>> {
        // 7205C, 1000 N thrust, 1000 rad/s: δz = 26.893679 µm gives Q = 260.182616 N.
        let bearing = Bearing::catalogue("7205C")?;
        let oil = Oil {
            viscosity: 0.04,
            pressure_viscosity: 2.2e-8,
        };
        let law = HertzFilmLaw::with_film(&bearing, oil, 1000.0)?;
        let geometry = bearing.geometry;
        let axial = geometry.free_axial() + 26.893679e-6;
        let contact = law.contact(&Ball::at(axial, geometry.free_radial()), 1000.0);
        assert!((contact.load_inner - 260.182616).abs() < 2e-5);
        Ok(())
    }
}
