//! Hertz contact and oil film of both races in series: the law of a ball without inertia.

use super::contact_spring::ContactSpring;
use super::film_spring::{FilmSpring, LubricatedContact};
use super::races::RaceFilms;
use super::{BallContact, BallForce, BallLaw, BallTangent, Bearing, BearingError, LoadSlope, Oil};

/// Law of a ball between two lubricated races, its inertia neglected.
///
/// ```text
/// d = √(A1² + A2²)   δ = d − A   δ = (Q/K_n)^(2/3) − h_i(Q) − h_o(Q)
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
///
/// ```
/// use jeffcott::bearing::{BallLaw, HertzFilmLaw, Oil, catalogue};
/// // 7205C, 1000 N thrust, 1000 rad/s: δz = 26.893679 µm gives Q = 260.182616 N.
/// let bearing = catalogue::find("7205C").unwrap().bearing()?;
/// let oil = Oil { viscosity: 0.04, pressure_viscosity: 2.2e-8 };
/// let law = HertzFilmLaw::new(&bearing, oil, 1000.0)?;
/// let geometry = bearing.geometry;
/// let axial = geometry.free_axial() + 26.893679e-6;
/// let contact = law.contact(axial, geometry.free_radial(), 1000.0);
/// assert!((contact.load_inner - 260.182616).abs() < 2e-5);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct HertzFilmLaw {
    free_distance: f64,
    contact: LubricatedContact,
    prepared_speed: f64,
    prepared: FilmSpring,
    films: RaceFilms,
}

impl HertzFilmLaw {
    /// Law of one ball of a bearing; fastest at `prepared_speed` in rad/s, right at every speed.
    ///
    /// # Errors
    /// [`BearingError`] where ball and races form no contact or the oil is none.
    pub fn new(bearing: &Bearing, oil: Oil, prepared_speed: f64) -> Result<Self, BearingError> {
        let contacts = [bearing.inner_contact()?, bearing.outer_contact()?];
        let films = RaceFilms::new(bearing, &contacts, &oil)?;
        // equal loads and equal exponents: the two films add up to one
        let contact = LubricatedContact::new(
            bearing.load_deflection_constant()?,
            films.central_constants().iter().sum(),
        );
        Ok(Self {
            free_distance: bearing.geometry.groove_centre_distance(),
            contact,
            prepared_speed,
            prepared: contact.at_speed(prepared_speed),
            films,
        })
    }

    /// Oil films of both races: their thickness under the loads of a [`BallContact`].
    pub fn films(&self) -> &RaceFilms {
        &self.films
    }

    /// Stiffness of both elastic contacts in series under a load in N, N/m.
    pub(super) fn elastic_stiffness(&self, load: f64) -> f64 {
        self.contact.elastic().stiffness_under(load)
    }

    /// Both races and their films in series at a shaft speed in rad/s.
    #[inline]
    pub(super) fn spring(&self, speed: f64) -> FilmSpring {
        if speed == self.prepared_speed {
            self.prepared
        } else {
            self.contact.at_speed(speed)
        }
    }

    /// Distance of the groove centres in m, load in N and its derivative by the distance in N/m.
    #[inline]
    fn solve(&self, axial: f64, radial: f64, speed: f64) -> (f64, f64, f64) {
        let spring = self.spring(speed);
        // coinciding centres have no line of centres; any serves, for they press on nothing
        let distance = (axial * axial + radial * radial)
            .sqrt()
            .max(f64::MIN_POSITIVE);
        let (load, stiffness) = spring.load_and_stiffness(distance - self.free_distance);
        (distance, load, stiffness)
    }
}

impl BallLaw for HertzFilmLaw {
    fn force(&self, axial: f64, radial: f64, speed: f64) -> BallForce {
        let (distance, load, _) = self.solve(axial, radial, speed);
        BallForce {
            axial: load * (axial / distance),
            radial: load * (radial / distance),
            couple: 0.0,
        }
    }

    fn force_and_tangent(&self, axial: f64, radial: f64, speed: f64) -> (BallForce, BallTangent) {
        let (distance, load, stiffness) = self.solve(axial, radial, speed);
        let (sin, cos) = (axial / distance, radial / distance);
        // ∂F/∂A = k n nᵀ + (Q/d) t tᵀ,  n = (sin α, cos α), t = (cos α, −sin α)
        let across = load / distance;
        let mixed = (stiffness - across) * sin * cos;
        let force = BallForce {
            axial: load * sin,
            radial: load * cos,
            couple: 0.0,
        };
        let tangent = [
            [stiffness * sin * sin + across * cos * cos, mixed],
            [mixed, stiffness * cos * cos + across * sin * sin],
            [0.0, 0.0],
        ];
        (force, tangent)
    }

    fn load_slopes(&self, axial: f64, radial: f64, speed: f64) -> [LoadSlope; 2] {
        let (distance, load, stiffness) = self.solve(axial, radial, speed);
        let by_place = [stiffness * axial / distance, stiffness * radial / distance];
        [LoadSlope { load, by_place }; 2]
    }

    fn contact(&self, axial: f64, radial: f64, speed: f64) -> BallContact {
        let (distance, load, _) = self.solve(axial, radial, speed);
        let angle = axial.atan2(radial);
        BallContact {
            approach: distance - self.free_distance,
            load_inner: load,
            load_outer: load,
            angle_inner: angle,
            angle_outer: angle,
        }
    }
}
