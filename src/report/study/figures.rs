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
use crate::report::units::{MICRO, MILLI};
use crate::study::{StudyRow, Variable};

/// Panels side by side.
const COLUMNS: usize = 2;
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
        |area| draw(area, &names, &panels, COLUMNS),
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

/// Deformation around every bearing, one curve a value; left as it is, right less its mean.
pub(super) fn deformation(
    title: &str,
    variable: &Variable,
    rows: &[StudyRow],
) -> Result<String, ReportError> {
    let value = |place: &Around| MICRO * place.deformation;
    let panels = (0..bearings(rows)).flat_map(|index| {
        let whole = around(rows, index, "deformation δ in µm", value);
        let change = less_mean(&whole, "δ less its mean in µm");
        [whole, change]
    });
    let panels: Vec<_> = panels.collect();
    around_figure("deformation.svg", title, variable, rows, &panels)
}

/// Contact angles around every bearing, one curve a value; inner race left, outer race right, each
/// as it is and below that less its mean.
pub(super) fn contact_angle(
    title: &str,
    variable: &Variable,
    rows: &[StudyRow],
) -> Result<String, ReportError> {
    let inner = |place: &Around| place.contact.angle_inner.to_degrees();
    let outer = |place: &Around| place.contact.angle_outer.to_degrees();
    let panels = (0..bearings(rows)).flat_map(|index| {
        let inner = around(rows, index, "inner angle α in deg", inner);
        let outer = around(rows, index, "outer angle α in deg", outer);
        let changes = [
            less_mean(&inner, "inner α less its mean in deg"),
            less_mean(&outer, "outer α less its mean in deg"),
        ];
        [inner, outer].into_iter().chain(changes)
    });
    let panels: Vec<_> = panels.collect();
    around_figure("contact_angle.svg", title, variable, rows, &panels)
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

/// The same curves, each less its mean around the bearing: what the load across the shaft does,
/// however large the rest is.
fn less_mean(panel: &Panel, name: &str) -> Panel {
    let curve = |curve: &Curve| {
        // the ends only close the turn
        let places = curve.points.iter().skip(1).rev().skip(1);
        let (count, sum) = places.fold((0.0, 0.0), |(count, sum), point| {
            (count + 1.0, sum + point.1)
        });
        let mean = sum / f64::max(count, 1.0);
        let points = curve.points.iter();
        Curve {
            points: points.map(|&(at, value)| (at, value - mean)).collect(),
            marks: Vec::new(),
            colour: curve.colour,
        }
    };
    Panel {
        x_name: panel.x_name.clone(),
        x_ticks: panel.x_ticks.clone(),
        y_name: name.to_owned(),
        curves: panel.curves.iter().map(curve).collect(),
    }
}

fn around_figure(
    figure: &'static str,
    title: &str,
    variable: &Variable,
    rows: &[StudyRow],
    panels: &[Panel],
) -> Result<String, ReportError> {
    let count = rows.len();
    let name = |(index, row): (usize, &StudyRow)| -> (String, RGBColor) {
        (shown(variable, row.value), graded(index, count))
    };
    let names: Vec<_> = rows.iter().enumerate().map(name).collect();
    let height = HEAD_HEIGHT + panels.len().div_ceil(COLUMNS) as u32 * ROW_HEIGHT;
    svg(figure, height, title, |area| {
        draw(area, &names, panels, COLUMNS)
    })
}
