//! Takes samples and fits the orders of the shaft's angle to them, window by window.

use std::collections::VecDeque;
use std::f64::consts::PI;

use nalgebra::{DMatrix, DVector};

use super::{OVERLAP, OrderTracks, RESOLVED, Track, TrackPoint, TrackedOrder};
use crate::analysis::Channel;
use crate::rotor::Sample;

/// The orders by size, those within `resolution` of the first of some joined at their mean.
fn joined(orders: &[TrackedOrder], resolution: f64) -> Vec<TrackedOrder> {
    let mut sorted: Vec<&TrackedOrder> = orders.iter().collect();
    sorted.sort_by(|a, b| a.order.total_cmp(&b.order));
    let mut groups: Vec<Vec<&TrackedOrder>> = Vec::new();
    for order in sorted {
        match groups.last_mut() {
            Some(group) if order.order - group[0].order < resolution => group.push(order),
            _ => groups.push(vec![order]),
        }
    }
    let join = |group: &Vec<&TrackedOrder>| {
        let names: Vec<_> = group.iter().map(|order| order.name.as_str()).collect();
        let sum: f64 = group.iter().map(|order| order.order).sum();
        TrackedOrder {
            name: names.join(" + "),
            order: sum / group.len() as f64,
        }
    };
    groups.iter().map(join).collect()
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
/// with Ψ the length of the window and ψ_j its middle. Orders that are less than `2/revolutions` apart share a track at
/// their mean. What changes within a window is averaged over it, which two terms of a series take away again:
///
/// ```text
/// Ã = A + σ²/2 A″ + …   →   A = Ã − DÃ + D²Ã,   D = σ²/2 d²/dψ²,   σ² = Ψ²(1/12 − 1/(2π²))
/// ```
///
/// The last term is what is reported as the bias that is left.
pub struct TrackRecorder {
    found: OrderTracks,
    /// Windows that are being filled, the earliest first.
    open: VecDeque<Fit>,
    /// Number of the next window.
    next: u64,
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
    /// Windows of so many revolutions, at least 1, over samples that know orders below `limit`.
    pub fn new(
        orders: Vec<TrackedOrder>,
        channels: Vec<Channel>,
        revolutions: f64,
        limit: f64,
    ) -> Self {
        let revolutions = revolutions.max(1.0);
        let is_known = |order: &TrackedOrder| order.order < limit;
        let (known, folded): (Vec<_>, Vec<_>) = orders.iter().cloned().partition(is_known);
        let tracked = joined(&known, RESOLVED / revolutions);
        Self {
            basis: vec![1.0; 1 + 2 * tracked.len()],
            found: OrderTracks {
                revolutions,
                orders,
                bias: vec![0.0; tracked.len()],
                tracked,
                folded,
                channels,
                points: Vec::new(),
            },
            open: VecDeque::new(),
            next: 0,
        }
    }

    /// How many numbers the table of so many revolutions has.
    pub fn table_numbers(&self, revolutions: f64) -> f64 {
        let OrderTracks {
            tracked, channels, ..
        } = &self.found;
        // time and speed besides amplitude and phase of every order and channel
        let columns = 2 + 2 * tracked.len() * channels.len();
        let windows = (revolutions / self.found.revolutions - 1.0) * OVERLAP;
        (windows.floor() + 1.0).max(0.0) * columns as f64
    }

    /// Takes one sample of a run: samples are at equal times, and the angle does not fall.
    pub fn record(&mut self, sample: &Sample) {
        let turning = [sample.time, sample.angle, sample.speed];
        self.take(turning, |channel| channel.value(sample).unwrap_or(f64::NAN));
    }

    /// Takes time, angle and speed of a sample, and the values of its channels.
    pub fn take(&mut self, [time, angle, speed]: [f64; 3], value: impl Fn(Channel) -> f64) {
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
        let distance = 2.0 * half / OVERLAP;
        let begun = angle / distance;
        if begun >= 0.0 && !self.found.tracked.is_empty() {
            // a sample may jump over windows: of those that have begun, the last few hold it
            let first = (begun - OVERLAP + 1.0).floor() as u64;
            let after = (begun.floor() as u64).saturating_add(1);
            for number in first.max(self.next)..after {
                let middle = distance * number as f64 + half;
                self.open.push_back(Fit::new(middle, &self.found));
            }
            self.next = self.next.max(after);
        }
        if speed > 0.0 {
            self.fill_basis(angle);
            let channels = self.found.channels.iter();
            let values: Vec<f64> = channels.map(|channel| value(*channel)).collect();
            for fit in &mut self.open {
                let weight = 0.5 + 0.5 * (PI * (angle - fit.middle) / half).cos();
                fit.add(weight * speed, [time, speed], &self.basis, &values);
            }
        }
    }

    /// The orders of all whole windows.
    pub fn finish(mut self) -> OrderTracks {
        self.found.correct();
        self.found
    }

    fn fill_basis(&mut self, angle: f64) {
        for (order, pair) in self.found.tracked.iter().zip(self.basis[1..].chunks_mut(2)) {
            let (sin, cos) = (order.order * angle).sin_cos();
            pair.copy_from_slice(&[cos, sin]);
        }
    }
}

impl Fit {
    fn new(middle: f64, found: &OrderTracks) -> Self {
        let unknowns = 1 + 2 * found.tracked.len();
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
    use std::f64::consts::TAU;

    /// A bell of three revolutions under windows of four: 3 % low without the correction.
    #[test]
    fn what_a_window_averages_is_taken_away() {
        let order = vec![TrackedOrder {
            name: "1×".to_owned(),
            order: 1.0,
        }];
        let mut recorder = TrackRecorder::new(order, vec![Channel::Displacement(0)], 4.0, 50.0);
        let envelope = |angle: f64| 1e-6 * (-0.5 * ((angle / TAU - 50.0) / 3.0).powi(2)).exp();
        for n in 0..10_000 {
            let time = 1e-3 * f64::from(n);
            let (speed, angle) = (20.0 * PI, 20.0 * PI * time);
            let x = envelope(angle) * (angle + 0.3).cos();
            recorder.record(&Sample {
                time,
                angle,
                speed,
                displacement: [x, 0.0, 0.0, 0.0, 0.0],
                ..Sample::default()
            });
        }
        let tracks = recorder.finish();
        let mut worst: f64 = 0.0;
        for point in &tracks.points {
            let error = point.tracks[0][0].amplitude - envelope(point.time * 20.0 * PI);
            worst = worst.max(error.abs() / 1e-6);
            assert!(error.abs() < 2e-9, "{error:e} at {} s", point.time);
        }
        let bias = tracks.bias[0];
        assert!(bias > worst && bias < 3e-3, "{bias} and {worst}");
    }

    /// Tracks of the first two orders of a shaft that is at some angles, with an amplitude of 1 of the first.
    fn of_angles(angles: impl Iterator<Item = f64>, limit: f64) -> OrderTracks {
        let order = |order| TrackedOrder {
            name: format!("{order}×"),
            order,
        };
        let orders = vec![order(1.0), order(2.0)];
        let mut recorder = TrackRecorder::new(orders, vec![Channel::Displacement(0)], 4.0, limit);
        for (n, angle) in angles.enumerate() {
            recorder.take([n as f64, angle, 1.0], |_| angle.cos());
        }
        recorder.finish()
    }

    #[test]
    fn orders_above_half_the_sampling_rate_are_left_out() {
        for (turns, left) in [(0.2, 2), (0.3, 1), (1e9, 0), (1e300, 0)] {
            let angles = (0..400).map(|n| TAU * turns * f64::from(n));
            let tracks = of_angles(angles, 0.5 / turns);
            assert_eq!(tracks.tracked, tracks.orders[..left]);
            assert_eq!(tracks.folded, tracks.orders[left..]);
            assert_eq!(tracks.points.is_empty(), left == 0);
            for point in &tracks.points {
                let [first, rest @ ..] = &point.tracks[0][..] else {
                    panic!("no track at {}", point.time);
                };
                assert!((first.amplitude - 1.0).abs() < 1e-9);
                assert!(rest.iter().all(|track| track.amplitude < 1e-9));
            }
        }
    }

    #[test]
    fn windows_that_a_sample_jumps_over_are_not_filled() {
        let turn = |from: f64| (0..400).map(move |n| from + 0.2 * TAU * f64::from(n));
        let angles = turn(0.0).chain(turn(1e11)).chain([1e300, f64::INFINITY]);
        let tracks = of_angles(angles, 2.5);
        // 80 revolutions twice, in windows of four that overlap by three
        assert!(tracks.points.len() > 150);
        for point in &tracks.points {
            let amplitude = point.tracks[0][0].amplitude;
            assert!((amplitude - 1.0).abs() < 1e-4, "{amplitude}");
        }
    }

    /// Tracks of a run-up at 10 rad/s² in which the shaft is displaced by a length in m at an angle.
    fn run_up(mut recorder: TrackRecorder, displacement: impl Fn(f64) -> f64) -> OrderTracks {
        for n in 0..20_000 {
            let time = 5e-4 * f64::from(n);
            let angle = 5.0 * time * time;
            recorder.take([time, angle, 10.0 * time], |_| displacement(angle));
        }
        recorder.finish()
    }

    #[test]
    fn orders_that_are_too_close_share_a_track() {
        let named = |name: &str, order| TrackedOrder {
            name: name.to_owned(),
            order,
        };
        let orders = vec![
            named("1×", 1.0),
            named("2×", 2.0),
            named("3×", 3.0),
            named("BPFO", 3.08),
        ];
        let recorder = TrackRecorder::new(orders, vec![Channel::Displacement(0)], 6.0, 60.0);
        let tracks = run_up(recorder, |angle| 1e-6 * (3.08 * angle).cos());
        let names: Vec<_> = tracks.tracked.iter().map(|track| &track.name[..]).collect();
        assert_eq!(names, ["1×", "2×", "3× + BPFO"]);
        for point in &tracks.points[2..] {
            let amplitudes: Vec<f64> = point.tracks[0]
                .iter()
                .map(|track| track.amplitude)
                .collect();
            assert!(
                amplitudes[0] < 1e-8 && amplitudes[1] < 1e-8,
                "{amplitudes:?}"
            );
            assert!((amplitudes[2] - 1e-6).abs() < 1e-8, "{amplitudes:?}");
        }
        assert!(tracks.warnings()[0].contains("3× + BPFO"));
    }

    #[test]
    fn orders_of_a_run_up_are_told_apart() {
        let order = |name: &str, order| TrackedOrder {
            name: name.to_owned(),
            order,
        };
        let orders = vec![order("1×", 1.0), order("BPFO", 4.8)];
        let recorder = TrackRecorder::new(orders, vec![Channel::Displacement(0)], 8.0, 60.0);
        // 3 µm of order 1, 1 µm of order 4.8, and a mean of 50 µm
        let tracks = run_up(recorder, |angle| {
            5e-5 + 3e-6 * (angle + 0.5).cos() + 1e-6 * (4.8 * angle).sin()
        });
        for point in &tracks.points {
            let [first, pass] = [point.tracks[0][0], point.tracks[0][1]];
            assert!((first.amplitude - 3e-6).abs() < 1e-12 && (first.phase - 0.5).abs() < 1e-6);
            assert!((pass.amplitude - 1e-6).abs() < 1e-12);
        }
    }
}
