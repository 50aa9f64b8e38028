//! Both curves of the columns that are furthest apart, and their difference.

use std::f64::consts::{PI, TAU};
use std::path::{Path, PathBuf};

use super::table::Source;
use super::{ColumnComparison, CompareError, Comparison, TableComparison, Worst};
use crate::report::figure::{Axis, Curve, Figure, Name, Panel, Point, broken_at_turns, distinct};
use crate::report::terminal::shown_column;
use crate::report::write_whole;
use crate::table::{Column, ColumnKind};

/// Most columns that are shown.
const MOST_COLUMNS: usize = 4;
/// Height of a plot, px.
const HEIGHT: u32 = 166;
/// Amplitudes are shown down to this part of the largest, −140 dB.
const SMALLEST: f64 = 1e-7;
/// Places closer than this part of them are one.
const SAME_PLACE: f64 = 1e-9;

/// Writes the figure of two results that were compared.
///
/// # Errors
/// [`CompareError`] where a table cannot be read again, or the figure not be drawn or written.
pub(crate) fn write_figure(
    comparison: &Comparison,
    compared: [&Path; 2],
    file: &Path,
) -> Result<(), CompareError> {
    let figure = difference_figure("comparison", comparison, compared)?;
    write_whole(file, figure.svg().as_bytes())?;
    Ok(())
}

/// The columns that are furthest apart: to the left both curves, to the right their difference, with the places of the
/// comparison marked. Amplitudes of spectra are in dB of the largest.
pub(super) fn difference_figure(
    name: &str,
    comparison: &Comparison,
    [first, second]: [&Path; 2],
) -> Result<Figure, CompareError> {
    let mut panels = Vec::new();
    for (table, column) in furthest(comparison) {
        let inside = |path: &Path| -> PathBuf {
            if path.is_dir() {
                path.join(&table.name)
            } else {
                path.to_owned()
            }
        };
        let files = [inside(first), inside(second)];
        if files.iter().any(|file| !file.exists()) {
            // lines of documents have no curve
            continue;
        }
        let tables = [Source::open(&files[0])?, Source::open(&files[1])?];
        panels.extend(both_panels(&tables, column));
    }
    let title = format!("{} and {}", first.display(), second.display());
    let figure = Figure::new(name, &title, 2, panels);
    Ok(figure.with_names(Name::each(["a", "b", "b − a"])))
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
    let columns = tables.flat_map(|table| table.columns.iter().map(move |column| (table, column)));
    let mut shares: Vec<_> = columns
        .filter(|(table, column)| table.known.first() != Some(&column.column))
        .filter_map(|found| Some((share(found.1.worst()?), found)))
        .filter(|(share, _)| *share > 0.0)
        .collect();
    shares.sort_by(|a, b| b.0.total_cmp(&a.0));
    let shown = shares.into_iter().take(MOST_COLUMNS);
    shown.map(|(_, found)| found).collect()
}

/// The panel of both curves and that of the difference.
fn both_panels(tables: &[Source<'_>; 2], column: &ColumnComparison) -> [Panel; 2] {
    let of = &column.column;
    let curves = tables.each_ref().map(|table| points(table, of));
    let (over, across) = shown_column(tables[0].axis().0);
    let places = curves.iter().flatten().map(|(at, _)| across * at);
    let axis = Axis::spanning(over, places);
    let marks = column.places.iter();
    let marks = marks.map(|worst| (worst.at, apart(worst.first, worst.second, of)));
    let marks: Vec<Point> = marks.collect();
    let mut difference = differences(&curves, of);
    if difference.len() < 2 {
        difference.clone_from(&marks);
    }
    let ((name, unit), factor) = shown_column(of);
    let shown = |(at, value): Point| (across * at, factor * value);
    let broken = |mut curve: Curve| {
        if of.kind == ColumnKind::Phase {
            curve.points = broken_at_turns(&curve.points);
        }
        curve
    };
    let change = Curve {
        marks: marks.into_iter().map(shown).collect(),
        ..broken(Curve::envelope(
            distinct(2),
            difference.into_iter().map(shown),
        ))
    };
    let scale = tables[0].largest(of).max(tables[1].largest(of));
    let in_decibels = of.kind == ColumnKind::Measure("amplitude") && scale > 0.0;
    let curves = curves.iter().enumerate().map(|(index, points)| {
        let points = points.iter().map(|&(at, value)| match in_decibels {
            true => (across * at, 20.0 * (value / scale).max(SMALLEST).log10()),
            false => shown((at, value)),
        });
        broken(Curve::envelope(distinct(index), points))
    });
    let values = match in_decibels {
        true => (name, "dB of the largest".to_owned()),
        false => (name, unit.clone()),
    };
    [
        Panel::holding(axis.clone(), values, HEIGHT, curves.collect()),
        Panel::holding(axis, ("b − a", unit), HEIGHT, vec![change]),
    ]
}

fn points(table: &Source<'_>, column: &Column) -> Vec<Point> {
    let values = table.values(column).unwrap_or_default().iter().copied();
    table.axis().1.iter().copied().zip(values).collect()
}

/// b − a where both have a point at the same abscissa.
fn differences([first, second]: &[Vec<Point>; 2], column: &Column) -> Vec<Point> {
    let mut others = second.iter().peekable();
    let pairs = first.iter().filter_map(|(at, a)| {
        let near = SAME_PLACE * at.abs();
        while others.next_if(|(other, _)| *other < at - near).is_some() {}
        let (_, b) = others.next_if(|(other, _)| *other <= at + near)?;
        Some((*at, apart(*a, *b, column)))
    });
    pairs.collect()
}

/// b − a, of phases the shorter way round.
fn apart(a: f64, b: f64, column: &Column) -> f64 {
    if column.kind == ColumnKind::Phase {
        (b - a + PI).rem_euclid(TAU) - PI
    } else {
        b - a
    }
}

#[cfg(test)]
mod tests {
    use super::super::{Rules, Tolerance, Tolerances, compare};
    use super::*;

    /// Neither the phases nor their difference, which all pass half a turn, are joined across it.
    #[test]
    fn phases_are_broken_where_they_begin_anew() {
        let folder = tempfile::tempdir().expect("a folder");
        let written = |name: &str, lag: f64| {
            let row = |step: u32| {
                let phase = (lag * f64::from(step) + PI).rem_euclid(TAU) - PI;
                format!("{step},1,{phase}\n")
            };
            let rows: String = (0..40).map(row).collect();
            let file = folder.path().join(name);
            let head = "speed_rad_s,x_amplitude_m,x_phase_rad\n";
            std::fs::write(&file, head.to_owned() + &rows).expect("a table");
            file
        };
        let [first, second] = [written("a.csv", -0.1), written("b.csv", -0.3)];
        let exact = Tolerance::new(0.0, 1e-9).expect("a tolerance");
        let rules = Rules::new(Tolerances::uniform(exact));
        let comparison = compare(&first, &second, &rules).expect("a comparison");
        let figure = difference_figure("", &comparison, [&first, &second]).expect("a figure");
        let is_phase = |panel: &&Panel| panel.y.label.unit == "deg";
        let curves = figure
            .panels
            .iter()
            .filter(is_phase)
            .flat_map(|panel| &panel.curves);
        let mut count = 0;
        for curve in curves {
            let steps = curve
                .points
                .windows(2)
                .map(|pair| (pair[1].1 - pair[0].1).abs());
            assert!(steps.filter(|step| !step.is_nan()).all(|step| step < 20.0));
            assert!(curve.points.iter().any(|point| point.1.is_nan()));
            count += 1;
        }
        assert_eq!(count, 3);
    }
}
