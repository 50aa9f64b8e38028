//! Whether a motion has settled: how its mean and its spread move from third to third.

use std::f64::consts::TAU;
use std::ops::{Add, Mul, Sub};

use fearless_simd::{Level, Simd, SimdBase, dispatch};

use super::moments::across;
use super::row::{MOST, Row};
use crate::bearing::{LANES, Lanes};
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

/// Weights of the samples of a row, and of one that is not whole with nothing behind them.
#[derive(Default)]
#[repr(align(32))]
struct Weights([[f64; LANES]; MOST / LANES + 1]);

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

    /// Takes the samples of a row, in registers of a level of the processor.
    pub fn record(&mut self, level: Level, row: &Row) {
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
        for (part, sums) in self.sums.iter_mut().enumerate() {
            let inside = ends[part]..ends[part + 1];
            if inside.is_empty() {
                continue;
            }
            let mut weights = Weights::default();
            let (from, count) = (place(times[inside.start]), inside.len());
            dispatch!(level, simd => {
                hann(simd, from, step, count, &mut weights);
                add(simd, &weights, |axis| &row.displacements(axis)[inside.clone()], origin, sums)
            });
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

/// Adds Σ w, and of every freedom Σ w x and Σ w x² of values that count from an origin.
#[inline(always)]
fn add<'a, S: Simd>(
    simd: S,
    weights: &Weights,
    values: impl Fn(usize) -> &'a [f64],
    origin: &[f64; FREEDOMS],
    (sum, freedoms): &mut (f64, [[f64; 2]; FREEDOMS]),
) {
    let mut total = Lanes::splat(simd, 0.0);
    for weights in &weights.0 {
        total += simd.load_array_ref_f64x4(weights);
    }
    *sum += across(total);
    for axis in 0..FREEDOMS {
        let (rows, rest) = values(axis).as_chunks::<LANES>();
        let mut own = [Lanes::splat(simd, 0.0); 2];
        for (row, weights) in rows.iter().zip(&weights.0) {
            add_weighted(simd, row, weights, origin[axis], &mut own);
        }
        if !rest.is_empty() {
            // beyond the last values weights are zero
            let mut last = [origin[axis]; LANES];
            last[..rest.len()].copy_from_slice(rest);
            add_weighted(simd, &last, &weights.0[rows.len()], origin[axis], &mut own);
        }
        freedoms[axis][0] += across(own[0]);
        freedoms[axis][1] += across(own[1]);
    }
}

/// Adds w x and w x² of values that count from an origin.
#[inline(always)]
fn add_weighted<S: Simd>(
    simd: S,
    values: &[f64; LANES],
    weights: &[f64; LANES],
    origin: f64,
    sums: &mut [Lanes<S>; 2],
) {
    let distance = simd.load_array_ref_f64x4(values) - origin;
    let part = simd.load_array_ref_f64x4(weights) * distance;
    sums[0] += part;
    sums[1] += part * distance;
}

/// A Hann window of whole turns at so many places so many turns apart: its phase is turned from a few of them, side
/// by side, to the next; behind the last place there is nothing.
#[inline(always)]
fn hann<S: Simd>(simd: S, place: f64, step: f64, count: usize, weights: &mut Weights) {
    let [start, turn] = [place, step].map(|turns| (TAU * turns).sin_cos());
    let (mut sin, mut cos) = ([0.0; LANES], [0.0; LANES]);
    let mut phase = start;
    for lane in 0..LANES {
        (sin[lane], cos[lane]) = phase;
        phase = turned(phase, turn);
    }
    let twice = turned(turn, turn);
    let turn = turned(twice, twice);
    let turn = (Lanes::splat(simd, turn.0), Lanes::splat(simd, turn.1));
    let mut phases = (
        simd.load_array_ref_f64x4(&sin),
        simd.load_array_ref_f64x4(&cos),
    );
    for number in 0..count.div_ceil(LANES) {
        weights.0[number] = *(0.5 - 0.5 * phases.1);
        phases = turned(phases, turn);
    }
    weights.0.as_flattened_mut()[count..count.next_multiple_of(LANES)].fill(0.0);
}

/// Sine and cosine of the sum of two angles.
#[inline(always)]
fn turned<T>((sin, cos): (T, T), (turn_sin, turn_cos): (T, T)) -> (T, T)
where
    T: Copy + Add<Output = T> + Sub<Output = T> + Mul<Output = T>,
{
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
        let mut weights = Weights::default();
        dispatch!(Level::new(), simd => hann(simd, 1.37, 7e-3, 63, &mut weights));
        let (inside, behind) = weights.0.as_flattened().split_at(63);
        assert!(behind.iter().all(|weight| *weight == 0.0));
        for (index, weight) in inside.iter().enumerate() {
            let expected = (std::f64::consts::PI * (1.37 + 7e-3 * index as f64))
                .sin()
                .powi(2);
            assert!((weight - expected).abs() < 1e-14, "{index}");
        }
    }
}
