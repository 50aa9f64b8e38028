//! Peaks of a spectrum and the causes that they are named by.

use super::Channel;

/// What a spectral line can be caused by.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum LineKind {
    /// k × shaft frequency.
    ShaftOrder(u32),
    /// k × ball-pass frequency of the outer race of bearing number `bearing` (from 0), ± sideband × shaft.
    BallPassOuter {
        /// Bearing, from 0.
        bearing: usize,
        /// Multiple.
        multiple: u32,
        /// Shaft orders added.
        sideband: i32,
    },
    /// k × cage frequency of bearing `bearing`.
    Cage {
        /// Bearing, from 0.
        bearing: usize,
        /// Multiple.
        multiple: u32,
    },
    /// Natural frequency number `mode` (from 0) of the linearised system.
    Natural {
        /// Mode, from 0, lowest first.
        mode: usize,
    },
}

/// A frequency at which a cause would show.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Line {
    /// The cause.
    pub kind: LineKind,
    /// Its frequency, Hz.
    pub frequency: f64,
}

/// A local maximum of an amplitude spectrum.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Peak {
    /// Quantity it was found in.
    pub channel: Channel,
    /// Frequency estimated between the bins, Hz.
    pub frequency: f64,
    /// Amplitude (peak value) in the unit of the channel.
    pub amplitude: f64,
    /// The nearest known cause within a bin and a half, if any.
    pub line: Option<Line>,
}
