//! The law of a ball with inertia: construction and force.

use nalgebra::Vector2;

use super::balance::Ball;
use super::inertia::InertiaLaw;
use super::solve::Rest;
use super::start::StartConstants;
use super::state::{BallState, SpinResistance, contact_of};
use crate::bearing::film_spring::LubricatedContact;
use crate::bearing::races::{DryRaces, LubricatedRaces, RaceFilms, Races};
use crate::bearing::{
    BallContact, BallForce, BallLaw, BallTangent, Bearing, BearingError, LoadSlope, Oil,
};
use crate::physics::{HertzContact, RaceControl, ball_mass};

/// Law of a ball with centrifugal force and gyroscopic moment.
///
/// The ball's centre (X1, X2), measured from the outer groove centre, is where the forces on the
/// ball balance:
///
/// ```text
/// L_o = √(X1² + X2²) = (f_o − ½)D + s_o(Q_o)
/// L_i = √((A1 − X1)² + (A2 − X2)²) = (f_i − ½)D + s_i(Q_i)
/// Q_i sin α_i − Q_o sin α_o + T_i cos α_i − T_o cos α_o       = 0
/// Q_i cos α_i − Q_o cos α_o − T_i sin α_i + T_o sin α_o + F_c = 0
/// F_c = ½ m_b d_m ω_m²   M_g = J |ω_R| ω_m sin β   T = λ M_g/D
/// F_a = Q_i sin α_i + T_i cos α_i   F_r = Q_i cos α_i − T_i sin α_i   couple = −λ_i f_i M_g
/// ```
///
/// | symbol | meaning | unit |
/// |---|---|---|
/// | A1, A2 | axial and radial distance of the groove centres | m |
/// | Q, α, T | normal load, contact angle, friction force at a race | N, rad, N |
/// | s(Q) | approach: Hertz, less the film thickness where there is oil | m |
/// | f, D, d_m | groove factor, ball and pitch diameter | –, m, m |
/// | ω_m, ω_R, β | motion of the ball, [`crate::physics::BallMotion`] | rad/s, rad |
/// | λ | shares of the friction, [`RaceControl`] | – |
///
/// The signs of T are those of a turning inner ring, with M_g of the sign of β. At rest both
/// loads are equal and the law is that of Hertz contacts in series. A ball without load at the
/// inner race rests on the outer race alone, at α_o = 0. Holds for contact angles below 90°, that
/// is while the inner groove centre is outside the ball's own radius, A2 > X2.
///
/// Where the books' formulas say nothing the law goes on smoothly:
/// - friction and control of the inner race fade out, to the outer race, below
///   `Q_i = 0.05 m_b d_m ω²` (about half of F_c): what bears nothing cannot rub;
/// - once the ball is off the inner race by a tenth of (f_i − ½)D, its orbital speed goes over to
///   the cage's, for an angle to a race far away has no meaning;
/// - in the kinematics, contacts more than 75° apart count as at most 83° apart.
///
/// Source: A. B. Jones, *J. Basic Engineering* 82 (1960) 309–320; Harris & Kotzalas, *Rolling
/// Bearing Analysis*, 5th ed. (2007), vol. 2, ch. 3. The gyroscopic terms' signs are opposite to
/// the books', whose ω_R is negative here.
///
/// ```
/// use jeffcott::bearing::{BallLaw, JonesLaw, catalogue};
/// use jeffcott::physics::RaceControl;
/// // 7205C, 1000 N thrust, 1000 rad/s: δz = 31.83103 µm, Q_i = 246.6608 N, Q_o = 252.6792 N,
/// // α_i = 19.74569°, α_o = 19.06724° (independent implementations).
/// let bearing = catalogue::find("7205C").unwrap().bearing()?;
/// let law = JonesLaw::new(&bearing, RaceControl::Outer)?;
/// let axial = bearing.geometry.free_axial() + 31.83103e-6;
/// let contact = law.contact(axial, bearing.geometry.free_radial(), 1000.0);
/// assert!((contact.load_inner - 246.6608).abs() < 2e-4);
/// assert!((contact.load_outer - 252.6792).abs() < 2e-4);
/// assert!((contact.angle_inner.to_degrees() - 19.74569).abs() < 6e-6);
/// assert!((contact.angle_outer.to_degrees() - 19.06724).abs() < 6e-6);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct JonesLaw<R = DryRaces> {
    ball: Ball,
    start: StartConstants,
    resistance: SpinResistance,
    races: R,
}

/// Jones's law with oil films.
pub type JonesFilmLaw = JonesLaw<LubricatedRaces>;

impl JonesLaw<DryRaces> {
    /// Law of one ball of a bearing without oil films.
    ///
    /// # Errors
    /// [`BearingError`] where ball and races form no contacts, where one stiffness is given for
    /// both of them together, or where the ball has no mass.
    pub fn new(bearing: &Bearing, control: RaceControl) -> Result<Self, BearingError> {
        let contacts = contacts(bearing)?;
        Self::with_races(bearing, control, &contacts, DryRaces::new(&contacts))
    }
}

