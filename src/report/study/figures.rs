//! The figures of a study: stiffnesses against the variable, deformation and contact angle around
//! every bearing.

use super::{axis_name, shown};
use crate::bearing::Around;
use crate::report::figure::{
    Axis, Curve, Figure, Name, Panel, all_around, distinct, graded, turned,
};
use crate::report::units::{MICRO, MILLI};
use crate::study::{StudyRow, Variable};

/// Height of a plot, px.
const HEIGHT: u32 = 272;
/// Most points of a curve that are marked.
const MOST_MARKS: usize = 40;
/// Most values that are named.
const MOST_NAMES: usize = 8;

/// K_x, K_y, K_z and both tilts against the variable, in four panels.
pub(super) fn stiffness(title: &str, variable: &Variable, rows: &[StudyRow]) -> Figure {
    let values = rows.iter().map(|row| variable.shown(row.value));
    let axis = Axis::spanning(axis_name(variable), values);
    let panel = |name: &str, axes: &[usize]| {
        let curves = axes.iter().map(|axis| against(variable, rows, *axis));
        Panel::of(axis.clone(), name, HEIGHT, curves.collect())
    };
    let panels = vec![
        panel("K_x in N/µm", &[0]),
        panel("K_y in N/µm", &[1]),
        panel("K_z in N/µm", &[2]),
        panel("K_θx, K_θy in N m/mrad", &[3, 4]),
    ];
    let names = Name::each(["K_x", "K_y", "K_z", "K_θx", "K_θy"]);
    Figure::new("stiffness.svg", title, 2, panels).with_names(names)
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
    Curve::marked(distinct(axis), points, MOST_MARKS)
}

/// Deformation around every bearing, one curve a value; left as it is, right less its mean.
pub(super) fn deformation(title: &str, variable: &Variable, rows: &[StudyRow]) -> Figure {
    let value = |place: &Around| MICRO * place.deformation;
    let panels = (0..bearings(rows)).flat_map(|index| {
        let curves = around(rows, index, value);
        let change = less_mean(&curves, "δ less its mean in µm");
        [panel(rows, index, "deformation δ in µm", curves), change]
    });
    let figure = Figure::new("deformation.svg", title, 2, panels.collect());
    figure.with_names(values(variable, rows))
}

/// Contact angles around every bearing, one curve a value; inner race left, outer race right, each
/// as it is and below that less its mean.
pub(super) fn contact_angle(title: &str, variable: &Variable, rows: &[StudyRow]) -> Figure {
    let panels = (0..bearings(rows)).flat_map(|index| {
        let inner = around(rows, index, |at| at.contact.angle_inner.to_degrees());
        let outer = around(rows, index, |at| at.contact.angle_outer.to_degrees());
        let changes = [
            less_mean(&inner, "inner α less its mean in deg"),
            less_mean(&outer, "outer α less its mean in deg"),
        ];
        let whole = [
            panel(rows, index, "inner angle α in deg", inner),
            panel(rows, index, "outer angle α in deg", outer),
        ];
        whole.into_iter().chain(changes)
    });
    let figure = Figure::new("contact_angle.svg", title, 2, panels.collect());
    figure.with_names(values(variable, rows))
}

fn bearings(rows: &[StudyRow]) -> usize {
    rows.first().map_or(0, |row| row.around.len())
}

/// One quantity around bearing `index`, a curve a value of the variable.
fn around(rows: &[StudyRow], index: usize, value: impl Fn(&Around) -> f64) -> Vec<Curve> {
    let curve = |(place, row): (usize, &StudyRow)| {
        let values = row.around[index].iter().map(|at| (at.azimuth, value(at)));
        Curve::line(graded(place, rows.len()), all_around(turned(values)))
    };
    rows.iter().enumerate().map(curve).collect()
}

fn panel(rows: &[StudyRow], index: usize, name: &str, curves: Vec<Curve>) -> Panel {
    let name = if bearings(rows) > 1 {
        format!("bearing {}: {name}", index + 1)
    } else {
        name.to_owned()
    };
    Panel::of(Axis::azimuth(), name, HEIGHT, curves)
}

/// The same curves, each less its mean around the bearing: what the load across the shaft does,
/// however large the rest is.
fn less_mean(curves: &[Curve], name: &str) -> Panel {
    let curve = |curve: &Curve| {
        // the ends only close the turn
        let inner = curve.points.get(1..curve.points.len().max(2) - 1);
        let inner = inner.unwrap_or_default();
        let sum: f64 = inner.iter().map(|point| point.1).sum();
        let mean = sum / inner.len().max(1) as f64;
        let points = curve.points.iter();
        Curve::line(
            curve.colour,
            points.map(|(at, value)| (*at, value - mean)).collect(),
        )
    };
    let curves = curves.iter().map(curve).collect();
    Panel::of(Axis::azimuth(), name, HEIGHT, curves)
}

/// What the colours of the values mean; of many, of some.
fn values(variable: &Variable, rows: &[StudyRow]) -> Vec<Name> {
    let count = rows.len();
    let shown_names = shown_names(count);
    let indices = (0..shown_names).map(|place| place * (count - 1) / (shown_names - 1).max(1));
    indices
        .map(|index| Name::new(shown(variable, rows[index].value), graded(index, count)))
        .collect()
}

/// How many of `count` names are shown: of many, as many as can be evenly spaced ones.
fn shown_names(count: usize) -> usize {
    if count <= MOST_NAMES {
        return count;
    }
    (4..=MOST_NAMES)
        .rev()
        .find(|shown| (count - 1).is_multiple_of(shown - 1))
        .unwrap_or(MOST_NAMES)
}

#[cfg(test)]
mod tests {
    use super::shown_names;

    #[test]
    fn of_many_names_evenly_spaced_ones_are_shown() {
        let shown = [1, 8, 9, 17, 21, 26, 24].map(shown_names);
        assert_eq!(shown, [1, 8, 5, 5, 6, 6, 8]);
    }
}
