//! Whether a motion has settled: how its mean and its spread move from third to third.

use std::f64::consts::TAU;

use super::row::{MOST, Row};
use crate::bearing::LANES;
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
    #[inline(always)]
    pub fn record(&mut self, row: &Row) {
        let times = row.times();
        let [Some(first), Some(last)] = [times.first(), times.last()] else {
            return;
        };
        let origin = std::array::from_fn(|axis| row.displacements(axis)[0]);
        let origin = self.origin.get_or_insert(origin);
        let (start, third) = (self.start, self.third);
        let place = |time: f64| (time - start) / third;
        let ends = [1.0, 2.0, 3.0].map(|end| times.partition_point(|time| place(*time) < end));
        let step = (place(*last) - place(*first)) / (times.len() - 1).max(1) as f64;
        let mut weights = [0.0; MOST.next_multiple_of(LANES)];
        for (part, (sum, freedoms)) in self.sums.iter_mut().enumerate() {
            let inside = ends[part]..ends[part + 1];
            if inside.is_empty() {
                continue;
            }
            hann(place(times[inside.start]), step, &mut weights);
            let weights = &weights[..inside.len()];
            *sum += weights.iter().sum::<f64>();
            for (axis, sums) in freedoms.iter_mut().enumerate() {
                let values = &row.displacements(axis)[inside.clone()];
                add(weights, values, origin[axis], sums);
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

/// Adds Σ w x and Σ w x² of values that count from an origin, a few of them side by side.
#[inline(always)]
fn add(weights: &[f64], values: &[f64], origin: f64, sums: &mut [f64; 2]) {
    let (weights, last_weights) = weights.as_chunks::<LANES>();
    let (values, last_values) = values.as_chunks::<LANES>();
    let (mut first, mut second) = ([0.0; LANES], [0.0; LANES]);
    for (weights, values) in weights.iter().zip(values) {
        for lane in 0..LANES {
            let value = values[lane] - origin;
            let part = weights[lane] * value;
            first[lane] += part;
            second[lane] += part * value;
        }
    }
    for (lane, (weight, value)) in last_weights.iter().zip(last_values).enumerate() {
        let value = value - origin;
        first[lane] += weight * value;
        second[lane] += weight * value * value;
    }
    for (sum, [a, b, c, d]) in sums.iter_mut().zip([first, second]) {
        *sum += (a + b) + (c + d);
    }
}

/// A Hann window of whole turns at places so many turns apart: its phase is turned from a few of them, side by
/// side, to the next.
#[inline(always)]
fn hann(place: f64, step: f64, weights: &mut [f64; MOST.next_multiple_of(LANES)]) {
    let [start, turn] = [place, step].map(|turns| (TAU * turns).sin_cos());
    let (mut sin, mut cos) = ([0.0; LANES], [0.0; LANES]);
    let mut phase = start;
    for lane in 0..LANES {
        (sin[lane], cos[lane]) = phase;
        phase = turned(phase, turn);
    }
    let twice = turned(turn, turn);
    let turn = turned(twice, twice);
    for weights in weights.as_chunks_mut::<LANES>().0 {
        for lane in 0..LANES {
            weights[lane] = 0.5 - 0.5 * cos[lane];
            (sin[lane], cos[lane]) = turned((sin[lane], cos[lane]), turn);
        }
    }
}

/// Sine and cosine of the sum of two angles.
#[inline(always)]
fn turned((sin, cos): (f64, f64), (turn_sin, turn_cos): (f64, f64)) -> (f64, f64) {
    (
        sin * turn_cos + cos * turn_sin,
        cos * turn_cos - sin * turn_sin,
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn weights_of_a_row_are_those_of_the_window() {
        let mut weights = [0.0; MOST.next_multiple_of(LANES)];
        hann(1.37, 7e-3, &mut weights);
        for (index, weight) in weights.iter().enumerate() {
            let expected = (std::f64::consts::PI * (1.37 + 7e-3 * index as f64))
                .sin()
                .powi(2);
            assert!((weight - expected).abs() < 1e-14, "{index}");
        }
    }
}
