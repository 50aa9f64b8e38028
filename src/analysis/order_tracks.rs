//! Amplitude and phase of orders of the shaft's angle while the speed changes.

use std::collections::VecDeque;
use std::f64::consts::{PI, TAU};

use nalgebra::{DMatrix, DVector};
use serde::Serialize;

use super::Channel;
use crate::rotor::Sample;

/// Windows that overlap at any time.
const OVERLAP: f64 = 4.0;

/// An order that is tracked.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[non_exhaustive]
pub struct TrackedOrder {
    /// What it is called: `1×`, `BPFO`.
    pub name: String,
    /// Multiple of the shaft's frequency, positive.
    pub order: f64,
}

/// Amplitude and phase of one order.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct Track {
    /// Peak value in the unit of the channel.
    pub amplitude: f64,
    /// Phase in rad of `cos(order ψ + phase)`, ψ the angle of the shaft: the unbalance's is zero.
    pub phase: f64,
}

/// All orders in one window.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct TrackPoint {
    /// Weighted mean time of the window, s.
    pub time: f64,
    /// Weighted mean speed, rad/s.
    pub speed: f64,
    /// Orders within channels.
    pub tracks: Vec<Vec<Track>>,
}

/// Orders over a run.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct OrderTracks {
    /// Length of a window, revolutions of the shaft.
    pub revolutions: f64,
    /// The orders.
    pub orders: Vec<TrackedOrder>,
    /// The quantities.
    pub channels: Vec<Channel>,
    /// By angle of the shaft, a quarter of a window apart.
    pub points: Vec<TrackPoint>,
}

/// Takes samples and makes [`OrderTracks`] of them; memory does not grow with the samples.
///
/// Mean and all orders together are fitted by least squares, weighted by a Hann window over the shaft's
/// angle, so that they do not leak into each other:
///
/// ```text
/// Σ w(ψ) ω Δt [x − c_0 − Σ_k (a_k cos o_k ψ + b_k sin o_k ψ)]² → minimum,   w = ½ + ½ cos(2π(ψ − ψ_j)/Ψ)
/// ```
///
/// with Ψ the length of the window and ψ_j its middle. Orders that are less than about `2/revolutions`
/// apart are not separated. What changes within a window is averaged over it.
pub struct TrackRecorder {
    found: OrderTracks,
    /// Windows that are being filled, the earliest first.
    open: VecDeque<Fit>,
    /// Number of the next window.
    next: u32,
    basis: Vec<f64>,
}

/// Sums of one window.
struct Fit {
    middle: f64,
    gram: DMatrix<f64>,
    /// One column a channel.
    right: DMatrix<f64>,
    /// Σ w ω, Σ w ω t, Σ w ω².
    sums: [f64; 3],
}

impl TrackRecorder {
    /// Windows of so many revolutions, at least 1.
    pub fn new(orders: Vec<TrackedOrder>, channels: Vec<Channel>, revolutions: f64) -> Self {
        Self {
            basis: vec![1.0; 1 + 2 * orders.len()],
            found: OrderTracks {
                revolutions: revolutions.max(1.0),
                orders,
                channels,
                points: Vec::new(),
            },
            open: VecDeque::new(),
            next: 0,
        }
    }

    /// Takes one sample of a run: samples are at equal times, and the angle does not fall.
    pub fn record(&mut self, sample: &Sample) {
        let (angle, speed) = (sample.angle, sample.speed);
        let half = PI * self.found.revolutions;
        while self
            .open
            .front()
            .is_some_and(|fit| angle >= fit.middle + half)
        {
            let whole = self.open.pop_front();
            self.found
                .points
                .extend(whole.and_then(|fit| fit.finish(&self.found)));
        }
        while angle >= self.begin(self.next) {
            let fit = Fit::new(self.begin(self.next) + half, &self.found);
            // windows that a sparse sample jumps over are not filled
            if angle < fit.middle + half {
                self.open.push_back(fit);
            }
            self.next += 1;
        }
        if speed > 0.0 {
            self.fill_basis(angle);
            let value = |channel: &Channel| channel.of(sample).unwrap_or(f64::NAN);
            let values: Vec<f64> = self.found.channels.iter().map(value).collect();
            for fit in &mut self.open {
                let weight = 0.5 + 0.5 * (PI * (angle - fit.middle) / half).cos();
                fit.add(weight * speed, [sample.time, speed], &self.basis, &values);
            }
        }
    }

