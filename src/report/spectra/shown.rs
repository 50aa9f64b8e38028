//! What figures and pages show of a spectrum: amplitudes or powers of one unit, with named peaks.

use std::borrow::Cow;
use std::collections::HashSet;
use std::ops::Range;

use serde_json::{Value, json};

use crate::report::envelope::SCREEN_BUCKETS;
use crate::report::figure::{Axis, Curve, Name, Panel, Point, distinct};
use crate::report::page::{PagePanel, curve};
use crate::report::terminal::in_unit;

/// What most spectra are drawn over.
pub(super) const FREQUENCY: [&str; 2] = ["frequency", "Hz"];
/// What the others are drawn over.
pub(super) const ORDER: [&str; 2] = ["order", ""];

/// Columns of one unit over one axis.
#[derive(Debug)]
pub(in crate::report) struct ShownSpectrum<'a> {
    /// What they are called together.
    pub name: String,
    /// What is shown of them: amplitude, density ….
    pub quantity: String,
    /// Unit that they are shown in.
    pub unit: String,
    /// How many of it make one of the columns'.
    pub factor: f64,
    /// Quantity and unit of the axis.
    pub over: [&'static str; 2],
    /// Number of the first bin.
    pub first: isize,
    /// Distance of neighbouring bins.
    pub resolution: f64,
    /// Places that are shown at first.
    pub shown: Range<f64>,
    /// Each with its name.
    pub columns: Vec<(String, Cow<'a, [f64]>)>,
    /// What stands out.
    pub peaks: Vec<ShownPeak>,
}

/// A peak that has a name.
#[derive(Debug, Clone)]
pub(in crate::report) struct ShownPeak {
    /// Which column it is of.
    pub column: usize,
    pub at: f64,
    pub height: f64,
    pub name: String,
}

impl ShownSpectrum<'_> {
    fn place(&self, row: usize) -> f64 {
        (self.first + row as isize) as f64 * self.resolution
    }

    /// Places and values of a column but the mean.
    fn points(&self, column: usize) -> impl Iterator<Item = Point> {
        let all = self.columns[column].1.iter().enumerate();
        let placed = all.map(|(row, value)| (self.place(row), self.factor * value));
        placed.filter(|(place, _)| *place != 0.0)
    }

    /// The panel of a figure.
    pub fn panel(&self, height: u32) -> Panel {
        let columns = 0..self.columns.len();
        let values = columns.clone().flat_map(|column| self.points(column));
        let strongest = values.fold(0.0, |most: f64, (_, value)| most.max(value));
        let is_shown = |place: f64| self.shown.contains(&place) || place == self.shown.end;
        let curves = columns.map(|column| {
            let points = self.points(column).filter(|(place, _)| is_shown(*place));
            Curve::envelope(distinct(column), points)
        });
        let [quantity, unit] = self.over;
        let over = format!("{quantity}{}", in_unit(unit));
        let name = format!("{} in {}", self.quantity, self.unit);
        let (x, y) = (
            Axis::over(over, self.shown.clone()),
            Axis::below(name, strongest),
        );
        Panel {
            names: Name::each(self.columns.iter().map(|(name, _)| name.as_str())),
            curves: curves.collect(),
            peaks: self.strongest_peaks(),
            ..Panel::new(x, y, height)
        }
    }

    /// Peaks where the curve has them, strongest first, one for each name.
    fn strongest_peaks(&self) -> Vec<(Point, String)> {
        let mut peaks: Vec<&ShownPeak> = self.peaks.iter().collect();
        peaks.sort_by(|a, b| b.height.total_cmp(&a.height));
        let mut seen = HashSet::new();
        peaks.retain(|peak| seen.insert(&peak.name));
        let placed = peaks.into_iter().map(|peak| {
            // less than the peak itself where it lies between two bins
            let bin = peak.at / self.resolution;
            let values = &self.columns[peak.column].1;
            let [below, above] = [bin.floor(), bin.ceil()]
                .map(|bin| values.get(bin as usize).copied().unwrap_or(0.0));
            ((peak.at, self.factor * below.max(above)), peak.name.clone())
        });
        placed.collect()
    }

    /// The panel of a page: what stands out of all, whatever part is looked at.
    pub fn page_panel(&self) -> Value {
        let rows = self.prominent_rows();
        let curves = self.columns.iter().map(|(name, values)| {
            let points = rows.iter();
            let points = points.map(|row| (self.place(*row), self.factor * values[*row]));
            curve(name, points)
        });
        let marks = self.peaks.iter();
        let marks =
            marks.map(|peak| json!({ "at": peak.at, "height": peak.height, "name": peak.name }));
        json!(PagePanel {
            name: &self.name,
            unit: &self.unit,
            over: self.over,
            // one that is two-sided has lines on both sides of zero
            shown: (self.shown.start == 0.0).then_some(self.shown.end),
            logarithmic: true,
            curves: curves.collect(),
            marks: marks.collect(),
            band: None,
        })
    }

    /// Rows to draw, the mean left out: all or, of too many, from every segment the highest and the lowest.
    fn prominent_rows(&self) -> Vec<usize> {
        let count = self.columns.first().map_or(0, |(_, values)| values.len());
        let rows: Vec<usize> = (0..count).filter(|row| self.place(*row) != 0.0).collect();
        let segment = rows.len().div_ceil(SCREEN_BUCKETS);
        if segment <= 2 {
            return rows;
        }
        let height = |row: usize| {
            let values = self.columns.iter().map(|(_, values)| values[row]);
            values.fold(0.0, f64::max)
        };
        let by_height = |a: &&usize, b: &&usize| height(**a).total_cmp(&height(**b));
        let extremes = rows.chunks(segment).flat_map(|segment| {
            let lowest = segment.iter().min_by(by_height).copied();
            let highest = segment.iter().max_by(by_height).copied();
            let [first, last] = [lowest.min(highest), lowest.max(highest)];
            first.into_iter().chain(last.filter(|_| first != last))
        });
        extremes.collect()
    }
}
