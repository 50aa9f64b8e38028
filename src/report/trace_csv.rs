//! The trace as CSV, written while the run goes on.

use std::io::{self, Write};

use crate::rotor::{FREEDOMS, Sample};
use crate::simulate::TraceSink;

/// Columns of `trace.csv`, in their order. Forces are those of all bearings on the shaft.
pub const TRACE_COLUMNS: [&str; 20] = [
    "t_s",
    "angle_rad",
    "speed_rad_s",
    "x_m",
    "y_m",
    "z_m",
    "tilt_x_rad",
    "tilt_y_rad",
    "x_velocity_m_s",
    "y_velocity_m_s",
    "z_velocity_m_s",
    "tilt_x_velocity_rad_s",
    "tilt_y_velocity_rad_s",
    "force_x_N",
    "force_y_N",
    "force_z_N",
    "moment_x_N_m",
    "moment_y_N_m",
    "largest_ball_load_N",
    "balls_loaded",
];

/// One row of `trace.csv`.
type Row = (
    [f64; 3],
    [f64; FREEDOMS],
    [f64; FREEDOMS],
    [f64; FREEDOMS],
    f64,
    u32,
);

/// Writes samples as rows of CSV; numbers in the shortest form that reads back to the same value.
#[derive(Debug)]
pub struct TraceCsv<W: Write> {
    writer: csv::Writer<W>,
}

impl<W: Write> TraceCsv<W> {
    /// Writes the header.
    ///
    /// # Errors
    /// What the writer answers.
    pub fn new(writer: W) -> io::Result<Self> {
        let mut writer = csv::WriterBuilder::new()
            .has_headers(false)
            .from_writer(writer);
        writer.write_record(TRACE_COLUMNS)?;
        Ok(Self { writer })
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

impl<W: Write> TraceSink for TraceCsv<W> {
    fn sample(&mut self, sample: &Sample) -> io::Result<()> {
        let row: Row = (
            [sample.time, sample.angle, sample.speed],
            sample.displacement,
            sample.velocity,
            sample.force_on_shaft,
            sample.largest_ball_load,
            sample.balls_loaded,
        );
        self.writer.serialize(row).map_err(io::Error::from)
    }
}
