//! One-sided amplitude spectra of a whole run after the settle time, and their peaks.

use std::f64::consts::PI;

use realfft::RealFftPlanner;
use serde::Serialize;

use super::peaks::peaks;
use super::{
    Channel, Line, NoiseFloor, Peak, Recording, Transform, Window, is_above_noise, magnitude,
};

/// Fewer samples than this make no spectrum: the widest window mixes nine bins.
pub(super) const FEWEST_SAMPLES: usize = 16;

/// Amplitude and phase of one channel.
#[derive(Debug, Clone, PartialEq)]
pub struct ChannelSpectrum {
    /// The quantity.
    pub channel: Channel,
    /// One-sided amplitudes (peak values) at the spectrum's frequencies; zero but for the mean where all are
    /// round-off.
    pub amplitude: Vec<f64>,
    /// Phases in rad of `cos(2πft + phase)`, time counted from the start of the window.
    pub phase: Vec<f64>,
}

impl ChannelSpectrum {
    /// Amplitudes and phases under a window of a channel with a mean, transformed without it. The mean alone is at frequency
    /// zero: it is taken away before the window, whose skirt around it would hide the lowest lines.
    fn new(channel: Channel, mean: Option<f64>, centred: &Transform, window: Window) -> Self {
        let lines = (1..centred.bins()).map(|k| centred.line(k, window).to_polar());
        let mean = mean.map(|mean| (mean.abs(), if mean < 0.0 { PI } else { 0.0 }));
        let (amplitude, phase) = mean.into_iter().chain(lines).unzip();
        Self {
            channel,
            amplitude,
            phase,
        }
    }

    /// With no amplitude but the mean where none reaches up to a noise floor.
    #[must_use]
    pub(crate) fn above(mut self, floor: &NoiseFloor) -> Self {
        let lines = self.amplitude.get_mut(1..).unwrap_or_default();
        if magnitude(lines) < floor.below(self.channel) {
            lines.fill(0.0);
            self.phase.iter_mut().skip(1).for_each(|phase| *phase = 0.0);
        }
        self
    }
}

/// One-sided amplitude spectra of all channels on one frequency axis.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Spectrum {
    /// Frequency step, Hz; bin k is at k times this.
    #[serde(rename = "resolution_Hz")]
    pub resolution: f64,
    /// Shaft frequency, Hz; zero where the shaft does not turn.
    #[serde(rename = "shaft_frequency_Hz")]
    pub shaft_frequency: f64,
    /// Number of samples in the window.
    pub length: usize,
    /// Time of the first sample in the window, s.
    #[serde(rename = "start_s")]
    pub start: f64,
    /// Window.
    pub window: Window,
    /// One entry a channel.
    #[serde(skip)]
    pub channels: Vec<ChannelSpectrum>,
}

impl Spectrum {
    /// Number of frequencies.
    pub fn bins(&self) -> usize {
        self.channels
            .first()
            .map_or(0, |channel| channel.amplitude.len())
    }

    /// Frequency of bin `k`, Hz.
    pub fn frequency(&self, k: usize) -> f64 {
        k as f64 * self.resolution
    }

    /// Frequency of bin `k` as a multiple of the shaft frequency, if the shaft turns.
    pub fn order(&self, k: usize) -> Option<f64> {
        (self.shaft_frequency > 0.0).then(|| self.frequency(k) / self.shaft_frequency)
    }

    /// Noise floor of its channels.
    pub(crate) fn noise_floor(&self) -> NoiseFloor {
        let magnitudes = self
            .channels
            .iter()
            .map(|entry| (entry.channel, magnitude(&entry.amplitude)));
        NoiseFloor::new(magnitudes, self.resolution * self.length as f64)
    }

    /// Spectrum of one channel, if it was recorded.
    pub fn channel(&self, channel: Channel) -> Option<&ChannelSpectrum> {
        self.channels.iter().find(|entry| entry.channel == channel)
    }
}

/// Spectra of a run and their peaks.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct Analysis {
    /// Spectra of all channels.
    pub spectrum: Spectrum,
    /// Peaks of all channels, channel by channel, strongest first.
    pub peaks: Vec<Peak>,
}

