//! What is kept of a run to compare it with another: its trace, thinned where it is long, and its
//! statistics.

use std::io;

use serde::Serialize;

use crate::analysis::Moments;
use crate::rotor::{FREEDOMS, MotionScale, Rotor, Sample};
use crate::simulate::{Model, SimulateError, TraceSink};

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

/// The trace of a run as far as it is compared.
#[derive(Debug, Clone)]
pub(super) struct Trace {
    /// Freedoms that count.
    axes: &'static [usize],
    /// Length that turns tilts into displacements and moments into forces.
    scale: MotionScale,
    /// Time from which statistics count, s.
    settle: f64,
    /// Every how many samples a point is kept.
    stride: u64,
    samples: u64,
    times: Vec<f64>,
    points: Vec<Point>,
    moments: [[Moments; FREEDOMS]; 2],
}

impl Trace {
    /// That of a run of a model that is to begin.
    pub fn new(model: &Model) -> Result<Self, SimulateError> {
        let rotor = Rotor::assemble(&model.rotor)?;
        Ok(Self {
            axes: rotor.freedoms().axes(),
            scale: rotor.motion_scale(model.integrator.tolerance),
            settle: model.settle,
            stride: (model.samples() / MOST_POINTS as f64).ceil().max(1.0) as u64,
            samples: 0,
            times: Vec::new(),
            points: Vec::new(),
            moments: [[Moments::default(); FREEDOMS]; 2],
        })
    }

    /// Factor that makes a length of a displacement (`quantity` 0) and a force of a moment (1).
    fn lever(&self, quantity: usize, axis: usize) -> f64 {
        let lever = self.scale.lever(axis);
        if quantity == 0 { lever } else { 1.0 / lever }
    }

    /// Largest value of displacements and of forces over the freedoms that move, by quantity, axis and lever.
    fn largest(&self, value: impl Fn(usize, usize, f64) -> f64) -> [f64; 2] {
        [0, 1].map(|quantity| {
            let axes = self.axes.iter();
            let values = axes.map(|&axis| value(quantity, axis, self.lever(quantity, axis)));
            values.fold(0.0, f64::max)
        })
    }

    /// Largest distance of displacement and force from their means, from the settle time on.
    pub fn excursion(&self) -> [f64; 2] {
        self.largest(|quantity, axis, lever| lever * self.moments[quantity][axis].peak())
    }

    /// Distance of displacements in m and forces in N from the true trace of the same samples, over the freedoms that
    /// move there: the largest `norm` of their differences from a time on, and the largest differences of the statistics.
    pub fn distance(
        &self,
        truth: &Self,
        norm: fn(&Moments) -> f64,
        from: f64,
    ) -> ([f64; 2], [Statistics; 2]) {
        let first = self.times.partition_point(|time| *time < from);
        let largest = truth.largest(|quantity, axis, lever| {
            let pairs = self.points.iter().zip(&truth.points).skip(first);
            let differences =
                pairs.map(|(left, right)| lever * (left[quantity][axis] - right[quantity][axis]));
            norm(&differences.collect())
        });
        let statistics = [0, 1].map(|quantity| {
            let differences = truth.axes.iter().map(|&axis| {
                let [own, other] = [self, truth].map(|trace| trace.statistics(quantity, axis));
                own.distance(&other).times(truth.lever(quantity, axis))
            });
            differences.fold(Statistics::default(), |largest, next| largest.larger(&next))
        });
        (largest, statistics)
    }

    /// By how much the difference of displacements grows: of its largest values in `parts` equal parts of the time, the
    /// largest over the first.
    pub fn growth(&self, other: &Self, parts: usize) -> f64 {
        let length = self.points.len().div_ceil(parts).max(1);
        let apart = |(left, right): (&Point, &Point)| {
            let axes = self.axes.iter();
            axes.map(|&axis| self.lever(0, axis) * (left[0][axis] - right[0][axis]).abs())
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
        self.largest(|quantity, axis, lever| lever * self.statistics(quantity, axis).rms)
    }

    /// Statistics of one channel from the settle time on.
    fn statistics(&self, quantity: usize, axis: usize) -> Statistics {
        let moments = &self.moments[quantity][axis];
        Statistics {
            mean: moments.mean(),
            rms: moments.rms(),
            peak: 0.5 * moments.peak_to_peak(),
        }
    }
}

impl TraceSink for Trace {
    fn sample(&mut self, sample: &Sample) -> io::Result<()> {
        let point = [
            sample.displacement,
            sample.force_on_shaft.unwrap_or_default(),
        ];
        if self.samples.is_multiple_of(self.stride) {
            self.times.push(sample.time);
            self.points.push(point);
        }
        self.samples += 1;
        if sample.time >= self.settle {
            let moments = self.moments.as_flattened_mut().iter_mut();
            for (moments, value) in moments.zip(point.as_flattened()) {
                moments.take(*value);
            }
        }
        Ok(())
    }
}