impl JonesLaw<LubricatedRaces> {
    /// Law of one ball of a bearing with oil films; fastest at `prepared_speed` in rad/s, right
    /// at every speed.
    ///
    /// # Errors
    /// [`BearingError`] as [`JonesLaw::new`], and where the oil is none.
    pub fn with_film(
        bearing: &Bearing,
        control: RaceControl,
        oil: Oil,
        prepared_speed: f64,
    ) -> Result<Self, BearingError> {
        let contacts = contacts(bearing)?;
        let films = RaceFilms::new(bearing, &contacts, &oil)?;
        let constants = films.central_constants();
        let lubricated = std::array::from_fn(|race| {
            LubricatedContact::new(contacts[race].stiffness(), constants[race])
        });
        let races = LubricatedRaces::new(lubricated, films, prepared_speed);
        Self::with_races(bearing, control, &contacts, races)
    }

    /// Oil films of both races: their thickness under the loads of a [`BallContact`].
    pub fn films(&self) -> &RaceFilms {
        self.races.films()
    }

    /// Derivative of the force at the same loads, angles and inertia forces with the films rigid.
    pub(in crate::bearing) fn rigid_film_tangent(
        &self,
        axial: f64,
        radial: f64,
        speed: f64,
    ) -> BallTangent {
        let mut balance = self.solve(axial, radial, speed).balance;
        let loads = [balance.inner.load, balance.outer.load];
        [balance.inner.stiffness, balance.outer.stiffness] = self.races.elastic_stiffness(loads);
        self.ball.tangent(&balance)
    }
}

/// Contacts with the inner and the outer race.
fn contacts(bearing: &Bearing) -> Result<[HertzContact; 2], BearingError> {
    if let Some(stiffness) = bearing.contact_stiffness {
        return Err(BearingError::SeriesStiffness { stiffness });
    }
    Ok([bearing.inner_contact()?, bearing.outer_contact()?])
}

impl<R: Races> JonesLaw<R> {
    fn with_races(
        bearing: &Bearing,
        control: RaceControl,
        contacts: &[HertzContact; 2],
        races: R,
    ) -> Result<Self, BearingError> {
        let geometry = &bearing.geometry;
        let density = bearing.ball_material.density;
        if !(density > 0.0 && density.is_finite()) {
            return Err(BearingError::Density { density });
        }
        let diameter = geometry.ball_diameter();
        let mass = ball_mass(diameter, density);
        Ok(Self {
            ball: Ball {
                diameter,
                free_inner: (geometry.groove_factor_inner() - 0.5) * diameter,
                free_outer: (geometry.groove_factor_outer() - 0.5) * diameter,
                groove_radius: geometry.groove_factor_inner() * diameter,
                inertia: InertiaLaw {
                    control,
                    diameter_ratio: diameter / geometry.pitch_diameter(),
                    scale: 0.5 * mass * geometry.pitch_diameter(),
                },
            },
            start: StartConstants::new(contacts[0].stiffness(), contacts[1].stiffness()),
            resistance: SpinResistance::new(contacts),
            races,
        })
    }

    /// Everything about the ball in its place.
    pub fn state(&self, axial: f64, radial: f64, speed: f64) -> BallState {
        BallState::new(
            &self.ball,
            &self.resistance,
            &self.solve(axial, radial, speed),
        )
    }

    /// The contact with the inner race at a shaft speed in rad/s.
    pub(in crate::bearing) fn inner_spring(&self, speed: f64) -> R::Spring {
        let [inner, _] = self.races.at_speed(speed);
        inner
    }

    #[inline]
    fn solve(&self, axial: f64, radial: f64, speed: f64) -> Rest {
        let groove = Vector2::new(axial, radial);
        let springs = self.races.at_speed(speed);
        // F_0 = ½ m_b d_m ω²
        let force_scale = self.ball.inertia.scale * speed * speed;
        let start = self.ball.start(&self.start, groove, &springs, force_scale);
        self.ball.solve(groove, start, &springs, force_scale)
    }
}

impl<R: Races> BallLaw for JonesLaw<R> {
    const HAS_COUPLE: bool = true;

    fn force(&self, axial: f64, radial: f64, speed: f64) -> BallForce {
        self.ball.force(&self.solve(axial, radial, speed).balance)
    }

    fn force_and_tangent(&self, axial: f64, radial: f64, speed: f64) -> (BallForce, BallTangent) {
        let rest = self.solve(axial, radial, speed);
        (
            self.ball.force(&rest.balance),
            self.ball.tangent(&rest.balance),
        )
    }

    fn load_slopes(&self, axial: f64, radial: f64, speed: f64) -> [LoadSlope; 2] {
        self.solve(axial, radial, speed).balance.load_slopes()
    }

    /// From the inner race to the ball that rests on the outer race alone.
    fn past_lift_off(&self, axial: f64, radial: f64, speed: f64) -> f64 {
        let springs = self.races.at_speed(speed);
        let force_scale = self.ball.inertia.scale * speed * speed;
        let groove = Vector2::new(axial, radial);
        self.ball.overlap_when_thrown(groove, &springs, force_scale)
    }

    fn contact(&self, axial: f64, radial: f64, speed: f64) -> BallContact {
        contact_of(&self.solve(axial, radial, speed).balance)
    }
}
