//! What passes a defect, and what it looks like from the side.

use super::{Defect, DefectProfile, Passing, Surface};
use crate::bearing::Geometry;

/// A spall of a race with sharp edges and no floor in reach, as balls pass it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RacePass {
    /// The race.
    pub on: Surface,
    /// Of its middle, rad.
    pub angle: f64,
    /// Length along the race, m.
    pub length: f64,
    /// Position of the bearing along the shaft, m.
    pub position: f64,
    /// When balls pass its middle, where they strike the far edge.
    pub middle: Passing,
}

impl RacePass {
    /// Angle of the race from the edge to the middle, rad.
    pub fn half_angle(&self) -> f64 {
        0.5 * self.length / self.middle.radius
    }
}

/// A defect from the side, in the plane in which a ball rolls; lengths in m.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SideView {
    /// Radius of the ball.
    pub ball_radius: f64,
    /// Radius of the race; of a dent of a ball that of the ball.
    pub race_radius: f64,
    /// Whether the surface is convex: an inner race or a ball.
    pub convex: bool,
    /// Largest drop of the ball.
    pub drop: f64,
}

impl Defect {
    /// Balls that pass it, of a bearing at a position whose ball 0 starts at an azimuth in rad; none of a defect of a ball, of
    /// another profile, or of a slot whose floor balls reach.
    pub(in crate::bearing) fn race_pass(
        &self,
        geometry: &Geometry,
        first_ball: f64,
        position: f64,
    ) -> Option<RacePass> {
        let by_shaft = match self.on {
            Surface::Outer => 0.0,
            Surface::Inner => -1.0,
            Surface::Ball(_) => return None,
        };
        let kinks = self.slot(geometry, self.on == Surface::Inner).kinks();
        let meets_edges = self.profile == DefectProfile::Edges && kinks.len() == 3;
        meets_edges.then(|| RacePass {
            on: self.on,
            angle: self.angle,
            length: self.length,
            position,
            middle: Passing {
                offset: first_ball - self.angle,
                by_cage: 1.0,
                by_shaft,
                period: std::f64::consts::TAU / geometry.balls() as f64,
                radius: self.on.radius(geometry),
            },
        })
    }

    /// How it looks from the side; a dent of a ball as the inner race meets it.
    pub fn side_view(&self, geometry: &Geometry) -> SideView {
        let inner = self.on != Surface::Outer;
        SideView {
            ball_radius: 0.5 * geometry.ball_diameter(),
            race_radius: match self.on {
                Surface::Ball(_) => 0.5 * geometry.ball_diameter(),
                _ => super::surfaces::rolling_radius(geometry, inner),
            },
            convex: inner,
            drop: self.slot(geometry, inner).deepest(),
        }
    }
}
