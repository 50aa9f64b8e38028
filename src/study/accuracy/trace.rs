//! What is kept of a run to compare it with another: its trace, thinned where it is long, and its
//! statistics.

use std::io;

use serde::Serialize;

use crate::analysis::Moments;
use crate::rotor::{FREEDOMS, MotionScale, Rotor, Sample};
use crate::simulate::{Model, TraceSink};

/// Most points that are kept of a trace.
const MOST_POINTS: u64 = 1 << 17;

/// Displacement and force on the shaft, side by side.
type Point = [[f64; FREEDOMS]; 2];

/// Mean, root mean square about it, and half the peak-to-peak value of a quantity.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize)]
pub struct Statistics {
    /// Mean.
    pub mean: f64,
    /// Root mean square of the deviation from the mean.
    pub rms: f64,
    /// Half the difference of largest and smallest value.
    pub peak: f64,
}

impl Statistics {
    /// Each with that of another.
    fn with(&self, other: &Self, both: fn(f64, f64) -> f64) -> Self {
        Self {
            mean: both(self.mean, other.mean),
            rms: both(self.rms, other.rms),
            peak: both(self.peak, other.peak),
        }
    }

    /// Mean, rms and peak by their distances from another's.
    fn distance(&self, other: &Self) -> Self {
        self.with(other, |own, other| (own - other).abs())
    }

    /// The larger of each.
    pub(super) fn larger(&self, other: &Self) -> Self {
        self.with(other, f64::max)
    }

    /// Each as many times as large.
    pub(super) fn times(&self, factor: f64) -> Self {
        Self {
            mean: self.mean * factor,
            rms: self.rms * factor,
            peak: self.peak * factor,
        }
    }
}

impl From<&Moments> for Statistics {
    fn from(moments: &Moments) -> Self {
        Self {
            mean: moments.mean(),
            rms: moments.rms(),
            peak: 0.5 * moments.peak_to_peak(),
        }
    }
}

/// What is compared of a scene, the same for all its runs.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct View {
    /// Number of freedoms that count: the first so many of x, y, z, θx, θy.
    pub active: usize,
    /// Length that turns tilts into displacements and moments into forces, m.
    pub arm: f64,
    /// Time from which statistics count, s.
    pub settle: f64,
    /// Every how many samples a point is kept.
    pub stride: u64,
}

impl View {
    /// The view of the motion of a model.
    pub fn new(rotor: &Rotor, scale: &MotionScale, model: &Model) -> Self {
        Self {
            active: rotor.active_freedoms(),
            arm: scale.arm,
            settle: model.settle,
            stride: (model.samples() / MOST_POINTS as f64).ceil().max(1.0) as u64,
        }
    }

    /// Factor that makes a length of a displacement (`quantity` 0) and a force of a moment (1).
    fn lever(&self, quantity: usize, axis: usize) -> f64 {
        match (axis < 3, quantity) {
            (true, _) => 1.0,
            (false, 0) => self.arm,
            (false, _) => 1.0 / self.arm,
        }
    }
}

/// The trace of a run as far as it is compared.
#[derive(Debug, Clone)]
pub(super) struct Trace {
    view: View,
    samples: u64,
    times: Vec<f64>,
    points: Vec<Point>,
    moments: [[Moments; FREEDOMS]; 2],
}

/// Distance of two traces: of displacements in m, of forces in N.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(super) struct Distance {
    /// Largest at any instant.
    pub largest: [f64; 2],
    /// Root mean square of the difference about its mean, of the freedom where it is largest.
    pub vibration: [f64; 2],
    /// Of the statistics, the freedom where it is largest.
    pub statistics: [Statistics; 2],
}

impl Trace {
    pub fn new(view: View) -> Self {
        Self {
            view,
            samples: 0,
            times: Vec::new(),
            points: Vec::new(),
            moments: [[Moments::default(); FREEDOMS]; 2],
        }
    }

