//! Residuals and profiles of a fit, and what it predicts over the records.

use super::Row;
use crate::analysis::Channel;
use crate::fit::{Fit, Profile, Wanted};
use crate::report::compare::Overlay;
use crate::report::figure::{Axis, Curve, Figure, GREY, Mark, Name, Panel, distinct, ends};
use crate::report::variable::axis_label;
use crate::scenario::FitFile;
use crate::steady::SteadyLines;
use crate::table::{Column, Table};

/// Height of plots, px.
const HEIGHT: u32 = 250;
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
            Axis::names(rows.iter().map(|row| row.observation.name.clone())),
            60 + 22 * rows.len() as u32,
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

/// Lines as a spectrum that is nothing beside them.
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
