//! Points of a motion at equal phases of what drives it: Poincaré sections.

use std::f64::consts::TAU;
use std::fmt;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::analysis::Hermite;
use crate::analysis::recording::keep_last;
use crate::keys;
use crate::rotor::{FREEDOMS, Sample};

/// Samples that a point is interpolated between.
pub(super) const NODES: usize = 4;
/// Points of a section that are kept: the last ones.
const MOST_POINTS: usize = 1 << 14;
/// Part of a cycle by which a sample may miss a point and still be it.
const ON_THE_SPOT: f64 = 1e-9;

/// What a point is interpolated from.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(super) struct Node {
    time: f64,
    /// Of the shaft, rad.
    angle: f64,
    displacement: [f64; FREEDOMS],
    velocity: [f64; FREEDOMS],
}

impl Node {
    /// What a sample says of it.
    pub fn from_sample(sample: &Sample) -> Self {
        Self {
            time: sample.time,
            angle: sample.angle,
            displacement: sample.displacement,
            velocity: sample.velocity,
        }
    }
}

/// When a point is taken.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
#[non_exhaustive]
pub enum SectionKind {
    /// Once a revolution of the shaft.
    Revolution,
    /// Every time a ball of the first bearing passes where its first ball began.
    BallPass,
}

/// `revolution`, `ball_pass`.
impl fmt::Display for SectionKind {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(match self {
            Self::Revolution => "revolution",
            Self::BallPass => "ball_pass",
        })
    }
}

/// The motion at one phase.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct PoincarePoint {
    /// Cycles of the section since the start.
    pub number: u64,
    /// Time, s.
    pub time: f64,
    /// x, y, z in m, θx, θy in rad.
    pub displacement: [f64; FREEDOMS],
    /// Their rates.
    pub velocity: [f64; FREEDOMS],
}

/// Takes samples at equal times and constant speed, and finds the points of one section.
///
/// A point that falls on a sample is that sample; between samples, displacements and velocities are
/// interpolated through four samples with their rates, of velocities those of the polynomial.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[non_exhaustive]
pub struct Section {
    /// What a point is taken of.
    #[serde(rename = "section")]
    pub kind: SectionKind,
    /// Cycles a revolution of the shaft.
    #[serde(rename = "cycles_per_revolution")]
    pub order: f64,
    /// The points, by time: the last 16 384.
    #[serde(serialize_with = "keys::count")]
    pub points: Vec<PoincarePoint>,
    /// Largest difference of a displacement from that through three samples only, m and rad by freedom:
    /// more than the error of the interpolation.
    #[serde(rename = "interpolation_error")]
    pub interpolation: [f64; FREEDOMS],
}

impl Section {
    /// For `order` cycles a revolution.
    pub(crate) fn new(kind: SectionKind, order: f64) -> Self {
        Self {
            kind,
            order,
            points: Vec::new(),
            interpolation: [0.0; FREEDOMS],
        }
    }

    /// Takes four samples that follow each other and finds the points between the middle two, the second included.
    pub(super) fn record(&mut self, nodes: &[Node; NODES]) {
        let phase = |node: &Node| self.order * node.angle / TAU + ON_THE_SPOT;
        let [before, after] = [1, 2].map(|node: usize| phase(&nodes[node]));
        let mut number = before.floor() + 1.0;
        while number <= after {
            let part = ((number - before) / (after - before)).min(1.0);
            let missed = (after - number).abs() < 2.0 * ON_THE_SPOT;
            self.add(nodes, number as u64, if missed { 1.0 } else { part });
            number += 1.0;
        }
        keep_last(
            &mut self.points,
            MOST_POINTS + MOST_POINTS / 16,
            MOST_POINTS,
        );
    }

    /// With no more points than are kept.
    pub(super) fn of_last(mut self) -> Self {
        keep_last(&mut self.points, MOST_POINTS, MOST_POINTS);
        self
    }

    /// Adds the point at a part of the way from the second to the third sample.
    fn add(&mut self, nodes: &[Node; NODES], number: u64, part: f64) {
        let [_, before, after, _] = nodes;
        if part == 1.0 {
            self.points.push(PoincarePoint {
                number,
                time: after.time,
                displacement: after.displacement,
                velocity: after.velocity,
            });
            return;
        }
        let interval = after.time - before.time;
        let mut point = PoincarePoint {
            number,
            time: before.time + part * interval,
            displacement: [0.0; FREEDOMS],
            velocity: [0.0; FREEDOMS],
        };
        let position = 1.0 + part;
        let [at, later, earlier] = [position, position + SLOPE, position - SLOPE]
            .map(|position| Hermite::<NODES>::new(0, position));
        let fewer = Hermite::<{ NODES - 1 }>::new(1, position);
        for axis in 0..FREEDOMS {
            let values = nodes.each_ref().map(|node| node.displacement[axis]);
            let rates = nodes.each_ref().map(|node| node.velocity[axis] * interval);
            point.displacement[axis] = at.value(values, rates);
            point.velocity[axis] = (later.value(values, rates) - earlier.value(values, rates))
                / (2.0 * SLOPE * interval);
            let ([_, values @ ..], [_, rates @ ..]) = (values, rates);
            let difference = (fewer.value(values, rates) - point.displacement[axis]).abs();
            self.interpolation[axis] = self.interpolation[axis].max(difference);
        }
        self.points.push(point);
    }
}

/// Part of an interval over which the slope of the polynomial is taken: its error is below that of the
/// interpolation, and round-off small.
const SLOPE: f64 = 1e-3;
