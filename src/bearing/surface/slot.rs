//! A defect of a surface: a slot across the race, or a dent of a ball, and how far a ball sinks into it.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::Defect;

/// How the drop of a ball follows from its place over a defect.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum DefectProfile {
    /// Sharp edges: the ball rests on the nearer edge until it meets the floor.
    #[default]
    Edges,
    /// Half a sine of the full depth, as literature has it.
    HalfSine,
    /// The full depth, as literature has it, over all but a thousandth of the length at either end.
    Rectangular,
}

/// Part of the length over which the drop of a rectangular profile sets in: a force that jumps has no solution that a
/// step could end on.
const RAMP: f64 = 1e-3;

/// A slot under a ball of radius R on a race of radius ρ in the rolling plane.
///
/// With sharp edges the ball rests on the nearer one, β from it as seen from the centre of the race, and the surface
/// under it lies lower by
///
/// ```text
/// outer race  d = R − ρ (1 − cos β) − √(R² − ρ² sin² β)
/// inner race  d = R + ρ (1 − cos β) − √(R² − ρ² sin² β)      drop = min(h, d)
/// ```
///
/// in m, with the depth h of the floor. For small angles d = s²/2 (1/R ∓ 1/ρ) at a distance s from the edge: a ball
/// reaches the floor only in a slot longer than √(8h/(1/R ∓ 1/ρ)).
///
/// A dent of a ball drops it by the same d when it meets a race of that curvature.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Slot {
    /// Half the length, m.
    half: f64,
    /// h, m.
    depth: f64,
    profile: DefectProfile,
    /// R, m.
    ball_radius: f64,
    /// ρ, m.
    race_radius: f64,
    /// 1 on an inner race, −1 on an outer one.
    side: f64,
    /// Distance from an edge at which the ball meets the floor, m; infinite where the floor is too deep.
    floor: f64,
}

impl Slot {
    /// Slot of a defect between a ball and the inner or the outer race, with the radii R and ρ in m, ρ infinite of a flat
    /// washer.
    pub fn new(defect: &Defect, [ball_radius, race_radius]: [f64; 2], inner: bool) -> Self {
        let depth = defect.depth;
        let side = if inner { 1.0 } else { -1.0 };
        // sin² β/2 = h (2R − h)/(4 ρ r), r the distance of the ball's centre on the floor from that of the race
        let centre = race_radius + side * (ball_radius - depth);
        let square = depth * (2.0 * ball_radius - depth) / (4.0 * race_radius * centre);
        let floor = if depth < ball_radius && centre > 0.0 && square < 1.0 {
            2.0 * race_radius * square.sqrt().asin()
        } else {
            f64::INFINITY
        };
        Self {
            half: 0.5 * defect.length,
            depth,
            profile: defect.profile,
            ball_radius,
            race_radius,
            side,
            floor,
        }
    }

    /// Drop, m, and its slope, at a distance from the middle along the race in m.
    pub fn at(&self, place: f64) -> [f64; 2] {
        let from_edge = self.half - place.abs();
        if from_edge <= 0.0 {
            return [0.0; 2];
        }
        let [drop, slope] = match self.profile {
            DefectProfile::Edges => self.on_edge(from_edge),
            DefectProfile::HalfSine => {
                let rate = 0.5 * std::f64::consts::PI / self.half;
                let (sin, cos) = (rate * from_edge).sin_cos();
                [self.depth * sin, self.depth * rate * cos]
            }
            DefectProfile::Rectangular => {
                let ramp = 2.0 * self.half * RAMP;
                if from_edge < ramp {
                    [self.depth * from_edge / ramp, self.depth / ramp]
                } else {
                    [self.depth, 0.0]
                }
            }
        };
        [drop, if place < 0.0 { slope } else { -slope }]
    }

    /// Drop and slope at a distance from the nearer sharp edge.
    fn on_edge(&self, distance: f64) -> [f64; 2] {
        if distance >= self.floor {
            return [self.depth, 0.0];
        }
        let angle = distance / self.race_radius;
        let (sin, cos) = angle.sin_cos();
        let half_sin = (0.5 * angle).sin();
        let aside = self.race_radius * sin;
        let root = (self.ball_radius * self.ball_radius - aside * aside).sqrt();
        if root.is_nan() {
            return [self.depth, 0.0];
        }
        // R − √(R² − a²) = a²/(R + √(R² − a²))
        let drop = aside * aside / (self.ball_radius + root)
            + self.side * 2.0 * self.race_radius * half_sin * half_sin;
        [
            drop.min(self.depth),
            sin * (self.race_radius * cos / root + self.side),
        ]
    }

