//! A study: one row a value, and the bearings all around at every value.

use serde_json::{Value, json};

use super::figure::{Axis, Curve, Figure, Name, Panel, all_around, distinct, graded, turned};
use super::terminal::{Lines, MICRO, MILLI, digits, in_unit, of_bearing};
use super::variable::{axis_label, shown, variable_column};
use super::{FileSet, Findings};
use crate::analysis::Channel;
use crate::bearing::{Around, BallLine, BearingState};
use crate::keys;
use crate::quasi_static::{QuasiStatic, Twist};
use crate::rotor::FREEDOMS;
use crate::scenario::Scenario;
use crate::study::{Study, StudyRow, Variable};
use crate::table::{Named, Table};

/// The answers of a study, and the bearings all around; the numbers stand in the tables alone.
pub fn study_findings(scenario: &Scenario, study: &Study, rows: &[StudyRow]) -> Findings {
    let (title, variable) = (&scenario.title, &study.variable);
    Findings {
        tables: vec![
            ("study", answers(variable, rows)),
            ("around", around(variable, rows)),
        ],
        figures: vec![
            stiffness(title, variable, rows),
            deformation(title, variable, rows),
            contact_angle(title, variable, rows),
        ],
        ..Findings::new(
            FileSet::STUDY,
            scenario,
            about(study, rows),
            text(title, study, rows),
        )
    }
}

/// Columns of the whole shaft behind its stiffness.
const SHAFT: [Named<QuasiStatic>; 4] = [
    ("condition", "", |answer| answer.condition),
    ("residual", "", |answer| answer.residual),
    ("moment_z", "N m", |answer| {
        twist(answer, |twist| twist.moment)
    }),
    ("twist", "rad", |answer| twist(answer, |twist| twist.angle)),
];

fn twist(answer: &QuasiStatic, value: fn(&Twist) -> f64) -> f64 {
    answer.twist.as_ref().map_or(f64::NAN, value)
}

/// Columns of the largest and the smallest value of all balls of a bearing; NaN where there are none.
const EXTREMES: [Named<BallLine>; 3] = [
    ("load_inner", "N", |ball| ball.inner.load),
    ("load_outer", "N", |ball| ball.outer.load),
    ("angle_inner", "rad", |ball| ball.inner.angle),
];

/// Columns of one bearing after these.
const BEARING: [Named<BearingState>; 8] = [
    ("swing_of_angle_inner", "rad", |state| {
        let angle = |ball: &BallLine| ball.inner.angle;
        extreme(state, angle, f64::max) - extreme(state, angle, f64::min)
    }),
    ("largest_pressure", "Pa", |state| {
        let pressure = |ball: &BallLine| ball.inner.peak_pressure.max(ball.outer.peak_pressure);
        extreme(state, pressure, f64::max)
    }),
    ("life", "Mrev", |state| state.life.unwrap_or(f64::NAN)),
    ("life", "h", |state| {
        let lives = state.rating_lives.as_ref();
        lives
            .and_then(|lives| lives.reference_hours)
            .unwrap_or(f64::NAN)
    }),
    ("modified_life", "h", |state| {
        let lives = state.rating_lives.as_ref();
        lives
            .and_then(|lives| lives.modified?.hours)
            .unwrap_or(f64::NAN)
    }),
    ("preload", "N", |state| state.preload),
    ("static_safety", "", |state| {
        state.static_safety.unwrap_or(f64::NAN)
    }),
    ("friction_moment", "N m", |state| {
        state.friction_moment.total()
    }),
];

/// Largest or smallest value of all balls; NaN where there are none.
fn extreme(state: &BearingState, value: fn(&BallLine) -> f64, of: fn(f64, f64) -> f64) -> f64 {
    state.balls.iter().map(value).fold(f64::NAN, of)
}

/// Columns of a position around a bearing.
const AROUND: [Named<Around>; 6] = [
    ("azimuth", "rad", |place| place.azimuth),
    ("deformation", "m", |place| place.deformation),
    ("load_inner", "N", |place| place.contact.load_inner),
    ("load_outer", "N", |place| place.contact.load_outer),
    ("angle_inner", "rad", |place| place.contact.angle_inner),
    ("angle_outer", "rad", |place| place.contact.angle_outer),
];

/// The answer at every value.
fn answers(variable: &Variable, rows: &[StudyRow]) -> Table<'static> {
    let mut table = Table::default();
    table.add(variable_column(variable), rows.iter().map(|row| row.value));
    for axis in 0..FREEDOMS {
        let values = rows.iter().map(|row| row.answer.displacement[axis]);
        table.add(Channel::Displacement(axis).column(), values);
    }
    for axis in 0..FREEDOMS {
        let values = rows.iter().map(|row| row.answer.force[axis]);
        table.add(Channel::Force(axis).column(), values);
    }
    for (axis, column) in keys::diagonal_columns().into_iter().enumerate() {
        let values = rows.iter().map(|row| row.answer.stiffness[(axis, axis)]);
        table.add(column, values);
    }
    table.named("", &SHAFT, rows.iter().map(|row| Some(&row.answer)));
    let bearings = rows.iter().map(|row| row.answer.bearings.len()).max();
    for bearing in 0..bearings.unwrap_or(0) {
        let before = format!("bearing_{}_", bearing + 1);
        let states = || rows.iter().map(|row| row.answer.bearings.get(bearing));
        let loaded = states().map(|state| Some(state?.balls_loaded as f64));
        table.numbers(format!("{before}balls_loaded"), "", loaded);
        for (name, unit, value) in EXTREMES {
            let column = |of| states().map(move |state| Some(extreme(state?, value, of)));
            table.numbers(format!("{before}largest_{name}"), unit, column(f64::max));
            table.numbers(format!("{before}smallest_{name}"), unit, column(f64::min));
        }
        table.named(&before, &BEARING, states());
    }
    table
}

