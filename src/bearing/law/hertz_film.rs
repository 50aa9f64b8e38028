//! Hertz contact and oil film of both races in series: the law of a ball without inertia.

use super::film_spring::{FilmSpring, LubricatedContact};
use super::hertz::{distance_and_approach, on_line_of_centres};
use super::shares::spring_tangent;
use super::spring::approaches_under;
use super::{
    Ball, BallForce, BallLaw, BallResponse, BallTangent, FilmLaw, ForceLaw, HertzSpring, RaceFilms,
};
use crate::bearing::number::Number;
use crate::bearing::{Bearing, BearingError, Oil};

/// Law of a ball between two lubricated races, its inertia neglected.
///
/// ```text
/// d = √(A1² + A2²)   δ = d − A − drops   δ = (Q/K_n)^(2/3) − h_i(Q) − h_o(Q)
/// F_a = Q A1/d       F_r = Q A2/d
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
/// The films separate the surfaces, so that the slope `dδ/dQ` is the series rule of Hertz and
/// film stiffness. It has no kink at lift-off: apart, the load decays as gap^(−15). At rest
/// the law is the dry one. The sense of rotation does not matter.
///
/// Source: B. J. Hamrock & D. Dowson, *J. Lubrication Technology* 99 (1977) 264–276 (thickness);
/// Harris & Kotzalas, *Rolling Bearing Analysis*, 5th ed. (2007), ch. 7 (races in series).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct HertzFilmLaw {
    free_distance: f64,
    /// Both races in series.
    contact: LubricatedContact,
    /// Elastic contacts, inner race first.
    springs: [HertzSpring; 2],
    films: RaceFilms,
}

impl HertzFilmLaw {
    /// Law of one ball of a bearing; fastest at `prepared_speed` in rad/s, right at every speed.
    ///
    /// # Errors
    /// [`BearingError`] where ball and race form no contact or the oil is none.
    pub fn new(bearing: &Bearing, oil: Oil, prepared_speed: f64) -> Result<Self, BearingError> {
        let contacts = bearing.contacts()?;
        let films = RaceFilms::new(bearing, &contacts, &oil)?;
        // equal loads and equal exponents: the two films add up to one
        let film = films.central_constants().iter().sum();
        Ok(Self {
            free_distance: bearing.geometry.groove_centre_distance(),
            contact: LubricatedContact::new(contacts.in_series(), film, prepared_speed),
            springs: contacts.springs(),
            films,
        })
    }
}

impl ForceLaw for HertzFilmLaw {
    const HAS_COUPLE: bool = false;

    #[inline(always)]
    fn force<T: Number>(&self, ball: &Ball<T>, speed: f64) -> BallForce<T> {
        self.response(ball, speed).force
    }
}

impl BallLaw for HertzFilmLaw {
    type Spring = FilmSpring;

    #[inline(always)]
    fn response<T: Number>(&self, ball: &Ball<T>, speed: f64) -> BallResponse<T> {
        let (distance, approach) = distance_and_approach(ball, self.free_distance);
        let [load] = T::apply(&self.contact.at_speed(speed), [approach]);
        on_line_of_centres(ball, distance, load, approach)
    }

    fn spring(&self, speed: f64) -> FilmSpring {
        self.contact.at_speed(speed)
    }

    fn elastic_approaches<T: Number>(&self, response: &BallResponse<T>) -> [T; 2] {
        approaches_under(&self.springs, response.load)
    }
}

impl FilmLaw for HertzFilmLaw {
    fn films(&self) -> &RaceFilms {
        &self.films
    }

    fn contact_tangent(&self, ball: &Ball, speed: f64) -> BallTangent {
        let contact = self.contact(ball, speed);
        let load = contact.load_inner;
        let distance = ball.axial.hypot(ball.radial).max(f64::MIN_POSITIVE);
        let stiffness = self.contact.elastic.stiffness_under(load);
        spring_tangent(contact.angle_inner, stiffness, load / distance)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn balls_on_films_bear_what_others_found() -> Result<(), Box<dyn std::error::Error>> {
        // 7205C, 1000 N thrust, 1000 rad/s: δz = 26.893679 µm gives Q = 260.182616 N.
        let bearing = Bearing::catalogue("7205C")?;
        let oil = Oil {
            viscosity: 0.04,
            pressure_viscosity: 2.2e-8,
        };
        let law = HertzFilmLaw::new(&bearing, oil, 1000.0)?;
        let geometry = bearing.geometry;
        let axial = geometry.free_axial() + 26.893679e-6;
        let contact = law.contact(&Ball::at(axial, geometry.free_radial()), 1000.0);
        assert!((contact.load_inner - 260.182616).abs() < 2e-5);
        Ok(())
    }
}
