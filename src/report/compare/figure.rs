//! Both curves of the columns that are furthest apart, and their difference.

use std::f64::consts::{PI, TAU};
use std::path::{Path, PathBuf};

use super::table::Table;
use super::{ColumnComparison, CompareError, Comparison, TableComparison, Worst};
use crate::report::figure::{
    Axis, CURVE_BUCKETS, Curve, Figure, Name, Panel, Point, distinct, ends,
};
use crate::report::{Decimator, write_whole};

/// Most columns that are shown.
const MOST_COLUMNS: usize = 4;
/// Height of a plot, px.
const HEIGHT: u32 = 166;
/// Amplitudes are shown down to this part of the largest, −140 dB.
const SMALLEST: f64 = 1e-7;

/// Writes a figure of the columns that are furthest apart as SVG: to the left both curves, to the right
/// their difference, with the places of the comparison marked. Amplitudes of spectra stand in dB of the
/// largest. `first` and `second` are what was compared.
///
/// # Errors
/// [`CompareError`] where a table cannot be read again, or the figure not be drawn or written.
pub fn write_comparison_figure(
    comparison: &Comparison,
    first: &Path,
    second: &Path,
    file: &Path,
) -> Result<(), CompareError> {
    let mut panels = Vec::new();
    for (table, column) in furthest(comparison) {
        let inside = |path: &Path| -> PathBuf {
            if path.is_dir() {
                path.join(&table.name)
            } else {
                path.to_owned()
            }
        };
        let curves = Overlay::read([&inside(first), &inside(second)], &column.name)?;
        panels.extend(curves.panels(column));
    }
    let title = format!("{} and {}", first.display(), second.display());
    let figure = Figure::new("comparison", &title, 2, panels);
    let text = figure.with_names(Name::each(["a", "b", "b − a"])).svg()?;
    write_whole(file, text.as_bytes())?;
    Ok(())
}

/// The columns that are furthest from what is allowed, the furthest first.
fn furthest(comparison: &Comparison) -> Vec<(&TableComparison, &ColumnComparison)> {
    let share = |worst: &Worst| {
        if worst.allowed > 0.0 {
            worst.difference / worst.allowed
        } else {
            worst.difference * f64::INFINITY
        }
    };
    let tables = comparison.tables.iter();
    let numeric = tables.filter(|table| !table.known.iter().any(|name| name == "event"));
    let columns = numeric.flat_map(|table| table.columns.iter().map(move |column| (table, column)));
    let mut shares: Vec<_> = columns
        .filter(|(table, column)| table.known.first() != Some(&column.name))
        .filter_map(|found| Some((share(found.1.worst()?), found)))
        .filter(|(share, _)| *share > 0.0)
        .collect();
    shares.sort_by(|a, b| b.0.total_cmp(&a.0));
    let shown = shares.into_iter().take(MOST_COLUMNS);
    shown.map(|(_, found)| found).collect()
}

/// A column of two tables.
struct Overlay {
    /// Name of the first column.
    axis: String,
    curves: [Decimator; 2],
    /// Where both stand at the same places.
    difference: Option<Decimator>,
    /// Largest magnitude.
    scale: f64,
}

impl Overlay {
    fn read(paths: [&Path; 2], name: &str) -> Result<Self, CompareError> {
        let mut overlay = Self {
            axis: String::new(),
            curves: [Decimator::new(CURVE_BUCKETS), Decimator::new(CURVE_BUCKETS)],
            difference: Some(Decimator::new(CURVE_BUCKETS)),
            scale: 0.0,
        };
        let [mut first, mut second] =
            [Column::open(paths[0], name)?, Column::open(paths[1], name)?];
        overlay.axis.clone_from(&first.table.columns()[0]);
        let (mut a, mut b) = (first.next()?, second.next()?);
        // both in the order of the axis; a place that only one has belongs to its own curve
        while a.is_some() || b.is_some() {
            let gap = a
                .zip(b)
                .map(|(a, b)| (a.0 - b.0) / a.0.abs().max(b.0.abs()).max(f64::MIN_POSITIVE));
            let (take_a, take_b) = match gap {
                None => (a.is_some(), b.is_some()),
                Some(gap) if gap.abs() < 1e-9 || gap.is_nan() => (true, true),
                Some(gap) => (gap < 0.0, gap > 0.0),
            };
            overlay.push(a.filter(|_| take_a), b.filter(|_| take_b), name);
            if take_a {
                a = first.next()?;
            }
            if take_b {
                b = second.next()?;
            }
        }
        let common = |difference: &Decimator| difference.buckets().count() > 1;
        overlay.difference = overlay.difference.filter(common);
        Ok(overlay)
    }