/// Every bearing all around at every value; bearings and positions count from 1.
fn around(variable: &Variable, rows: &[StudyRow]) -> Table<'static> {
    let mut places = Vec::new();
    for row in rows {
        for (bearing, around) in row.around.iter().enumerate() {
            for (position, place) in around.iter().enumerate() {
                places.push((row.value, bearing + 1, position + 1, place));
            }
        }
    }
    let places = || places.iter();
    let mut table = Table::default();
    table.add(
        variable_column(variable),
        places().map(|(value, ..)| *value),
    );
    table.counts("bearing", places().map(|(_, bearing, ..)| *bearing as f64));
    table.counts(
        "position",
        places().map(|(.., position, _)| *position as f64),
    );
    table.named("", &AROUND, places().map(|(.., place)| Some(*place)));
    table
}

/// What a study is about: the number that varies by its key, and how many values it has.
fn about(study: &Study, rows: &[StudyRow]) -> Value {
    let Variable { key, unit, .. } = &study.variable;
    json!({
        "varied": { "key": key, "unit": unit },
        "points": rows.len(),
        "warnings": study.warnings(rows),
    })
}

/// Most rows shown.
const MOST_ROWS: usize = 24;

/// The values with place and stiffness of the shaft; of many, some.
fn text(title: &str, study: &Study, rows: &[StudyRow]) -> Lines {
    let mut out = Lines::titled(title);
    let varied = study.variable.key.rsplit('.').next().unwrap_or_default();
    let units = format!("{varied}\n{}", study.variable.shown_unit);
    let header = [
        units.as_str(),
        "x\nµm",
        "y\nµm",
        "z\nµm",
        "Kx\nN/µm",
        "Ky\nN/µm",
        "Kz\nN/µm",
        "Kθx\nN m/mrad",
        "Kθy\nN m/mrad",
    ];
    let step = rows.len().div_ceil(MOST_ROWS).max(1);
    let cells = rows.iter().step_by(step).map(|row| cells(study, row));
    out.table(header, cells);
    let (key, unit) = (&study.variable.key, in_unit(&study.variable.shown_unit));
    out.line("varied", format!("{key}{unit}: {} values", rows.len()));
    out
}

fn cells(study: &Study, row: &StudyRow) -> Vec<String> {
    let value = shown(&study.variable, row.value);
    let value = value.split(' ').next().unwrap_or_default().to_owned();
    let [x, y, z, ..] = row.answer.displacement;
    let places = [x, y, z].map(|place| format!("{:.3}", MICRO * place));
    let stiffness = (0..5).map(|axis| {
        let scale = if axis < 3 { MICRO } else { MILLI };
        digits(row.answer.stiffness[(axis, axis)] / scale)
    });
    [value].into_iter().chain(places).chain(stiffness).collect()
}

/// Height of a plot, px.
const HEIGHT: u32 = 272;
/// Most points of a curve that are marked.
const MOST_MARKS: usize = 40;
/// Most values that are named.
const MOST_NAMES: usize = 8;

/// K_x, K_y, K_z and both tilts against the variable, in four panels.
fn stiffness(title: &str, variable: &Variable, rows: &[StudyRow]) -> Figure {
    let values = rows.iter().map(|row| variable.shown(row.value));
    let axis = Axis::spanning(axis_label(variable), values);
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
    Figure::new("stiffness", title, 2, panels).with_names(names)
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
fn deformation(title: &str, variable: &Variable, rows: &[StudyRow]) -> Figure {
    let value = |place: &Around| MICRO * place.deformation;
    let panels = (0..bearings(rows)).flat_map(|index| {
        let curves = curves_around(rows, index, value);
        let change = less_mean(&curves, "δ less its mean in µm");
        [panel(rows, index, "deformation δ in µm", curves), change]
    });
    let figure = Figure::new("deformation", title, 2, panels.collect());
    figure.with_names(values(variable, rows))
}

/// Contact angles around every bearing, one curve a value; inner race left, outer race right, each
/// as it is and below that less its mean.
fn contact_angle(title: &str, variable: &Variable, rows: &[StudyRow]) -> Figure {
    let panels = (0..bearings(rows)).flat_map(|index| {
        let inner = curves_around(rows, index, |at| at.contact.angle_inner.to_degrees());
        let outer = curves_around(rows, index, |at| at.contact.angle_outer.to_degrees());
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
    let figure = Figure::new("contact_angle", title, 2, panels.collect());
    figure.with_names(values(variable, rows))
}

fn bearings(rows: &[StudyRow]) -> usize {
    rows.first().map_or(0, |row| row.around.len())
}

/// One quantity around bearing `index`, a curve a value of the variable.
fn curves_around(rows: &[StudyRow], index: usize, value: impl Fn(&Around) -> f64) -> Vec<Curve> {
    let curve = |(place, row): (usize, &StudyRow)| {
        let values = row.around[index].iter().map(|at| (at.azimuth, value(at)));
        Curve::line(graded(place, rows.len()), all_around(turned(values)))
    };
    rows.iter().enumerate().map(curve).collect()
}

fn panel(rows: &[StudyRow], index: usize, name: &str, curves: Vec<Curve>) -> Panel {
    let name = of_bearing(index, bearings(rows)) + name;
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
        let points = curve.points.iter().map(|(at, value)| (*at, value - mean));
        Curve::line(curve.colour, points.collect())
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
    let mut few = (4..=MOST_NAMES).rev();
    let even = few.find(|shown| (count - 1).is_multiple_of(shown - 1));
    even.unwrap_or(MOST_NAMES)
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
