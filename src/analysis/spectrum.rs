//! One-sided amplitude spectra.

/// Window of a spectrum.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Window {
    /// No weighting: exact for lines on a bin, as on whole revolutions at constant speed.
    Rectangular,
    /// Hann: narrow lines, 15 % amplitude error at the worst place between bins.
    Hann,
    /// Flat top: amplitudes within 1 % anywhere between bins.
    FlatTop,
}

/// A quantity of the trace that a spectrum is taken of.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Channel {
    /// Displacement or tilt of freedom 0 … 4: x, y, z in m, θx, θy in rad.
    Displacement(usize),
    /// Force of the bearings on the shaft along freedom 0 … 4, N or N m.
    Force(usize),
}

/// Amplitude and phase of one channel.
#[derive(Debug, Clone, PartialEq)]
pub struct ChannelSpectrum {
    /// The quantity.
    pub channel: Channel,
    /// One-sided amplitudes (peak values) at the spectrum's frequencies.
    pub amplitude: Vec<f64>,
    /// Phases in rad of `cos(2πft + phase)`, time counted from the start of the window.
    pub phase: Vec<f64>,
}

/// One-sided amplitude spectra of all channels on one frequency axis.
#[derive(Debug, Clone, PartialEq)]
pub struct Spectrum {
    /// Frequency step, Hz; bin k stands at k times this.
    pub resolution: f64,
    /// Shaft frequency, Hz; zero where the shaft does not turn.
    pub shaft_frequency: f64,
    /// Number of samples in the window.
    pub length: usize,
    /// Time of the first sample in the window, s.
    pub start: f64,
    /// Window.
    pub window: Window,
    /// One entry a channel.
    pub channels: Vec<ChannelSpectrum>,
}
