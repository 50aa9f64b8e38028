//! What a spectrum is asked to show.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::Detrend;
use crate::analysis::{Channel, Window};
use crate::table::SCALINGS;

/// What is made of the channels.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub enum SpectrumKind {
    /// One one-sided spectrum a channel.
    Plain,
    /// The spectrum of the channel's envelope.
    Envelope {
        /// Lowest and highest frequency of what has the envelope, Hz.
        band: [f64; 2],
    },
    /// The spectrum of the envelope of the band in which the first channel knocks most, which becomes that of an `Envelope`.
    ImpulsiveEnvelope,
    /// Two-sided spectra of x + iy; channels come in pairs.
    Whirl,
    /// Cross spectra of the first channel with each of the others.
    Cross,
}

/// How long a segment is.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Segment {
    /// One segment: the record.
    Whole,
    /// So many seconds.
    Seconds(f64),
    /// So many revolutions of the shaft.
    Revolutions(u32),
    /// So many samples.
    Samples(usize),
}

/// Axis of a spectrum.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Axis {
    /// Frequency in Hz.
    #[default]
    Frequency,
    /// Shaft orders; at a changing speed of samples at equal shaft angles.
    Order,
}

impl SpectrumKind {
    /// Name as in the files: `plain`, `envelope`, `whirl`, `cross`.
    pub fn name(self) -> &'static str {
        match self {
            Self::Plain => "plain",
            Self::Envelope { .. } | Self::ImpulsiveEnvelope => "envelope",
            Self::Whirl => "whirl",
            Self::Cross => "cross",
        }
    }
}

impl Axis {
    /// Unit of its values: `Hz`, or `order`.
    pub fn unit(self) -> &'static str {
        match self {
            Self::Frequency => "Hz",
            Self::Order => "order",
        }
    }
}

/// A spectrum that a run is to estimate.
#[derive(Debug, Clone, PartialEq)]
pub struct SpectrumRequest {
    /// Its name, by which its file is called.
    pub name: String,
    /// What is made of the channels.
    pub kind: SpectrumKind,
    /// The channels: pairs (x, y) of a whirl, the reference first of a cross spectrum.
    pub channels: Vec<Channel>,
    /// Scaling of the values.
    pub scaling: Scaling,
    /// Window of every segment.
    pub window: Window,
    /// Length of a segment.
    pub segment: Segment,
    /// Share of a segment that the next one holds as well, 0 … 1 (excluded).
    pub overlap: f64,
    /// What is taken out of every segment.
    pub detrend: Detrend,
    /// Its axis.
    pub axis: Axis,
}

impl SpectrumRequest {
    /// Channels that it takes to have `channel`, `resampled` at equal angles or as it is.
    ///
    /// A displacement and a velocity are interpolated with their rates; of an envelope, and of accelerations and forces,
    /// only values are known.
    pub(in crate::analysis) fn sources(&self, channel: Channel, resampled: bool) -> Vec<Channel> {
        let is_plain = !matches!(
            self.kind,
            SpectrumKind::Envelope { .. } | SpectrumKind::ImpulsiveEnvelope
        );
        let rate = rate_of(channel).filter(|_| is_plain && resampled);
        [channel].into_iter().chain(rate).collect()
    }
}

/// The time derivative of a channel, where that is known.
pub(super) fn rate_of(channel: Channel) -> Option<Channel> {
    match channel {
        Channel::Displacement(freedom) => Some(Channel::Velocity(freedom)),
        Channel::Velocity(freedom) => Some(Channel::Acceleration(freedom)),
        Channel::Body {
            body,
            quantity,
            axis,
        } => Some(Channel::Body {
            body,
            quantity: quantity.rate()?,
            axis,
        }),
        _ => None,
    }
}

/// Scaling of a spectrum.
///
/// With P the power of a bin, the mean over the segments of `|Σ w x exp(−2πikn/N)|²/(Σ w)²`, and
/// s = 2 for the image at −f that a one-sided spectrum folds in (s = 1 at zero frequency, at half the
/// sampling rate of an even length, and in a two-sided spectrum):
///
/// ```text
/// peak = s √P    peak to peak = 2 s √P    rms = √(s P)    power = s P    density = s P/ENBW
/// ```
///
/// `scipy.signal.welch` calls power `scaling="spectrum"` and density `scaling="density"`; Matlab's
/// `pwelch` calls them "power" and "psd".
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Scaling {
    /// Amplitude.
    Peak,
    /// Root mean square.
    Rms,
    /// Twice the amplitude.
    PeakToPeak,
    /// Mean square: "spectrum" of SciPy, "power" of Matlab.
    Power,
    /// Mean square per Hz or per order: "density" of SciPy, "psd" of Matlab.
    Density,
}

impl Scaling {
    /// The value of a bin of power `power` that counts `sides` times, under a window of the
    /// equivalent noise bandwidth `bandwidth` in units of the axis.
    ///
    /// ```
    /// use jeffcott::internals::Scaling;
    /// // a cosine of amplitude 3 has (3/2)² at f and at −f
    /// assert_eq!(Scaling::Peak.value(2.25, 2.0, 1.5), 3.0);
    /// assert_eq!(Scaling::Power.value(2.25, 2.0, 1.5), 4.5);
    /// assert_eq!(Scaling::Density.value(2.25, 2.0, 1.5), 3.0);
    /// ```
    pub fn value(self, power: f64, sides: f64, bandwidth: f64) -> f64 {
        match self {
            Self::Peak => sides * power.sqrt(),
            Self::PeakToPeak => 2.0 * sides * power.sqrt(),
            Self::Rms => (sides * power).sqrt(),
            Self::Power => sides * power,
            Self::Density => sides * power / bandwidth,
        }
    }

    /// Whether values are in the unit squared.
    pub fn is_square(self) -> bool {
        matches!(self, Self::Power | Self::Density)
    }

    /// Name as in the files: `peak`, `rms`, `peak_to_peak`, `power`, `density`.
    pub fn name(self) -> &'static str {
        SCALINGS[self as usize]
    }
}
