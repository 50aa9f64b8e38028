//! The answer to a static question as a person reads it, in at most 100 columns.

use std::fmt::Write;
use std::path::PathBuf;

use comfy_table::{CellAlignment, Table, presets};

use super::super::text::decimal;
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
    let mut out = format!("{title}\n");
    line(&mut out, "equilibrium", &displacement(answer));
    line(&mut out, "held", &held(answer));
    line(&mut out, "force", &force(answer));
    line(&mut out, "twist", &twist(answer));
    line(&mut out, "stiffness", &diagonal(&answer.stiffness));
    line(&mut out, "condition", &condition(answer.condition));
    let steps = answer.newton_steps;
    let search = format!("{steps} Newton steps, residual {:.1e}", answer.residual);
    line(&mut out, "search", &search);
    block(&mut out, &stiffness_table(&answer.stiffness));
    for (index, state) in answer.bearings.iter().enumerate() {
        bearing(&mut out, index + 1, state);
    }
    for file in files {
        line(&mut out, "wrote", &file.display().to_string());
    }
    out
}

/// A named line; none where there is nothing to say.
fn line(out: &mut String, name: &str, text: &str) {
    if !text.is_empty() {
        writeln!(out, "  {name:<13} {text}").expect("a String takes everything");
    }
}

/// A table between blank lines.
fn block(out: &mut String, table: &Table) {
    writeln!(out, "\n{}\n", table.trim_fmt()).expect("a String takes everything");
}

fn displacement(answer: &QuasiStatic) -> String {
    let places = NAMES.iter().zip(PLACES).zip(answer.displacement);
    let shown =
        places.map(|((name, unit), value)| format!("{name} {} {unit}", decimal(MICRO * value)));
    shown.collect::<Vec<_>>().join(", ")
}

fn held(answer: &QuasiStatic) -> String {
    let held = NAMES.iter().zip(answer.free).filter(|(_, free)| !free);
    held.map(|(name, _)| *name).collect::<Vec<_>>().join(", ")
}

fn force(answer: &QuasiStatic) -> String {
    let parts = FORCES.iter().zip(answer.force);
    let shown = parts.map(|((name, unit), value)| format!("{name} {} {unit}", decimal(value)));
    shown.collect::<Vec<_>>().join(", ")
}

fn twist(answer: &QuasiStatic) -> String {
    answer.twist.map_or_else(String::new, |twist| {
        format!(
            "Mz {} N mm, θz {} µrad",
            decimal(MILLI * twist.moment),
            decimal(MICRO * twist.angle)
        )
    })
}

