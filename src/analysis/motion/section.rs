//! Points of a motion at equal phases of what drives it: Poincaré sections.

use std::array;
use std::collections::VecDeque;
use std::f64::consts::TAU;
use std::fmt;

use super::hermite::hermite;
use crate::rotor::{FREEDOMS, Sample};

/// Samples that a point is interpolated between.
const NODES: usize = 4;
/// Part of a cycle by which a sample may miss a point and still be it.
const ON_THE_SPOT: f64 = 1e-9;

/// What a point is taken once of.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum SectionKind {
    /// A revolution of the shaft.
    Revolution,
    /// A pass of the balls of the first bearing.
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
#[derive(Debug, Clone, PartialEq)]
pub struct Section {
    /// What a point is taken of.
    pub kind: SectionKind,
    /// Cycles a revolution of the shaft.
    pub order: f64,
    /// The points, by time.
    pub points: Vec<PoincarePoint>,
    /// Largest difference of a displacement from that through three samples only, m and rad by freedom:
    /// more than the error of the interpolation.
    pub interpolation: [f64; FREEDOMS],
    nodes: VecDeque<Node>,
}

/// What is interpolated between.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Node {
    /// Cycles since the start.
    phase: f64,
    /// Whole ones among them.
    cycles: f64,
    time: f64,
    displacement: [f64; FREEDOMS],
    velocity: [f64; FREEDOMS],
}

impl Section {
    /// For `order` cycles a revolution.
    pub fn new(kind: SectionKind, order: f64) -> Self {
        Self {
            kind,
            order,
            points: Vec::new(),
            interpolation: [0.0; FREEDOMS],
            nodes: VecDeque::with_capacity(NODES + 1),
        }
    }

    /// Takes one sample.
    pub fn record(&mut self, sample: &Sample) {
        let phase = self.order * sample.angle / TAU + ON_THE_SPOT;
        self.nodes.push_back(Node {
            phase,
            cycles: phase.floor(),
            time: sample.time,
            displacement: sample.displacement,
            velocity: sample.velocity,
        });
        if self.nodes.len() > NODES {
            self.nodes.pop_front();
        }
        if self.nodes.len() == NODES {
            self.look();
        }
    }

    /// Looks for points after the second and up to the third of four samples.
    fn look(&mut self) {
        let [from, to] = [&self.nodes[1], &self.nodes[2]];
        let [before, after] = [from.phase, to.phase];
        let (mut number, last) = (from.cycles + 1.0, to.cycles);
        while number <= last {
            let part = ((number - before) / (after - before)).min(1.0);
            let missed = (after - number).abs() < 2.0 * ON_THE_SPOT;
            self.add(number as u64, if missed { 1.0 } else { part });
            number += 1.0;
        }
    }

    /// Adds the point at a part of the way from the second to the third sample.
    fn add(&mut self, number: u64, part: f64) {
        let [before, after] = [&self.nodes[1], &self.nodes[2]];
        if part == 1.0 {
            let Node {
                time,
                displacement,
                velocity,
                ..
            } = *after;
            self.points.push(PoincarePoint {
                number,
                time,
                displacement,
                velocity,
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
        for axis in 0..FREEDOMS {
            let node = |index: usize| &self.nodes[index];
            let values: [f64; NODES] = array::from_fn(|index| node(index).displacement[axis]);
            let rates: [f64; NODES] = array::from_fn(|index| node(index).velocity[axis] * interval);
            // a freedom that is held stays where it is
            if values == [0.0; NODES] && rates == values {
                continue;
            }
            let place = 1.0 + part;
            let at = |place: f64| hermite(0, &values, &rates, place);
            point.displacement[axis] = at(place);
            point.velocity[axis] =
                (at(place + SLOPE) - at(place - SLOPE)) / (2.0 * SLOPE * interval);
            let fewer = hermite(1, &values[1..], &rates[1..], place);
            let difference = (fewer - point.displacement[axis]).abs();
            self.interpolation[axis] = self.interpolation[axis].max(difference);
        }
        self.points.push(point);
    }
}

/// Part of an interval over which the slope of the polynomial is taken: its error is below that of the
/// interpolation, and round-off small.
const SLOPE: f64 = 1e-3;
