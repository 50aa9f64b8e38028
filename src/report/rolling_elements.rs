//! The rolling elements of bearings: their table, and their figure all around the shaft.

use super::figure::{Axis, Curve, Figure, Name, Panel, all_around, distinct, turned};
use super::terminal::of_bearing;
use crate::bearing::{BallLine, BearingState, FilmState, RaceContact};
use crate::physics::Race;
use crate::table::{Named, Table};

/// What is given of the balls, of pressure, film and spin at the inner race; films and inertia where the bearing has them.
pub(super) const SHOWN: [(&str, &str); 15] = [
    ("row", "row"),
    ("ball", "ball"),
    ("φ", "azimuth"),
    ("Qi", "inner_load"),
    ("Qo", "outer_load"),
    ("αi", "inner_angle"),
    ("αo", "outer_angle"),
    ("δ", "deformation"),
    ("pi", "inner_peak_pressure"),
    ("hi", "inner_film_minimum"),
    ("λi", "inner_film_lambda"),
    ("Fc", "centrifugal_force"),
    ("Mg", "gyroscopic_moment"),
    ("race", "controlling_race"),
    ("spin", "inner_spin_to_roll"),
];

/// Columns of one contact, after `inner_` or `outer_`.
pub(super) const CONTACT: [Named<RaceContact>; 13] = [
    ("load", "N", |own| own.load),
    ("angle", "rad", |own| own.angle),
    ("approach", "m", |own| own.approach),
    ("semi_major", "m", |own| own.semi_major),
    ("semi_minor", "m", |own| own.semi_minor),
    ("peak_pressure", "Pa", |own| own.peak_pressure),
    ("contact_stiffness", "N/m", |own| own.contact_stiffness),
    ("film_central", "m", |own| film(own, |film| film.central)),
    ("film_minimum", "m", |own| film(own, |film| film.minimum)),
    ("film_stiffness", "N/m", |own| {
        film(own, |film| film.stiffness)
    }),
    ("film_lambda", "", |own| {
        film(own, |film| film.lambda.unwrap_or(f64::NAN))
    }),
    ("spin_to_roll", "", |own| own.spin_to_roll),
    ("shoulder_margin", "rad", |own| {
        own.shoulder_margin.unwrap_or(f64::NAN)
    }),
];

pub(super) fn film(contact: &RaceContact, value: fn(&FilmState) -> f64) -> f64 {
    contact.film.as_ref().map_or(f64::NAN, value)
}

/// Columns of a ball besides its contacts.
pub(super) const INERTIAS: [Named<BallLine>; 2] = [
    ("centrifugal_force", "N", |line| line.centrifugal_force),
    ("gyroscopic_moment", "N m", |line| line.gyroscopic_moment),
];

/// The balls of bearings with their numbers and rows; balls count from 1, row after row.
pub(super) fn balls_table<'a>(
    bearings: impl IntoIterator<Item = (usize, &'a BearingState)>,
) -> Table<'static> {
    let balls = bearings.into_iter().flat_map(|(bearing, state)| {
        let balls = (1..).zip(&state.balls);
        balls.map(move |(ball, line)| (bearing, ball, line))
    });
    let balls: Vec<_> = balls.collect();
    Table::from_items(&balls)
        .headed(ROLLING_ELEMENTS)
        .count("bearing", |(bearing, ..)| *bearing as f64)
        .count("row", |(.., line)| line.row as f64)
        .count("ball", |(_, ball, _)| f64::from(*ball))
        .number("azimuth", "rad", |(.., line)| line.azimuth)
        .number("deformation", "m", |(.., line)| line.deformation)
        .named("inner_", &CONTACT, |(.., line)| Some(&line.inner))
        .named("outer_", &CONTACT, |(.., line)| Some(&line.outer))
        .named("", &INERTIAS, |(.., line)| Some(line))
        .word("controlling_race", |(.., line)| {
            line.controlling_race.map(race_name).unwrap_or_default()
        })
        .end()
}

