//! One-sided amplitude spectra.

use std::f64::consts::PI;

use serde::Serialize;

use super::{Channel, NoiseFloor, Transform, Window, magnitude};

/// Amplitude and phase of one channel.
#[derive(Debug, Clone, PartialEq)]
pub struct ChannelSpectrum {
    /// The quantity.
    pub channel: Channel,
    /// One-sided amplitudes (peak values) at the spectrum's frequencies; zero but for the mean where all are
    /// round-off.
    pub amplitude: Vec<f64>,
    /// Phases in rad of `cos(2πft + phase)`, time counted from the start of the window; none where only
    /// amplitudes were asked for.
    pub phase: Vec<f64>,
}

impl ChannelSpectrum {
    /// Amplitudes and phases of a transformed channel under a window. The mean stands alone at frequency zero: it is
    /// taken away before the window, whose skirt around it would hide the lowest lines.
    pub(crate) fn new(channel: Channel, transform: Transform, window: Window) -> Self {
        let (mean, transform) = transform.split_mean();
        let lines = (1..transform.bins()).map(|k| transform.amplitude_and_phase(k, window));
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
    /// Frequency step, Hz; bin k stands at k times this.
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
        NoiseFloor::of(magnitudes, self.resolution * self.length as f64)
    }

    /// Spectrum of one channel, if it was recorded.
    pub fn channel(&self, channel: Channel) -> Option<&ChannelSpectrum> {
        self.channels.iter().find(|entry| entry.channel == channel)
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
            let spectrum = ChannelSpectrum::new(Channel::Displacement(0), transform, window);
            assert!((spectrum.amplitude[0] - 3.0).abs() < 1e-14);
            assert_eq!(spectrum.phase[0], PI);
            let skirt = spectrum.amplitude[1..8]
                .iter()
                .fold(0.0, |a: f64, b| a.max(*b));
            assert!(skirt < 1e-14, "{window:?}: {skirt:e}");
        }
    }
}
