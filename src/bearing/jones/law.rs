//! The law itself: construction, force, state.

use nalgebra::Vector2;

use super::balance::{Balance, Ball};
use super::solve::Rest;
use super::inertia::InertiaLaw;
use super::start::StartConstants;
use crate::bearing::film_spring::LubricatedContact;
use crate::bearing::races::{DryRaces, LubricatedRaces, RaceFilms, Races};
use crate::bearing::{
    BallContact, BallForce, BallLaw, BallLawError, BallTangent, Bearing, Oil,
};
use crate::physics::{BallMotion, HertzContact, RaceControl, ball_mass};

/// Law of a ball with centrifugal force and gyroscopic moment.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct JonesLaw<R = DryRaces> {
    ball: Ball,
    diameter: f64,
    start: StartConstants,
    races: R,
}

/// Everything about one ball in its place, for people to read.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BallState {
    /// Loads and angles of both contacts.
    pub contact: BallContact,
    /// Centrifugal force F_c, N.
    pub centrifugal_force: f64,
    /// Gyroscopic moment M_g that friction holds, N m.
    pub gyroscopic_moment: f64,
    /// Motion of the ball.
    pub motion: BallMotion,
}

impl JonesLaw<DryRaces> {
    /// Law of one ball of a bearing without oil film.
    ///
    /// # Errors
    /// [`BallLawError`] where the contacts cannot be formed or the ball has no mass.
    pub fn new(bearing: &Bearing, control: RaceControl) -> Result<Self, BallLawError> {
        let [inner, outer] = contacts(bearing)?;
        Self::with_races(bearing, control, DryRaces::new(&inner, &outer), &inner, &outer)
    }
}

impl JonesLaw<LubricatedRaces> {
    /// Law of one ball of a bearing with oil films; fastest at `prepared_speed` in rad/s, right
    /// at every speed.
    ///
    /// # Errors
    /// [`BallLawError`].
    pub fn with_film(
        bearing: &Bearing,
        control: RaceControl,
        oil: Oil,
        prepared_speed: f64,
    ) -> Result<Self, BallLawError> {
        let [inner, outer] = contacts(bearing)?;
        let films = RaceFilms::new(bearing, &inner, &outer, &oil)?;
        let [film_inner, film_outer] = films.central_constants();
        let races = LubricatedRaces::new(
            [
                LubricatedContact::new(inner.stiffness(), film_inner),
                LubricatedContact::new(outer.stiffness(), film_outer),
            ],
            prepared_speed,
        );
        Self::with_races(bearing, control, races, &inner, &outer)
    }
}

fn contacts(bearing: &Bearing) -> Result<[HertzContact; 2], BallLawError> {
    if let Some(stiffness) = bearing.contact_stiffness {
        return Err(BallLawError::SeriesStiffness { stiffness });
    }
    Ok([bearing.inner_contact()?, bearing.outer_contact()?])
}

impl<R: Races> JonesLaw<R> {
    fn with_races(
        bearing: &Bearing,
        control: RaceControl,
        races: R,
        inner: &HertzContact,
        outer: &HertzContact,
    ) -> Result<Self, BallLawError> {
        let geometry = &bearing.geometry;
        let density = bearing.ball_material.density;
        if !(density > 0.0 && density.is_finite()) {
            return Err(BallLawError::Density { density });
        }
        let diameter = geometry.ball_diameter();
        let ball = Ball {
            free_inner: (geometry.groove_factor_inner() - 0.5) * diameter,
            free_outer: (geometry.groove_factor_outer() - 0.5) * diameter,
            groove_radius: geometry.groove_factor_inner() * diameter,
            inertia: InertiaLaw {
                control,
                diameter_ratio: diameter / geometry.pitch_diameter(),
                scale: 0.5 * ball_mass(diameter, density) * geometry.pitch_diameter(),
            },
        };
        Ok(Self {
            ball,
            diameter,
            start: StartConstants::new(inner.stiffness(), outer.stiffness()),
            races,
        })
    }

    /// Number of trial positions of the ball's centre that a solve takes.
    pub fn trials(&self, axial: f64, radial: f64, speed: f64) -> usize {
        self.solve(axial, radial, speed).trials
    }

    /// Largest force in N that is left over in the ball's balance.
    pub fn residual(&self, axial: f64, radial: f64, speed: f64) -> (f64, f64, f64) {
        let r = self.solve(axial, radial, speed); let b=&r.balance;
        (b.residual.norm(), b.outer.load + b.inner.load, b.round_off())
    }

    #[inline]
    fn solve(&self, axial: f64, radial: f64, speed: f64) -> Rest {
        let groove = Vector2::new(axial, radial);
        let springs = self.races.at_speed(speed);
        let force_scale = self.ball.inertia.scale * speed * speed;
        let start = self.ball.start(&self.start, groove, &springs, force_scale);
        self.ball.solve(groove, start, &springs, force_scale)
    }

    /// Everything about the ball in its place.
    pub fn state(&self, axial: f64, radial: f64, speed: f64) -> BallState {
        let Rest { balance, .. } = self.solve(axial, radial, speed);
        let contact = contact_of(&balance);
        let inertia = &balance.inertia;
        let friction = inertia.friction_inner.value + inertia.friction_outer.value;
        BallState {
            contact,
            centrifugal_force: inertia.centrifugal.value,
            // T_i + T_o = 2 M_g/D
            gyroscopic_moment: 0.5 * friction * self.diameter,
            motion: BallMotion::new(
                self.ball.inertia.control,
                self.ball.inertia.diameter_ratio,
                contact.angle_inner,
                contact.angle_outer,
            ),
        }
    }
}

impl<R: Races> BallLaw for JonesLaw<R> {
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

    fn contact(&self, axial: f64, radial: f64, speed: f64) -> BallContact {
        contact_of(&self.solve(axial, radial, speed).balance)
    }
}

fn contact_of(balance: &Balance) -> BallContact {
    let (inner, outer) = (&balance.inner, &balance.outer);
    let angle = |normal: &Vector2<f64>| normal.x.atan2(normal.y);
    BallContact {
        load_inner: inner.load,
        load_outer: outer.load,
        angle_inner: angle(&inner.normal),
        angle_outer: angle(&outer.normal),
    }
}
