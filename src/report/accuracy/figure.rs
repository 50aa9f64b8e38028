//! Figures of speed against error: methods over time, evaluations and steps; rungs by cost and difference.

use plotters::prelude::*;

use super::super::ReportError;
use super::super::figure::{Area, DrawError, GRID, INK, LINE, PALETTE, font, px, svg};
use super::super::figure_curves::distinct;
use super::log_axis::{LogAxis, tick_name};
use crate::study::accuracy::{Accuracy, Agreement, LadderRow, Measured};

/// Height of a panel, px.
const PANEL_HEIGHT: u32 = 380;
/// Height of a title, px.
const TITLE_HEIGHT: u32 = 36;
/// Height of the methods' names, at most a row for two of them, px.
const KEY_HEIGHT: u32 = 176;
/// Height of a row of it, px.
const KEY_ROW: u32 = 22;
/// Where names and words begin, px.
const KEY_LEFT: u32 = 82;
/// Half the size of a mark, px.
const MARK: u32 = 3;
/// Height of a rung, px.
const RUNG_HEIGHT: u32 = 30;
/// Room for the names of the rungs, px.
const RUNG_NAMES: u32 = 260;
/// The uncertainty.
const GREY: RGBColor = RGBColor(150, 150, 150);
/// Colours that there are; curves beyond them differ by their marks.
const COLOURS: usize = PALETTE.len();

