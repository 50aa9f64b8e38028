//! The path of the shaft's centre over its last revolutions.

use std::collections::VecDeque;
use std::f64::consts::TAU;

use serde_json::{Value, json};

use super::curve::curve;
use crate::analysis::{Motion, Section};
use crate::report::terminal::MICRO;
use crate::rotor::Sample;

/// Most samples that are kept.
const MOST_SAMPLES: usize = 16_384;
/// Most points of a section that are drawn.
const MOST_POINTS: usize = 2000;
/// Revolutions that are drawn.
const REVOLUTIONS: f64 = 10.0;

/// The last samples of a run: shaft angle, x and y.
#[derive(Debug, Clone, Default)]
pub(super) struct Orbit {
    last: VecDeque<[f64; 3]>,
}

impl Orbit {
    /// Takes one sample.
    pub fn sample(&mut self, sample: &Sample) {
        if self.last.len() == MOST_SAMPLES {
            self.last.pop_front();
        }
        let [x, y, ..] = sample.displacement;
        self.last.push_back([sample.angle, MICRO * x, MICRO * y]);
    }

    /// The last revolutions, or as much of them as is known: x and y in µm.
    pub fn curve(&self) -> Value {
        let end = self.last.back().map_or(0.0, |[angle, ..]| *angle);
        let start = end - REVOLUTIONS * TAU;
        let drawn = self.last.iter().filter(|[angle, ..]| *angle >= start);
        let first = drawn.clone().next().map_or(end, |[angle, ..]| *angle);
        json!({
            "revolutions": (end - first) / TAU,
            "curve": curve("orbit", drawn.map(|[_, x, y]| (*x, *y))),
        })
    }
}

/// Where the shaft stands once a cycle of every section: x and y in µm.
pub(super) fn sections(motion: &Motion) -> Value {
    let section = |section: &Section| {
        let start = section.points.len().saturating_sub(MOST_POINTS);
        let points = section.points[start..].iter().map(|point| {
            let [x, y, ..] = point.displacement;
            (MICRO * x, MICRO * y)
        });
        curve(&section.kind.to_string(), points)
    };
    motion.sections.iter().map(section).collect()
}
