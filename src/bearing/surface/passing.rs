//! When balls pass a place of a surface, what they meet of a defect, and what it looks like from the side.

use std::f64::consts::{PI, TAU};

use super::slot::Slot;
use super::{Defect, DefectProfile, Surface};
use crate::bearing::{Bearing, Geometry};

/// Passages of balls at a place: they happen at shaft angles ψ and cage angles ψ_c at which
///
/// ```text
/// offset + by_cage ψ_c + by_shaft ψ
/// ```
///
/// is a whole number of periods, all in rad.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Passing {
    /// Value at the start.
    pub offset: f64,
    /// Part that turns with the cage.
    pub by_cage: f64,
    /// Part that turns with the shaft.
    pub by_shaft: f64,
    /// From one passage to the next.
    pub period: f64,
    /// Radius that makes a distance of the angle, m.
    pub radius: f64,
}

impl Passing {
    /// Change by the angle of the shaft where the cage turns by a ratio of it.
    pub fn rate(&self, cage_ratio: f64) -> f64 {
        self.by_cage * cage_ratio + self.by_shaft
    }

    /// The first angle of the shaft beyond `after`, `later` passages on, where the cage turns by a ratio of it; none where no
    /// ball ever passes.
    pub fn next_angle(&self, after: f64, cage_ratio: f64, later: u32) -> Option<f64> {
        let rate = self.rate(cage_ratio);
        if rate == 0.0 {
            return None;
        }
        let (period, offset) = (self.period.copysign(rate), self.offset);
        let passed = ((offset + rate * after) / period).floor();
        Some(((passed + 1.0 + f64::from(later)) * period - offset) / rate)
    }

    /// How far balls are past the place, or before it, m, at angles of cage and shaft: continuous, with a simple zero at
    /// each passage.
    pub fn distance(&self, cage: f64, shaft: f64) -> f64 {
        let angle = self.offset + self.by_cage * cage + self.by_shaft * shaft;
        let scale = PI / self.period;
        (scale * angle).sin() * self.radius / scale
    }
}

/// A spall of a race with sharp edges and no floor in reach, as balls pass it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RaceSpall {
    /// The race.
    pub on: Surface,
    /// Angle of its middle, rad.
    pub angle: f64,
    /// Length along the race, m.
    pub length: f64,
    /// Angle of the race from the edge to the middle, where balls strike the far edge, rad.
    pub half_angle: f64,
    /// Part of the shaft's angle by which the race turns back under the balls.
    pub by_shaft: f64,
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
    /// What balls meet of it; none of a defect of a ball, of another profile, or of a slot whose floor balls reach.
    pub(in crate::bearing) fn race_spall(&self, bearing: &Bearing) -> Option<RaceSpall> {
        if let Surface::Ball(_) = self.on {
            return None;
        }
        let geometry = &bearing.geometry;
        let kinks = self.slot(geometry, self.on == Surface::Inner).kinks();
        let meets_edges = self.profile == DefectProfile::Edges && kinks.len() == 3;
        meets_edges.then(|| RaceSpall {
            on: self.on,
            angle: self.angle,
            length: self.length,
            half_angle: 0.5 * self.length / self.on.radius(geometry),
            by_shaft: self.on.by_shaft(bearing.rotating_ring),
        })
    }

    /// How it looks from the side; a dent of a ball as the inner race meets it.
    pub fn side_view(&self, geometry: &Geometry) -> SideView {
        let inner = self.on != Surface::Outer;
        SideView {
            ball_radius: 0.5 * geometry.ball_diameter(),
            race_radius: match self.on {
                Surface::Ball(_) => 0.5 * geometry.ball_diameter(),
                _ => rolling_radius(geometry, inner),
            },
            convex: inner,
            drop: self.slot(geometry, inner).deepest(),
        }
    }

    /// The slot that it is between a ball and the inner or the outer race.
    pub(super) fn slot(&self, geometry: &Geometry, inner: bool) -> Slot {
        let ball_radius = 0.5 * geometry.ball_diameter();
        Slot::new(self, [ball_radius, rolling_radius(geometry, inner)], inner)
    }

    /// When balls pass its kinks.
    pub(super) fn passings(
        &self,
        bearing: &Bearing,
        first_ball: f64,
        rolling_ratio: f64,
    ) -> Vec<Passing> {
        let geometry = &bearing.geometry;
        let radius = self.on.radius(geometry);
        let spacing = TAU / geometry.balls() as f64;
        let past = |start: f64, [by_cage, by_shaft]: [f64; 2], period: f64, inner: bool| {
            let kinks = self.slot(geometry, inner).kinks().into_iter();
            let passing = move |place: f64| Passing {
                offset: start - place / radius,
                by_cage,
                by_shaft,
                period,
                radius,
            };
            kinks.map(passing).collect::<Vec<_>>()
        };
        match self.on {
            Surface::Outer | Surface::Inner => {
                let by_shaft = self.on.by_shaft(bearing.rotating_ring);
                let inner = self.on == Surface::Inner;
                past(first_ball - self.angle, [1.0, by_shaft], spacing, inner)
            }
            Surface::Ball(_) => {
                let under =
                    |middle, inner| past(middle - self.angle, [rolling_ratio, 0.0], TAU, inner);
                [under(PI, true), under(0.0, false)].concat()
            }
        }
    }
}

/// Radius of a race in the rolling plane, m: (d_m ± D cos α)/(2 cos α).
fn rolling_radius(geometry: &Geometry, inner: bool) -> f64 {
    let (side, gamma) = (if inner { -1.0 } else { 1.0 }, geometry.gamma());
    0.5 * geometry.ball_diameter() * (1.0 + side * gamma) / gamma
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn passages_follow_each_other_forwards_and_backwards() {
        for by_shaft in [0.0, -1.0] {
            let passing = Passing {
                offset: 0.3,
                by_cage: 1.0,
                by_shaft,
                period: 0.7,
                radius: 0.02,
            };
            let (ratio, mut angle) = (0.4, 0.0);
            for _ in 0..50 {
                let next = passing.next_angle(angle, ratio, 0).expect("a passage");
                assert!(next > angle);
                let apart = passing.distance(ratio * next, next);
                assert!(apart.abs() < 1e-15, "{apart:e}");
                let further = passing.next_angle(next + 1e-9, ratio, 0).expect("another");
                let expected = 0.7 / passing.rate(ratio).abs();
                assert!((further - next - expected).abs() < 1e-12);
                angle = next + 1e-9;
            }
        }
    }
}