    /// Largest drop, m.
    pub fn deepest(&self) -> f64 {
        match self.profile {
            DefectProfile::Edges => self.on_edge(self.half)[0],
            DefectProfile::HalfSine | DefectProfile::Rectangular => self.depth,
        }
    }

    /// Places along the race at which the drop is not smooth, m from the middle: entry, where the ball meets the floor or
    /// the other edge, where it leaves them, exit.
    pub fn kinks(&self) -> Vec<f64> {
        let inner = match self.profile {
            DefectProfile::Edges if self.floor < self.half => Some(self.half - self.floor),
            DefectProfile::Edges => Some(0.0),
            DefectProfile::HalfSine => None,
            DefectProfile::Rectangular => Some(self.half * (1.0 - 2.0 * RAMP)),
        };
        let mut kinks = vec![-self.half, self.half];
        match inner {
            Some(0.0) => kinks.push(0.0),
            Some(place) => kinks.extend([-place, place]),
            None => {}
        }
        kinks
    }
}

#[cfg(test)]
mod tests {
    use super::super::Surface;
    use super::*;

    /// 6205 of a well-known data set: D 7.94, d_m 39.04 mm, 0°.
    fn slot(length: f64, depth: f64, profile: DefectProfile, inner: bool) -> Slot {
        let side = if inner { -7.94e-3 } else { 7.94e-3 };
        let defect = Defect {
            on: Surface::Outer,
            angle: 0.0,
            length,
            depth,
            profile,
        };
        Slot::new(&defect, [3.97e-3, 0.5 * (39.04e-3 + side)], inner)
    }

    #[test]
    fn faults_of_a_6205_drop_the_ball_by_less_than_their_depth() {
        let expected = [
            (7.0, [0.8273, 1.2496]),
            (14.0, [3.3105, 4.9998]),
            (21.0, [7.4540, 11.2546]),
        ];
        for (thousandths, drops) in expected {
            for (inner, drop) in [false, true].into_iter().zip(drops) {
                let length = thousandths * 25.4e-6;
                let slot = slot(length, 11.0 * 25.4e-6, DefectProfile::Edges, inner);
                let found = 1e6 * slot.deepest();
                assert!((found - drop).abs() < 0.6e-4, "{found}, not {drop}");
                assert_eq!(slot.kinks().len(), 3);
            }
        }
    }

    /// The lengths by the formula of small angles, which are longer than the exact ones by parts of h/R.
    #[test]
    fn the_floor_is_reached_from_a_length_on() {
        let lengths = [
            (5e-6, [0.4371e-3, 0.3557e-3], 5e-4),
            (50e-6, [1.382e-3, 1.125e-3], 5e-3),
        ];
        for (depth, lengths, apart) in lengths {
            for (inner, length) in [false, true].into_iter().zip(lengths) {
                let slot = |length| slot(length, depth, DefectProfile::Edges, inner);
                let edge = 2.0 * slot(1.0).floor;
                assert!((edge / length - 1.0).abs() < apart, "{edge:e}");
                assert!(slot(0.999 * edge).deepest() < depth);
                let long = slot(1.001 * edge);
                assert_eq!((long.deepest(), long.kinks().len()), (depth, 4));
                // continuous where the floor is met
                let before = long.on_edge(long.floor * (1.0 - 1e-9))[0];
                assert!((before / depth - 1.0).abs() < 1e-8);
            }
        }
    }

    #[test]
    fn slopes_are_those_of_the_drops() {
        for profile in [
            DefectProfile::Edges,
            DefectProfile::HalfSine,
            DefectProfile::Rectangular,
        ] {
            for inner in [false, true] {
                let slot = slot(0.5e-3, 5e-6, profile, inner);
                for part in [-0.9999, -0.93, -0.4, 0.05, 0.2, 0.97, 0.9999, 1.2] {
                    let (place, step) = (part * slot.half, 1e-9);
                    let [up, down] = [step, -step].map(|step| slot.at(place + step)[0]);
                    let slope = slot.at(place)[1];
                    let expected = (up - down) / (2.0 * step);
                    assert!(
                        (slope - expected).abs() < 1e-6,
                        "{profile:?} {part}: {slope} {expected}"
                    );
                }
            }
        }
    }
}
