//! When samples were taken.

use std::sync::Arc;

/// Largest distance of a time from those of an even rate, in steps: so much is lost where times are rounded.
const EVEN: f64 = 0.05;

/// When the samples of a channel were taken.
#[derive(Debug, Clone, PartialEq, Default)]
pub enum Sampling {
    /// The file does not say it.
    #[default]
    Unknown,
    /// At an even rate.
    Even {
        /// Samples a second, Hz.
        rate: f64,
        /// Time of the first, s.
        start: f64,
    },
    /// At these times, s, which rise unevenly.
    Times(Arc<[f64]>),
    /// At times that do not rise at this sample, counted from 1.
    Unordered(usize),
}

impl Sampling {
    /// The sampling of times in s: even where none is further than a twentieth of a step from an even rate.
    pub fn from_times(times: &[f64]) -> Self {
        let [start, .., end] = *times else {
            return Self::Unknown;
        };
        // a time that is not a number, or infinite, does not rise
        let rises = |pair: &[f64]| pair[0] < pair[1] && (pair[1] - start).is_finite();
        if let Some(before) = times.windows(2).position(|pair| !rises(pair)) {
            return Self::Unordered(before + 2);
        }
        let steps = (times.len() - 1) as f64;
        let (step, rate) = ((end - start) / steps, steps / (end - start));
        let is_near = |(index, time): (usize, &f64)| {
            (time - start - index as f64 * step).abs() <= EVEN * step
        };
        match times.iter().enumerate().all(is_near) {
            true => Self::Even { rate, start },
            false => Self::Times(times.into()),
        }
    }

    /// Samples a second, Hz, if they are even.
    pub fn rate(&self) -> Option<f64> {
        match self {
            Self::Even { rate, .. } => Some(*rate),
            _ => None,
        }
    }

    /// Time from the first to the last of so many samples, s.
    pub fn duration(&self, samples: usize) -> Option<f64> {
        match self {
            Self::Unknown | Self::Unordered(_) => None,
            Self::Even { rate, .. } => Some(samples.saturating_sub(1) as f64 / rate),
            Self::Times(times) => Some(times.last()? - times.first()?),
        }
    }
}
