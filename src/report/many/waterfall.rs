//! The spectra of a study over its only axis.

use std::path::Path;

use super::digest::Digest;
use super::{each_row, number_in};
use crate::report::ReportError;
use crate::report::figure::Figure;
use crate::report::run_up::{MOST_CELLS, Raster, moving, runs_figure};

/// Columns before the amplitudes: run, frequency and order.
const START: usize = 3;

/// Spectra of one run.
#[derive(Debug)]
struct Spectra {
    run: u64,
    /// Value of the axis.
    at: f64,
    frequencies: Vec<f64>,
    /// Of every channel.
    amplitudes: Vec<Vec<f64>>,
}

/// Value of the axis in one run, and its cells: of every channel by rising frequency.
type Column = (f64, Vec<Vec<f64>>);

impl Digest {
    /// Amplitudes of the displacements over the only axis of a grid and frequency, every channel a row.
    pub(super) fn waterfall(
        &self,
        title: &str,
        spectra: &Path,
    ) -> Result<Option<Figure>, ReportError> {
        let ([(axis, _)], Some(ends), false) = (&self.labels[..], self.ends(0), self.drawn) else {
            return Ok(None);
        };
        let mut highest = 0.0_f64;
        each_run(self, spectra, |run| highest = highest.max(run.end()))?;
        let mut columns = Vec::new();
        let names = each_run(self, spectra, |run| columns.push(run.column(highest)))?;
        columns.sort_by(|a: &Column, b| a.0.total_cmp(&b.0));
        let raster = |channel| raster(&columns, channel, ends, highest);
        let channels = names.iter().enumerate();
        let channels = channels.filter(|(_, name)| name.ends_with("_amplitude_m"));
        let rows = channels.map(|(channel, name)| {
            let name = name.trim_end_matches("_amplitude_m").to_owned();
            (name, raster(channel))
        });
        let rows: Vec<_> = rows.collect();
        let loudest: Vec<f64> = rows.iter().map(|(_, raster)| raster.loudest()).collect();
        let rows: Vec<_> = moving(&loudest).map(|row| rows[row].clone()).collect();
        Ok((!rows.is_empty()).then(|| runs_figure(title, axis, &rows)))
    }
}

/// Shows the spectra of one run after the other, of those that are drawn; returns the names of the channels.
fn each_run(
    digest: &Digest,
    path: &Path,
    mut show: impl FnMut(&Spectra),
) -> Result<Vec<String>, ReportError> {
    let mut channels = Vec::new();
    let mut current: Option<Spectra> = None;
    each_row(path, |names, record| {
        if channels.is_empty() {
            channels = names.iter().skip(START).map(str::to_owned).collect();
        }
        let run = number_in(&record, 0) as u64;
        if let Some(whole) = current.take_if(|known| known.run != run) {
            show(&whole);
        }
        let Some(row) = digest.row(run).filter(|row| !row.down) else {
            return;
        };
        let spectra = current.get_or_insert_with(|| Spectra {
            run,
            at: digest.at(row, 0),
            frequencies: Vec::new(),
            amplitudes: vec![Vec::new(); channels.len()],
        });
        spectra.frequencies.push(number_in(&record, 1));
        for (place, channel) in spectra.amplitudes.iter_mut().enumerate() {
            channel.push(number_in(&record, START + place));
        }
    })?;
    current.iter().for_each(show);
    Ok(channels)
}

impl Spectra {
    fn end(&self) -> f64 {
        self.frequencies.last().copied().unwrap_or(0.0)
    }

    /// In every cell up to `highest` the largest amplitude, or where none falls into it, the nearest; nothing
    /// beyond the last frequency of the run.
    fn column(&self, highest: f64) -> Column {
        let size = highest / MOST_CELLS as f64;
        let end = self.end();
        let cell = |cell: usize, channel: &[f64]| {
            let [from, to] = [cell, cell + 1].map(|edge| edge as f64 * size);
            if from > end {
                return 0.0;
            }
            let first = self.frequencies.partition_point(|at| *at < from);
            let last = self.frequencies.partition_point(|at| *at < to);
            if first < last {
                return channel[first..last].iter().copied().fold(0.0, f64::max);
            }
            let below = first.saturating_sub(1);
            let above = first.min(channel.len() - 1);
            let middle = 0.5 * (from + to);
            let away = |place: usize| (self.frequencies[place] - middle).abs();
            channel[if away(below) < away(above) {
                below
            } else {
                above
            }]
        };
        let cells = |channel: &Vec<f64>| (0..MOST_CELLS).map(|k| cell(k, channel)).collect();
        (self.at, self.amplitudes.iter().map(cells).collect())
    }
}

/// At even steps of the axis the nearest run.
fn raster(columns: &[Column], channel: usize, ends: [f64; 2], highest: f64) -> Raster {
    let [low, high] = ends;
    let step = (high - low) / MOST_CELLS as f64;
    let nearest = |cell: usize| {
        let middle = low + (cell as f64 + 0.5) * step;
        let place = columns.partition_point(|(at, _)| *at < middle);
        let around = columns[place.saturating_sub(1)..].iter().take(2);
        around.min_by(|a, b| (a.0 - middle).abs().total_cmp(&(b.0 - middle).abs()))
    };
    let cells = (0..MOST_CELLS).filter_map(nearest);
    let cells = cells.map(|(_, channels)| channels[channel].clone());
    Raster::of(ends, [0.0, highest], cells.collect())
}
