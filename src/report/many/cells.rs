//! The spectra of a grid of runs, cell by cell, with their named peaks.

use super::digest::{Digest, is_down};
use super::rows::Rows;
use crate::numerics::digits::to_digits;
use crate::numerics::distinct::rising;
use crate::report::ReportError;
use crate::report::figure::{Axis, Curve, Figure, Name, Panel, Point, distinct};
use crate::report::terminal::{Lines, MICRO};
use crate::report::variable::{key_in_words, shown};
use crate::study::many::{KeptPeak, Line};

/// Most runs whose spectra are drawn one by one.
const MOST_CELLS: usize = 64;
/// Panels side by side where no axis has at most so many values.
const COLUMNS: usize = 4;
/// Height of a panel, px.
const HEIGHT: u32 = 130;
/// Most names in a panel.
const MOST_NAMED: usize = 3;
/// Peaks of a run that are reported.
const MOST_REPORTED: usize = 2;

/// A run of the grid with what is drawn of it.
struct Cell {
    run: u64,
    values: Vec<f64>,
    spectrum: Vec<Line>,
    /// Peaks of the displacements that are lengths, strongest first.
    peaks: Vec<KeptPeak>,
}

/// The runs of a grid whose spectra are drawn one by one.
pub(super) struct Cells<'a> {
    digest: &'a Digest,
    cells: Vec<Cell>,
}

impl Digest {
    /// The runs of a grid of two axes with their spectra; none where there are too many to be drawn.
    pub(super) fn cells(&self, rows: &Rows) -> Result<Cells<'_>, ReportError> {
        let mut cells = Vec::new();
        let is_grid = self.head.axes.len() == 2 && !self.head.drawn && self.is_complete();
        if is_grid && self.head.keep.highest_order.is_some() && self.rows.len() <= MOST_CELLS {
            let runs = self.rows.iter().filter(|row| !is_down(row));
            rows.each_of(runs.map(|row| row.run), |row| {
                let outcome = row.outcome.unwrap_or_default();
                let mut peaks = outcome.peaks;
                peaks.retain(|peak| peak.channel.unit() == "m");
                peaks.sort_by(|a, b| b.amplitude.total_cmp(&a.amplitude));
                cells.push(Cell {
                    run: row.run,
                    values: row.values,
                    spectrum: outcome.spectrum,
                    peaks,
                });
            })?;
        }
        Ok(Cells {
            digest: self,
            cells,
        })
    }
}

impl Cells<'_> {
    /// A panel a run, over orders of the shaft, a row of panels for each value of the first axis.
    pub fn figure(&self) -> Option<Figure> {
        let head = &self.digest.head;
        let lengths = head.lengths();
        let turning = |cell: &&Cell| cell.spectrum.iter().any(|line| line.order.is_some());
        let turning: Vec<_> = self.cells.iter().filter(turning).collect();
        let lines = || turning.iter().flat_map(|cell| &cell.spectrum);
        let amplitudes =
            lines().flat_map(|line| lengths.iter().map(|(of, _)| line.amplitudes[*of]));
        let strongest = MICRO * amplitudes.fold(0.0, f64::max);
        let highest = lines().filter_map(|line| line.order).fold(0.0, f64::max);
        let panel = |cell: &&Cell| {
            let points = |of: usize| -> Vec<Point> {
                let points = cell.spectrum.iter();
                let points =
                    points.filter_map(|line| Some((line.order?, MICRO * line.amplitudes[of])));
                points.collect()
            };
            let curves = lengths.iter().enumerate();
            let curves =
                curves.map(|(place, (of, _))| Curve::envelope(distinct(place), points(*of)));
            Panel {
                title: self.values(cell).join(", "),
                curves: curves.collect(),
                peaks: self.named(cell),
                ..Panel::new(
                    Axis::over("order of the shaft", 0.0..highest),
                    Axis::below(("amplitude", "µm"), strongest),
                    HEIGHT,
                )
            }
        };
        let panels: Vec<_> = turning.iter().map(panel).collect();
        let columns = match rising(turning.iter().map(|cell| cell.values[1])).len() {
            few if few <= COLUMNS + 1 => few,
            _ => COLUMNS,
        };
        let names = Name::each(lengths.iter().map(|(_, channel)| channel.name()));
        let figure = Figure::new("spectra", &head.title, columns, panels).with_names(names);
        (strongest > 0.0).then_some(figure)
    }

    /// The strongest peaks of every run with their names.
    pub fn tell(&self, out: &mut Lines) {
        let axes = self.digest.head.axes.iter().map(key_in_words);
        let mut heads: Vec<_> = std::iter::once("run".to_owned()).chain(axes).collect();
        heads.extend(["strongest peak", "second"].map(str::to_owned));
        let reported = |peak: &KeptPeak| {
            let KeptPeak {
                channel,
                frequency,
                name,
                ..
            } = peak;
            let name = name
                .as_deref()
                .map_or_else(String::new, |name| format!(" {name}"));
            let amplitude = to_digits(MICRO * peak.amplitude, 3);
            format!("{channel}{name} {frequency:.0} Hz {amplitude} µm")
        };
        let rows = self.cells.iter().map(|cell| {
            let start = std::iter::once(cell.run.to_string()).chain(self.values(cell));
            let mut peaks = cell.peaks.iter().map(reported);
            let peaks = (0..MOST_REPORTED).map(|_| peaks.next().unwrap_or_default());
            start.chain(peaks).collect()
        });
        if self.cells.iter().any(|cell| !cell.peaks.is_empty()) {
            out.table(heads.iter().map(String::as_str), rows.collect::<Vec<_>>());
        }
    }

    /// The values of a run as they are written.
    fn values(&self, cell: &Cell) -> Vec<String> {
        let axes = self.digest.head.axes.iter().zip(&cell.values);
        axes.map(|(axis, value)| shown(axis, *value)).collect()
    }

    /// The strongest peaks that have a name, each name once.
    fn named(&self, cell: &Cell) -> Vec<(Point, String)> {
        let mut named: Vec<(Point, String)> = Vec::new();
        for peak in &cell.peaks {
            if let (Some(name), Some(order)) = (&peak.name, peak.order)
                && named.iter().all(|(_, known)| known != name)
            {
                named.push(((order, MICRO * peak.amplitude), name.clone()));
            }
        }
        named.truncate(MOST_NAMED);
        named
    }
}
