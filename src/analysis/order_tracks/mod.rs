//! Amplitude and phase of orders of the shaft's angle while the speed changes.

mod recorder;

use std::f64::consts::PI;

use realfft::num_complex::Complex;
use serde::Serialize;

use super::Channel;
pub use recorder::TrackRecorder;

/// Windows that overlap at any time.
const OVERLAP: f64 = 4.0;
/// Orders less than this over the revolutions of a window apart are not told apart: the main lobes of Hann windows.
const RESOLVED: f64 = 2.0;
/// Modulations of an order that a track follows, on both sides together, times the revolutions: where half the power is left.
const BANDWIDTH: f64 = 2.52;
/// Half the variance of the Hann window, 1/12 − 1/(2π²) of its length squared, in steps between windows squared.
const CURVATURE: f64 = 0.5 * OVERLAP * OVERLAP * (1.0 / 12.0 - 0.5 / (PI * PI));
/// An order below this part of the largest one of a channel has no bias that is reported.
const LOUD: f64 = 0.1;

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
    /// The orders that were asked for.
    pub orders: Vec<TrackedOrder>,
    /// The orders, those that the windows do not tell apart in one track at their mean, without those that fold.
    pub tracked: Vec<TrackedOrder>,
    /// The orders that are not below half the sampling rate at the highest speed.
    pub folded: Vec<TrackedOrder>,
    /// The quantities.
    pub channels: Vec<Channel>,
    /// By angle of the shaft, a quarter of a window apart.
    pub points: Vec<TrackPoint>,
    /// What is left of the bias by the sweep at the largest amplitude, in parts of it: of each track the largest of all
    /// channels that it is loud in.
    pub bias: Vec<f64>,
}

impl OrderTracks {
    /// Orders closer than this share a track.
    pub fn resolution(&self) -> f64 {
        RESOLVED / self.revolutions
    }

    /// Width of the band about an order whose modulation a track follows, orders.
    pub fn bandwidth(&self) -> f64 {
        BANDWIDTH / self.revolutions
    }

    /// Takes away what the windows average, and notes what is left of it.
    fn correct(&mut self) {
        let complex = |track: &Track| Complex::from_polar(track.amplitude, track.phase);
        let channels = 0..self.channels.len();
        let loudest: Vec<f64> = channels.map(|channel| self.loudest(channel)).collect();
        for (order, bias) in self.bias.iter_mut().enumerate() {
            for (channel, loudest) in loudest.iter().enumerate() {
                let points = self.points.iter();
                let found: Vec<_> = points
                    .map(|point| complex(&point.tracks[channel][order]))
                    .collect();
                let first = curvature(&found);
                let second = curvature(&first);
                let mut largest = (0.0, 0.0);
                for (index, point) in self.points.iter_mut().enumerate() {
                    let value = found[index] - first[index] + second[index];
                    let track = &mut point.tracks[channel][order];
                    (track.amplitude, track.phase) = value.to_polar();
                    if track.amplitude > largest.0 {
                        largest = (track.amplitude, second[index].norm() / track.amplitude);
                    }
                }
                if largest.0 > LOUD * loudest {
                    *bias = bias.max(largest.1);
                }
            }
        }
    }

    /// Largest amplitude of any order of a channel.
    pub(crate) fn loudest(&self, channel: usize) -> f64 {
        let all = self.points.iter().flat_map(|point| &point.tracks[channel]);
        all.map(|track| track.amplitude).fold(0.0, f64::max)
    }

    /// What the reader of the tracks should know.
    pub(crate) fn warnings(&self) -> Vec<String> {
        let revolutions = self.revolutions;
        let shared = self
            .tracked
            .iter()
            .filter(|track| !self.orders.contains(track));
        let shared = shared.map(|track| {
            format!(
                "order tracks: the orders of {} are closer than the {:.3} that windows of {revolutions} revolutions tell \
                 apart, and share one track: its amplitude may be that of any of them",
                track.name, self.resolution()
            )
        });
        let biased = self
            .tracked
            .iter()
            .zip(&self.bias)
            .filter(|(_, bias)| **bias > MOST_BIAS);
        let biased = biased.map(|(track, bias)| format!("{:.1} % of {}", 100.0 * bias, track.name));
        let biased: Vec<_> = biased.collect();
        let biased = (!biased.is_empty()).then(|| {
            format!(
                "order tracks change so fast with the speed that windows of {revolutions} revolutions miss about {} (of its \
                 largest amplitude each): the trace and the largest motion are exact, a slower change of the speed is tracked \
                 better",
                biased.join(", ")
            )
        });
        let names: Vec<_> = self.folded.iter().map(|track| &track.name[..]).collect();
        let folded = (!names.is_empty()).then(|| {
            format!(
                "order tracks are without {}, which at the highest speed are not below half the sampling rate: sample faster, or check \
                 the unit of a measured speed",
                names.join(", ")
            )
        });
        shared.chain(biased).chain(folded).collect()
    }
}

/// A bias above this part of the amplitude is worth a warning.
const MOST_BIAS: f64 = 0.01;

/// What a Hann window adds to the middle value, `σ²/2 · d²A/dψ²`, by second differences; the ends take that of their neighbours.
fn curvature(values: &[Complex<f64>]) -> Vec<Complex<f64>> {
    let last = values.len().saturating_sub(2);
    let at = |index: usize| {
        let index = index.clamp(1, last);
        (values[index + 1] - 2.0 * values[index] + values[index - 1]) * CURVATURE
    };
    match last {
        0 => vec![Complex::ZERO; values.len()],
        _ => (0..values.len()).map(at).collect(),
    }
}
