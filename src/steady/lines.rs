//! What a steady motion is made of: lines at the frequencies of its forcing and their sums, and the range of its
//! quantities.

use std::f64::consts::TAU;

use nalgebra::{Complex, DMatrix};
use serde::Serialize;

use super::extremes::extremes;
use super::periods::Periods;
use crate::analysis::{Channel, Line, fourier_coefficients, nearest_cause};
use crate::rotor::{CageMotion, Rotor, Sample};
use crate::shooting::Circle;
use crate::simulate::{Model, line_causes};

/// Lines up to this part of the sampling rate are kept: above, those beyond half the rate fold back.
const KEPT: usize = 4;

/// Phases of the second frequency, per node, at which extremes are sought.
const FINER: usize = 4;

/// A line.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct SteadyLine {
    /// Frequency, Hz.
    pub frequency: f64,
    /// Multiples of the frequency of the motion's period and of the second frequency that it is the sum
    /// of.
    pub multiples: [i32; 2],
    /// Amplitude (peak value) of every channel; the mean at frequency 0.
    pub amplitude: Vec<f64>,
    /// Phase of every channel, rad, of `cos(2πft + phase)`.
    pub phase: Vec<f64>,
}

/// The lines of all channels, by frequency.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct SteadyLines {
    /// The channels.
    pub channels: Vec<Channel>,
    /// The lines.
    pub lines: Vec<SteadyLine>,
}

/// Part of its frequency within which a line is that of its cause.
const NEAR: f64 = 1e-4;

impl SteadyLine {
    /// What causes it, where that is known.
    pub(crate) fn cause(&self, causes: &[Line]) -> Option<Line> {
        let moves = self.multiples != [0, 0];
        let near = || nearest_cause(self.frequency, NEAR * self.frequency, causes);
        moves.then(near).flatten()
    }
}

impl SteadyLines {
    /// What can cause lines in a scene. Where its cages roll at the angles of loaded balls and the motion was found with free
    /// ones, those are the cages by which more lines have a cause.
    pub(crate) fn causes(&self, model: &Model) -> Vec<Line> {
        let with = |cage: CageMotion| {
            let mut model = model.clone();
            model.rotor.cage = cage;
            let rotor = Rotor::assemble(&model.rotor);
            let causes = rotor.map_or_else(|_| Vec::new(), |rotor| line_causes(&model, &rotor));
            let named = self
                .lines
                .iter()
                .filter(|line| line.cause(&causes).is_some());
            (named.count(), causes)
        };
        let (named, own) = with(model.rotor.cage);
        if model.rotor.cage != CageMotion::Operating {
            return own;
        }
        match with(CageMotion::Rolling) {
            (more, rolling) if more > named => rolling,
            _ => own,
        }
    }

    /// Amplitude of a channel at the line nearest to a frequency in Hz.
    pub fn amplitude(&self, channel: Channel, frequency: f64) -> Option<f64> {
        let index = self.channels.iter().position(|known| *known == channel)?;
        let distance = |line: &&SteadyLine| (line.frequency - frequency).abs();
        let nearest = self
            .lines
            .iter()
            .min_by(|a, b| distance(a).total_cmp(&distance(b)))?;
        nearest.amplitude.get(index).copied()
    }

    /// The lines of one period sampled from every node; what is below `noise` of its channel's largest in
    /// all channels is left out.
    pub(super) fn from_samples(
        periods: &Periods,
        channels: &[Channel],
        sampled: &[Vec<Sample>],
        noise: f64,
    ) -> Self {
        let spectra = channels.iter().map(|channel| values(*channel, sampled));
        let spectra: Vec<_> = spectra.map(|values| spectrum(periods, &values)).collect();
        let least = spectra.iter().map(|spectrum| {
            let lines = spectrum.iter().filter(|(at, _)| *at != [0, 0]);
            noise * lines.map(|(_, value)| value.norm()).fold(0.0, f64::max)
        });
        let least: Vec<f64> = least.collect();
        let mut lines = Vec::new();
        for number in 0..spectra.first().map_or(0, Vec::len) {
            let at = spectra[0][number].0;
            let values: Vec<_> = spectra.iter().map(|spectrum| spectrum[number].1).collect();
            let mut pairs = values.iter().zip(&least);
            if at == [0, 0] || pairs.any(|(value, least)| value.norm() > *least) {
                lines.push(line(periods, at, &values));
            }
        }
        lines.sort_by(|a, b| a.frequency.total_cmp(&b.frequency));
        Self {
            channels: channels.to_vec(),
            lines,
        }
    }
}