impl Analysis {
    /// The peaks without names that are no higher than the noise around them.
    #[must_use]
    pub(crate) fn without_names_of_noise(mut self) -> Self {
        for peak in &mut self.peaks {
            let bin = (peak.frequency / self.spectrum.resolution).round() as usize;
            let entry = self.spectrum.channel(peak.channel);
            if entry.is_some_and(|own| !is_above_noise(&own.amplitude, bin, peak.amplitude)) {
                peak.line = None;
                peak.others.clear();
            }
        }
        self
    }
}

/// On a grid of shaft angle the spectra are taken of the largest whole number of revolutions that fits, the last
/// ones of the run, so that what turns with the shaft falls on a bin; on a free grid of time, of all samples. Beyond
/// 131 072 samples and 256 revolutions they take the last of them. There is none where less than one revolution, or too few samples for a spectrum, were recorded.
impl Recording {
    /// Spectra of recorded channels under `window` and their peaks, named by the nearest of `causes`.
    pub fn spectrum(
        &self,
        channels: &[Channel],
        window: Window,
        causes: &[Line],
    ) -> Option<Analysis> {
        let mut found = Vec::new();
        let floor = self.noise_floor();
        let spectrum = self.transformed(channels, window, |spectrum, channel, transform| {
            let (mean, centred) = transform.split_mean();
            let least = floor.below(channel);
            found.extend(peaks(channel, &centred, spectrum.resolution, causes, least));
            ChannelSpectrum::new(channel, mean, &centred, window).above(&floor)
        })?;
        Some(Analysis {
            spectrum,
            peaks: found,
        })
    }

    /// The spectrum up to an order of the shaft, or all of it where the shaft does not turn; without peaks.
    pub fn lines(
        &self,
        channels: &[Channel],
        window: Window,
        highest_order: f64,
    ) -> Option<Spectrum> {
        let floor = self.noise_floor();
        self.transformed(channels, window, |spectrum, channel, transform| {
            let (mean, centred) = transform.split_mean();
            let mut entry = ChannelSpectrum::new(channel, mean, &centred, window);
            if spectrum.shaft_frequency > 0.0 {
                let highest = highest_order * spectrum.shaft_frequency / spectrum.resolution;
                entry.amplitude.truncate(1 + highest as usize);
                entry.phase.truncate(1 + highest as usize);
            }
            entry.above(&floor)
        })
    }

    /// The spectrum that is made of the transforms of some channels.
    fn transformed(
        &self,
        channels: &[Channel],
        window: Window,
        mut entry: impl FnMut(&Spectrum, Channel, Transform) -> ChannelSpectrum,
    ) -> Option<Spectrum> {
        let (recorded, block) = (self.length(), self.grid.block());
        let length = recorded.min(self.grid.most_in_spectrum()) / block * block;
        if length < FEWEST_SAMPLES {
            return None;
        }
        let skipped = recorded - length;
        let mut spectrum = Spectrum {
            resolution: self.grid.rate / length as f64,
            shaft_frequency: self.grid.shaft_frequency,
            length,
            start: self.start() + skipped as f64 / self.grid.rate,
            window,
            channels: Vec::new(),
        };
        let mut planner = RealFftPlanner::new();
        for &channel in channels {
            let values = self.channel(channel)[skipped..].to_vec();
            let transform = Transform::planned(values, &mut planner);
            spectrum.channels.push(entry(&spectrum, channel, transform));
        }
        Some(spectrum)
    }
}

#[cfg(test)]
mod tests {
    use std::f64::consts::TAU;

    use super::*;

    #[test]
    fn under_every_window_the_mean_stands_alone_at_frequency_zero() {
        let value = |n: u32| -3.0 + 1e-6 * (0.5 * TAU * f64::from(n)).cos();
        for window in [Window::Rectangular, Window::Hann, Window::FlatTop] {
            let transform = Transform::new((0..64).map(value).collect());
            let (mean, centred) = transform.split_mean();
            let spectrum = ChannelSpectrum::new(Channel::Displacement(0), mean, &centred, window);
            assert!((spectrum.amplitude[0] - 3.0).abs() < 1e-14);
            assert_eq!(spectrum.phase[0], PI);
            let skirt = spectrum.amplitude[1..8]
                .iter()
                .fold(0.0, |a: f64, b| a.max(*b));
            assert!(skirt < 1e-14, "{window:?}: {skirt:e}");
        }
    }
}
