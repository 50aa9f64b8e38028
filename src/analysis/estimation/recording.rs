//! The channels that spectra are estimated of, as the run goes by.

use super::angle_grid::Turning;
use super::{Axis, SpectrumRequest};
use crate::analysis::Channel;
use crate::rotor::Sample;

/// How the samples of a run follow each other.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SampleGrid {
    /// Samples a second.
    pub rate: f64,
    /// Frequency of a shaft of constant speed, Hz; zero where it changes or stands.
    pub shaft_frequency: f64,
    /// Samples a revolution, where that is a whole number at constant speed.
    pub per_revolution: Option<u32>,
}

/// Collects what requests need after the settle time, and nothing else.
#[derive(Debug, Clone, PartialEq)]
pub struct Recording {
    pub(super) grid: SampleGrid,
    settle: f64,
    channels: Vec<(Channel, Vec<f64>)>,
    /// Where spectra over orders must be resampled.
    pub(super) turning: Option<Turning>,
    /// Time of the first recorded sample, s.
    start: Option<f64>,
}

impl Recording {
    /// Of samples on `grid`, without the first `settle` seconds.
    pub fn new(grid: SampleGrid, settle: f64, requests: &[SpectrumRequest]) -> Self {
        let mut channels: Vec<(Channel, Vec<f64>)> = Vec::new();
        let resampled = |request: &SpectrumRequest| {
            request.axis == Axis::Order && grid.per_revolution.is_none()
        };
        for request in requests {
            let sources = request.channels.iter();
            let sources = sources.flat_map(|channel| request.sources(*channel, resampled(request)));
            for source in sources {
                if channels.iter().all(|(known, _)| *known != source) {
                    channels.push((source, Vec::new()));
                }
            }
        }
        Self {
            grid,
            settle,
            channels,
            turning: requests.iter().any(resampled).then(Turning::default),
            start: None,
        }
    }

    /// Whether samples must come with their accelerations.
    pub fn needs_acceleration(&self) -> bool {
        let mut channels = self.channels.iter();
        channels.any(|(channel, _)| matches!(channel, Channel::Acceleration(_)))
    }

    /// Takes one sample, with accelerations where [`Recording::needs_acceleration`]; those before the settle time
    /// are dropped.
    pub fn record(&mut self, sample: &Sample) {
        if sample.time < self.settle {
            return;
        }
        self.start.get_or_insert(sample.time);
        if let Some(turning) = &mut self.turning {
            turning.angle.push(sample.angle);
            turning.speed.push(sample.speed);
        }
        for (channel, values) in &mut self.channels {
            values.extend(channel.of(sample));
        }
    }

    /// Samples recorded of a channel; none where it was not asked for.
    pub(super) fn channel(&self, channel: Channel) -> &[f64] {
        let mut channels = self.channels.iter();
        let found = channels.find(|(known, _)| *known == channel);
        found.map_or(&[], |(_, values)| values)
    }

    /// Number of samples recorded of every channel.
    pub(super) fn length(&self) -> usize {
        let lengths = self.channels.iter().map(|(_, values)| values.len());
        lengths.min().unwrap_or(0)
    }

    /// Time of the first one, s.
    pub(super) fn start(&self) -> f64 {
        self.start.unwrap_or(self.settle)
    }
}