/// Multiples of both frequencies and the complex amplitude there.
type Component = ([i32; 2], Complex<f64>);

/// Components of a channel: of every pair of opposite ones a single one.
fn spectrum(periods: &Periods, values: &DMatrix<f64>) -> Vec<Component> {
    let circle = &periods.circle;
    let instants = values.ncols();
    let coefficients = &circle.coefficients * values;
    let most = (instants / KEPT) as i32;
    let mut found = Vec::new();
    for harmonic in 0..=circle.harmonics() {
        let turned: Vec<Complex<f64>> = (0..instants)
            .map(|instant| {
                let part = instant as f64 / instants as f64;
                let back = -(harmonic as f64) * circle.rotation * part;
                complex(&coefficients, harmonic, instant) * Complex::from_polar(1.0, back)
            })
            .collect();
        let along = fourier_coefficients(&turned);
        // the phase of the second frequency where the first period begins
        let first = Complex::from_polar(1.0, -(harmonic as f64) * periods.first_phase());
        let least = if harmonic == 0 { 0 } else { -most };
        for multiple in least..=most {
            let bin = multiple.rem_euclid(instants as i32) as usize;
            found.push(([multiple, harmonic as i32], along[bin] * first));
        }
    }
    found
}

/// Coefficient of e^{ikφ} at an instant.
fn complex(coefficients: &DMatrix<f64>, harmonic: usize, instant: usize) -> Complex<f64> {
    if harmonic == 0 {
        return Complex::new(coefficients[(0, instant)], 0.0);
    }
    let cos = coefficients[(2 * harmonic - 1, instant)];
    let sin = coefficients[(2 * harmonic, instant)];
    Complex::new(0.5 * cos, -0.5 * sin)
}

fn line(periods: &Periods, multiples: [i32; 2], values: &[Complex<f64>]) -> SteadyLine {
    let second = periods.bases.get(1).map_or(0.0, |base| base.frequency);
    let frequency =
        f64::from(multiples[0]) / periods.circle.period + f64::from(multiples[1]) * (second / TAU);
    let sign = if frequency < 0.0 { -1 } else { 1 };
    let line = |value: &Complex<f64>| match multiples {
        // the mean keeps its sign
        [0, 0] => (value.re, 0.0),
        _ => (2.0 * value.norm(), f64::from(sign) * value.arg()),
    };
    let (amplitude, phase) = values.iter().map(line).unzip();
    SteadyLine {
        frequency: frequency.abs(),
        multiples: multiples.map(|multiple| sign * multiple),
        amplitude,
        phase,
    }
}

/// Mean, peak-to-peak range and RMS of a quantity.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[non_exhaustive]
pub struct MotionRange {
    /// The quantity.
    #[serde(serialize_with = "Channel::serialize_with_unit")]
    pub channel: Channel,
    /// Its mean, in its unit.
    pub mean: f64,
    /// Distance of its extremes: of a motion that repeats those between the samples, of two frequencies those of the samples.
    pub peak_to_peak: f64,
    /// Root mean square about the mean.
    pub rms: f64,
}

/// Values of a channel over one period: a row a node, a column an instant; not a number where samples
/// do not carry it.
pub(super) fn values(channel: Channel, sampled: &[Vec<Sample>]) -> DMatrix<f64> {
    let instants = sampled.first().map_or(0, Vec::len);
    DMatrix::from_fn(sampled.len(), instants, |node, instant| {
        channel.value(&sampled[node][instant]).unwrap_or(f64::NAN)
    })
}

/// Ranges of channels.
pub(super) fn ranges(
    channels: &[Channel],
    circle: &Circle,
    sampled: &[Vec<Sample>],
) -> Vec<MotionRange> {
    let nodes = circle.nodes();
    let finer = if nodes == 1 { 1 } else { FINER * nodes };
    let angles: Vec<f64> = (0..finer).map(|k| TAU * k as f64 / finer as f64).collect();
    let around = circle.values_at(&angles);
    let range = |channel: &Channel| {
        let all = &around * values(*channel, sampled);
        let mean = all.mean();
        let [lowest, highest] = match nodes {
            1 => extremes(all.as_slice()),
            _ => [all.min(), all.max()],
        };
        MotionRange {
            channel: *channel,
            mean,
            peak_to_peak: highest - lowest,
            rms: all.map(|value| (value - mean).powi(2)).mean().sqrt(),
        }
    };
    channels.iter().map(range).collect()
}
