//! Figures as the page's script reads them: what they are made of, to be drawn at any size.

use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use plotters::style::RGBColor;
use serde_json::{Value, json};

use super::panel::narrow;
use crate::report::figure::{Axis, Cell, Curve, Figure, Map, Mark, Name, Panel, Point};

/// Figures with their panels.
pub(in crate::report) fn figures_json<'a>(figures: impl IntoIterator<Item = &'a Figure>) -> Value {
    figures.into_iter().map(figure).collect()
}

fn figure(figure: &Figure) -> Value {
    json!({
        "name": figure.name(),
        "title": figure.title,
        "names": names(&figure.names),
        "columns": figure.columns,
        "panels": figure.panels.iter().map(panel).collect::<Value>(),
    })
}

fn panel(panel: &Panel) -> Value {
    let label =
        |((x, y), text, colour): &(Point, String, RGBColor)| json!([x, y, text, hex(*colour)]);
    let peak = |((x, y), text): &(Point, String)| json!([x, y, text]);
    json!({
        "title": panel.title,
        "names": names(&panel.names),
        "x": axis(&panel.x),
        "y": axis(&panel.y),
        "height": panel.height,
        "equal": panel.equal,
        "cells": (!panel.cells.is_empty()).then(|| cells(&panel.cells)),
        "bar": panel.bar.as_ref().map(axis),
        "map": panel.map.as_ref().map(map),
        "curves": panel.curves.iter().map(curve).collect::<Value>(),
        "labels": panel.labels.iter().map(label).collect::<Value>(),
        "peaks": panel.peaks.iter().map(peak).collect::<Value>(),
    })
}

fn names(names: &[Name]) -> Value {
    let name = |name: &Name| json!({ "text": name.text, "colour": hex(name.colour) });
    names.iter().map(name).collect()
}

fn axis(axis: &Axis) -> Value {
    json!({
        "name": axis.name.trim(),
        "ends": axis.ends,
        "logarithmic": axis.logarithmic,
        "texts": axis.texts(),
    })
}

fn curve(curve: &Curve) -> Value {
    let marks_points = !curve.points.is_empty() && curve.marks == curve.points;
    json!({
        "name": curve.name,
        "colour": hex(curve.colour),
        "fine": curve.fine,
        "points": points(&distinct_points(curve)),
        "marks": if marks_points { Value::Null } else { points(&curve.marks) },
        "pointsAreMarked": marks_points,
        "mark": match curve.mark {
            Mark::Spot => "spot",
            Mark::Dot => "dot",
            Mark::Disc => "disc",
            Mark::Triangle => "triangle",
        },
        "runs": numbers(&curve.runs),
    })
}

/// The points of a curve; where they belong to no runs, none twice.
fn distinct_points(curve: &Curve) -> Vec<Point> {
    let mut points = curve.points.clone();
    if curve.runs.is_empty() && curve.marks.is_empty() {
        points.dedup();
    }
    points
}

/// Abscissas and values.
fn points(points: &[Point]) -> Value {
    let of = |value: fn(&Point) -> f64| narrow(points.iter().map(value));
    json!([of(|point| point.0), of(|point| point.1)])
}

/// Numbers of runs, which are exact below 2^24.
fn numbers(runs: &[u64]) -> Value {
    let found = (!runs.is_empty()).then(|| narrow(runs.iter().map(|run| *run as f64)));
    found.into()
}

fn cells(cells: &[Cell]) -> Value {
    let corners = |index: usize, axis: fn(&Point) -> f64| {
        narrow(cells.iter().map(|cell| axis(&cell.corners[index])))
    };
    let runs: Vec<u64> = cells.iter().filter_map(|cell| cell.run).collect();
    json!({
        "left": corners(0, |point| point.0),
        "right": corners(1, |point| point.0),
        "top": corners(0, |point| point.1),
        "bottom": corners(1, |point| point.1),
        "values": narrow(cells.iter().map(|cell| cell.value)),
        "colours": cells.iter().map(|cell| hex(cell.colour)).collect::<Value>(),
        "runs": numbers(&runs),
    })
}

fn map(map: &Map) -> Value {
    json!({
        "width": map.width,
        "levels": STANDARD.encode(&map.levels),
        "top": map.top,
        "decades": map.decades,
        "unit": map.unit,
    })
}

fn hex(RGBColor(red, green, blue): RGBColor) -> String {
    format!("#{red:02x}{green:02x}{blue:02x}")
}
