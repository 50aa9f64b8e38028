//! The spectra of a study over an axis.

use std::collections::BTreeMap;

use super::digest::{Digest, is_down};
use super::figures::MOST_MAPS;
use super::rows::Rows;
use crate::analysis::Channel;
use crate::numerics::distinct::rising;
use crate::report::ReportError;
use crate::report::figure::Figure;
use crate::report::raster::{MOST_CELLS, Raster, moving};
use crate::report::run::run_up::runs_figure;
use crate::report::variable::{axis_label, shown};
use crate::study::many::{Line, RunRecord};

/// Key of the axis that spectra are drawn over where there are two.
const SPEED: &str = "speed.constant";

impl Digest {
    /// Amplitudes of the displacements of a grid over an axis and frequency: at even steps of the axis the nearest run.
    ///
    /// Over a single axis every displacement that moves has a panel; of two axes it is the speed, or else the last one, and the
    /// displacement that is loudest anywhere has a panel for each value of the other axis.
    pub(super) fn waterfall(&self, rows: &Rows) -> Result<Option<Figure>, ReportError> {
        let axes = &self.head.axes;
        if self.head.drawn || !(1..=2).contains(&axes.len()) {
            return Ok(None);
        }
        let speed = axes.iter().position(|axis| axis.key == SPEED);
        let over = speed.unwrap_or(axes.len() - 1);
        let Some(ends) = self.ends(over) else {
            return Ok(None);
        };
        let level = |(_, raster): &(Channel, Raster)| raster.loudest();
        let mut panels = Vec::new();
        if let [_] = axes[..] {
            let drawn = self.rasters(rows, over, ends, &|_| true)?;
            let levels: Vec<f64> = drawn.iter().map(level).collect();
            panels.extend(moving(&levels).map(|row| {
                let (channel, raster) = drawn[row].clone();
                (channel.to_string(), channel, raster)
            }));
        } else {
            let other = 1 - over;
            let values = rising(self.rows.iter().map(|row| row.values[other]));
            let every = values.len().div_ceil(MOST_MAPS).max(1);
            let values = values.into_iter().step_by(every).map(|value| {
                let drawn = self.rasters(rows, over, ends, &|row| row.values[other] == value)?;
                Ok((shown(&axes[other], value), drawn))
            });
            let values = values.collect::<Result<Vec<_>, ReportError>>()?;
            // one and the same displacement, so that panels can be compared
            let all = values.iter().flat_map(|(_, drawn)| drawn);
            let loudest = all.max_by(|a, b| level(a).total_cmp(&level(b)));
            let Some(loudest) = loudest.filter(|own| level(own) > 0.0).map(|own| own.0) else {
                return Ok(None);
            };
            panels.extend(values.into_iter().flat_map(|(value, drawn)| {
                let own = drawn
                    .into_iter()
                    .filter(move |(channel, _)| *channel == loudest);
                own.map(move |(of, raster)| (format!("{value}: {of}"), of, raster))
            }));
        }
        let label = axis_label(&axes[over]);
        Ok((!panels.is_empty()).then(|| runs_figure(&self.head.title, label, &panels)))
    }

    /// The displacements, each over an axis, of those runs that are asked for.
    fn rasters(
        &self,
        rows: &Rows,
        over: usize,
        ends: [f64; 2],
        asked: &dyn Fn(&RunRecord) -> bool,
    ) -> Result<Vec<(Channel, Raster)>, ReportError> {
        let nearest = self.nearest(over, ends, asked);
        let mut columns: BTreeMap<u64, _> = nearest.iter().map(|run| (*run, None)).collect();
        let runs = columns.keys().copied().collect::<Vec<_>>();
        let channels = self.head.lengths();
        rows.each_of(runs.into_iter(), |row| {
            let Ok(outcome) = &row.outcome else { return };
            if !outcome.spectrum.is_empty() {
                let column = |(index, _): &(usize, Channel)| {
                    cells(&outcome.spectrum, *index, self.highest_frequency)
                };
                let cells: Vec<_> = channels.iter().map(column).collect();
                columns.insert(row.run, Some(cells));
            }
        })?;
        let raster = |place: usize| {
            let cells = nearest.iter().filter_map(|run| columns[run].as_ref());
            let cells = cells.map(|channels| channels[place].clone());
            Raster::new(ends, [0.0, self.highest_frequency], cells.collect())
        };
        let named = channels.iter().enumerate();
        let drawn = named.map(|(place, (_, channel))| (*channel, raster(place)));
        Ok(drawn.collect())
    }

    /// The run nearest to each of so many even steps of an axis.
    fn nearest(
        &self,
        over: usize,
        [low, high]: [f64; 2],
        asked: &dyn Fn(&RunRecord) -> bool,
    ) -> Vec<u64> {
        let rows = self.rows.iter().filter(|row| !is_down(row) && asked(row));
        let mut at: Vec<_> = rows.map(|row| (self.at(row, over), row.run)).collect();
        at.sort_by(|a, b| a.0.total_cmp(&b.0));
        let step = (high - low) / MOST_CELLS as f64;
        let nearest = |cell: usize| {
            let middle = low + (cell as f64 + 0.5) * step;
            let place = at.partition_point(|(at, _)| *at < middle);
            let around = at[place.saturating_sub(1)..].iter().take(2);
            around.min_by(|a, b| (a.0 - middle).abs().total_cmp(&(b.0 - middle).abs()))
        };
        let cells = (0..MOST_CELLS).filter_map(nearest);
        cells.map(|(_, run)| *run).collect()
    }
}

/// In every cell up to `highest` the largest amplitude, or where none falls into it, the nearest; nothing beyond the
/// last frequency of the run.
fn cells(lines: &[Line], channel: usize, highest: f64) -> Vec<f64> {
    let size = highest / MOST_CELLS as f64;
    let end = lines.last().map_or(0.0, |line| line.frequency);
    let cell = |cell: usize| {
        let [from, to] = [cell, cell + 1].map(|edge| edge as f64 * size);
        if from > end {
            return 0.0;
        }
        let first = lines.partition_point(|line| line.frequency < from);
        let last = lines.partition_point(|line| line.frequency < to);
        if first < last {
            let inside = lines[first..last].iter();
            return inside
                .map(|line| line.amplitudes[channel])
                .fold(0.0, f64::max);
        }
        let middle = 0.5 * (from + to);
        let away = |line: &Line| (line.frequency - middle).abs();
        let around = &lines[first.saturating_sub(1)..=first.min(lines.len() - 1)];
        let nearest = around
            .iter()
            .rev()
            .min_by(|a, b| away(a).total_cmp(&away(b)));
        nearest.map_or(0.0, |line| line.amplitudes[channel])
    };
    (0..MOST_CELLS).map(cell).collect()
}
