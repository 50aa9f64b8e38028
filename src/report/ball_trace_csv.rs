//! Loads and contact angles of every ball along a run as CSV, written while the run goes on.

use std::io::{self, Write};

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

/// Writes one row a sample: time, shaft angle, and `bearing1_ball1_inner_load_N` … of every ball,
/// bearings and balls counted from 1.
///
/// Numbers stand in the shortest form that reads back to the same value.
#[derive(Debug)]
pub struct BallTraceCsv<W: Write> {
    writer: csv::Writer<W>,
    /// Kept from row to row for its room; empty before the header is written.
    row: Vec<f64>,
}

impl<W: Write> BallTraceCsv<W> {
    /// The header waits for the first sample, which knows the balls.
    pub fn new(writer: W) -> Self {
        Self {
            writer: csv::WriterBuilder::new()
                .has_headers(false)
                .from_writer(writer),
            row: Vec::new(),
        }
    }

    /// Writes a row.
    ///
    /// # Errors
    /// What the writer answers.
    pub fn row(&mut self, sample: &Sample, contacts: &BallContacts) -> io::Result<()> {
        if self.row.is_empty() {
            self.writer.write_record(columns(contacts))?;
        }
        self.row.clear();
        self.row.extend([sample.time, sample.angle]);
        for ball in contacts.bearings().flatten() {
            self.row.extend(BALL.map(|(_, value)| value(ball)));
        }
        self.writer.serialize(&self.row).map_err(io::Error::from)
    }

    /// Gives the writer back, with everything written.
    ///
    /// # Errors
    /// What the writer answers.
    pub fn finish(self) -> io::Result<W> {
        self.writer
            .into_inner()
            .map_err(csv::IntoInnerError::into_error)
    }
}

fn columns(contacts: &BallContacts) -> Vec<String> {
    let mut columns = vec!["t_s".to_owned(), "angle_rad".to_owned()];
    for (bearing, balls) in contacts.bearings().enumerate() {
        for ball in 0..balls.len() {
            let name = |(end, _)| format!("bearing{}_ball{}_{end}", bearing + 1, ball + 1);
            columns.extend(BALL.map(name));
        }
    }
    columns
}
