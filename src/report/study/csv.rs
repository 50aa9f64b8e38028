//! `study.csv`: one row a value.

use std::io::{self, Write};

use super::super::table::{cell, number};
use super::column_name;
use crate::analysis::Channel;
use crate::bearing::{BallLine, BearingState};
use crate::rotor::FREEDOMS;
use crate::study::{StudyRow, Variable};

/// A column of the whole shaft.
type ShaftColumn = (&'static str, fn(&StudyRow) -> Option<f64>);
/// A column of one bearing, after `bearing_1_`.
type BearingColumn = (&'static str, fn(&BearingState) -> Option<f64>);

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

/// Writes the table.
pub(super) fn write<W: Write>(variable: &Variable, rows: &[StudyRow], writer: W) -> io::Result<()> {
    let bearings = rows.iter().map(|row| row.answer.bearings.len()).max();
    let mut writer = csv::Writer::from_writer(writer);
    writer.write_record(header(variable, bearings.unwrap_or(0)))?;
    for row in rows {
        writer.write_record(record(row))?;
    }
    writer.flush()
}

fn header(variable: &Variable, bearings: usize) -> Vec<String> {
    let mut names = vec![column_name(variable)];
    names.extend(
        (0..FREEDOMS)
            .map(Channel::Displacement)
            .map(Channel::column),
    );
    names.extend((0..FREEDOMS).map(Channel::Force).map(Channel::column));
    names.extend(SHAFT.map(|(name, _)| name.to_owned()));
    for bearing in 1..=bearings {
        names.extend(BEARING.map(|(name, _)| format!("bearing_{bearing}_{name}")));
    }
    names
}

fn record(row: &StudyRow) -> Vec<String> {
    let mut cells = vec![number(row.value)];
    cells.extend(row.answer.displacement.map(number));
    cells.extend(row.answer.force.map(number));
    cells.extend(SHAFT.map(|(_, value)| cell(value(row))));
    for state in &row.answer.bearings {
        cells.extend(BEARING.map(|(_, value)| cell(value(state))));
    }
    cells
}

fn largest(state: &BearingState, value: fn(&BallLine) -> f64) -> Option<f64> {
    state.balls.iter().map(value).reduce(f64::max)
}

fn smallest(state: &BearingState, value: fn(&BallLine) -> f64) -> Option<f64> {
    state.balls.iter().map(value).reduce(f64::min)
}