    /// Axes of both quantities with their levers.
    fn channels(&self) -> impl Iterator<Item = (usize, usize, f64)> + use<> {
        let view = self.view;
        (0..2).flat_map(move |quantity| {
            (0..view.active).map(move |axis| (quantity, axis, view.lever(quantity, axis)))
        })
    }

    /// Largest distance of displacement and force from those at `rest`.
    pub fn excursion(&self, rest: &Point) -> [f64; 2] {
        let mut largest = [0.0_f64; 2];
        for (quantity, axis, lever) in self.channels() {
            for point in &self.points {
                let shift = lever * (point[quantity][axis] - rest[quantity][axis]).abs();
                largest[quantity] = largest[quantity].max(shift);
            }
        }
        largest
    }

    /// Distance from the true trace of the same samples, from a time on, over the freedoms that move
    /// there.
    pub fn distance(&self, truth: &Self, from: f64) -> Distance {
        let mut distance = Distance::default();
        let first = self.times.partition_point(|time| *time < from);
        for (quantity, axis, lever) in truth.channels() {
            let pairs = self.points.iter().zip(&truth.points).skip(first);
            let differences =
                pairs.map(|(left, right)| lever * (left[quantity][axis] - right[quantity][axis]));
            let apart: Moments = differences.collect();
            let (largest, vibration) = (apart.magnitude(), apart.rms());
            let statistics = self.statistics(quantity, axis);
            let statistics = statistics.distance(&truth.statistics(quantity, axis));
            let statistics = statistics.times(lever);
            distance.largest[quantity] = distance.largest[quantity].max(largest);
            distance.vibration[quantity] = distance.vibration[quantity].max(vibration);
            distance.statistics[quantity] = distance.statistics[quantity].larger(&statistics);
        }
        distance
    }

    /// By how much the difference of displacements grows: of its largest values in `parts` equal parts of the time, the
    /// largest over the first.
    pub fn growth(&self, other: &Self, parts: usize) -> f64 {
        let length = self.points.len().div_ceil(parts).max(1);
        let apart = |(left, right): (&Point, &Point)| {
            (0..self.view.active)
                .map(|axis| self.view.lever(0, axis) * (left[0][axis] - right[0][axis]).abs())
                .fold(0.0, f64::max)
        };
        let pairs: Vec<f64> = self.points.iter().zip(&other.points).map(apart).collect();
        let largest = |part: &[f64]| part.iter().copied().fold(0.0, f64::max);
        match pairs.chunks(length).next().map(largest) {
            Some(first) if first > 0.0 => largest(&pairs) / first,
            _ => 1.0,
        }
    }

    /// Forgets the trace itself; its statistics stay.
    pub fn forget_points(&mut self) {
        self.times = Vec::new();
        self.points = Vec::new();
    }

    /// Largest root mean square of a displacement and of a force about their means, from the settle
    /// time on.
    pub fn vibration(&self) -> [f64; 2] {
        let mut largest = [0.0_f64; 2];
        for (quantity, axis, lever) in self.channels() {
            let rms = lever * self.statistics(quantity, axis).rms;
            largest[quantity] = largest[quantity].max(rms);
        }
        largest
    }

    /// Statistics of one channel from the settle time on.
    fn statistics(&self, quantity: usize, axis: usize) -> Statistics {
        Statistics::from(&self.moments[quantity][axis])
    }
}

impl TraceSink for Trace {
    fn sample(&mut self, sample: &Sample) -> io::Result<()> {
        let point = [
            sample.displacement,
            sample.force_on_shaft.unwrap_or_default(),
        ];
        if self.samples.is_multiple_of(self.view.stride) {
            self.times.push(sample.time);
            self.points.push(point);
        }
        self.samples += 1;
        if sample.time >= self.view.settle {
            let moments = self.moments.as_flattened_mut().iter_mut();
            for (moments, value) in moments.zip(point.as_flattened()) {
                moments.take(*value);
            }
        }
        Ok(())
    }
}
