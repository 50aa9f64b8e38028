//! The columns of a run that spectra are taken of.

use super::{Axis, Channel, NoiseFloor, SpectrumRequest, magnitude};
use crate::rotor::Sample;

/// Samples and revolutions that a spectrum of a whole run may rest on: beyond both it takes the last ones.
const MOST_IN_SPECTRUM: usize = 1 << 17;
const REVOLUTIONS_IN_SPECTRUM: usize = 256;

/// How the samples of a run follow each other.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SampleGrid {
    /// Samples a second.
    pub rate: f64,
    /// Frequency of a shaft of constant speed, Hz; zero where it changes or is at rest.
    pub shaft_frequency: f64,
    /// Samples a revolution, where that is a whole number at constant speed.
    pub per_revolution: Option<u32>,
}

impl SampleGrid {
    /// So many samples a revolution of a shaft that turns at a constant frequency in Hz.
    pub fn of_angle(shaft_frequency: f64, per_revolution: u32) -> Self {
        Self {
            rate: shaft_frequency * f64::from(per_revolution),
            shaft_frequency,
            per_revolution: Some(per_revolution),
        }
    }

    /// Samples that a spectrum of a whole run rests on at most: 256 revolutions or more.
    pub(super) fn most_in_spectrum(&self) -> usize {
        MOST_IN_SPECTRUM.max(REVOLUTIONS_IN_SPECTRUM * self.block())
    }

    /// Number of samples of which a record holds a multiple, so that what turns with the shaft falls on a bin.
    pub(super) fn block(&self) -> usize {
        self.per_revolution
            .map_or(1, |samples| samples.max(1) as usize)
    }
}

/// Collects columns after the settle time, at equal steps of time.
#[derive(Debug, Clone, PartialEq)]
pub struct Recording {
    pub(super) grid: SampleGrid,
    settle: f64,
    channels: Vec<(Channel, Vec<f64>)>,
    /// Samples that are kept at least: the last ones.
    most: usize,
    /// Time of the first recorded sample that is kept, s.
    start: Option<f64>,
}

/// Drops the oldest values down to `kept` where there are more than `most`; how many.
pub(super) fn keep_last<T>(values: &mut Vec<T>, most: usize, kept: usize) -> usize {
    if values.len() <= most {
        return 0;
    }
    values.drain(..values.len() - kept).len()
}

impl Recording {
    /// Of samples on `grid`, without the first `settle` seconds; of no column so far.
    pub fn new(grid: SampleGrid, settle: f64) -> Self {
        Self {
            grid,
            settle,
            channels: Vec::new(),
            most: usize::MAX,
            start: None,
        }
    }

    /// Columns that were taken elsewhere, all of one length, the first values at a time, s.
    pub(crate) fn of_columns(
        grid: SampleGrid,
        start: f64,
        channels: Vec<(Channel, Vec<f64>)>,
    ) -> Self {
        Self {
            channels,
            start: Some(start),
            ..Self::new(grid, start)
        }
    }

    /// With further columns, each once.
    #[must_use]
    pub fn with(mut self, channels: impl IntoIterator<Item = Channel>) -> Self {
        for channel in channels {
            if self.channels.iter().all(|(known, _)| *known != channel) {
                self.channels.push((channel, Vec::new()));
            }
        }
        self
    }

    /// With all columns that spectra are estimated from.
    #[must_use]
    pub fn with_requests(mut self, requests: &[SpectrumRequest]) -> Self {
        for request in requests {
            let resampled = request.axis == Axis::Order && self.grid.per_revolution.is_none();
            if resampled {
                self = self.with([Channel::Angle, Channel::Speed]);
            }
            let channels = request.channels.iter();
            self = self.with(channels.flat_map(|channel| request.sources(*channel, resampled)));
        }
        self
    }

    /// Of the last samples that a spectrum of the whole run takes alone.
    #[must_use]
    pub(crate) fn of_last(mut self) -> Self {
        self.most = self.grid.most_in_spectrum();
        self
    }

    /// Samples that are held at most: a few more than are kept, so that they seldom move.
    fn most_held(&self) -> usize {
        self.most.saturating_add(self.most / 16)
    }

    /// Samples that are held of so many.
    pub(crate) fn kept_of(&self, samples: f64) -> f64 {
        samples.min(self.most_held() as f64)
    }

