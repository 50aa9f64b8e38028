//! The answer to a static question as a person reads it, in at most 100 columns.

use std::path::PathBuf;

use super::super::terminal::{Lines, clearance_text, decimal, digits, listed, or_dash};
use super::ball_table::race_name;
use crate::bearing::{BallLine, BearingState, FilmState, Matrix5, RaceContact};
use crate::quasi_static::QuasiStatic;
use crate::report::units::{MICRO, MILLI};
use crate::rotor::FREEDOMS;

/// A coupling below this part of its diagonal terms is what round-off left of zero.
const ROUND_OFF: f64 = 1e-12;

/// Names of the freedoms, and how displacements and forces along them are shown.
const NAMES: [&str; FREEDOMS] = ["x", "y", "z", "θx", "θy"];
const PLACES: [&str; FREEDOMS] = ["µm", "µm", "µm", "µrad", "µrad"];
const FORCES: [(&str, &str); FREEDOMS] = [
    ("Fx", "N"),
    ("Fy", "N"),
    ("Fz", "N"),
    ("Mx", "N m"),
    ("My", "N m"),
];

/// Equilibrium, stiffness and every bearing with its balls; then the files written.
pub fn answer_text(title: &str, answer: &QuasiStatic, files: &[PathBuf]) -> String {
    let mut out = Lines::titled(title);
    let displacement = NAMES.iter().zip(PLACES).zip(answer.displacement);
    let displacement = displacement
        .map(|((name, unit), value)| format!("{name} {} {unit}", decimal(MICRO * value)));
    out.line("equilibrium", listed(displacement));
    let held = NAMES.iter().zip(answer.free).filter(|(_, free)| !free);
    out.line("held", listed(held.map(|(name, _)| (*name).to_owned())));
    let force = FORCES.iter().zip(answer.force);
    let force = force.map(|((name, unit), value)| format!("{name} {} {unit}", decimal(value)));
    out.line("force", listed(force));
    if let Some(twist) = answer.twist {
        let (moment, angle) = (MILLI * twist.moment, MICRO * twist.angle);
        let text = format!("Mz {} N mm, θz {} µrad", decimal(moment), decimal(angle));
        out.line("twist", text);
    }
    out.line("stiffness", diagonal(&answer.stiffness));
    out.line("condition", condition(answer.condition));
    let steps = answer.newton_steps;
    let search = format!("{steps} Newton steps, residual {:.1e}", answer.residual);
    out.line("search", search);
    put_stiffness(&mut out, &answer.stiffness);
    for (index, state) in answer.bearings.iter().enumerate() {
        put_bearing(&mut out, index + 1, state);
    }
    out.wrote(files)
}

/// K_x … K_θy in N/µm and N m/mrad.
fn diagonal(stiffness: &Matrix5) -> String {
    let shown = |axes: std::ops::Range<usize>, scale: f64| {
        let term = |axis| digits(stiffness[(axis, axis)] / scale);
        listed(axes.map(|axis| format!("K_{} {}", NAMES[axis], term(axis))))
    };
    let (along, about) = (shown(0..3, MICRO), shown(3..FREEDOMS, MILLI));
    format!("{along} N/µm; {about} N m/mrad")
}

fn condition(condition: f64) -> String {
    if condition.is_finite() {
        digits(condition)
    } else {
        "infinite: the stiffness is singular".to_owned()
    }
}

/// K, a micrometre or a milliradian a column.
fn put_stiffness(out: &mut Lines, stiffness: &Matrix5) {
    let columns = ["x\n/µm", "y\n/µm", "z\n/µm", "θx\n/mrad", "θy\n/mrad"];
    let header = std::iter::once("K").chain(columns);
    let rows = FORCES.iter().enumerate().map(|(row, (name, unit))| {
        let cells = (0..FREEDOMS).map(|column| {
            let scale = if column < 3 { MICRO } else { MILLI };
            let term = stiffness[(row, column)];
            let diagonal = stiffness[(row, row)] * stiffness[(column, column)];
            let noise = ROUND_OFF * diagonal.abs().sqrt();
            digits(if term.abs() < noise {
                0.0
            } else {
                term / scale
            })
        });
        std::iter::once(format!("{name} in {unit}"))
            .chain(cells)
            .collect()
    });
    out.table(header, rows);
}

