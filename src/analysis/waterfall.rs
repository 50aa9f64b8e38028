//! Short-time spectra, one after the other: the spectrogram of a run.

use realfft::RealFftPlanner;

use super::{Channel, Transform, Window};
use crate::rotor::Sample;

/// Windows that overlap at any time.
const OVERLAP: usize = 4;
/// Fewest samples of a window.
const FEWEST: usize = 16;

/// A short-time spectrum.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct Slice {
    /// Middle of its window, s.
    pub time: f64,
    /// Mean speed in its window, rad/s.
    pub speed: f64,
    /// One-sided amplitudes (peak values) of every channel, by bin.
    pub amplitude: Vec<Vec<f64>>,
}

/// Short-time spectra under a Hann window, each a quarter of a window after the one before and less its
/// mean.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct Waterfall {
    /// Samples of a window.
    pub length: usize,
    /// Samples from a window to the next.
    pub hop: usize,
    /// Frequency step, Hz.
    pub resolution: f64,
    /// The quantities.
    pub channels: Vec<Channel>,
    /// The spectra, by time.
    pub slices: Vec<Slice>,
}

impl Waterfall {
    /// Number of frequencies, from 0 on.
    pub fn bins(&self) -> usize {
        let first = self
            .slices
            .first()
            .and_then(|slice| slice.amplitude.first());
        first.map_or(0, Vec::len)
    }

    /// Length of a window, s.
    pub fn window(&self) -> f64 {
        1.0 / self.resolution
    }
}

/// Takes samples and makes a [`Waterfall`] of them; only the last window of samples is kept.
pub struct WaterfallRecorder {
    waterfall: Waterfall,
    bins: usize,
    interval: f64,
    samples: Vec<Vec<f64>>,
    speeds: Vec<f64>,
    planner: RealFftPlanner<f64>,
}

impl WaterfallRecorder {
    /// For `rate` samples a second, windows of about `window` seconds, and frequencies up to `limit`
    /// in Hz, or half the rate.
    pub fn new(channels: Vec<Channel>, rate: f64, window: f64, limit: f64) -> Self {
        let hop = ((window * rate / OVERLAP as f64).round() as usize).max(FEWEST / OVERLAP);
        let length = OVERLAP * hop;
        let resolution = rate / length as f64;
        Self {
            bins: ((limit / resolution).ceil() as usize).min(length / 2) + 1,
            interval: 1.0 / rate,
            samples: vec![Vec::with_capacity(length); channels.len()],
            speeds: Vec::with_capacity(length),
            planner: RealFftPlanner::new(),
            waterfall: Waterfall {
                length,
                hop,
                resolution,
                channels,
                slices: Vec::new(),
            },
        }
    }

    /// How many numbers the table of so many samples has.
    pub fn table_numbers(&self, samples: f64) -> f64 {
        let Waterfall {
            length,
            hop,
            ref channels,
            ..
        } = self.waterfall;
        let slices = ((samples - length as f64) / hop as f64).floor() + 1.0;
        // time, speed and frequency besides the amplitudes
        slices.max(0.0) * (self.bins * (3 + channels.len())) as f64
    }

    /// Takes one sample of a run.
    pub fn record(&mut self, sample: &Sample) {
        let turning = [sample.time, sample.speed];
        self.take(turning, |channel| channel.value(sample).unwrap_or(f64::NAN));
    }

    /// Takes time and speed of a sample, and the values of its channels.
    pub fn take(&mut self, [time, speed]: [f64; 2], value: impl Fn(Channel) -> f64) {
        for (channel, samples) in self.waterfall.channels.iter().zip(&mut self.samples) {
            samples.push(value(*channel));
        }
        self.speeds.push(speed);
        if self.speeds.len() == self.waterfall.length {
            self.slice(time);
        }
    }

    /// The spectra of all whole windows.
    pub fn finish(self) -> Waterfall {
        self.waterfall
    }

    /// Transforms a full window that ends at a time, and makes room for the next.
    fn slice(&mut self, end: f64) {
        let (length, hop) = (self.waterfall.length, self.waterfall.hop);
        let amplitude = self.samples.iter().map(|samples| {
            let transform = Transform::planned(samples.clone(), &mut self.planner);
            let transform = transform.without_mean();
            let bins = 0..self.bins;
            bins.map(|k| transform.amplitude(k, Window::Hann)).collect()
        });
        let slice = Slice {
            // the periodic window is even about the sample in its middle
            time: end - (length / 2 - 1) as f64 * self.interval,
            speed: self.speeds.iter().sum::<f64>() / length as f64,
            amplitude: amplitude.collect(),
        };
        self.waterfall.slices.push(slice);
        self.samples.iter_mut().for_each(|samples| {
            samples.drain(..hop);
        });
        self.speeds.drain(..hop);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::TAU;

    #[test]
    fn a_tone_stands_in_its_bin_in_every_slice() {
        // 2 µm at 40 Hz, 1000 samples a second, windows of 0.1 s up to 100 Hz
        let mut recorder =
            WaterfallRecorder::new(vec![Channel::Displacement(0)], 1000.0, 0.1, 100.0);
        for n in 0..1000 {
            let time = f64::from(n) / 1000.0;
            let x = 2e-6 * (TAU * 40.0 * time).cos();
            recorder.record(&Sample {
                time,
                speed: 100.0,
                displacement: [x, 0.0, 0.0, 0.0, 0.0],
                ..Sample::default()
            });
        }
        let waterfall = recorder.finish();
        assert_eq!(
            (waterfall.length, waterfall.hop, waterfall.bins()),
            (100, 25, 11)
        );
        assert_eq!(waterfall.slices.len(), 37); // the last one ends with the samples
        let slice = &waterfall.slices[20];
        assert!((slice.time - 0.55).abs() < 1e-12);
        assert!((slice.amplitude[0][4] - 2e-6).abs() < 1e-18);
    }
}
