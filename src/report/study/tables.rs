//! `study.csv`, one row a value, and `around.csv`, one row for each value, bearing and position around it.

use super::super::table::Table;
use super::column_name;
use crate::analysis::Channel;
use crate::bearing::{Around, BallLine, BearingState};
use crate::rotor::FREEDOMS;
use crate::study::{StudyRow, Variable};

/// A column of the whole shaft.
type ShaftColumn = (&'static str, fn(&StudyRow) -> Option<f64>);
/// A column of one bearing, after `bearing_1_`.
type BearingColumn = (&'static str, fn(&BearingState) -> Option<f64>);
/// A column of a position around a bearing.
type AroundColumn = (&'static str, fn(&Around) -> f64);

const SHAFT: [ShaftColumn; 9] = [
    ("K_x_N_m", |row| Some(row.answer.stiffness[(0, 0)])),
    ("K_y_N_m", |row| Some(row.answer.stiffness[(1, 1)])),
    ("K_z_N_m", |row| Some(row.answer.stiffness[(2, 2)])),
    ("K_tilt_x_N_m_rad", |row| Some(row.answer.stiffness[(3, 3)])),
    ("K_tilt_y_N_m_rad", |row| Some(row.answer.stiffness[(4, 4)])),
    ("condition", |row| Some(row.answer.condition)),
    ("residual", |row| Some(row.answer.residual)),
    ("moment_z_N_m", |row| {
        row.answer.twist.map(|twist| twist.moment)
    }),
    ("twist_rad", |row| row.answer.twist.map(|twist| twist.angle)),
];

const BEARING: [BearingColumn; 12] = [
    ("balls_loaded", |state| Some(state.balls_loaded as f64)),
    ("largest_load_inner_N", |state| {
        largest(state, |ball| ball.inner.load)
    }),
    ("smallest_load_inner_N", |state| {
        smallest(state, |ball| ball.inner.load)
    }),
    ("largest_load_outer_N", |state| {
        largest(state, |ball| ball.outer.load)
    }),
    ("smallest_load_outer_N", |state| {
        smallest(state, |ball| ball.outer.load)
    }),
    ("largest_angle_inner_rad", |state| {
        largest(state, |ball| ball.inner.angle)
    }),
    ("smallest_angle_inner_rad", |state| {
        smallest(state, |ball| ball.inner.angle)
    }),
    ("swing_of_angle_inner_rad", |state| {
        let largest = largest(state, |ball| ball.inner.angle);
        Some(largest? - smallest(state, |ball| ball.inner.angle)?)
    }),
    ("largest_pressure_Pa", |state| {
        largest(state, |ball| {
            ball.inner.peak_pressure.max(ball.outer.peak_pressure)
        })
    }),
    ("life_Mrev", |state| state.life),
    ("static_safety", |state| state.static_safety),
    ("friction_moment_N_m", |state| {
        Some(state.friction_moment.total())
    }),
];

const AROUND: [AroundColumn; 6] = [
    ("azimuth_rad", |place| place.azimuth),
    ("deformation_m", |place| place.deformation),
    ("load_inner_N", |place| place.contact.load_inner),
    ("load_outer_N", |place| place.contact.load_outer),
    ("angle_inner_rad", |place| place.contact.angle_inner),
    ("angle_outer_rad", |place| place.contact.angle_outer),
];

/// The answer at every value.
pub(super) fn answers(variable: &Variable, rows: &[StudyRow]) -> Table {
    let mut table = Table::default();
    table.numbers(column_name(variable), rows.iter().map(|row| row.value));
    for axis in 0..FREEDOMS {
        let values = rows.iter().map(|row| row.answer.displacement[axis]);
        table.numbers(Channel::Displacement(axis).column(), values);
    }
    for axis in 0..FREEDOMS {
        let values = rows.iter().map(|row| row.answer.force[axis]);
        table.numbers(Channel::Force(axis).column(), values);
    }
    for (name, value) in SHAFT {
        table.numbers(name, rows.iter().map(value));
    }
    let bearings = rows.iter().map(|row| row.answer.bearings.len()).max();
    for bearing in 0..bearings.unwrap_or(0) {
        for (name, value) in BEARING {
            let values = rows
                .iter()
                .map(|row| row.answer.bearings.get(bearing).and_then(value));
            table.numbers(format!("bearing_{}_{name}", bearing + 1), values);
        }
    }
    table
}

/// Every bearing all around at every value; bearings and positions count from 1.
pub(super) fn around(variable: &Variable, rows: &[StudyRow]) -> Table {
    let places = rows.iter().flat_map(|row| {
        row.around
            .iter()
            .enumerate()
            .flat_map(move |(bearing, around)| {
                let places = around.iter().enumerate();
                places.map(move |(position, place)| (row.value, [bearing + 1, position + 1], place))
            })
    });
    let places: Vec<(f64, [usize; 2], &Around)> = places.collect();
    let mut table = Table::default();
    table.numbers(
        column_name(variable),
        places.iter().map(|(value, ..)| *value),
    );
    for (count, name) in ["bearing", "position"].into_iter().enumerate() {
        table.counts(
            name,
            places.iter().map(|(_, counts, _)| counts[count] as f64),
        );
    }
    for (name, value) in AROUND {
        table.numbers(name, places.iter().map(|(.., place)| value(place)));
    }
    table
}

fn largest(state: &BearingState, value: fn(&BallLine) -> f64) -> Option<f64> {
    state.balls.iter().map(value).reduce(f64::max)
}

fn smallest(state: &BearingState, value: fn(&BallLine) -> f64) -> Option<f64> {
    state.balls.iter().map(value).reduce(f64::min)
}
