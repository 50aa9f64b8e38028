//! Spectra as a raster of colours, over time, speed or the values of a study.

use std::ops::Range;

use super::figure::Map;
use crate::analysis::{Slice, Waterfall};

/// Most cells along an axis: more cannot be seen.
pub(in crate::report) const MOST_CELLS: usize = 320;

/// Cells along the axis of speed.
pub(super) const SPEED_CELLS: usize = 200;

/// Decades below the loudest cell that are told apart.
pub(super) const DECADES: f64 = 4.0;

/// Part of the largest amplitude that counts as content, and how far beyond its highest frequency a map goes.
pub(super) const CONTENT: f64 = 1e-3;

pub(super) const BEYOND: f64 = 1.2;

/// A channel below this part of the loudest one does not move.
pub(super) const ROUND_OFF: f64 = 1e-9;

/// Bins that hold the mean, which was taken away.
pub(super) const MEAN_BINS: usize = 1;

/// Amplitudes over one axis and frequency.
#[derive(Debug, Clone, PartialEq)]
pub(in crate::report) struct Raster {
    /// Ends of the first axis, s or rad/s.
    pub ends: [f64; 2],
    /// Ends of the axis of frequencies, Hz.
    pub frequencies: [f64; 2],
    /// Columns by the first axis, each by rising frequency.
    columns: Vec<Vec<f64>>,
}

impl Raster {
    /// Of columns at even steps, each by rising frequency.
    pub fn new(ends: [f64; 2], frequencies: [f64; 2], columns: Vec<Vec<f64>>) -> Self {
        Self {
            ends,
            frequencies,
            columns,
        }
    }

    /// Over time: a column a spectrum, neighbours joined where they are too many.
    pub fn over_time(waterfall: &Waterfall, channel: usize) -> Self {
        let slices = &waterfall.slices;
        let step = waterfall.window() * waterfall.hop as f64 / waterfall.length as f64;
        let columns = slices
            .chunks(slices.len().div_ceil(MOST_CELLS).max(1))
            .map(|some| mean_square(waterfall, channel, some.iter()))
            .collect();
        let ends = [slices.first(), slices.last()];
        let [first, last] = ends.map(|slice| slice.map_or(0.0, |slice| slice.time));
        Self {
            ends: [first - 0.5 * step, last + 0.5 * step],
            frequencies: frequencies(waterfall),
            columns,
        }
    }

    /// Over speed: in a column all spectra of about its speed, or the nearest one where there is none.
    pub fn over_speed(waterfall: &Waterfall, channel: usize) -> Self {
        let slices = || waterfall.slices.iter();
        let speeds = || slices().map(|slice| slice.speed);
        let (low, high) = (
            speeds().fold(f64::INFINITY, f64::min),
            speeds().fold(0.0, f64::max),
        );
        let step = (high - low) / SPEED_CELLS as f64;
        let columns = (0..SPEED_CELLS).map(|cell| {
            let middle = low + (cell as f64 + 0.5) * step;
            let away = |speed: f64| (speed - middle).abs();
            let nearest = speeds().map(away).fold(f64::INFINITY, f64::min);
            let reach = nearest.max(0.5 * step);
            let about = slices().filter(|slice| away(slice.speed) <= reach);
            mean_square(waterfall, channel, about)
        });
        Self {
            ends: [low, high],
            frequencies: frequencies(waterfall),
            columns: columns.collect(),
        }
    }

    /// What the first axis shows, in a unit of which `scale` make one of its own.
    pub fn range(&self, scale: f64) -> Range<f64> {
        scale * self.ends[0]..scale * self.ends[1]
    }

    /// Loudest cell but for the mean.
    pub fn loudest(&self) -> f64 {
        let cells = self
            .columns
            .iter()
            .flat_map(|column| column.iter().skip(MEAN_BINS));
        cells.copied().fold(0.0, f64::max)
    }

    /// Frequency a little above the highest one of its content, Hz.
    pub fn content(&self, loudest: f64) -> f64 {
        let counts = |value: &f64| *value > CONTENT * loudest;
        let highest = |column: &Vec<f64>| column.iter().rposition(counts);
        let rows = self.columns.iter().filter_map(highest).max();
        let all = self.columns.iter().map(Vec::len).max().unwrap_or(0);
        let [low, high] = self.frequencies;
        rows.map_or(high, |row| {
            let kept = (BEYOND * (row + 1) as f64).ceil().min(all as f64);
            low + (high - low) * kept / all.max(1) as f64
        })
    }

    /// Without what is above a frequency in Hz, to a cell.
    pub fn up_to(&self, highest: f64) -> Self {
        let all = self.columns.iter().map(Vec::len).max().unwrap_or(0);
        let [low, high] = self.frequencies;
        let size = (high - low) / all.max(1) as f64;
        let kept = ((highest - low) / size).round().clamp(0.0, all as f64) as usize;
        let columns = self.columns.iter();
        Self {
            ends: self.ends,
            frequencies: [low, low + kept as f64 * size],
            columns: columns
                .map(|column| column[..kept.min(column.len())].to_vec())
                .collect(),
        }
    }

    /// Levels from the highest frequency down, 0 at [`DECADES`] below `loudest` or less, 255 there or above.
    pub fn map(&self, loudest: f64) -> Map {
        let height = self.columns.first().map_or(0, Vec::len);
        let joined = height.div_ceil(MOST_CELLS).max(1);
        let level = |row: usize, column: &Vec<f64>| {
            let cells = column[row * joined..((row + 1) * joined).min(height)].iter();
            let value = cells.copied().fold(0.0, f64::max);
            let part = 1.0 + (value / loudest).log10() / DECADES;
            (255.0 * part.clamp(0.0, 1.0)).round() as u8
        };
        let rows = (0..height.div_ceil(joined)).rev();
        let pixels = rows.flat_map(|row| self.columns.iter().map(move |column| level(row, column)));
        Map {
            width: self.columns.len(),
            levels: pixels.collect(),
        }
    }
}

/// Which channels are more than round-off compared with the loudest, by the largest amplitude of each.
pub(in crate::report) fn moving(loudest: &[f64]) -> impl Iterator<Item = usize> {
    let floor = ROUND_OFF * loudest.iter().copied().fold(0.0, f64::max);
    (0..loudest.len()).filter(move |channel| loudest[*channel] > floor)
}

/// A bin is as wide as the step of frequencies, about its middle.
pub(super) fn frequencies(waterfall: &Waterfall) -> [f64; 2] {
    let half = 0.5 * waterfall.resolution;
    [-half, waterfall.bins() as f64 * waterfall.resolution - half]
}

/// Root of the mean square of some spectra.
pub(super) fn mean_square<'a>(
    waterfall: &Waterfall,
    channel: usize,
    slices: impl Iterator<Item = &'a Slice>,
) -> Vec<f64> {
    let mut sums = vec![0.0; waterfall.bins()];
    let mut count = 0.0;
    for slice in slices {
        count += 1.0;
        for (sum, amplitude) in sums.iter_mut().zip(&slice.amplitude[channel]) {
            *sum += amplitude * amplitude;
        }
    }
    sums.iter().map(|sum: &f64| (sum / count).sqrt()).collect()
}
