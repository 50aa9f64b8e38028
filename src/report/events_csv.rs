//! The events of a run as CSV, written while the run goes on.

use std::io::{self, Write};

use crate::simulate::Event;

/// Columns of `events.csv`, in their order.
pub const EVENT_COLUMNS: [&str; 4] = ["t_s", "event", "bearing", "ball"];

/// Writes one row an event; bearings and balls count from 1, and what happens to a bearing as a
/// whole has no ball.
#[derive(Debug)]
pub struct EventsCsv<W: Write> {
    writer: csv::Writer<W>,
}

impl<W: Write> EventsCsv<W> {
    /// Writes the header.
    ///
    /// # Errors
    /// What the writer answers.
    pub fn new(writer: W) -> io::Result<Self> {
        let mut writer = csv::WriterBuilder::new()
            .has_headers(false)
            .from_writer(writer);
        writer.write_record(EVENT_COLUMNS)?;
        Ok(Self { writer })
    }

    /// Writes a row.
    ///
    /// # Errors
    /// What the writer answers.
    pub fn row(&mut self, event: &Event) -> io::Result<()> {
        let ball = event.ball.map(|ball| ball + 1);
        let row = (event.time, event.kind.name(), event.bearing + 1, ball);
        self.writer.serialize(row).map_err(io::Error::from)
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