    fn push(&mut self, a: Option<(f64, f64)>, b: Option<(f64, f64)>, name: &str) {
        for (curve, point) in self.curves.iter_mut().zip([a, b]) {
            if let Some((at, value)) = point {
                curve.push(at, value);
                if value.is_finite() {
                    self.scale = self.scale.max(value.abs());
                }
            }
        }
        if let (Some((at, a)), Some((_, b)), Some(difference)) = (a, b, &mut self.difference) {
            difference.push(at, apart(a, b, name));
        }
    }

    /// The panel of both curves and that of the difference.
    fn panels(&self, column: &ColumnComparison) -> [Panel; 2] {
        let name = &column.name;
        let differences = column.places.iter();
        let marks: Vec<_> = differences
            .map(|worst| (worst.at, apart(worst.first, worst.second, name)))
            .collect();
        let curve = match &self.difference {
            Some(difference) => difference.points().collect(),
            None => marks.clone(),
        };
        let (unit, size) = power(curve.iter().map(|point| point.1));
        let scaled = |points: Vec<Point>| -> Vec<Point> {
            let points = points.into_iter();
            points.map(|(at, value)| (at, value / size)).collect()
        };
        let difference = Curve {
            marks: scaled(marks),
            ..Curve::line(distinct(2), scaled(curve))
        };
        let (values, curves) = self.both(name);
        let shown = self.curves.iter().flat_map(Decimator::points);
        let axis = Axis::spanning(&self.axis, shown.map(|(at, _)| at));
        let change = format!("b − a{unit}");
        [
            Panel::of(axis.clone(), values, HEIGHT, curves),
            Panel::of(axis, change, HEIGHT, vec![difference]),
        ]
    }

    /// Both curves, and what their axis shows.
    fn both(&self, name: &str) -> (String, Vec<Curve>) {
        let in_decibel = name.contains("_amplitude_") && self.scale > 0.0;
        let (unit, size) = power([self.scale].into_iter());
        let shown = |value: f64| {
            if in_decibel {
                20.0 * (value / self.scale).max(SMALLEST).log10()
            } else {
                value / size
            }
        };
        let curve = |(index, curve): (usize, &Decimator)| {
            let points = curve.points().map(|(at, value)| (at, shown(value)));
            Curve::line(distinct(index), points.collect())
        };
        let name = if in_decibel {
            format!("{name}, dB")
        } else {
            format!("{name}{unit}")
        };
        (name, self.curves.iter().enumerate().map(curve).collect())
    }
}

/// b − a, of phases the shorter way round.
fn apart(a: f64, b: f64, name: &str) -> f64 {
    if name.ends_with("_phase_rad") {
        (b - a + PI).rem_euclid(TAU) - PI
    } else {
        b - a
    }
}

/// The power of a thousand that makes values readable, in words and as a number.
fn power(values: impl Iterator<Item = f64>) -> (String, f64) {
    let largest = ends(values.map(f64::abs)).map_or(0.0, |[_, largest]| largest);
    if largest == 0.0 {
        return (String::new(), 1.0);
    }
    match 3 * (largest.log10() / 3.0).floor() as i32 {
        0 => (String::new(), 1.0),
        exponent => (format!(" / 1e{exponent}"), 10f64.powi(exponent)),
    }
}

/// A column of a file beside its first.
struct Column {
    table: Table,
    place: usize,
    row: Vec<f64>,
}

impl Column {
    fn open(path: &Path, name: &str) -> Result<Self, CompareError> {
        let table = Table::open(path)?;
        let place = table.columns().iter().position(|column| column == name);
        Ok(Self {
            place: place.unwrap_or(0),
            table,
            row: Vec::new(),
        })
    }

    fn next(&mut self) -> Result<Option<(f64, f64)>, CompareError> {
        let more = self.table.read(&mut self.row)?;
        Ok(more.then(|| (self.row[0], self.row[self.place])))
    }
}
