//! Place of a ball between its races, and what it then bears.

use serde::Serialize;

use crate::bearing::dual::Dual;
use crate::bearing::number::Plain;
use crate::physics::{BallMotion, Race};

/// A ball between its races, seen in its own plane.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Ball<T = f64> {
    /// A1: axial distance of the inner groove centre from the outer one, m.
    pub axial: T,
    /// A2: their radial distance, m.
    pub radial: T,
    /// T = θx sin φ − θy cos φ: tilt of the inner ring in the plane of the ball, rad. Balls do not know it but by A1.
    pub tilt: T,
    /// How much lower the surfaces of the inner and the outer race lie under the ball, m: zero on perfect races.
    pub drop: [T; 2],
}

impl Ball {
    /// A ball on perfect races.
    pub fn at(axial: f64, radial: f64) -> Self {
        Self {
            axial,
            radial,
            tilt: 0.0,
            drop: [0.0; 2],
        }
    }
}

impl<T: Plain> Ball<T> {
    /// Place with slopes by A1 and A2; with D = 3 by the tilt, too, and with D = 4 by both drops.
    #[inline(always)]
    pub fn with_slopes<const D: usize>(&self) -> Ball<Dual<T, D>> {
        let [inner, outer] = self.drop;
        Ball {
            axial: Dual::variable(self.axial, 0),
            radial: Dual::variable(self.radial, 1),
            tilt: if D == 3 {
                Dual::variable(self.tilt, 2)
            } else {
                Dual::fixed(self.tilt)
            },
            drop: if D == 4 {
                [Dual::variable(inner, 2), Dual::variable(outer, 3)]
            } else {
                [Dual::fixed(inner), Dual::fixed(outer)]
            },
        }
    }
}

/// What the inner ring presses onto one ball, in the ball's own plane.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct BallForce<T = f64> {
    /// Axial force F_a, N.
    pub axial: T,
    /// Radial force F_r, N.
    pub radial: T,
    /// Moment about the inner groove centre, N m; zero without gyroscopic friction. The moment of
    /// the ball about the shaft axis' normal is `N = R_i F_a + couple`.
    pub couple: T,
}

impl<T> From<[T; 3]> for BallForce<T> {
    #[inline(always)]
    fn from([axial, radial, couple]: [T; 3]) -> Self {
        Self {
            axial,
            radial,
            couple,
        }
    }
}

impl<T: Plain, const D: usize> BallForce<Dual<T, D>> {
    /// The force without its slopes.
    #[inline(always)]
    pub fn value(&self) -> BallForce<T> {
        BallForce {
            axial: self.axial.value,
            radial: self.radial.value,
            couple: self.couple.value,
        }
    }
}

/// Exact derivative of a [`BallForce`]: rows axial, radial, couple; columns A1, A2.
pub type BallTangent = [[f64; 2]; 3];

/// How a ball answers to the position of the inner ring.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct BallResponse<T = f64> {
    /// What the inner ring presses onto it.
    pub force: BallForce<T>,
    /// Normal loads at the inner and the outer race, N.
    pub load: [T; 2],
    /// Approach of ball and inner race, m, as [`BallContact::approach`].
    pub approach: T,
}

/// State of one ball's two contacts, for people to read.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize)]
pub struct BallContact {
    /// Normal load at the inner race, N.
    #[serde(rename = "load_inner_N")]
    pub load_inner: f64,
    /// Normal load at the outer race, N.
    #[serde(rename = "load_outer_N")]
    pub load_outer: f64,
    /// Contact angle at the inner race, rad.
    #[serde(rename = "angle_inner_rad")]
    pub angle_inner: f64,
    /// Contact angle at the outer race, rad.
    #[serde(rename = "angle_outer_rad")]
    pub angle_outer: f64,
    /// Approach of ball and inner race, m: of dry surfaces, so less than the elastic one by the
    /// film, and negative where they are apart. A law without ball inertia knows only that of both
    /// races together.
    #[serde(rename = "approach_m")]
    pub approach: f64,
}

/// What a slice of a roller bears between both races.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Lamina {
    /// Middle from the middle of the roller, m.
    pub position: f64,
    /// Width, m.
    pub width: f64,
    /// Approach of both races together, m; negative where they are apart.
    pub approach: f64,
    /// Load, N.
    pub load: f64,
}

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
