//! Loads and contact angles of every ball along a run as rows of a table.

use super::table::Column;
use crate::bearing::BallContact;
use crate::rotor::{BallContacts, Sample};

/// What is written of one ball: the end of the column's name and the value.
type BallColumn = (&'static str, fn(&BallContact) -> f64);

/// Named as in the table of `jeffcott bearing`.
const BALL: [BallColumn; 4] = [
    ("inner_load_N", |ball| ball.load_inner),
    ("inner_angle_rad", |ball| ball.angle_inner),
    ("outer_load_N", |ball| ball.load_outer),
    ("outer_angle_rad", |ball| ball.angle_outer),
];

/// Columns of a table of balls: time, shaft angle, and `bearing1_ball1_inner_load_N` … of every ball,
/// bearings and balls counted from 1.
pub fn ball_columns(contacts: &BallContacts) -> Vec<Column> {
    let mut columns = vec![Column::number("t_s"), Column::number("angle_rad")];
    for (bearing, balls) in contacts.bearings().iter().enumerate() {
        for ball in 0..balls.balls() {
            let name = |(end, _)| format!("bearing{}_ball{}_{end}", bearing + 1, ball + 1);
            columns.extend(BALL.map(name).map(Column::number));
        }
    }
    columns
}

/// Puts the row of a sample into `row`.
pub fn ball_row(sample: &Sample, contacts: &BallContacts, row: &mut Vec<f64>) {
    row.clear();
    row.extend([sample.time, sample.angle]);
    for balls in contacts.bearings() {
        for contact in balls.contacts() {
            row.extend(BALL.map(|(_, value)| value(&contact)));
        }
    }
}
