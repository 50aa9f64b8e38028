//! The law of a ball with inertia: construction, force, and its state for people to read.

use super::balance::{self, Balance, Contact, Positions, Response};
use super::inertia::InertiaLaw;
use super::solve::{Rest, StartConstants};
use crate::bearing::law::film_spring::LubricatedContact;
use crate::bearing::law::spring::approaches_under;
use crate::bearing::law::{
    Ball, BallContact, BallForce, BallLaw, BallResponse, BallState, BallTangent, ContactSpring,
    FilmLaw, ForceLaw, HertzSpring, PointContacts, PreparedContact, RaceFilms,
};
use crate::bearing::number::{Function, Number, Plain};
use crate::bearing::{Bearing, BearingError, Oil};
use crate::physics::{
    BallMotion, HertzContact, RaceControl, ball_mass, complete_elliptic_second, controlling_race,
};

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
/// | s(Q) | approach: Hertz, less the film thickness where there is oil, plus the drop of the surface | m |
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
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct JonesLaw<C = HertzSpring> {
    ball: balance::Ball,
    start: StartConstants,
    /// To spinning at a load of 1 N, inner and outer race, N m.
    resistance: [f64; 2],
    /// With the inner and the outer race.
    contacts: [C; 2],
}

/// Jones's law with oil films.
pub type JonesFilmLaw = JonesLaw<LubricatedContact>;

impl JonesLaw {
    /// Law of one ball of a bearing without oil films.
    ///
    /// # Errors
    /// [`BearingError`] where ball and races form no contacts, where one stiffness is given for
    /// both of them together, or where the ball has no mass.
    pub fn new(bearing: &Bearing, control: RaceControl) -> Result<Self, BearingError> {
        Self::with_contacts(bearing, control, |contacts| Ok(contacts.springs()))
    }
}

impl JonesFilmLaw {
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
        Self::with_contacts(bearing, control, |contacts| {
            let films = RaceFilms::new(bearing, contacts, &oil)?.central_constants();
            let springs = contacts.springs();
            Ok([0, 1]
                .map(|race| LubricatedContact::new(springs[race], films[race], prepared_speed)))
        })
    }
}

impl<C: PreparedContact> JonesLaw<C> {
    /// A law with contacts prepared from those of the bearing.
    fn with_contacts(
        bearing: &Bearing,
        control: RaceControl,
        prepare: impl FnOnce(&PointContacts) -> Result<[C; 2], BearingError>,
    ) -> Result<Self, BearingError> {
        if let Some(stiffness) = bearing.contact_stiffness {
            return Err(BearingError::SeriesStiffness { stiffness });
        }
        let contacts = bearing.point_contacts()?;
        let prepared = prepare(&contacts)?;
        let geometry = &bearing.geometry;
        let density = bearing.ball_material.density;
        if !(density > 0.0 && density.is_finite()) {
            return Err(BearingError::Density { density });
        }
        let (diameter, factors) = (geometry.ball_diameter(), geometry.groove_factors());
        let mass = ball_mass(diameter, density);
        Ok(Self {
            ball: balance::Ball {
                diameter,
                free: factors.map(|factor| (factor - 0.5) * diameter),
                groove_radius: factors[0] * diameter,
                inertia: InertiaLaw {
                    control,
                    diameter_ratio: diameter / geometry.pitch_diameter(),
                    scale: 0.5 * mass * geometry.pitch_diameter(),
                },
            },
            start: StartConstants::new(contacts.springs()),
            resistance: contacts.hertz.each_ref().map(spin_resistance),
            contacts: prepared,
        })
    }

    /// Contacts with the inner and the outer race at a speed in rad/s.
    #[inline(always)]
    fn at_speed(&self, speed: f64) -> [C::Spring; 2] {
        let [inner, outer] = &self.contacts;
        [inner.at_speed(speed), outer.at_speed(speed)]
    }

    /// F_0 = ½ m_b d_m ω², N.
    #[inline(always)]
    fn force_scale(&self, speed: f64) -> f64 {
        self.ball.inertia.scale * speed * speed
    }

    #[inline]
    fn solve(&self, ball: &Ball, speed: f64) -> Rest {
        let groove = [ball.axial, ball.radial];
        let (springs, force_scale) = (self.at_speed(speed), self.force_scale(speed));
        // with the surfaces lower by their drops
        let free = [0, 1].map(|race| self.ball.free[race] + ball.drop[race]);
        let over = balance::Ball { free, ..self.ball };
        let start = Positions {
            centre: over.start(&self.start, groove, &springs, force_scale),
            groove,
            drop: ball.drop,
        };
        self.ball.solve(start, &springs, force_scale)
    }
}

/// A ball's balance at a speed as a function of the position of the inner groove centre and the drops.
struct InBalance<'a, C> {
    law: &'a JonesLaw<C>,
    speed: f64,
}

impl<C: PreparedContact> InBalance<'_, C> {
    #[inline(always)]
    fn rest(&self, [axial, radial, inner, outer]: [f64; 4]) -> Rest {
        let ball = Ball {
            drop: [inner, outer],
            ..Ball::at(axial, radial)
        };
        self.law.solve(&ball, self.speed)
    }
}

impl<C: PreparedContact> Function<4, 6> for InBalance<'_, C> {
    fn with_slopes(&self, at: [f64; 4]) -> (Response<f64>, [[f64; 4]; 6]) {
        let (law, rest) = (self.law, self.rest(at));
        let springs = law.at_speed(self.speed);
        let force_scale = law.force_scale(self.speed);
        let load = |race: usize, approach| springs[race].load_and_stiffness(approach);
        let slopes = law.ball.slopes(&rest.positions, load, force_scale);
        (law.ball.response(&rest.balance), slopes)
    }

    fn values(&self, at: [f64; 4]) -> Response<f64> {
        self.law.ball.response(&self.rest(at).balance)
    }
}

