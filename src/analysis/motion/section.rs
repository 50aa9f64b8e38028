//! Points of a motion at equal phases of what drives it: Poincaré sections.

use std::f64::consts::TAU;
use std::fmt;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::keys;
use crate::rotor::{FREEDOMS, Sample};

/// Samples that a point is interpolated between.
pub(super) const NODES: usize = 4;
/// Part of a cycle by which a sample may miss a point and still be it.
const ON_THE_SPOT: f64 = 1e-9;

/// When a point is taken.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
#[non_exhaustive]
pub enum SectionKind {
    /// Once a revolution of the shaft.
    Revolution,
    /// Every time a ball of the first bearing passes where ball 0 began.
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
    /// The points, by time.
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
    pub(super) fn record(&mut self, nodes: &[Sample; NODES]) {
        let phase = |sample: &Sample| self.order * sample.angle / TAU + ON_THE_SPOT;
        let [before, after] = [1, 2].map(|node: usize| phase(&nodes[node]));
        let mut number = before.floor() + 1.0;
        while number <= after {
            let part = ((number - before) / (after - before)).min(1.0);
            let missed = (after - number).abs() < 2.0 * ON_THE_SPOT;
            self.add(nodes, number as u64, if missed { 1.0 } else { part });
            number += 1.0;
        }
    }

    /// Adds the point at a part of the way from the second to the third sample.
    fn add(&mut self, nodes: &[Sample; NODES], number: u64, part: f64) {
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
        let place = 1.0 + part;
        let [at, later, earlier] =
            [place, place + SLOPE, place - SLOPE].map(|place| Hermite::<NODES>::new(0, place));
        let fewer = Hermite::<{ NODES - 1 }>::new(1, place);
        for axis in 0..FREEDOMS {
            let values = nodes.map(|node| node.displacement[axis]);
            let rates = nodes.map(|node| node.velocity[axis] * interval);
            // a freedom that is held stays where it is
            if values == [0.0; NODES] && rates == values {
                continue;
            }
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

/// The polynomial through values and slopes at whole places `first`, `first` + 1, …, seen at one place: the same
/// weights serve every quantity that is known there.
///
/// ```text
/// p(s) = Σ_i [1 − 2 l_i'(i)(s − i)] l_i(s)² f_i + (s − i) l_i(s)² f_i'
/// ```
///
/// with l_i Lagrange's polynomials of the places: of degree 7 through four of them. Between the middle
/// two its error is at most `(9/16)² h⁸ |f⁽⁸⁾|/8!`, h the distance of the places.
///
/// Source: Hermite's interpolation, e.g. Stoer & Bulirsch, *Introduction to Numerical Analysis*, 3rd ed.
/// (2002), section 2.1.5.
pub struct Hermite<const K: usize> {
    /// Of every value and its slope.
    weights: [[f64; 2]; K],
}

impl<const K: usize> Hermite<K> {
    pub fn new(first: usize, place: f64) -> Self {
        let at = |index: usize| (first + index) as f64;
        let weights = std::array::from_fn(|i| {
            let (mut lagrange, mut rate) = (1.0, 0.0);
            for j in 0..K {
                // known as this is compiled
                let apart = i as f64 - j as f64;
                if j != i {
                    lagrange *= (place - at(j)) / apart;
                    rate += 1.0 / apart;
                }
            }
            let (square, distance) = (lagrange * lagrange, place - at(i));
            [square * (1.0 - 2.0 * rate * distance), square * distance]
        });
        Self { weights }
    }

    /// Value of the polynomial through these at the place.
    pub fn value(&self, values: [f64; K], slopes: [f64; K]) -> f64 {
        let mut sum = 0.0;
        for (i, [own, by_slope]) in self.weights.iter().enumerate() {
            sum += own * values[i] + by_slope * slopes[i];
        }
        sum
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_polynomial_of_degree_seven_is_met_exactly() {
        let value = |s: f64| 1.0 + s - 0.3 * s.powi(4) + 0.01 * s.powi(7);
        let slope = |s: f64| 1.0 - 1.2 * s.powi(3) + 0.07 * s.powi(6);
        let places = [0.0, 1.0, 2.0, 3.0];
        for place in [1.0, 1.25, 1.5, 2.0] {
            let found = Hermite::new(0, place).value(places.map(value), places.map(slope));
            assert!((found - value(place)).abs() < 1e-14, "{place}: {found}");
        }
    }

    #[test]
    fn a_cosine_is_met_within_the_bound_of_the_remainder() {
        for step in [0.2, 0.4, 0.8] {
            let value = |s: f64| (step * s).cos();
            let slope = |s: f64| -step * (step * s).sin();
            let places = [0.0, 1.0, 2.0, 3.0];
            let bound = (9.0f64 / 16.0).powi(2) * step.powi(8) / 40_320.0;
            for part in 0..=10 {
                let place = 1.0 + 0.1 * f64::from(part);
                let found = Hermite::new(0, place).value(places.map(value), places.map(slope));
                let error = found - value(place);
                assert!(
                    error.abs() <= bound + 1e-15,
                    "{step} {place}: {error:e} of {bound:e}"
                );
            }
        }
    }
}
