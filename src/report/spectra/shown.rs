//! What figures and pages show of a spectrum: amplitudes or powers of one unit, with named peaks.

use std::borrow::Cow;
use std::collections::HashSet;
use std::ops::Range;

use crate::report::envelope::{Decimator, SCREEN_BUCKETS};
use crate::report::figure::{Axis, Curve, Name, Panel, Point, distinct, ends};
use crate::report::terminal::{shown_column, shown_quantity, shown_unit};
use crate::table::{Column, ColumnKind, Table};

/// Columns of one unit over one axis.
#[derive(Debug, Clone)]
pub(in crate::report) struct ShownSpectrum<'a> {
    /// Unit of the columns.
    pub of: &'a str,
    /// What is shown of them: amplitude, density ….
    pub quantity: String,
    /// Unit that they are shown in.
    pub unit: String,
    /// How many of it make one of the columns'.
    pub factor: f64,
    /// The abscissa: its column and values.
    pub over: (&'a Column, &'a [f64]),
    /// Places that are shown at first.
    pub shown: Range<f64>,
    /// Each with its name.
    pub columns: Vec<(String, Cow<'a, [f64]>)>,
    /// Peaks with names.
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

/// A line of a column of a table that has a name: where it is, and its value there.
#[derive(Debug, Clone)]
pub(super) struct NamedLine {
    pub column: Column,
    pub at: f64,
    pub value: f64,
    pub name: String,
}

impl<'a> ShownSpectrum<'a> {
    /// The columns of a table that have lines, those of one unit together, over its first column.
    pub(super) fn grouped(
        table: &'a Table<'_>,
        lines: &[NamedLine],
        shown: &Range<f64>,
    ) -> Vec<Self> {
        let mut groups = Vec::<Self>::new();
        for (column, values) in table.iter() {
            let (ColumnKind::Measure(what), Some(over)) = (&column.kind, table.iter().next())
            else {
                continue;
            };
            let known = groups.iter().position(|group| group.of == column.unit);
            let place = known.unwrap_or_else(|| {
                let (unit, factor) = shown_unit(&column.unit);
                groups.push(Self {
                    of: &column.unit,
                    quantity: what.replace('_', " "),
                    unit,
                    factor,
                    over,
                    shown: shown.clone(),
                    columns: Vec::new(),
                    peaks: Vec::new(),
                });
                groups.len() - 1
            });
            let group = &mut groups[place];
            let own = lines.iter().filter(|line| line.column == *column);
            group.peaks.extend(own.map(|line| ShownPeak {
                column: group.columns.len(),
                at: line.at,
                height: group.factor * line.value,
                name: line.name.clone(),
            }));
            let name = shown_quantity(&column.quantity);
            group.columns.push((name, Cow::Borrowed(values)));
        }
        groups
    }

    /// Places and values of a column but the mean.
    fn points(&self, column: usize) -> impl Iterator<Item = Point> {
        let places = self.over.1.iter().copied();
        let placed = places.zip(self.columns[column].1.iter());
        let placed = placed.map(|(place, value)| (place, self.factor * value));
        placed.filter(|(place, _)| *place != 0.0)
    }

    /// The columns over all places, of which some are shown at first.
    pub fn panel(&self, height: u32) -> Panel {
        let columns = 0..self.columns.len();
        let values = columns.clone().flat_map(|column| self.points(column));
        let strongest = values.fold(0.0, |most: f64, (_, value)| most.max(value));
        let curves = columns.map(|column| Curve::line(distinct(column), self.envelope(column)));
        let (over, places) = self.over;
        let (label, _) = shown_column(over);
        let x = Axis {
            reach: ends(places.iter().copied()),
            ..Axis::over(label, self.shown.clone())
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
            let above = self.over.1.partition_point(|place| *place < peak.at);
            let values = &self.columns[peak.column].1;
            let [below, above] =
                [above.saturating_sub(1), above].map(|row| values.get(row).copied().unwrap_or(0.0));
            ((peak.at, self.factor * below.max(above)), peak.name.clone())
        });
        placed.collect()
    }
}
