//! Everything about one ball in its place, for people to read.

use super::balance::{Balance, Ball};
use super::contact::Contact;
use super::solve::Rest;
use crate::bearing::BallContact;
use crate::physics::{BallMotion, HertzContact, Race, complete_elliptic_second, controlling_race};

/// Loads, angles, inertia and motion of one ball.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BallState {
    /// Loads and angles of both contacts.
    pub contact: BallContact,
    /// Centrifugal force F_c, N.
    pub centrifugal_force: f64,
    /// Gyroscopic moment M_g, N m; negative with a negative contact angle.
    pub gyroscopic_moment: f64,
    /// Motion under the race control of the law.
    pub motion: BallMotion,
    /// Race that controls by Jones's criterion, whatever the law assumes.
    pub controlling_race: Race,
    /// Number of trial positions that the solution took.
    pub trials: usize,
}

impl BallState {
    pub(super) fn new(ball: &Ball, resistance: &SpinResistance, rest: &Rest) -> Self {
        let contact = contact_of(&rest.balance);
        let inertia = &rest.balance.inertia;
        Self {
            contact,
            centrifugal_force: inertia.centrifugal,
            // T_i + T_o = 2 M_g/D
            gyroscopic_moment: 0.5 * ball.diameter * (inertia.friction[0] + inertia.friction[1]),
            motion: BallMotion::new(
                ball.inertia.control,
                ball.inertia.diameter_ratio,
                contact.angle_inner,
                contact.angle_outer,
            ),
            controlling_race: resistance.controlling_race(&contact),
            trials: rest.trials,
        }
    }
}

pub(super) fn contact_of(balance: &Balance<f64>) -> BallContact {
    let (inner, outer) = (&balance.inner, &balance.outer);
    let angle = |contact: &Contact<f64>| contact.sin.atan2(contact.cos);
    BallContact {
        load_inner: inner.load,
        load_outer: outer.load,
        angle_inner: angle(inner),
        angle_outer: angle(outer),
        approach: inner.approach,
    }
}

/// Resistance to spinning Q a E at a load of 1 N, inner and outer race, N m.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct SpinResistance([f64; 2]);

impl SpinResistance {
    pub(super) fn new(contacts: &[HertzContact; 2]) -> Self {
        Self(contacts.each_ref().map(|contact| {
            let kappa = contact.ellipticity();
            // m = 1 − 1/κ²
            let elliptic = complete_elliptic_second(1.0 - 1.0 / (kappa * kappa));
            contact.ellipse(1.0).semi_major * elliptic
        }))
    }

    fn controlling_race(&self, contact: &BallContact) -> Race {
        // a grows as Q^(1/3)
        let resistance = |unit: f64, load: f64| unit * load * load.cbrt();
        controlling_race(
            resistance(self.0[0], contact.load_inner),
            resistance(self.0[1], contact.load_outer),
            contact.angle_inner - contact.angle_outer,
        )
    }
}
