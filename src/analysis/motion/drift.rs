//! Whether a motion has settled: how its mean and its spread move from third to third.

use std::f64::consts::TAU;

use serde::Serialize;

use crate::rotor::{FREEDOMS, Sample};

/// A motion whose statistics move by less than this part of it has settled.
pub const SETTLED: f64 = 0.02;

/// How far mean and RMS of a freedom move from the second to the last third of the window.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Drift {
    /// The freedom that moves most, 0 … 4.
    #[serde(skip)]
    pub freedom: usize,
    /// Change of its mean, in parts of the RMS of the motion.
    pub mean: f64,
    /// Change of its RMS, in the same parts.
    pub rms: f64,
}

impl Drift {
    /// The larger of both changes.
    pub(crate) fn largest(&self) -> f64 {
        self.mean.abs().max(self.rms.abs())
    }

    /// Whether the motion has settled.
    pub fn is_settled(&self) -> bool {
        self.largest() < SETTLED
    }
}

/// Takes samples of the freedoms at equal times over a window of known ends.
///
/// Mean and RMS of each third are weighted by a Hann window over it, so that a vibration of no whole
/// number of periods in a third does not move them.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct DriftRecorder {
    start: f64,
    third: f64,
    /// Where the sums count from.
    origin: Option<[f64; FREEDOMS]>,
    /// Of the second and the last third Σ w, and of every freedom Σ w x and Σ w x².
    sums: [(f64, [[f64; 2]; FREEDOMS]); 2],
}

impl DriftRecorder {
    /// For samples from `start` to `end`, s.
    pub fn new(start: f64, end: f64) -> Self {
        Self {
            start,
            third: (end - start) / 3.0,
            origin: None,
            sums: [(0.0, [[0.0; 2]; FREEDOMS]); 2],
        }
    }

    /// Takes a sample.
    pub fn record(&mut self, sample: &Sample) {
        let origin = self.origin.get_or_insert(sample.displacement);
        let place = (sample.time - self.start) / self.third;
        let (weights, sums) = match place {
            1.0..2.0 => &mut self.sums[0],
            2.0..3.0 => &mut self.sums[1],
            _ => return,
        };
        // a Hann window over every third
        let weight = 0.5 - 0.5 * (TAU * place).cos();
        *weights += weight;
        for axis in 0..FREEDOMS {
            let distance = sample.displacement[axis] - origin[axis];
            sums[axis][0] += weight * distance;
            sums[axis][1] += weight * distance * distance;
        }
    }

    /// The freedom that moves most, lengths and angles made comparable by `levers`, in parts of `scale`;
    /// none where a third holds too little.
    pub fn finish(&self, levers: &[f64; FREEDOMS], scale: f64) -> Option<Drift> {
        let [second, last] = &self.sums;
        if !(second.0 > 0.0 && last.0 > 0.0 && scale > 0.0) {
            return None;
        }
        let statistics = |(weight, sums): &(f64, [[f64; 2]; FREEDOMS]), axis: usize| {
            let [first, square] = sums[axis].map(|sum| sum / weight);
            [first, (square - first * first).max(0.0).sqrt()]
        };
        let drifts = levers.iter().enumerate().map(|(freedom, lever)| {
            let (before, after) = (statistics(second, freedom), statistics(last, freedom));
            let change = |index: usize| lever * (after[index] - before[index]) / scale;
            Drift {
                freedom,
                mean: change(0),
                rms: change(1),
            }
        });
        drifts.max_by(|a, b| a.largest().total_cmp(&b.largest()))
    }
}