/// K_x … K_θy in N/µm and N m/mrad.
fn diagonal(stiffness: &Matrix5) -> String {
    let shown = |axes: std::ops::Range<usize>, scale: f64| {
        let terms = axes.map(|axis| {
            let term = stiffness[(axis, axis)] / scale;
            format!("K_{} {}", NAMES[axis], digits(term))
        });
        terms.collect::<Vec<_>>().join(", ")
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
fn stiffness_table(stiffness: &Matrix5) -> Table {
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
    table(header, rows)
}

fn bearing(out: &mut String, number: usize, state: &BearingState) {
    writeln!(out, "bearing {number}").expect("a String takes everything");
    line(out, "balls loaded", &state.balls_loaded.to_string());
    let life = state
        .life
        .map(|life| format!("{life:.4e} million revolutions"));
    line(out, "life L10r", &life.unwrap_or_default());
    let safety = state.static_safety.map(|safety| format!("{safety:.3}"));
    line(out, "static safety", &safety.unwrap_or_default());
    let friction = state.friction_moment;
    let parts = format!(
        "{} N mm: load {}, viscous {}",
        decimal(MILLI * friction.total()),
        decimal(MILLI * friction.load),
        decimal(MILLI * friction.viscous)
    );
    line(out, "friction", &parts);
    let pass = state.ball_pass;
    let pass = format!(
        "outer race {:.3} Hz, inner race {:.3} Hz, ball spin {:.3} Hz, cage {:.3} Hz",
        pass.outer, pass.inner, pass.spin, pass.cage
    );
    line(out, "ball pass", &pass);
    if let Some(shares) = &state.shares {
        line(out, "of contacts", &diagonal(&shares.contacts));
        line(out, "of films", &diagonal(&shares.films));
    }
    if !state.balls.is_empty() {
        block(out, &ball_table(&state.balls));
    }
}

/// A column of the ball table.
struct Column {
    header: &'static str,
    cell: fn(&BallLine) -> String,
}

const PLACE: [Column; 7] = [
    Column {
        header: "φ\ndeg",
        cell: |line| format!("{:.1}", line.azimuth.to_degrees()),
    },
    Column {
        header: "Qi\nN",
        cell: |line| format!("{:.1}", line.inner.load),
    },
    Column {
        header: "Qo\nN",
        cell: |line| format!("{:.1}", line.outer.load),
    },
    Column {
        header: "αi\ndeg",
        cell: |line| angle(&line.inner),
    },
    Column {
        header: "αo\ndeg",
        cell: |line| angle(&line.outer),
    },
    Column {
        header: "δ\nµm",
        cell: |line| format!("{:.3}", MICRO * line.deformation),
    },
    Column {
        header: "pmax\nMPa",
        cell: |line| format!("{:.0}", worst(line, |c| c.peak_pressure) / 1e6),
    },
];

const FILM: [Column; 2] = [
    Column {
        header: "hmin\nµm",
        cell: |line| thinnest(line, |film| Some(MICRO * film.minimum)),
    },
    Column {
        header: "λ\n",
        cell: |line| thinnest(line, |film| film.lambda),
    },
];

const INERTIA: [Column; 3] = [
    Column {
        header: "Fc\nN",
        cell: |line| format!("{:.2}", line.centrifugal_force),
    },
    Column {
        header: "Mg\nN mm",
        cell: |line| format!("{:.3}", MILLI * line.gyroscopic_moment),
    },
    Column {
        header: "control\n",
        cell: |line| line.controlling_race.map_or("–", race_name).to_owned(),
    },
];

const SPIN: [Column; 1] = [Column {
    header: "spin/\nroll",
    cell: |line| format!("{:.3}", worst(line, |contact| contact.spin_to_roll.abs())),
}];

/// Ball by ball; films and inertia where the bearing has them.
fn ball_table(balls: &[BallLine]) -> Table {
    let films = balls
        .iter()
        .any(|line| line.inner.film.or(line.outer.film).is_some());
    let inertia = balls.iter().any(|line| line.centrifugal_force != 0.0);
    let mut columns: Vec<&Column> = PLACE.iter().collect();
    columns.extend(FILM.iter().filter(|_| films));
    columns.extend(INERTIA.iter().filter(|_| inertia));
    columns.extend(&SPIN);
    let header = std::iter::once("ball").chain(columns.iter().map(|column| column.header));
    let rows = balls.iter().enumerate().map(|(index, line)| {
        let cells = columns.iter().map(|column| (column.cell)(line));
        std::iter::once((index + 1).to_string())
            .chain(cells)
            .collect()
    });
    table(header, rows)
}

/// The larger value of both contacts.
fn worst(line: &BallLine, value: fn(&RaceContact) -> f64) -> f64 {
    value(&line.inner).max(value(&line.outer))
}

/// The smaller value of both films.
fn thinnest(line: &BallLine, value: impl Fn(&FilmState) -> Option<f64>) -> String {
    let films = [line.inner.film, line.outer.film].into_iter().flatten();
    let smallest = films.filter_map(|film| value(&film)).reduce(f64::min);
    smallest.map_or_else(|| "–".to_owned(), |value| format!("{value:.3}"))
}

/// The contact angle; an unloaded contact has none.
fn angle(contact: &RaceContact) -> String {
    if contact.load > 0.0 {
        format!("{:.3}", contact.angle.to_degrees())
    } else {
        "–".to_owned()
    }
}

/// A table without lines, everything but its first column to the right.
pub(in super::super) fn table<'a>(
    header: impl Iterator<Item = &'a str>,
    rows: impl Iterator<Item = Vec<String>>,
) -> Table {
    let mut table = Table::new();
    table.load_style(presets::NOTHING).set_header(header);
    for row in rows {
        table.add_row(row);
    }
    for column in table.column_iter_mut().skip(1) {
        column.set_cell_alignment(CellAlignment::Right);
        column.set_padding((1, 0));
    }
    table
}

/// Five significant digits; powers of ten where they would be many.
pub(in super::super) fn digits(value: f64) -> String {
    let size = value.abs();
    if value == 0.0 {
        "0".to_owned()
    } else if (1e-3..1e5).contains(&size) {
        let decimals = (4.0 - size.log10().floor()).max(0.0) as usize;
        format!("{value:.decimals$}")
    } else {
        format!("{value:.3e}")
    }
}
