//! The channels of a record as signals in SI units at one rate, and how the shaft turned.

mod reader;
mod turning;

use super::Issue;
use super::input::{RecordFileInput, RecordInput};
use super::key::entry;
use super::problems::Problems;
use super::quantity::{si, significant};
use crate::analysis::Channel;
use crate::measurement::Turning;
use crate::record::{Record, on_line};
use crate::table::{Column, Table};
use reader::{Signal, SignalReader};

/// Part of a rate by which two are the same.
const SAME_RATE: f64 = 1e-6;
/// Fewest samples that are analysed.
const FEWEST: usize = 16;

/// Signals in SI units at equal times.
pub(super) struct Signals {
    /// The channels, all of one length.
    pub values: Vec<(Channel, Vec<f64>)>,
    /// Samples a second.
    pub rate: f64,
    /// Time of the first, s.
    pub start: f64,
    /// How the shaft turned, where that is known.
    pub turning: Option<Turning>,
    /// What each is in the file: its name there, unit, quantity, direction.
    sources: Vec<[String; 4]>,
}

impl Signals {
    /// The signals that a description asks for.
    pub fn new(
        input: &RecordFileInput,
        record: Record,
        problems: &mut Problems<'_>,
    ) -> Option<Self> {
        let mut reader = SignalReader::new(&input.record, record);
        let chosen = reader.chosen(input.speed.as_ref(), problems)?;
        let turning = reader.turning(input.speed.as_ref(), problems);
        let mut signals = Vec::new();
        for (place, (index, signal)) in chosen.iter().enumerate() {
            let read = problems.inside(entry("record.channel", place), |problems| {
                reader.signal(*index, signal, problems)
            });
            signals.push(read?);
        }
        let mut found = Self::joined(signals, problems)?;
        found.cut(&input.record, problems)?;
        found.turning = turning?.at_samples(&mut found, problems)?;
        Some(found)
    }

    /// Signals of one rate.
    fn joined(signals: Vec<Signal>, problems: &mut Problems<'_>) -> Option<Self> {
        let first = signals.first()?;
        let (rate, start) = (first.rate, first.start);
        let is_other = |one: &&Signal| (one.rate / rate - 1.0).abs() > SAME_RATE;
        if let Some(other) = signals.iter().find(is_other) {
            let message = format!(
                "`{}` has {rate} samples a second and `{}` {}: one analysis takes channels of one rate",
                first.source[0], other.source[0], other.rate
            );
            let issue = Issue::new("record.channel", message);
            problems.refuse(issue.help("analyse them one after the other, with `--channel`"));
            return None;
        }
        let lengths = signals.iter().map(|one| one.values.len());
        let length = lengths.min().unwrap_or(0);
        let (mut known, mut values, mut sources) = (Vec::new(), Vec::new(), Vec::new());
        for mut signal in signals {
            signal.values.truncate(length);
            let alike = known.iter().filter(|other| **other == signal.channel);
            let alike = alike.count();
            known.push(signal.channel);
            if alike > 0 {
                // names are one each, also where what is between their signs differs
                let column = signal.channel.column();
                let quantity = format!("{}_{}", column.quantity, alike + 1);
                signal.channel = Channel::of_measured(Column::number(quantity, column.unit));
            }
            values.push((signal.channel, signal.values));
            sources.push(signal.source);
        }
        Some(Self {
            values,
            rate,
            start,
            turning: None,
            sources,
        })
    }

    /// Keeps the part that is asked for.
    fn cut(&mut self, input: &RecordInput, problems: &mut Problems<'_>) -> Option<()> {
        let (length, rate) = (self.length(), self.rate);
        let first =
            si(&input.start).map_or(0.0, |start| ((start - self.start) * rate - 1e-6).ceil());
        let first = first.max(0.0) as usize;
        let count =
            si(&input.duration).map_or(length, |duration| (duration * rate).round() as usize);
        if first + FEWEST > length {
            let end = significant(self.start + length as f64 / rate);
            let message =
                format!("nothing is left: the record ends at {end} s, after {length} samples");
            problems.refuse(Issue::new("record.start", message).help("give an earlier `start`"));
            return None;
        }
        self.keep(first..(first + count.max(1)).min(length));
        Some(())
    }

    fn keep(&mut self, range: std::ops::Range<usize>) {
        for (_, values) in &mut self.values {
            values.truncate(range.end);
            values.drain(..range.start);
        }
        self.start += range.start as f64 / self.rate;
    }

    /// Values of another signal at the samples, on straight lines where its rate differs.
    fn at_samples(&self, signal: &Signal) -> Vec<f64> {
        let place = |sample: usize| {
            let time = self.start - signal.start + sample as f64 / self.rate;
            time * signal.rate
        };
        let samples = 0..self.length();
        samples
            .map(|sample| on_line(&signal.values, place(sample)))
            .collect()
    }

    /// Number of samples.
    pub fn length(&self) -> usize {
        self.values.first().map_or(0, |(_, values)| values.len())
    }

    /// The channels.
    pub fn channels(&self) -> Vec<Channel> {
        self.values.iter().map(|(channel, _)| *channel).collect()
    }

    /// What is analysed, and what each channel is in the file.
    pub fn table(&self) -> Table<'static> {
        let signals: Vec<_> = self.values.iter().zip(&self.sources).collect();
        let table = Table::of(&signals)
            .word("channel", |((channel, _), _)| channel.name())
            .word("unit", |((channel, _), _)| channel.unit());
        let words = ["column", "unit_in_file", "measured", "direction"];
        let words = words.into_iter().enumerate();
        words
            .fold(table, |table, (place, word)| {
                table.word(word, |(_, source)| &source[place])
            })
            .end()
    }
}
