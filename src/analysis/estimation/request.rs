//! What a spectrum is asked to show.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::{Detrend, Scaling};
use crate::analysis::{Channel, Window};

/// What is made of the channels.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub enum SpectrumKind {
    /// One one-sided spectrum a channel.
    Plain,
    /// The same of the channel's envelope.
    Envelope {
        /// Lowest and highest frequency of what has the envelope, Hz.
        band: [f64; 2],
    },
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

/// What a spectrum stands over.
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
            Self::Envelope { .. } => "envelope",
            Self::Whirl => "whirl",
            Self::Cross => "cross",
        }
    }
}

impl Axis {
    /// Name as in the files: `frequency`, `order`.
    pub fn name(self) -> &'static str {
        match self {
            Self::Frequency => "frequency",
            Self::Order => "order",
        }
    }

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
    /// What it stands over.
    pub axis: Axis,
}

impl SpectrumRequest {
    /// Channels that it takes to have `channel`, `resampled` at equal angles or as it is.
    ///
    /// A displacement is interpolated with its first two derivatives, and a velocity as the derivative
    /// of that; of an envelope, and of accelerations and forces, only values are known.
    pub(in crate::analysis) fn sources(&self, channel: Channel, resampled: bool) -> Vec<Channel> {
        let is_plain = !matches!(self.kind, SpectrumKind::Envelope { .. });
        match channel {
            Channel::Displacement(freedom) | Channel::Velocity(freedom)
                if is_plain && resampled =>
            {
                vec![
                    Channel::Displacement(freedom),
                    Channel::Velocity(freedom),
                    Channel::Acceleration(freedom),
                ]
            }
            _ => vec![channel],
        }
    }
}
