//! Whether a motion has settled: how its mean and its spread move from third to third.

use std::f64::consts::TAU;

use super::row::{MOST, Row};
use crate::rotor::FREEDOMS;

/// A motion whose statistics move by less than this part of it has settled.
pub const SETTLED: f64 = 0.02;

/// How far mean and RMS of a freedom move from the second to the last third of the window.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Drift {
    /// The freedom that moves most, 0 … 4.
    pub freedom: usize,
    /// Change of its mean, in parts of the RMS of the motion.
    pub mean: f64,
    /// Change of its RMS, in the same parts.
    pub rms: f64,
}

impl Drift {
    /// The larger of both changes.
    pub fn largest(&self) -> f64 {
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

    /// Takes the samples of a row.
    pub fn record(&mut self, row: &Row) {
        let times = row.times();
        let [Some(first), Some(last)] = [times.first(), times.last()] else {
            return;
        };
        let origin = std::array::from_fn(|axis| row.displacements(axis)[0]);
        self.origin.get_or_insert(origin);
        let (start, third) = (self.start, self.third);
        let place = |time: f64| (time - start) / third;
        let ends = [1.0, 2.0, 3.0].map(|end| times.partition_point(|time| place(*time) < end));
        let step = (place(*last) - place(*first)) / (times.len() - 1).max(1) as f64;
        let mut weights = [0.0; MOST];
        for part in 0..2 {
            let inside = ends[part]..ends[part + 1];
            if inside.is_empty() {
                continue;
            }
            let weights = &mut weights[..inside.len()];
            hann(place(times[inside.start]), step, weights);
            self.add(part, weights, |axis| {
                &row.displacements(axis)[inside.clone()]
            });
        }
    }

    /// Adds values of all freedoms under their weights.
    fn add<'a>(&mut self, part: usize, weights: &[f64], of: impl Fn(usize) -> &'a [f64]) {
        let Some(origin) = self.origin else { return };
        let (sum, freedoms) = &mut self.sums[part];
        *sum += weights.iter().sum::<f64>();
        for (axis, [first, second]) in freedoms.iter_mut().enumerate() {
            for (weight, value) in weights.iter().zip(of(axis)) {
                let value = value - origin[axis];
                *first += weight * value;
                *second += weight * value * value;
            }
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

/// A Hann window of whole turns at places so many turns apart: its phase is turned from one to the next.
fn hann(place: f64, step: f64, weights: &mut [f64]) {
    let [(mut sin, mut cos), (turn_sin, turn_cos)] =
        [place, step].map(|turns| (TAU * turns).sin_cos());
    for weight in weights {
        *weight = 0.5 - 0.5 * cos;
        (sin, cos) = (
            sin * turn_cos + cos * turn_sin,
            cos * turn_cos - sin * turn_sin,
        );
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn weights_of_a_row_are_those_of_the_window() {
        let mut weights = [0.0; MOST];
        hann(1.37, 7e-3, &mut weights);
        for (index, weight) in weights.iter().enumerate() {
            let expected = (std::f64::consts::PI * (1.37 + 7e-3 * index as f64))
                .sin()
                .powi(2);
            assert!((weight - expected).abs() < 1e-14, "{index}");
        }
    }
}
