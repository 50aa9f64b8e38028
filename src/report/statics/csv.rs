//! `balls.csv`: one row for each ball of each bearing.

use std::io::{self, Write};

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

/// A number in the shortest form that reads back to the same value.
pub(in super::super) fn number(value: f64) -> String {
    format!("{value:?}")
}

/// A number, or an empty cell.
pub(in super::super) fn cell(value: Option<f64>) -> String {
    value.map(number).unwrap_or_default()
}

/// Writes the table.
pub(super) fn write_balls<W: Write>(answer: &QuasiStatic, writer: W) -> io::Result<()> {
    let mut writer = csv::Writer::from_writer(writer);
    writer.write_record(header())?;
    for (bearing, state) in answer.bearings.iter().enumerate() {
        for (ball, line) in state.balls.iter().enumerate() {
            writer.write_record(row(bearing + 1, ball + 1, line))?;
        }
    }
    writer.flush()
}

fn header() -> Vec<String> {
    let before = ["bearing", "ball", "azimuth_rad", "deformation_m"];
    let contacts = ["inner", "outer"]
        .into_iter()
        .flat_map(|race| CONTACT.map(|(name, _)| format!("{race}_{name}")));
    let after = [
        "centrifugal_force_N",
        "gyroscopic_moment_N_m",
        "controlling_race",
    ];
    let before = before.into_iter().map(str::to_owned);
    let after = after.into_iter().map(str::to_owned);
    before.chain(contacts).chain(after).collect()
}

fn row(bearing: usize, ball: usize, line: &BallLine) -> Vec<String> {
    let mut row = vec![bearing.to_string(), ball.to_string()];
    row.extend([line.azimuth, line.deformation].map(number));
    for contact in [&line.inner, &line.outer] {
        row.extend(CONTACT.map(|(_, value)| cell(value(contact))));
    }
    row.extend([line.centrifugal_force, line.gyroscopic_moment].map(number));
    row.push(
        line.controlling_race
            .map(race_name)
            .unwrap_or_default()
            .to_owned(),
    );
    row
}

/// `inner` or `outer`.
pub(super) fn race_name(race: Race) -> &'static str {
    match race {
        Race::Inner => "inner",
        Race::Outer => "outer",
    }
}
