//! The trace: what its columns show of a sample.

use std::io::{self, Write};

use super::table::{Column, ColumnKind, CsvTable};
use crate::rotor::Sample;
use crate::scenario::TraceChannel;
use crate::simulate::TraceSink;

/// A column of the trace.
#[derive(Debug, Clone, Copy)]
struct Field {
    name: &'static str,
    kind: ColumnKind,
    value: fn(&Sample) -> f64,
}

const fn number(name: &'static str, value: fn(&Sample) -> f64) -> Field {
    Field {
        name,
        kind: ColumnKind::Number,
        value,
    }
}

/// The time, then every [`TraceChannel`] in its order.
const FIELDS: [Field; TraceChannel::ALL.len() + 1] = [
    number("t_s", |sample| sample.time),
    number("angle_rad", |sample| sample.angle),
    number("speed_rad_s", |sample| sample.speed),
    number("x_m", |sample| sample.displacement[0]),
    number("y_m", |sample| sample.displacement[1]),
    number("z_m", |sample| sample.displacement[2]),
    number("tilt_x_rad", |sample| sample.displacement[3]),
    number("tilt_y_rad", |sample| sample.displacement[4]),
    number("x_velocity_m_s", |sample| sample.velocity[0]),
    number("y_velocity_m_s", |sample| sample.velocity[1]),
    number("z_velocity_m_s", |sample| sample.velocity[2]),
    number("tilt_x_velocity_rad_s", |sample| sample.velocity[3]),
    number("tilt_y_velocity_rad_s", |sample| sample.velocity[4]),
    number("force_x_N", |sample| sample.force_on_shaft[0]),
    number("force_y_N", |sample| sample.force_on_shaft[1]),
    number("force_z_N", |sample| sample.force_on_shaft[2]),
    number("moment_x_N_m", |sample| sample.force_on_shaft[3]),
    number("moment_y_N_m", |sample| sample.force_on_shaft[4]),
    number("largest_ball_load_N", |sample| sample.largest_ball_load),
    Field {
        name: "balls_loaded",
        kind: ColumnKind::Count,
        value: |sample| f64::from(sample.balls_loaded),
    },
];

/// Columns of the trace, in their order. Forces are those of all bearings on the shaft.
pub const TRACE_COLUMNS: [&str; FIELDS.len()] = {
    let mut names = [""; FIELDS.len()];
    let mut place = 0;
    while place < FIELDS.len() {
        names[place] = FIELDS[place].name;
        place += 1;
    }
    names
};

/// The columns of a trace that are written: the time, and all others or some of them.
#[derive(Debug, Clone)]
pub(super) struct TraceTable {
    fields: Vec<Field>,
    /// Kept from row to row for its room.
    row: Vec<f64>,
}

impl TraceTable {
    /// The time and some channels, or all of them where none is named.
    pub fn new(channels: Option<&[TraceChannel]>) -> Self {
        let fields = match channels {
            None => FIELDS.to_vec(),
            Some(channels) => std::iter::once(FIELDS[0])
                .chain(channels.iter().map(|channel| FIELDS[*channel as usize + 1]))
                .collect(),
        };
        Self {
            row: Vec::with_capacity(fields.len()),
            fields,
        }
    }

    pub fn columns(&self) -> Vec<Column> {
        let column = |field: &Field| Column::of(field.name, field.kind);
        self.fields.iter().map(column).collect()
    }

    /// The row of a sample.
    pub fn row(&mut self, sample: &Sample) -> &[f64] {
        self.row.clear();
        self.row
            .extend(self.fields.iter().map(|field| (field.value)(sample)));
        &self.row
    }
}

/// Writes samples as rows of CSV, all columns.
#[derive(Debug)]
pub struct TraceCsv<W: Write> {
    table: TraceTable,
    csv: CsvTable<W>,
}

impl<W: Write> TraceCsv<W> {
    /// Writes the header.
    ///
    /// # Errors
    /// What the writer answers.
    pub fn new(writer: W) -> io::Result<Self> {
        let table = TraceTable::new(None);
        Ok(Self {
            csv: CsvTable::new(writer, &table.columns())?,
            table,
        })
    }

    /// Gives the writer back, with everything written.
    ///
    /// # Errors
    /// What the writer answers.
    pub fn finish(self) -> io::Result<W> {
        self.csv.finish()
    }
}

impl<W: Write> TraceSink for TraceCsv<W> {
    fn sample(&mut self, sample: &Sample) -> io::Result<()> {
        self.csv.row(self.table.row(sample))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_channel_shows_its_own_column() {
        for (channel, _) in TraceChannel::ALL {
            let table = TraceTable::new(Some(&[channel]));
            let column = &table.columns()[1].name;
            let unit = column.strip_prefix(channel.name()).expect("its name first");
            let units = ["", "_m", "_m_s", "_rad", "_rad_s", "_N", "_N_m"];
            assert!(units.contains(&unit), "{column} of {}", channel.name());
        }
    }
}
