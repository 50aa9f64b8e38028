//! One-sided amplitude spectra.

use serde::Serialize;

use super::{Channel, Transform, Window};

/// Amplitude and phase of one channel.
#[derive(Debug, Clone, PartialEq)]
pub struct ChannelSpectrum {
    /// The quantity.
    pub channel: Channel,
    /// One-sided amplitudes (peak values) at the spectrum's frequencies.
    pub amplitude: Vec<f64>,
    /// Phases in rad of `cos(2πft + phase)`, time counted from the start of the window; none where only
    /// amplitudes were asked for.
    pub phase: Vec<f64>,
}

impl ChannelSpectrum {
    /// Amplitudes and phases of a transformed channel under a window.
    pub(crate) fn new(channel: Channel, transform: &Transform, window: Window) -> Self {
        let bins = 0..transform.bins();
        let (amplitude, phase) = bins
            .map(|k| transform.amplitude_and_phase(k, window))
            .unzip();
        Self {
            channel,
            amplitude,
            phase,
        }
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

    /// Spectrum of one channel, if it was recorded.
    pub fn channel(&self, channel: Channel) -> Option<&ChannelSpectrum> {
        self.channels.iter().find(|entry| entry.channel == channel)
    }
}
