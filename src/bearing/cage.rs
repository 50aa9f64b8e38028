//! How the balls of a bearing go round with their cage.

use std::f64::consts::TAU;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::{Bearing, Geometry};
use crate::physics::{BallPass, Race, nominal_cage_speed};

/// How the balls go round.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum CageMotion {
    /// The cage rolls at the contact angles of the balls loaded at the static equilibrium at t = 0, and keeps that
    /// ratio to the speed; where no ball is loaded, at the nominal angle, 0 for a deep groove bearing.
    #[default]
    Operating,
    /// The cage rolls at the free contact angle.
    Rolling,
    /// The cage does not turn: no ball-pass lines.
    Frozen,
}

impl CageMotion {
    /// Whether the balls go round, and the stiffness varies with the ball pass.
    pub fn turns(self) -> bool {
        self != Self::Frozen
    }
}

/// How the cage of one bearing turns.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Cage {
    /// γ = D cos α/d_m of the contact angle that the balls roll at.
    pub gamma: f64,
    /// Its speed over that of the turning ring.
    pub ratio: f64,
}

impl Cage {
    /// Cage of a bearing that slips by a part, with one ring that turns:
    ///
    /// `ω_c/ω = (1 − γ)/2 (1 − slip)`, and (1 + γ)/2 (1 − slip) where it is the outer one
    pub fn new(bearing: &Bearing, gamma: f64, slip: f64) -> Self {
        let rolling = match bearing.rotating_ring {
            Race::Inner => nominal_cage_speed(1.0, gamma),
            Race::Outer => nominal_cage_speed(1.0, -gamma),
        };
        let ratio = (1.0 - slip) * rolling;
        Self { gamma, ratio }
    }

    /// Frequencies at a speed of the turning ring in rad/s. Balls roll on the outer race, also under a cage that slips.
    pub fn ball_pass(&self, bearing: &Bearing, speed: f64) -> BallPass {
        let (geometry, turning) = (&bearing.geometry, speed / TAU);
        let rings = match bearing.rotating_ring {
            Race::Inner => [turning, 0.0],
            Race::Outer => [0.0, turning],
        };
        let rolling = rolling_ratio(geometry, self.gamma);
        BallPass::from_rings(rings, self.ratio * turning, geometry.balls(), rolling)
    }

    /// Angle that a ball turns by over that of the cage, rolling on the outer race.
    pub fn rolling_ratio(&self, bearing: &Bearing) -> f64 {
        let past_outer = match bearing.rotating_ring {
            Race::Outer if self.ratio > 0.0 => 1.0 - 1.0 / self.ratio,
            _ => 1.0,
        };
        past_outer * rolling_ratio(&bearing.geometry, self.gamma)
    }
}

impl Bearing {
    /// Frequencies of its rolling elements at a speed of the turning ring in rad/s, at the nominal contact angle, under a cage that
    /// slips by a part.
    pub(crate) fn rolling_ball_pass(&self, slip: f64, speed: f64) -> BallPass {
        Cage::new(self, self.geometry.nominal_gamma(), slip).ball_pass(self, speed)
    }
}

/// Angle that a ball turns by over that of the cage: (1 + γ) d_m/D.
pub(super) fn rolling_ratio(geometry: &Geometry, gamma: f64) -> f64 {
    (1.0 + gamma) * geometry.pitch_diameter() / geometry.ball_diameter()
}
