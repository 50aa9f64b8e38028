//! From the place of the inner ring to everything that is known of a loaded bearing.

use super::ball_line::{BallLines, BallReading};
use super::bearing_friction::skf_moment;
use super::fatigue_limit::fatigue_load_limit;
use super::law::{BallLaw, Share, with_law};
use super::life::reference_rating_life;
use super::static_safety::{static_rating, static_safety};
use super::support::Support;
use super::{
    BallLine, Bearing, BearingRotation, BearingState, GeometryState, InternalGeometry, Matrix5,
    StiffnessShares, Vector5, warnings,
};
use crate::physics::{BallPass, ball_pass_frequencies, dynamic_rating};

/// Share of the largest load at the inner race below which a ball counts as unloaded: behind an oil
/// film the load of a ball never quite vanishes.
pub(crate) const LOADED_SHARE: f64 = 1e-6;

/// A bearing to be assessed at one place and speed.
pub(super) struct Assessment<'a> {
    support: &'a Support,
    /// Displacement of the inner ring.
    place: Vector5,
    rotation: BearingRotation,
}

impl<'a> Assessment<'a> {
    pub fn new(support: &'a Support, place: Vector5, speed: f64) -> Self {
        Self {
            support,
            place,
            rotation: BearingRotation::at_start(speed),
        }
    }

    pub fn state(&self) -> BearingState {
        let support = self.support;
        let (force, stiffness) = with_law!(&support.law, law => {
            support.ring.force_and_stiffness(law, &self.place, &self.rotation)
        });
        let balls = self.balls();
        let loads = || balls.iter().map(|ball| [ball.inner.load, ball.outer.load]);
        let bearing = self.bearing();
        let life = bearing
            .dynamic_rating
            .and_then(|rating| reference_rating_life(&bearing.geometry, rating, loads()));
        let speed = self.rotation.speed;
        BearingState {
            rating_lives: life.and_then(|life| bearing.rating_lives(life, &force, speed)),
            fit: bearing.fit,
            preload: self.preload(),
            friction_moment_skf: skf_moment(bearing, &support.contacts, &force, speed),
            geometry: self.geometry(),
            clearance: self.bearing().clearance(),
            displacement: self.place,
            force,
            stiffness: support.seat.condense(stiffness),
            shares: self.shares(),
            balls_loaded: loaded(&balls).count(),
            life,
            static_safety: static_safety(&support.contacts, loads()),
            friction_moment: support.friction_moment(&force, self.rotation.speed),
            ball_pass: self.ball_pass(&balls),
            warnings: warnings::of(
                bearing,
                self.rotation.speed,
                &balls,
                &loaded(&balls).collect::<Vec<_>>(),
            ),
            balls,
        }
    }

    /// Axial force in N with the shaft in its place.
    fn preload(&self) -> f64 {
        let Support {
            ring, law, seat, ..
        } = self.support;
        let place = [0.0, 0.0, seat.offset(), 0.0, 0.0];
        let rest = BearingRotation::at_start(0.0);
        with_law!(law, law => ring.force_and_stiffness(law, &place, &rest).0[2])
    }

    fn geometry(&self) -> GeometryState {
        let (bearing, contacts) = (self.bearing(), &self.support.contacts);
        let geometry = &bearing.geometry;
        let (balls, ball_diameter) = (geometry.balls(), geometry.ball_diameter());
        let pitch_diameter = geometry.pitch_diameter();
        let angle = geometry.nominal_angle();
        GeometryState {
            internal: InternalGeometry {
                balls,
                ball_diameter,
                pitch_diameter,
                contact_angle: geometry.contact_angle(),
                groove_factor_inner: geometry.groove_factor_inner(),
                groove_factor_outer: geometry.groove_factor_outer(),
                dynamic_rating: dynamic_rating(balls, ball_diameter, pitch_diameter, angle),
                static_rating: static_rating(geometry, contacts),
            },
            fatigue_load_limit: fatigue_load_limit(geometry, contacts),
            estimated: bearing.estimated,
        }
    }

    fn bearing(&self) -> &Bearing {
        &self.support.definition().bearing
    }

    fn balls(&self) -> Vec<BallLine> {
        let Support { ring, law, .. } = self.support;
        let speed = self.rotation.speed;
        let lines = BallLines {
            bearing: self.bearing(),
            contacts: &self.support.contacts,
            films: with_law!(law, law => law.films()),
            speed,
        };
        let line = |(number, &azimuth): (usize, &f64)| {
            let ball = ring.ball_at(&self.place, azimuth, Some(number), &self.rotation);
            let inertia = with_law!(law, law => law.state(&ball, speed));
            let contact = || with_law!(law, law => law.contact(&ball, speed));
            lines.line(&BallReading {
                azimuth,
                distance: ball.axial.hypot(ball.radial),
                contact: inertia.map_or_else(contact, |state| state.contact),
                inertia,
            })
        };
        ring.azimuths().iter().enumerate().map(line).collect()
    }

    fn shares(&self) -> Option<StiffnessShares> {
        let Support {
            ring, law, seat, ..
        } = self.support;
        let shares: Option<[Matrix5; 2]> = with_law!(law, law => {
            Share::of(law, self.rotation.speed).map(|shares| {
                shares.map(|share| ring.force_and_stiffness(&share, &self.place, &self.rotation).1)
            })
        });
        shares.map(|[contacts, films]| StiffnessShares {
            contacts: seat.condense(contacts),
            films: seat.condense(films),
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
            self.rotation.speed,
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