    /// The orders of all whole windows.
    pub fn finish(self) -> OrderTracks {
        self.found
    }

    /// Angle at which a window begins, rad.
    fn begin(&self, number: u32) -> f64 {
        TAU * self.found.revolutions / OVERLAP * f64::from(number)
    }

    fn fill_basis(&mut self, angle: f64) {
        for (order, pair) in self.found.orders.iter().zip(self.basis[1..].chunks_mut(2)) {
            let (sin, cos) = (order.order * angle).sin_cos();
            pair.copy_from_slice(&[cos, sin]);
        }
    }
}

impl Fit {
    fn new(middle: f64, found: &OrderTracks) -> Self {
        let unknowns = 1 + 2 * found.orders.len();
        Self {
            middle,
            gram: DMatrix::zeros(unknowns, unknowns),
            right: DMatrix::zeros(unknowns, found.channels.len()),
            sums: [0.0; 3],
        }
    }

    fn add(&mut self, weight: f64, [time, speed]: [f64; 2], basis: &[f64], values: &[f64]) {
        for (row, value) in basis.iter().enumerate() {
            let weighted = weight * value;
            for (column, other) in basis.iter().enumerate().skip(row) {
                self.gram[(column, row)] += weighted * other;
            }
            for (channel, value) in values.iter().enumerate() {
                self.right[(row, channel)] += weighted * value;
            }
        }
        for (sum, value) in self.sums.iter_mut().zip([1.0, time, speed]) {
            *sum += weight * value;
        }
    }

    /// None where the samples do not separate the orders.
    fn finish(self, found: &OrderTracks) -> Option<TrackPoint> {
        // only the lower triangle is filled, and only it is read
        let factors = self.gram.cholesky()?;
        let track = |column: DVector<f64>| -> Vec<Track> {
            let solved = factors.solve(&column);
            let pairs = solved.as_slice()[1..].chunks(2);
            pairs
                .map(|pair| Track {
                    amplitude: pair[0].hypot(pair[1]),
                    phase: (-pair[1]).atan2(pair[0]),
                })
                .collect()
        };
        let columns = 0..found.channels.len();
        let [weight, time, speed] = self.sums;
        Some(TrackPoint {
            time: time / weight,
            speed: speed / weight,
            tracks: columns
                .map(|channel| track(self.right.column(channel).into_owned()))
                .collect(),
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn orders_of_a_run_up_are_told_apart() {
        let order = |name: &str, order| TrackedOrder {
            name: name.to_owned(),
            order,
        };
        let orders = vec![order("1×", 1.0), order("BPFO", 4.8)];
        let mut recorder = TrackRecorder::new(orders, vec![Channel::Displacement(0)], 8.0);
        // a run-up at 10 rad/s²: 3 µm of order 1, 1 µm of order 4.8, and a mean of 50 µm
        for n in 0..20_000 {
            let time = 5e-4 * f64::from(n);
            let (speed, angle) = (10.0 * time, 5.0 * time * time);
            let x = 5e-5 + 3e-6 * (angle + 0.5).cos() + 1e-6 * (4.8 * angle).sin();
            recorder.record(&Sample {
                time,
                angle,
                speed,
                displacement: [x, 0.0, 0.0, 0.0, 0.0],
                ..Sample::default()
            });
        }
        let tracks = recorder.finish();
        for point in &tracks.points {
            let [first, pass] = [point.tracks[0][0], point.tracks[0][1]];
            assert!((first.amplitude - 3e-6).abs() < 1e-12 && (first.phase - 0.5).abs() < 1e-6);
            assert!((pass.amplitude - 1e-6).abs() < 1e-12);
        }
    }
}
