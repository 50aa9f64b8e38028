//! `balls.csv`: one row for each ball of each bearing.

use super::super::table::Table;
use crate::bearing::{BallLine, RaceContact};
use crate::physics::Race;
use crate::quasi_static::QuasiStatic;

/// Columns of one contact, after `inner_` or `outer_`.
type ContactColumn = (&'static str, fn(&RaceContact) -> Option<f64>);

const CONTACT: [ContactColumn; 13] = [
    ("load_N", |contact| Some(contact.load)),
    ("angle_rad", |contact| Some(contact.angle)),
    ("approach_m", |contact| Some(contact.approach)),
    ("semi_major_m", |contact| Some(contact.semi_major)),
    ("semi_minor_m", |contact| Some(contact.semi_minor)),
    ("peak_pressure_Pa", |contact| Some(contact.peak_pressure)),
    ("contact_stiffness_N_m", |contact| {
        Some(contact.contact_stiffness)
    }),
    ("film_central_m", |contact| {
        contact.film.map(|film| film.central)
    }),
    ("film_minimum_m", |contact| {
        contact.film.map(|film| film.minimum)
    }),
    ("film_stiffness_N_m", |contact| {
        contact.film.map(|film| film.stiffness)
    }),
    ("film_lambda", |contact| {
        contact.film.and_then(|film| film.lambda)
    }),
    ("spin_to_roll", |contact| Some(contact.spin_to_roll)),
    ("shoulder_margin_rad", |contact| contact.shoulder_margin),
];

/// The balls of all bearings, both numbered from 1 on.
pub(super) fn balls(answer: &QuasiStatic) -> Table {
    let bearings = answer.bearings.iter().enumerate();
    let balls: Vec<(usize, usize, &BallLine)> = bearings
        .flat_map(|(bearing, state)| {
            let balls = state.balls.iter().enumerate();
            balls.map(move |(ball, line)| (bearing + 1, ball + 1, line))
        })
        .collect();
    let lines = || balls.iter().map(|(.., line)| *line);
    let mut table = Table::default();
    table.counts("bearing", balls.iter().map(|(bearing, ..)| *bearing as f64));
    table.counts("ball", balls.iter().map(|(_, ball, _)| *ball as f64));
    table.numbers("azimuth_rad", lines().map(|line| line.azimuth));
    table.numbers("deformation_m", lines().map(|line| line.deformation));
    for (name, value) in CONTACT {
        table.numbers(
            format!("inner_{name}"),
            lines().map(|line| value(&line.inner)),
        );
    }
    for (name, value) in CONTACT {
        table.numbers(
            format!("outer_{name}"),
            lines().map(|line| value(&line.outer)),
        );
    }
    table.numbers(
        "centrifugal_force_N",
        lines().map(|line| line.centrifugal_force),
    );
    table.numbers(
        "gyroscopic_moment_N_m",
        lines().map(|line| line.gyroscopic_moment),
    );
    let controlling = lines().map(|line| line.controlling_race.map(race_name).unwrap_or_default());
    table.words("controlling_race", controlling);
    table
}

/// `inner` or `outer`.
pub(super) fn race_name(race: Race) -> &'static str {
    match race {
        Race::Inner => "inner",
        Race::Outer => "outer",
    }
}
