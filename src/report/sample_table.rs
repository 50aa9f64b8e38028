//! Tables with one row a sample: trace, energy, drive.

use std::io::{self, Write};

use super::table::{Column, ColumnKind, CsvTable};
use crate::analysis::Channel;
use crate::rotor::Sample;
use crate::simulate::TraceSink;

/// What a table shows of the samples.
#[derive(Debug, Clone)]
pub(super) struct SampleTable {
    channels: Vec<Channel>,
    /// Kept from row to row for its room.
    row: Vec<f64>,
}

impl SampleTable {
    /// Some channels, in their order.
    pub fn new(channels: impl IntoIterator<Item = Channel>) -> Self {
        Self {
            channels: channels.into_iter().collect(),
            row: Vec::new(),
        }
    }

    /// Its columns.
    pub fn columns(&self) -> Vec<Column> {
        self.channels.iter().copied().map(column).collect()
    }

    /// Whether it shows accelerations.
    pub fn needs_acceleration(&self) -> bool {
        let mut channels = self.channels.iter();
        channels.any(|channel| matches!(channel, Channel::Acceleration(_)))
    }

    /// The row of a sample; NaN where a value was not observed.
    pub fn row(&mut self, sample: &Sample) -> &[f64] {
        self.row.clear();
        let values = self.channels.iter().map(|channel| channel.of(sample));
        self.row
            .extend(values.map(|value| value.unwrap_or(f64::NAN)));
        &self.row
    }
}

fn column(channel: Channel) -> Column {
    let kind = match channel.is_count() {
        true => ColumnKind::Count,
        false => ColumnKind::Number,
    };
    Column::of(channel.column(), kind)
}

/// Columns of the trace, where no others are asked for. Forces are those of all bearings on the shaft.
pub fn trace_columns() -> Vec<Column> {
    Channel::of_trace().map(column).collect()
}

/// Writes samples as rows of CSV, all columns of the trace.
#[derive(Debug)]
pub struct TraceCsv<W: Write> {
    table: SampleTable,
    csv: CsvTable<W>,
}

impl<W: Write> TraceCsv<W> {
    /// Writes the header.
    ///
    /// # Errors
    /// What the writer answers.
    pub fn new(writer: W) -> io::Result<Self> {
        let table = SampleTable::new(Channel::of_trace());
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
