//! From the place of the inner ring to everything that is known of a loaded bearing.

use super::any_ring::AnyRing;
use super::ball_line::BallLines;
use super::bearing_friction::BearingFriction;
use super::life::reference_rating_life;
use super::ring::{CageAngle, Vector5};
use super::seat::Seat;
use super::static_safety::static_safety;
use super::{BallLine, Bearing, BearingState, MountedBearing, StiffnessShares, warnings};
use crate::physics::{BallPass, HertzContact, ball_pass_frequencies};

/// Share of the largest load at the inner race below which a ball counts as unloaded: behind an oil
/// film the load of a ball never quite vanishes.
pub(crate) const LOADED_SHARE: f64 = 1e-6;

/// A bearing to be assessed at one place and speed.
pub(super) struct Assessment<'a> {
    pub definition: &'a MountedBearing,
    pub ring: &'a AnyRing,
    pub seat: &'a Seat,
    /// Hertz contacts of the geometry, inner race first.
    pub contacts: &'a [HertzContact; 2],
    /// Displacement of the inner ring.
    pub place: Vector5,
    /// Shaft speed, rad/s.
    pub speed: f64,
}

impl Assessment<'_> {
    pub fn state(&self) -> BearingState {
        let (force, stiffness) =
            self.ring
                .force_and_stiffness(&self.place, CageAngle::START, self.speed);
        let balls = self.balls();
        let loads = || balls.iter().map(|ball| [ball.inner.load, ball.outer.load]);
        let bearing = self.bearing();
        BearingState {
            displacement: self.place,
            force,
            stiffness: self.seat.condense(stiffness),
            shares: self.shares(),
            balls_loaded: loaded(&balls).count(),
            life: bearing
                .dynamic_rating
                .and_then(|rating| reference_rating_life(&bearing.geometry, rating, loads())),
            static_safety: static_safety(self.contacts, loads()),
            friction_moment: BearingFriction::new(self.definition, self.contacts)
                .moment(&force, self.speed),
            ball_pass: self.ball_pass(&balls),
            warnings: warnings::of(
                bearing,
                self.speed,
                &balls,
                &loaded(&balls).collect::<Vec<_>>(),
            ),
            balls,
        }
    }

    fn bearing(&self) -> &Bearing {
        &self.definition.bearing
    }

    fn balls(&self) -> Vec<BallLine> {
        let lines = BallLines {
            bearing: self.bearing(),
            contacts: self.contacts,
            films: self.ring.films(),
            speed: self.speed,
        };
        self.ring
            .readings(&self.place, self.speed)
            .iter()
            .map(|reading| lines.line(reading))
            .collect()
    }

    fn shares(&self) -> Option<StiffnessShares> {
        self.ring
            .shares(&self.place, self.speed)
            .map(|shares| StiffnessShares {
                contacts: self.seat.condense(shares.contacts),
                films: self.seat.condense(shares.films),
            })
    }

    /// Frequencies at the mean contact angle of the loaded balls.
    fn ball_pass(&self, balls: &[BallLine]) -> BallPass {
        let geometry = &self.bearing().geometry;
        let gamma = match operating_angle(balls) {
            // γ = D cos α/d_m
            Some(angle) => geometry.ball_diameter() * angle.cos() / geometry.pitch_diameter(),
            None => geometry.gamma(),
        };
        ball_pass_frequencies(
            self.speed,
            geometry.balls(),
            geometry.ball_diameter(),
            geometry.pitch_diameter(),
            gamma,
        )
    }
}

/// Balls that bear at the inner race, with their numbers.
fn loaded(balls: &[BallLine]) -> impl Iterator<Item = (usize, &BallLine)> {
    let largest = balls.iter().map(|ball| ball.inner.load).fold(0.0, f64::max);
    let least = LOADED_SHARE * largest;
    balls
        .iter()
        .enumerate()
        .filter(move |(_, ball)| ball.inner.load > least)
}

/// Mean size of the contact angle, weighted by the load at the inner race; of each ball the mean of
/// both races, rad. None without load.
fn operating_angle(balls: &[BallLine]) -> Option<f64> {
    let (mut moment, mut load) = (0.0, 0.0);
    for ball in balls {
        // |α_i + α_o|/2
        moment += ball.inner.load * 0.5 * (ball.inner.angle + ball.outer.angle).abs();
        load += ball.inner.load;
    }
    (load > 0.0).then(|| moment / load)
}
