//! Tables beside the trace, one row a sample.

use std::io::{self, Write};

use crate::rotor::Sample;

/// What a table shows of the samples.
#[derive(Debug, Clone, Copy)]
pub(super) struct TableKind {
    /// Name of the file.
    pub file: &'static str,
    /// Names of the columns, each with its unit.
    pub columns: &'static [&'static str],
    /// Appends the values of a row; none where the sample has nothing to show.
    pub row: fn(&Sample, &mut Vec<f64>),
}

impl TableKind {
    /// Where the energy is: `energy.csv`.
    pub const ENERGY: Self = Self {
        file: "energy.csv",
        columns: &[
            "t_s",
            "kinetic_J",
            "stored_J",
            "loads_J",
            "unbalance_J",
            "rotation_J",
            "viscous_damping_J",
            "contact_damping_J",
            "bearings_J",
            "drive_J",
            "load_torque_J",
            "bearing_friction_J",
        ],
        row: |sample, row| {
            if let Some(energy) = &sample.energy {
                row.extend([sample.time, energy.kinetic, energy.stored]);
                row.extend(energy.works.values());
            }
        },
    };
    /// Moments on a driven shaft: `drive.csv`.
    pub const DRIVE: Self = Self {
        file: "drive.csv",
        columns: &[
            "t_s",
            "speed_rad_s",
            "drive_torque_N_m",
            "load_torque_N_m",
            "friction_moment_N_m",
            "vibration_torque_N_m",
            "twist_rad",
        ],
        row: |sample, row| {
            if let Some(moments) = &sample.drive {
                row.extend([sample.time, sample.speed, moments.drive, moments.load]);
                row.extend([moments.friction, moments.vibration, moments.twist]);
            }
        },
    };
}

/// Writes rows of numbers in the shortest form that reads back to the same value.
#[derive(Debug)]
pub(super) struct SampleTable<W: Write> {
    kind: TableKind,
    writer: csv::Writer<W>,
    row: Vec<f64>,
}

impl<W: Write> SampleTable<W> {
    /// Writes the header.
    pub fn new(kind: TableKind, writer: W) -> io::Result<Self> {
        let mut writer = csv::WriterBuilder::new()
            .has_headers(false)
            .from_writer(writer);
        writer.write_record(kind.columns)?;
        Ok(Self {
            kind,
            writer,
            row: Vec::with_capacity(kind.columns.len()),
        })
    }

    pub fn sample(&mut self, sample: &Sample) -> io::Result<()> {
        self.row.clear();
        (self.kind.row)(sample, &mut self.row);
        if self.row.is_empty() {
            return Ok(());
        }
        self.writer
            .serialize(&self.row[..])
            .map_err(io::Error::from)
    }

    /// Gives the writer back, with everything written.
    pub fn finish(self) -> io::Result<W> {
        self.writer
            .into_inner()
            .map_err(csv::IntoInnerError::into_error)
    }
}