/// Quantity on an axis and its name.
type Axis = (&'static str, fn(&Measured) -> Option<f64>);

const TIME: Axis = ("time of the integration in ms", |measured| {
    Some(1e3 * measured.cost.seconds)
});
const EVALUATIONS: Axis = ("evaluations of the right-hand side", |measured| {
    Some(measured.cost.counters.evaluations as f64)
});
const STEPS: Axis = ("steps, accepted and rejected", |measured| {
    let counters = &measured.cost.counters;
    Some((counters.steps + counters.rejected) as f64)
});
const DISPLACEMENT: Axis = ("error in displacement", |measured| {
    Some(measured.errors.displacement_relative)
});
const FORCE: Axis = ("error in force", |measured| {
    Some(measured.errors.force_relative)
});
const RMS: Axis = ("error in rms of displacement", |measured| {
    Some(measured.errors.statistics.rms)
});
const FORCE_RMS: Axis = ("error in rms of force", |measured| {
    Some(measured.errors.force_statistics.rms)
});
const LINES: Axis = ("error in labelled lines", |measured| measured.errors.lines);

/// What is plotted over what, and the uncertainty of it: of traces, or of their rms where they mean
/// nothing.
fn panels(agreement: &Agreement) -> [(Axis, Axis, Option<f64>); 5] {
    let (scatter, uncertainty) = (&agreement.scatter, &agreement.uncertainty);
    let (displacement, force) = if agreement.irregular {
        let limits = (scatter.statistics.rms, scatter.force_statistics.rms);
        ((RMS, Some(limits.0)), (FORCE_RMS, Some(limits.1)))
    } else {
        let limits = (
            uncertainty.displacement_relative,
            uncertainty.force_relative,
        );
        ((DISPLACEMENT, Some(limits.0)), (FORCE, Some(limits.1)))
    };
    [
        (TIME, displacement.0, displacement.1),
        (EVALUATIONS, displacement.0, displacement.1),
        (STEPS, displacement.0, displacement.1),
        (TIME, force.0, force.1),
        (TIME, LINES, uncertainty.lines),
    ]
}

/// Points of a method from the loosest tolerance to the tightest.
fn measured<'a>(accuracy: &'a Accuracy, method: &'a str) -> impl Iterator<Item = &'a Measured> {
    let rows = accuracy.rows.iter().filter(move |row| row.method == method);
    rows.filter_map(|row| row.result.as_ref().ok())
}

/// Error over time, evaluations and steps, a curve a method; the uncertainty is a grey line.
pub(super) fn methods(title: &str, accuracy: &Accuracy) -> Result<String, ReportError> {
    let mut methods: Vec<&str> = Vec::new();
    for row in &accuracy.rows {
        if !methods.contains(&row.method.as_str()) {
            methods.push(&row.method);
        }
    }
    svg(
        "accuracy.svg",
        TITLE_HEIGHT + 3 * PANEL_HEIGHT,
        title,
        |area| {
            let areas = area.split_evenly((3, 2));
            for (panel, area) in panels(&accuracy.agreement).iter().zip(&areas) {
                draw_methods(area, accuracy, &methods, panel)?;
            }
            let (key, reading) = areas[5].split_vertically(px(KEY_HEIGHT));
            draw_key(&key, &methods)?;
            draw_reading(&reading, accuracy)
        },
    )
}

fn draw_methods(
    area: &Area,
    accuracy: &Accuracy,
    methods: &[&str],
    ((x_name, x), (y_name, y), uncertainty): &(Axis, Axis, Option<f64>),
) -> Result<(), DrawError> {
    let all = || {
        accuracy
            .rows
            .iter()
            .filter_map(|row| row.result.as_ref().ok())
    };
    let x_axis = LogAxis::of(all().filter_map(x));
    let y_axis = LogAxis::of(all().filter_map(y));
    let (x_place, y_place) = (x_axis.clone(), y_axis.clone());
    let mut chart = ChartBuilder::on(area)
        .margin_top(px(10))
        .margin_left(px(8))
        .margin_right(px(28))
        .set_label_area_size(LabelAreaPosition::Left, px(74))
        .set_label_area_size(LabelAreaPosition::Bottom, px(44))
        .build_cartesian_2d(x_axis, y_axis)?;
    chart
        .configure_mesh()
        .bold_line_style(GRID)
        .light_line_style(TRANSPARENT)
        .x_labels(x_place.count())
        .y_labels(y_place.count())
        .x_label_formatter(&tick_name)
        .y_label_formatter(&tick_name)
        .x_desc(*x_name)
        .y_desc(*y_name)
        .axis_style(INK)
        .label_style(font(12))
        .axis_desc_style(font(13))
        .draw()?;
    if let Some(uncertainty) = uncertainty {
        let uncertainty = y_place.place(*uncertainty);
        let ends = [x_place.range.start, x_place.range.end].map(|end| (end, uncertainty));
        chart.draw_series(LineSeries::new(ends, GREY.stroke_width(LINE)))?;
    }
    for (index, method) in methods.iter().enumerate() {
        let points: Vec<(f64, f64)> = measured(accuracy, method)
            .filter_map(|row| Some((x_place.place(x(row)?), y_place.place(y(row)?))))
            .collect();
        let colour = distinct(index);
        let line = points.iter().copied();
        chart.draw_series(LineSeries::new(line, colour.stroke_width(LINE)))?;
        if is_round(index) {
            let mark = |point: &(f64, f64)| Circle::new(*point, px(MARK), colour.filled());
            chart.draw_series(points.iter().map(mark))?;
        } else {
            let mark =
                |point: &(f64, f64)| TriangleMarker::new(*point, px(2 * MARK), colour.filled());
            chart.draw_series(points.iter().map(mark))?;
        }
    }
    Ok(())
}

/// Whether the marks of a method are circles; of the others they are triangles.
fn is_round(index: usize) -> bool {
    index < COLOURS
}

/// Every method's name behind its colour and mark, in two columns.
fn draw_key(area: &Area, methods: &[&str]) -> Result<(), DrawError> {
    let rows = methods.len().div_ceil(2);
    let column_width = area.dim_in_pixel().0.saturating_sub(px(KEY_LEFT)) / 2;
    for (index, method) in methods.iter().enumerate() {
        let left = (px(KEY_LEFT) + (index / rows) as u32 * column_width) as i32;
        let middle = px(24 + KEY_ROW * (index % rows) as u32) as i32;
        let right = left + px(30) as i32;
        let centre = ((left + right) / 2, middle);
        let colour = distinct(index);
        let stroke = [(left, middle), (right, middle)];
        area.draw(&PathElement::new(stroke, colour.stroke_width(LINE)))?;
        if is_round(index) {
            area.draw(&Circle::new(centre, px(MARK), colour.filled()))?;
        } else {
            area.draw(&TriangleMarker::new(centre, px(2 * MARK), colour.filled()))?;
        }
        let corner = (right + px(8) as i32, middle - px(7) as i32);
        area.draw(&Text::new((*method).to_owned(), corner, font(13)))?;
    }
    Ok(())
}

/// What the figure rests on, in words.
fn draw_reading(area: &Area, accuracy: &Accuracy) -> Result<(), DrawError> {
    let agreement = &accuracy.agreement;
    let (method, tolerance) = &agreement.reference;
    let (other, tightness) = &agreement.other;
    let grey = if agreement.irregular {
        "Grey line: scatter of exact runs, which part company here."
    } else {
        "Grey line: distance of the two, the uncertainty."
    };
    let lines = [
        format!("Reference: {method} at {tolerance:e},"),
        format!("compared with {other} at {tightness:e}."),
        grey.to_owned(),
        format!("Motion: {:.4} µm.", 1e6 * agreement.scale.displacement),
        "Errors are relative to it, those of forces to their change,".to_owned(),
        "those of lines to each line.".to_owned(),
        "Along a curve, the tolerance falls.".to_owned(),
    ];
    for (index, line) in lines.into_iter().enumerate() {
        let corner = (px(KEY_LEFT) as i32, px(KEY_ROW * index as u32) as i32);
        area.draw(&Text::new(line, corner, font(13)))?;
    }
    Ok(())
}

/// A row a rung: its cost to the left, its difference from the top rung to the right.
pub(super) fn ladder(title: &str, accuracy: &Accuracy) -> Result<String, ReportError> {
    let rows: Vec<&LadderRow> = accuracy
        .ladder
        .rows
        .iter()
        .filter(|row| row.result.is_ok())
        .collect();
    let height = TITLE_HEIGHT + 68 + RUNG_HEIGHT * rows.len().max(1) as u32;
    svg("ladder.svg", height, title, |area| {
        let (names, rest) = area.split_horizontally(px(RUNG_NAMES));
        let (left, right) = rest.split_horizontally(rest.dim_in_pixel().0 / 2);
        draw_rungs(&names, &rows)?;
        let cost = |row: &LadderRow| {
            let (cost, _) = row.result.as_ref().ok()?;
            Some(1e3 * cost.seconds / accuracy.duration)
        };
        let difference = |row: &LadderRow| {
            let (_, errors) = row.result.as_ref().ok()?;
            let difference = if accuracy.agreement.irregular {
                errors.statistics.rms
            } else {
                errors.displacement_relative
            };
            (difference > 0.0).then_some(difference)
        };
        let costs: Vec<_> = rows.iter().map(|row| cost(row)).collect();
        let differences: Vec<_> = rows.iter().map(|row| difference(row)).collect();
        draw_dots(&left, "ms per simulated second", &costs, 0)?;
        let name = if accuracy.agreement.irregular {
            "difference of the rms from the top"
        } else {
            "vibration: rms difference from the top"
        };
        draw_dots(&right, name, &differences, 1)
    })
}

/// The names of the rungs, each at the height of its dots.
fn draw_rungs(area: &Area, rows: &[&LadderRow]) -> Result<(), DrawError> {
    // the panels beside the names have a margin above and their axis below
    let height = area.dim_in_pixel().1.saturating_sub(px(54));
    for (index, row) in rows.iter().enumerate() {
        let place = (2 * index as u32 + 1) * height / (2 * rows.len() as u32);
        let middle = (px(10) + place) as i32 - px(7) as i32;
        let name = row.configuration.to_string();
        area.draw(&Text::new(name, (px(10) as i32, middle), font(12)))?;
    }
    Ok(())
}

/// A dot a row over one logarithmic axis; a row without a value has none.
fn draw_dots(
    area: &Area,
    name: &str,
    values: &[Option<f64>],
    colour: usize,
) -> Result<(), DrawError> {
    let axis = LogAxis::of(values.iter().flatten().copied());
    let place = axis.clone();
    let rows = values.len().max(1) as f64;
    let mut chart = ChartBuilder::on(area)
        .margin_top(px(10))
        .margin_left(px(10))
        .margin_right(px(28))
        .set_label_area_size(LabelAreaPosition::Bottom, px(44))
        .build_cartesian_2d(axis, rows..0.0)?;
    chart
        .configure_mesh()
        .bold_line_style(GRID)
        .light_line_style(TRANSPARENT)
        .disable_y_mesh()
        .x_labels(place.count())
        .x_label_formatter(&tick_name)
        .x_desc(name)
        .axis_style(INK)
        .label_style(font(12))
        .axis_desc_style(font(13))
        .draw()?;
    let dots = values.iter().enumerate().filter_map(|(index, value)| {
        let at = (place.place((*value)?), index as f64 + 0.5);
        Some(Circle::new(at, px(5), distinct(colour).filled()))
    });
    chart.draw_series(dots)?;
    Ok(())
}
