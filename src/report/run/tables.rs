//! Tables that a run writes while it goes on: samples, balls, events.

use std::io;
use std::io::Write;

use crate::analysis::Channel;
use crate::bearing::BallContact;
use crate::report::table::{CsvTable, TableFiles};
use crate::report::{ReportError, RunFolder};
use crate::rotor::{BallContacts, Sample};
use crate::simulate::{Event, EventKind, TraceSink};
use crate::table::{Column, Named, Table};

/// A table of samples that is being written.
#[derive(Debug)]
pub(super) struct SampleFiles {
    channels: Vec<Channel>,
    /// Its files.
    pub files: TableFiles,
}

impl SampleFiles {
    /// Begins a table of some channels, in their order.
    pub fn open(
        folder: &RunFolder,
        stem: &str,
        channels: Vec<Channel>,
    ) -> Result<Self, ReportError> {
        let columns: Vec<_> = channels.iter().copied().map(Channel::column).collect();
        Ok(Self {
            files: TableFiles::open(folder, stem, &columns)?,
            channels,
        })
    }

    /// Whether it shows accelerations.
    pub fn needs_acceleration(&self) -> bool {
        let mut channels = self.channels.iter();
        channels.any(|channel| channel.needs_acceleration())
    }

    /// Writes the row of a sample.
    pub fn sample(&mut self, sample: &Sample) -> io::Result<()> {
        self.files
            .row(&sample_row(self.channels.iter().copied(), sample))
    }
}

/// Channels of a sample; NaN where a value was not observed.
fn sample_row(channels: impl Iterator<Item = Channel>, sample: &Sample) -> Vec<f64> {
    let values = channels.map(|channel| channel.value(sample));
    values.map(|value| value.unwrap_or(f64::NAN)).collect()
}

/// Channels of samples that are there, a row a sample.
pub(in crate::report) fn sample_table(
    samples: &[Sample],
    channels: impl IntoIterator<Item = Channel>,
) -> Table<'static> {
    let mut table = Table::default();
    for channel in channels {
        let values = samples.iter().map(|sample| channel.value(sample));
        table.add(channel.column(), values);
    }
    table
}

/// Columns that the trace has of every shaft. Forces are those of all bearings on the shaft.
pub fn trace_columns() -> Vec<Column> {
    Channel::of_trace().map(Channel::column).collect()
}

/// Writes samples as rows of CSV.
#[derive(Debug)]
pub struct TraceCsv<W: Write> {
    channels: Vec<Channel>,
    table: CsvTable<W>,
}

impl<W: Write> TraceCsv<W> {
    /// Writes the header of some channels.
    ///
    /// # Errors
    /// What the writer answers.
    pub fn new(writer: W, channels: Vec<Channel>) -> io::Result<Self> {
        let columns: Vec<_> = channels.iter().copied().map(Channel::column).collect();
        let table = CsvTable::new(writer, &columns)?;
        Ok(Self { channels, table })
    }

    /// Gives the writer back, with everything written.
    ///
    /// # Errors
    /// What the writer answers.
    pub fn finish(self) -> io::Result<W> {
        self.table.finish()
    }
}

impl<W: Write> TraceSink for TraceCsv<W> {
    fn needs_acceleration(&self) -> bool {
        let mut channels = self.channels.iter();
        channels.any(|channel| channel.needs_acceleration())
    }

    fn sample(&mut self, sample: &Sample) -> io::Result<()> {
        let channels = self.channels.iter().copied();
        self.table.row(&sample_row(channels, sample))
    }
}

/// Named as in the table of `jeffcott bearing`.
const BALL: [Named<BallContact>; 4] = [
    ("inner_load", "N", |ball| ball.load_inner),
    ("inner_angle", "rad", |ball| ball.angle_inner),
    ("outer_load", "N", |ball| ball.load_outer),
    ("outer_angle", "rad", |ball| ball.angle_outer),
];

/// Columns of a table of balls: time, shaft angle, and `bearing1_ball1_inner_load_N` … of every ball,
/// bearings and balls counted from 1.
pub fn ball_columns(contacts: &BallContacts) -> Vec<Column> {
    let mut columns = [Channel::Time, Channel::Angle]
        .map(Channel::column)
        .to_vec();
    for (bearing, balls) in contacts.bearings().iter().enumerate() {
        for ball in 0..balls.balls() {
            let before = format!("bearing{}_ball{}", bearing + 1, ball + 1);
            let column = |(of, unit, _)| Column::number(format!("{before}_{of}"), unit);
            columns.extend(BALL.map(column));
        }
    }
    columns
}

/// The row of a sample.
pub fn ball_row(sample: &Sample, contacts: &BallContacts) -> Vec<f64> {
    let balls = contacts
        .bearings()
        .iter()
        .flat_map(|bearing| bearing.contacts());
    let values = balls.flat_map(|ball| BALL.map(|(.., value)| value(&ball)));
    [sample.time, sample.angle]
        .into_iter()
        .chain(values)
        .collect()
}

/// Columns of a table of events; what happens to a bearing as a whole has no ball.
pub fn event_columns() -> Vec<Column> {
    vec![
        Channel::Time.column(),
        Column::words("event", EventKind::ALL.map(EventKind::name)),
        Column::count("bearing"),
        Column::count("ball"),
    ]
}

/// The row of an event; bearings and balls count from 1.
pub fn event_row(event: &Event) -> [f64; 4] {
    let ball = event.ball.map_or(f64::NAN, |ball| (ball + 1) as f64);
    let kind = f64::from(event.kind as u8);
    [event.time, kind, (event.bearing + 1) as f64, ball]
}