impl<C: PreparedContact> ForceLaw for JonesLaw<C> {
    const HAS_COUPLE: bool = true;

    #[inline(always)]
    fn force<T: Number>(&self, ball: &Ball<T>, speed: f64) -> BallForce<T> {
        self.response(ball, speed).force
    }

    #[inline(always)]
    fn distance_past_lift_off<T: Plain>(&self, ball: &Ball<T>, _place: usize, speed: f64) -> T {
        if C::Spring::IS_SMOOTH {
            return ball.axial.constant(f64::INFINITY);
        }
        let outer = self.contacts[1].elastic();
        let groove = [ball.axial, ball.radial];
        self.ball
            .overlap_when_thrown(groove, ball.drop, &outer, self.force_scale(speed))
    }
}

impl<C: PreparedContact> BallLaw for JonesLaw<C> {
    type Spring = C::Spring;

    #[inline(always)]
    fn response<T: Number>(&self, ball: &Ball<T>, speed: f64) -> BallResponse<T> {
        let [inner, outer] = ball.drop;
        let balance = InBalance { law: self, speed };
        let [axial, radial, couple, load_inner, load_outer, approach] =
            T::apply(&balance, [ball.axial, ball.radial, inner, outer]);
        BallResponse {
            force: [axial, radial, couple].into(),
            load: [load_inner, load_outer],
            approach,
        }
    }

    fn spring(&self, speed: f64) -> C::Spring {
        let [inner, _] = self.at_speed(speed);
        inner
    }

    fn contact(&self, ball: &Ball, speed: f64) -> BallContact {
        contact_of(&self.solve(ball, speed).balance)
    }

    fn elastic_approaches<T: Number>(&self, response: &BallResponse<T>) -> [T; 2] {
        approaches_under(
            &self.contacts.map(|contact| contact.elastic()),
            response.load,
        )
    }

    fn state(&self, ball: &Ball, speed: f64) -> Option<BallState> {
        let rest = self.solve(ball, speed);
        let contact = contact_of(&rest.balance);
        let Balance { inertia, .. } = rest.balance;
        // a grows as Q^(1/3)
        let resistance = |race: usize, load: f64| self.resistance[race] * load * load.cbrt();
        Some(BallState {
            contact,
            centrifugal_force: inertia.centrifugal,
            // T_i + T_o = 2 M_g/D
            gyroscopic_moment: 0.5
                * self.ball.diameter
                * (inertia.friction[0] + inertia.friction[1]),
            motion: BallMotion::new(
                self.ball.inertia.control,
                self.ball.inertia.diameter_ratio,
                contact.angle_inner,
                contact.angle_outer,
            ),
            controlling_race: controlling_race(
                resistance(0, contact.load_inner),
                resistance(1, contact.load_outer),
                contact.angle_inner - contact.angle_outer,
            ),
            trials: rest.trials,
        })
    }
}

impl FilmLaw for JonesFilmLaw {
    fn contact_tangent(&self, ball: &Ball, speed: f64) -> BallTangent {
        let rest = self.solve(ball, speed);
        let springs = self.at_speed(speed);
        // the films rigid
        let load = |race: usize, approach| {
            let load = rest.balance.contacts[race].load;
            let (behind_film, _) = springs[race].load_and_stiffness(approach);
            (
                behind_film,
                self.contacts[race].elastic().stiffness_under(load),
            )
        };
        let force_scale = self.force_scale(speed);
        let [axial, radial, couple, ..] = self.ball.slopes(&rest.positions, load, force_scale);
        [axial, radial, couple].map(|[axial, radial, ..]| [axial, radial])
    }
}

fn contact_of(balance: &Balance<f64>) -> BallContact {
    let [inner, outer] = &balance.contacts;
    let angle = |contact: &Contact<f64>| contact.sin.atan2(contact.cos);
    BallContact {
        load_inner: inner.load,
        load_outer: outer.load,
        angle_inner: angle(inner),
        angle_outer: angle(outer),
        approach: inner.approach,
    }
}

/// Resistance to spinning Q a E at a load of 1 N, N m.
fn spin_resistance(contact: &HertzContact) -> f64 {
    let kappa = contact.ellipticity();
    // m = 1 − 1/κ²
    let elliptic = complete_elliptic_second(1.0 - 1.0 / (kappa * kappa));
    contact.ellipse(1.0).semi_major * elliptic
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn balls_with_inertia_bear_what_others_found() -> Result<(), Box<dyn std::error::Error>> {
        // 7205C, 1000 N thrust, 1000 rad/s: δz = 31.83103 µm, Q_i = 246.6608 N, Q_o = 252.6792 N,
        // α_i = 19.74569°, α_o = 19.06724° (independent implementations).
        let bearing = Bearing::catalogue("7205C")?;
        let law = JonesLaw::new(&bearing, RaceControl::Outer)?;
        let axial = bearing.geometry.free_axial() + 31.83103e-6;
        let ball = Ball::at(axial, bearing.geometry.free_radial());
        let contact = law.contact(&ball, 1000.0);
        assert!((contact.load_inner - 246.6608).abs() < 2e-4);
        assert!((contact.load_outer - 252.6792).abs() < 2e-4);
        assert!((contact.angle_inner.to_degrees() - 19.74569).abs() < 6e-6);
        assert!((contact.angle_outer.to_degrees() - 19.06724).abs() < 6e-6);
        Ok(())
    }
}