fn put_bearing(out: &mut Lines, number: usize, state: &BearingState) {
    out.put(format_args!("bearing {number}"));
    if let Some(clearance) = &state.clearance {
        out.line("clearance", clearance_text(clearance));
    }
    out.line("balls loaded", state.balls_loaded);
    if let Some(life) = state.life {
        out.line("life L10r", format!("{life:.4e} million revolutions"));
    }
    if let Some(safety) = state.static_safety {
        out.line("static safety", format!("{safety:.3}"));
    }
    let friction = &state.friction_moment;
    let [total, load, viscous] =
        [friction.total(), friction.load, friction.viscous].map(|moment| decimal(MILLI * moment));
    let text = format!("{total} N mm: load {load}, viscous {viscous}");
    out.line("friction", text);
    let pass = &state.ball_pass;
    let pass = format!(
        "outer race {:.3} Hz, inner race {:.3} Hz, ball spin {:.3} Hz, cage {:.3} Hz",
        pass.outer, pass.inner, pass.spin, pass.cage
    );
    out.line("ball pass", pass);
    if let Some(shares) = &state.shares {
        out.line("of contacts", diagonal(&shares.contacts));
        out.line("of films", diagonal(&shares.films));
    }
    if !state.balls.is_empty() {
        put_balls(out, &state.balls);
    }
}

/// A column of the ball table: its title and its cells.
type Column = (&'static str, fn(&BallLine) -> String);

const PLACE: [Column; 7] = [
    ("φ\ndeg", |line| {
        format!("{:.1}", line.azimuth.to_degrees())
    }),
    ("Qi\nN", |line| format!("{:.1}", line.inner.load)),
    ("Qo\nN", |line| format!("{:.1}", line.outer.load)),
    ("αi\ndeg", |line| angle(&line.inner)),
    ("αo\ndeg", |line| angle(&line.outer)),
    ("δ\nµm", |line| format!("{:.3}", MICRO * line.deformation)),
    ("pmax\nMPa", |line| {
        format!("{:.0}", worst(line, |c| c.peak_pressure) / 1e6)
    }),
];

const FILM: [Column; 2] = [
    ("hmin\nµm", |line| {
        thinnest(line, |film| Some(MICRO * film.minimum))
    }),
    ("λ\n", |line| thinnest(line, |film| film.lambda)),
];

const INERTIA: [Column; 3] = [
    ("Fc\nN", |line| format!("{:.2}", line.centrifugal_force)),
    ("Mg\nN mm", |line| {
        format!("{:.3}", MILLI * line.gyroscopic_moment)
    }),
    ("control\n", |line| {
        or_dash(line.controlling_race.map(|race| race_name(race).to_owned()))
    }),
];

const SPIN: [Column; 1] = [("spin/\nroll", |line| {
    format!("{:.3}", worst(line, |contact| contact.spin_to_roll.abs()))
})];

/// Ball by ball; films and inertia where the bearing has them.
fn put_balls(out: &mut Lines, balls: &[BallLine]) {
    let films = balls
        .iter()
        .any(|line| line.inner.film.or(line.outer.film).is_some());
    let inertia = balls.iter().any(|line| line.centrifugal_force != 0.0);
    let mut columns: Vec<&Column> = PLACE.iter().collect();
    columns.extend(FILM.iter().filter(|_| films));
    columns.extend(INERTIA.iter().filter(|_| inertia));
    columns.extend(&SPIN);
    let header = std::iter::once("ball").chain(columns.iter().map(|(title, _)| *title));
    let rows = balls.iter().enumerate().map(|(index, line)| {
        let cells = columns.iter().map(|(_, cell)| cell(line));
        std::iter::once((index + 1).to_string())
            .chain(cells)
            .collect()
    });
    out.table(header, rows);
}

/// The larger value of both contacts.
fn worst(line: &BallLine, value: fn(&RaceContact) -> f64) -> f64 {
    value(&line.inner).max(value(&line.outer))
}

/// The smaller value of both films.
fn thinnest(line: &BallLine, value: impl Fn(&FilmState) -> Option<f64>) -> String {
    let films = [line.inner.film, line.outer.film].into_iter().flatten();
    let smallest = films.filter_map(|film| value(&film)).reduce(f64::min);
    or_dash(smallest.map(|value| format!("{value:.3}")))
}

/// The contact angle; an unloaded contact has none.
fn angle(contact: &RaceContact) -> String {
    let angle = || format!("{:.3}", contact.angle.to_degrees());
    or_dash((contact.load > 0.0).then(angle))
}