/// What people read above the table and the figure `balls`, which may be of rollers.
pub(super) const ROLLING_ELEMENTS: &str = "Rolling elements";

/// `inner` or `outer`.
pub(super) fn race_name(race: Race) -> &'static str {
    match race {
        Race::Inner => "inner",
        Race::Outer => "outer",
    }
}

/// Height of a plot, px.
pub(super) const HEIGHT: u32 = 272;

/// Every ball of every bearing around the shaft: one row of two panels for each bearing.
pub(super) fn balls_figure(title: &str, bearings: &[&BearingState]) -> Option<Figure> {
    let named = bearings.iter().enumerate();
    let panels = named.flat_map(|(index, state)| panels(&of_bearing(index, bearings.len()), state));
    let names = Name::each([
        "inner race",
        "outer race",
        "inner race, row 2",
        "outer race, row 2",
    ]);
    let figure = Figure {
        heading: ROLLING_ELEMENTS.to_owned(),
        ..Figure::new("balls", title, 2, panels.collect()).with_names(names)
    };
    (!figure.panels.is_empty()).then_some(figure)
}

fn panels(bearing: &str, state: &BearingState) -> [Panel; 2] {
    let panel = |name: &str, unit: &str, value: fn(&RaceContact) -> f64| {
        let rows: Vec<_> = state.balls.chunk_by(|a, b| a.row == b.row).collect();
        // the outer race and the second row first: where all agree, the inner race of the first row is seen
        let curves = rows.iter().enumerate().rev().flat_map(|(row, balls)| {
            [
                curve(balls, 2 * row + 1, |line| value(&line.outer)),
                curve(balls, 2 * row, |line| value(&line.inner)),
            ]
        });
        let curves = curves.collect();
        let label = (format!("{bearing}{name}"), unit);
        Panel::holding(Axis::azimuth(), label, HEIGHT, curves)
    };
    let load = format!("{} load Q", state.geometry.elements.name());
    [
        panel(&load, "N", |contact| contact.load),
        panel("contact angle α", "deg", |contact| {
            contact.angle.to_degrees()
        }),
    ]
}

fn curve(balls: &[BallLine], colour: usize, value: impl Fn(&BallLine) -> f64) -> Curve {
    let marks = turned(balls.iter().map(|line| (line.azimuth, value(line))));
    Curve {
        marks: marks.clone(),
        ..Curve::line(distinct(colour), all_around(marks))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::quasi_static::quasi_static;
    use crate::scenario::Scenario;

    /// Under a thrust the rows of a spherical bearing bear differently: each has curves of its own, of its own rollers.
    #[test]
    fn rows_of_a_bearing_are_told_and_drawn_apart() {
        let text = include_str!("../../scenarios/conveyor-head-22212.toml");
        let scenario = Scenario::from_toml(text).expect("a shipped scenario");
        let answer = quasi_static(&scenario.question).expect("an answer");
        let state = &answer.bearings[0];
        let table = balls_table([(1, state)]);
        let [rows, loads] = ["row", "inner_load"].map(|name| {
            let (_, values) = table.column(name).expect("a column");
            values
        });
        let count = rows.len() / 2;
        let figure = balls_figure("", &[state]).expect("a figure");
        let curves = &figure.panels[0].curves;
        assert_eq!((curves.len(), figure.names.len()), (4, 4));
        for row in 0..2 {
            let own = row * count..(row + 1) * count;
            assert!(
                rows[own.clone()]
                    .iter()
                    .all(|value| *value == (row + 1) as f64)
            );
            let colour = distinct(2 * row);
            let inner = curves.iter().find(|curve| curve.colour == colour);
            let drawn = inner.expect("a curve").marks.iter().map(|mark| mark.1);
            assert_eq!(drawn.collect::<Vec<_>>(), loads[own]);
        }
    }
}
