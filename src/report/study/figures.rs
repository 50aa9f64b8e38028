//! The figures of a study: stiffnesses against the variable, deformation and contact angle around
//! every bearing.

use plotters::style::RGBColor;

use super::super::ReportError;
use super::super::figure::svg;
use super::super::figure_curves::{
    Curve, Panel, all_around, azimuth_ticks, distinct, draw, graded, round_ticks, turned,
};
use super::{axis_name, shown};
use crate::bearing::Around;
use crate::study::{StudyRow, Variable};

/// m → µm.
const MICRO: f64 = 1e6;
/// N m/rad → N m/mrad.
const MILLI: f64 = 1e3;
/// Height of a row of panels, px.
const ROW_HEIGHT: u32 = 330;
/// Height of title and names, px.
const HEAD_HEIGHT: u32 = 60;
/// Most points of a curve that are marked.
const MOST_MARKS: usize = 40;

/// K_x, K_y, K_z and both tilts against the variable, in four panels.
pub(super) fn stiffness(
    title: &str,
    variable: &Variable,
    rows: &[StudyRow],
) -> Result<String, ReportError> {
    let values = rows.iter().map(|row| variable.shown(row.value));
    let low = values.clone().fold(f64::INFINITY, f64::min);
    let high = values.fold(f64::NEG_INFINITY, f64::max);
    let panel = |name: &str, axes: &[usize]| Panel {
        x_name: axis_name(variable),
        x_ticks: round_ticks(low, high),
        y_name: name.to_owned(),
        curves: axes
            .iter()
            .map(|&axis| against(variable, rows, axis))
            .collect(),
    };
    let panels = [
        panel("K_x in N/µm", &[0]),
        panel("K_y in N/µm", &[1]),
        panel("K_z in N/µm", &[2]),
        panel("K_θx, K_θy in N m/mrad", &[3, 4]),
    ];
    let names = ["K_x", "K_y", "K_z", "K_θx", "K_θy"];
    let names: Vec<_> = (0..5)
        .map(|axis| (names[axis].to_owned(), distinct(axis)))
        .collect();
    svg(
        "stiffness.svg",
        HEAD_HEIGHT + 2 * ROW_HEIGHT,
        title,
        |area| draw(area, &names, &panels, 2),
    )
}

/// Diagonal term `axis` of K against the variable.
fn against(variable: &Variable, rows: &[StudyRow], axis: usize) -> Curve {
    let scale = if axis < 3 { MICRO } else { MILLI };
    let point = |row: &StudyRow| {
        let stiffness = row.answer.stiffness[(axis, axis)] / scale;
        (variable.shown(row.value), stiffness)
    };
    let mut points: Vec<_> = rows.iter().map(point).collect();
    points.sort_by(|a, b| a.0.total_cmp(&b.0));
    Curve {
        marks: if points.len() <= MOST_MARKS {
            points.clone()
        } else {
            Vec::new()
        },
        points,
        colour: distinct(axis),
    }
}

/// Deformation around every bearing, one curve a value.
pub(super) fn deformation(
    title: &str,
    variable: &Variable,
    rows: &[StudyRow],
) -> Result<String, ReportError> {
    let value = |place: &Around| MICRO * place.deformation;
    let panels = (0..bearings(rows)).map(|index| around(rows, index, "deformation δ in µm", value));
    let panels: Vec<_> = panels.collect();
    around_figure("deformation.svg", title, variable, rows, &panels, 1)
}

/// Contact angles around every bearing, one curve a value; inner race left, outer race right.
pub(super) fn contact_angle(
    title: &str,
    variable: &Variable,
    rows: &[StudyRow],
) -> Result<String, ReportError> {
    let inner = |place: &Around| place.contact.angle_inner.to_degrees();
    let outer = |place: &Around| place.contact.angle_outer.to_degrees();
    let panels = (0..bearings(rows)).flat_map(|index| {
        [
            around(rows, index, "inner angle α in deg", inner),
            around(rows, index, "outer angle α in deg", outer),
        ]
    });
    let panels: Vec<_> = panels.collect();
    around_figure("contact_angle.svg", title, variable, rows, &panels, 2)
}

fn bearings(rows: &[StudyRow]) -> usize {
    rows.first().map_or(0, |row| row.around.len())
}

/// One quantity around bearing `index`.
fn around(rows: &[StudyRow], index: usize, name: &str, value: fn(&Around) -> f64) -> Panel {
    let bearing = if bearings(rows) > 1 {
        format!("bearing {}: ", index + 1)
    } else {
        String::new()
    };
    let curve = |(place, row): (usize, &StudyRow)| Curve {
        points: all_around(turned(
            row.around[index].iter().map(|at| (at.azimuth, value(at))),
        )),
        colour: graded(place, rows.len()),
        marks: Vec::new(),
    };
    Panel {
        x_name: "azimuth φ in deg".to_owned(),
        x_ticks: azimuth_ticks(),
        y_name: format!("{bearing}{name}"),
        curves: rows.iter().enumerate().map(curve).collect(),
    }
}

fn around_figure(
    figure: &'static str,
    title: &str,
    variable: &Variable,
    rows: &[StudyRow],
    panels: &[Panel],
    columns: usize,
) -> Result<String, ReportError> {
    let count = rows.len();
    let name = |(index, row): (usize, &StudyRow)| -> (String, RGBColor) {
        (shown(variable, row.value), graded(index, count))
    };
    let names: Vec<_> = rows.iter().enumerate().map(name).collect();
    let height = HEAD_HEIGHT + bearings(rows) as u32 * ROW_HEIGHT;
    svg(figure, height, title, |area| {
        draw(area, &names, panels, columns)
    })
}
