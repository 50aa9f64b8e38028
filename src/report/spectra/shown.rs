//! What figures and pages show of a spectrum: amplitudes or powers of one unit, with named peaks.

use std::borrow::Cow;
use std::collections::HashSet;
use std::ops::Range;

use crate::report::envelope::{Decimator, SCREEN_BUCKETS};
use crate::report::figure::{Axis, Curve, Name, Panel, Point, distinct};

/// What most spectra are drawn over.
pub(super) const FREQUENCY: (&str, &str) = ("frequency", "Hz");
/// What the others are drawn over.
pub(super) const ORDER: (&str, &str) = ("order", "");

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
    pub over: (&'static str, &'static str),
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

    /// The columns over all places, of which some are shown at first.
    pub fn panel(&self, height: u32) -> Panel {
        let columns = 0..self.columns.len();
        let values = columns.clone().flat_map(|column| self.points(column));
        let strongest = values.fold(0.0, |most: f64, (_, value)| most.max(value));
        let curves = columns.map(|column| Curve::line(distinct(column), self.envelope(column)));
        let count = self.columns.first().map_or(0, |(_, values)| values.len());
        let reach = [self.place(0), self.place(count.saturating_sub(1))];
        let x = Axis {
            reach: Some(reach),
            ..Axis::over(self.over, self.shown.clone())
        };
        let y = Axis::below((self.quantity.as_str(), self.unit.as_str()), strongest);
        Panel {
            curves: curves.collect(),
            peaks: self.strongest_peaks(),
            ..Panel::new(x, y, height)
        }
    }

    /// What the colours mean.
    pub fn names(&self) -> Vec<Name> {
        Name::each(self.columns.iter().map(|(name, _)| name.as_str()))
    }

    /// A column without the mean; where it is long its lowest and highest values, those that are shown at first and those
    /// on either side by themselves.
    fn envelope(&self, column: usize) -> Vec<Point> {
        let mut parts = [(); 3].map(|()| Decimator::new(SCREEN_BUCKETS));
        for (at, value) in self.points(column) {
            let part = usize::from(at >= self.shown.start) + usize::from(at > self.shown.end);
            parts[part].push(at, value);
        }
        parts.iter().flat_map(Decimator::points).collect()
    }

    /// Peaks where the curve has them, strongest first, one for each name.
    fn strongest_peaks(&self) -> Vec<(Point, String)> {
        let mut peaks: Vec<&ShownPeak> = self.peaks.iter().collect();
        peaks.sort_by(|a, b| b.height.total_cmp(&a.height));
        let mut seen = HashSet::new();
        peaks.retain(|peak| seen.insert(&peak.name));
        let placed = peaks.into_iter().map(|peak| {
            // less than the peak itself where it lies between two bins
            let row = peak.at / self.resolution - self.first as f64;
            let values = &self.columns[peak.column].1;
            let [below, above] = [row.floor(), row.ceil()]
                .map(|row| values.get(row as usize).copied().unwrap_or(0.0));
            ((peak.at, self.factor * below.max(above)), peak.name.clone())
        });
        placed.collect()
    }
}
