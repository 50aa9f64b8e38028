//! The spectra of a study over its only axis.

use std::path::Path;

use super::digest::{Digest, Row};
use crate::report::figure::Figure;
use crate::report::run_up::{MOST_CELLS, Raster, moving, runs_figure};
use crate::report::{FileAction, ReportError};

/// Columns before the amplitudes: run, frequency and order.
const START: usize = 3;

/// Spectra of one run.
#[derive(Debug, Default)]
struct Spectra {
    run: u64,
    frequencies: Vec<f64>,
    /// Of every channel.
    amplitudes: Vec<Vec<f64>>,
}

/// Cells of one run: of every channel by rising frequency.
struct Column {
    at: f64,
    channels: Vec<Vec<f64>>,
}

impl Digest {
    /// Amplitudes of the displacements over the only axis of a grid and frequency, every channel a row.
    pub(super) fn waterfall(
        &self,
        title: &str,
        spectra: &Path,
    ) -> Result<Option<Figure>, ReportError> {
        let ([axis], Some(ends), false) = (&self.axes[..], self.ends(0), self.drawn) else {
            return Ok(None);
        };
        let mut highest = 0.0_f64;
        let names = each_run(spectra, |spectra| {
            let last = spectra.frequencies.last().copied().unwrap_or(0.0);
            highest = highest.max(last);
        })?;
        let mut columns = Vec::new();
        let mut rows = self.rows.iter().filter(|row| !row.down).peekable();
        each_run(spectra, |spectra| {
            while rows.next_if(|row| row.run < spectra.run).is_some() {}
            if let Some(row) = rows.next_if(|row| row.run == spectra.run) {
                columns.push(spectra.column(row, highest));
            }
        })?;
        columns.sort_by(|a, b| a.at.total_cmp(&b.at));
        let raster = |channel| raster(&columns, channel, ends, highest);
        let channels = names.iter().skip(START).enumerate();
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

/// Shows the spectra of one run after the other; returns the names of the columns.
fn each_run(path: &Path, mut show: impl FnMut(&Spectra)) -> Result<csv::StringRecord, ReportError> {
    let refused = |error: csv::Error| {
        let error = std::io::Error::other(error.to_string());
        ReportError::file(FileAction::Read, path)(error)
    };
    let mut reader = csv::Reader::from_path(path).map_err(refused)?;
    let names = reader.headers().map_err(refused)?.clone();
    let mut standing = Spectra::default();
    for record in reader.records() {
        let record = record.map_err(refused)?;
        let run = record
            .get(0)
            .and_then(|cell| cell.parse().ok())
            .unwrap_or(0);
        if run != standing.run && !standing.frequencies.is_empty() {
            show(&standing);
            standing = Spectra::default();
        }
        standing.run = run;
        standing.take(&record);
    }
    if !standing.frequencies.is_empty() {
        show(&standing);
    }
    Ok(names)
}

impl Spectra {
    fn take(&mut self, record: &csv::StringRecord) {
        let number = |cell: &str| cell.parse().unwrap_or(f64::NAN);
        self.frequencies
            .push(record.get(1).map_or(f64::NAN, number));
        let cells = record.iter().skip(START).map(number);
        self.amplitudes
            .resize(record.len().saturating_sub(START), Vec::new());
        for (channel, amplitude) in self.amplitudes.iter_mut().zip(cells) {
            channel.push(amplitude);
        }
    }

    /// In every cell up to `highest` the largest amplitude, or where none falls into it, the nearest; nothing
    /// beyond the last frequency of the run.
    fn column(&self, row: &Row, highest: f64) -> Column {
        let size = highest / MOST_CELLS as f64;
        let end = self.frequencies.last().copied().unwrap_or(0.0);
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
        Column {
            at: row.values[0],
            channels: self.amplitudes.iter().map(cells).collect(),
        }
    }
}

/// At even steps of the axis the nearest run.
fn raster(columns: &[Column], channel: usize, ends: [f64; 2], highest: f64) -> Raster {
    let [low, high] = ends;
    let step = (high - low) / MOST_CELLS as f64;
    let nearest = |cell: usize| {
        let middle = low + (cell as f64 + 0.5) * step;
        let place = columns.partition_point(|column| column.at < middle);
        let around = columns[place.saturating_sub(1)..].iter().take(2);
        around.min_by(|a, b| (a.at - middle).abs().total_cmp(&(b.at - middle).abs()))
    };
    let cells = (0..MOST_CELLS).filter_map(nearest);
    let cells = cells.map(|column| column.channels[channel].clone());
    Raster::of(ends, [0.0, highest], cells.collect())
}