    /// With room for the samples of a run that ends at a time, s.
    #[must_use]
    pub(crate) fn until(mut self, end: f64) -> Self {
        let expected = self.kept_of((end - self.settle) * self.grid.rate + 2.0);
        for (_, values) in &mut self.channels {
            // without it, or with too little, they grow as they come
            let _ = values.try_reserve_exact(expected as usize);
        }
        self
    }

    /// Number of columns.
    pub(crate) fn columns(&self) -> usize {
        self.channels.len()
    }

    /// Whether samples must come with their accelerations.
    pub(crate) fn needs_acceleration(&self) -> bool {
        let mut channels = self.channels.iter();
        channels.any(|(channel, _)| channel.needs_acceleration())
    }

    /// Takes one sample; those before the settle time are dropped.
    pub fn record(&mut self, sample: &Sample) {
        if sample.time < self.settle {
            return;
        }
        let most = self.most_held();
        let start = self.start.get_or_insert(sample.time);
        let mut dropped = 0;
        for (channel, values) in &mut self.channels {
            values.extend(channel.value(sample));
            dropped = keep_last(values, most, self.most);
        }
        *start += dropped as f64 / self.grid.rate;
    }

    /// Samples a second.
    pub(crate) fn rate(&self) -> f64 {
        self.grid.rate
    }

    /// Values of a column; none where it was not asked for.
    pub(crate) fn channel(&self, channel: Channel) -> &[f64] {
        let mut channels = self.channels.iter();
        let found = channels.find(|(known, _)| *known == channel);
        found.map_or(&[], |(_, values)| values)
    }

    /// Noise floor of the columns.
    pub(super) fn noise_floor(&self) -> NoiseFloor {
        let channels = self.channels.iter();
        let magnitudes = channels.map(|(channel, values)| (*channel, magnitude(values)));
        NoiseFloor::new(magnitudes, self.grid.rate)
    }

    /// Number of samples recorded of every column.
    pub(crate) fn length(&self) -> usize {
        let lengths = self.channels.iter().map(|(_, values)| values.len());
        lengths.min().unwrap_or(0)
    }

    /// Time of the first one, s.
    pub(crate) fn start(&self) -> f64 {
        self.start.unwrap_or(self.settle)
    }
}

#[cfg(test)]
mod tests {
    use std::f64::consts::TAU;

    use super::*;
    use crate::analysis::Window;

    #[test]
    fn spectra_are_those_of_whole_revolutions_after_the_settle_time() {
        // 1 µm at the shaft frequency of 50 Hz, 64 samples a revolution, 0.1 s of 0.5 s left out
        let x = Channel::Displacement(0);
        let mut recording = Recording::new(SampleGrid::of_angle(50.0, 64), 0.1).with([x]);
        for n in 0..=1600 {
            recording.record(&Sample {
                time: f64::from(n) / 3200.0,
                displacement: [1e-6 * (TAU * f64::from(n) / 64.0).cos(), 0.0, 0.0, 0.0, 0.0],
                ..Sample::default()
            });
        }
        let found = recording.spectrum(&[x], Window::Rectangular, &[]);
        let found = found.expect("enough samples");
        assert_eq!(found.spectrum.length, 20 * 64);
        assert_eq!(found.peaks.len(), 1);
        assert!((found.peaks[0].frequency - 50.0).abs() < 1e-9);
        assert!((found.peaks[0].amplitude - 1e-6).abs() < 1e-15);
    }

    #[test]
    fn a_long_run_keeps_what_its_spectrum_rests_on() {
        let x = Channel::Displacement(0);
        let grid = SampleGrid::of_angle(50.0, 64);
        let kept = grid.most_in_spectrum();
        let mut recording = Recording::new(grid, 0.0).with([x]).of_last();
        for n in 0..300_000 {
            let time = f64::from(n) / 3200.0;
            recording.record(&Sample {
                time,
                displacement: [1e-6 * (TAU * f64::from(n) / 64.0).cos(), 0.0, 0.0, 0.0, 0.0],
                ..Sample::default()
            });
            assert!(recording.length() <= kept + kept / 16);
        }
        let found = recording.lines(&[x], Window::Rectangular, 2.0);
        let spectrum = found.expect("enough samples");
        assert_eq!(spectrum.length, kept);
        let end = spectrum.start + spectrum.length as f64 / 3200.0;
        assert!((end - 300_000.0 / 3200.0).abs() < 1e-6, "{end}");
        let amplitude = &spectrum.channels[0].amplitude;
        assert!((amplitude[kept / 64] - 1e-6).abs() < 1e-14);
    }
}
