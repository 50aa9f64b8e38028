//! Residuals and profiles of a fit, and what it predicts over the records.

use super::Row;
use crate::analysis::Channel;
use crate::fit::{Fit, Profile, Wanted};
use crate::numerics::distinct::each_once;
use crate::report::compare::Overlay;
use crate::report::figure::{Axis, Curve, Figure, GREY, Mark, Name, Panel, Point, distinct, ends};
use crate::report::terminal::shown_unit;
use crate::report::variable::axis_label;
use crate::scenario::FitFile;
use crate::steady::SteadyLines;
use crate::table::{Column, Table};

/// Height of plots, px.
const HEIGHT: u32 = 250;
/// Values that differ by more than this factor are shown over a logarithmic axis.
const WIDE: f64 = 10.0;

/// Half the length of the strokes at the ends of a bar, in lines.
const CROSS: f64 = 0.25;

/// Height of a panel of so many names, px.
fn height(rows: usize) -> u32 {
    60 + 22 * rows as u32
}

/// What was measured, a standard deviation to either side, and what is computed: a panel a unit, an observation a line.
pub(super) fn observations_figure(title: &str, rows: &[Row<'_>]) -> Figure {
    let units = each_once(rows.iter().map(|row| row.unit));
    let panel = |unit: &str| {
        let own: Vec<_> = rows.iter().filter(|row| row.unit == unit).collect();
        let (unit, factor) = shown_unit(unit);
        let points = |value: &dyn Fn(&Row<'_>) -> f64| -> Vec<Point> {
            let rows = own.iter().enumerate();
            rows.map(|(place, row)| (factor * value(row), place as f64 + 0.5))
                .collect()
        };
        let measured = points(&|row| row.measured);
        let computed = points(&|row| row.computed);
        let bars = [-1.0, 1.0].map(|side| points(&|row| row.measured + side * row.sigma));
        let all = bars
            .iter()
            .chain([&computed])
            .flatten()
            .map(|point| point.0);
        let [least, most] = ends(all.clone()).unwrap_or([0.0, 1.0]);
        let label = ("value", unit);
        let across = match least > 0.0 && most > WIDE * least {
            true => Axis::logarithmic(label, all),
            false => Axis::spanning(label, all),
        };
        // a bar from end to end, with a stroke across either of them
        let strokes = bars
            .iter()
            .flatten()
            .flat_map(|&(at, row)| [row - CROSS, row + CROSS, f64::NAN].map(|height| (at, height)));
        let [from, to] = &bars;
        let pairs = from.iter().zip(to);
        let lines = pairs.flat_map(|(from, to)| [*from, *to, (to.0, f64::NAN)]);
        let marked = |colour, mark, points| Curve {
            mark,
            ..Curve::dots(colour, points)
        };
        Panel {
            curves: vec![
                Curve::line(distinct(0), lines.chain(strokes).collect()),
                marked(distinct(0), Mark::Dot, measured),
                marked(distinct(1), Mark::Triangle, computed),
            ],
            ..Panel::new(
                across,
                Axis::names(own.iter().map(|row| row.name.to_owned())),
                height(own.len()),
            )
        }
    };
    let panels: Vec<_> = units.into_iter().map(panel).collect();
    let columns = panels.len().min(2);
    let mut names = Name::each(["measured, a standard deviation to either side", "computed"]);
    names[1].mark = Some(Mark::Triangle);
    Figure::new("fit_observations", title, columns, panels).with_names(names)
}

/// Residuals in standard deviations, an observation a line, beside one and two of them.
pub(super) fn residuals_figure(title: &str, rows: &[Row<'_>]) -> Figure {
    let count = rows.len() as f64;
    let points = rows
        .iter()
        .enumerate()
        .map(|(place, row)| (row.residual, place as f64 + 0.5));
    let points: Vec<_> = points.collect();
    let across = Axis::spanning(
        "(computed − measured)/σ",
        points.iter().map(|point| point.0).chain([-2.5, 2.5]),
    );
    let limits = [-2.0, -1.0, 0.0, 1.0, 2.0].map(|at| Curve {
        fine: at != 0.0,
        ..Curve::line(GREY, vec![(at, 0.0), (at, count)])
    });
    let dots = Curve {
        mark: Mark::Disc,
        ..Curve::dots(distinct(0), points)
    };
    let panel = Panel {
        curves: limits.into_iter().chain([dots]).collect(),
        ..Panel::new(
            across,
            Axis::names(rows.iter().map(|row| row.name.to_owned())),
            height(rows.len()),
        )
    };
    Figure::new("fit_residuals", title, 1, vec![panel])
}

/// χ² above its least over every unknown: where it is 1 lies a standard error.
pub(super) fn profiles_figure(file: &FitFile, fit: &Fit) -> Option<Figure> {
    let panel = |profile: &Profile| {
        let unknown = &file.unknowns[profile.unknown];
        let (variable, error) = (&unknown.variable, fit.errors[profile.unknown]);
        let at = |value: f64| variable.shown(value);
        let points: Vec<_> = profile
            .points
            .iter()
            .map(|point| (at(point[0]), point[1]))
            .collect();
        let best = fit.values[profile.unknown];
        let parabola = (-30..=30).map(|step| {
            let distance = f64::from(step) / 10.0;
            (at(best + distance * error), distance * distance)
        });
        let [least, most] = ends(points.iter().map(|point| point.0)).unwrap_or([0.0, 1.0]);
        let parabola = parabola
            .filter(|point| (least..=most).contains(&point.0))
            .collect();
        let curves = vec![
            Curve::line(GREY, parabola),
            Curve::marked(distinct(0), points, 50),
        ];
        Panel::holding(
            Axis::over(axis_label(variable), least..most),
            "χ² above its least",
            HEIGHT,
            curves,
        )
    };
    let panels: Vec<_> = fit
        .profiles
        .iter()
        .filter(|own| own.points.len() > 2)
        .map(panel)
        .collect();
    let names = [
        Name::new("with the other unknowns at their best", distinct(0)),
        Name::new("by the standard error", GREY),
    ];
    (!panels.is_empty())
        .then(|| Figure::new("fit_profiles", &file.title, 2, panels).with_names(names))
}

/// The records that lines were taken from, and the lines of the fitted motion over the same axis.
pub(super) fn predictions(file: &FitFile, fit: &Fit) -> (Vec<Overlay>, Overlay) {
    let records = file
        .records
        .iter()
        .filter_map(|path| Overlay::load(path).ok());
    let lines = fit.orbits.iter().flatten().map(|orbit| &orbit.lines).next();
    let channels = file.readings.iter().filter_map(|(_, wanted)| match wanted {
        Wanted::Amplitude { channel, .. } => Some(*channel),
        _ => None,
    });
    let mut channels: Vec<Channel> = channels.collect();
    channels.dedup();
    let table = lines.map(|lines| line_spectrum(lines, &channels));
    (
        records.collect(),
        Overlay::from_tables("fitted".to_owned(), table, Vec::new()),
    )
}

/// Lines as a spectrum that is nothing compared with them.
fn line_spectrum(lines: &SteadyLines, channels: &[Channel]) -> Table<'static> {
    const BESIDE: f64 = 1e-6;
    let moving = lines.lines.iter().filter(|line| line.frequency > 0.0);
    let places = moving.flat_map(|line| {
        [(1.0 - BESIDE, 0.0), (1.0, 1.0), (1.0 + BESIDE, 0.0)].map(|at| (line, at))
    });
    let places: Vec<_> = places.collect();
    let mut table = Table::default();
    table.add(
        Column::frequency(),
        places.iter().map(|(line, (at, _))| at * line.frequency),
    );
    for channel in channels {
        let Some(index) = lines.channels.iter().position(|known| known == channel) else {
            continue;
        };
        let heights = places
            .iter()
            .map(|(line, (_, height))| height * line.amplitude[index]);
        table.add(channel.measure("amplitude"), heights);
    }
    table
}
