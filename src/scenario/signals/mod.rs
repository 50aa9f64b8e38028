//! The channels of a record as signals in SI units at one rate, and how the shaft turned.

mod reader;
mod sampled;
mod turning;

use super::Issue;
use super::input::{RecordFileInput, RecordInput};
use super::key_path::entry;
use super::problems::Problems;
use super::quantity::{si, significant};
use crate::analysis::Channel;
use crate::measurement::Turning;
use crate::record::{Record, between, on_line};
use crate::table::{Column, Table};
use reader::{Signal, SignalReader};
use turning::TurningSource;

/// Part of a rate by which two are the same.
const SAME_RATE: f64 = 1e-6;
/// Part of a sample by which a time may be off it.
const ON_SAMPLE: f64 = 1e-3;
/// Times in s without bounds.
const ALWAYS: [f64; 2] = [f64::NEG_INFINITY, f64::INFINITY];
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
        let last = signals.iter().map(Signal::end).fold(0.0, f64::max);
        let slowest = signals.iter().map(|one| one.rate);
        let near = 1.5 / slowest.fold(f64::INFINITY, f64::min);
        let known = turning.as_ref().map_or(ALWAYS, TurningSource::known);
        let mut found = Self::joined(signals, known, problems)?;
        let end = found.start + found.length() as f64 / found.rate;
        let duration = si(&input.record.duration).unwrap_or(f64::INFINITY);
        let asked = si(&input.record.start).unwrap_or(found.start) + duration;
        if last.min(asked) > end + near {
            problems.warn(format!(
                "one of the channels ends before the others: the record is analysed up to {} s",
                significant(end)
            ));
        }
        found.cut(&input.record, problems)?;
        found.turning = turning?.at_samples(&mut found, problems)?;
        Some(found)
    }

    /// Signals at the samples of the fastest that all have in common, between two times.
    fn joined(
        signals: Vec<Signal>,
        [from, to]: [f64; 2],
        problems: &mut Problems<'_>,
    ) -> Option<Self> {
        let faster = |a: &&Signal, b: &&Signal| a.rate.total_cmp(&b.rate);
        let fastest = signals.iter().rev().max_by(faster)?;
        let (rate, start) = (fastest.rate, fastest.start);
        let ends = signals.iter().map(|one| {
            let from = one.start - start;
            [from, one.end() - start]
        });
        let common = ends.fold(
            [f64::max(from - start, 0.0), to - start],
            |[from, to]: [f64; 2], [start, end]| [from.max(start), to.min(end)],
        );
        let [first, end] = [common[0] * rate - ON_SAMPLE, common[1] * rate + ON_SAMPLE];
        let (first, end) = (first.ceil(), end.floor());
        let count = (end - first + 1.0).max(0.0) as usize;
        let (mut known, mut values, mut sources) = (Vec::new(), Vec::new(), Vec::new());
        for mut signal in signals {
            signal.bring_to(rate, start + first / rate, count, problems);
            signal.channel = distinct(signal.channel, &known);
            known.push(signal.channel);
            values.push((signal.channel, signal.values));
            sources.push(signal.source);
        }
        Some(Self {
            values,
            rate,
            start: start + first / rate,
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
        let kept = first..first.saturating_add(count).min(length);
        if kept.len() < FEWEST {
            let end = significant(self.start + length as f64 / rate);
            let message = format!("the record ends at {end} s, after {length} samples");
            let needed = format!("at least {FEWEST} are needed");
            problems.refuse(if first + FEWEST <= length {
                let message = format!("only {count} samples are in it, and {needed}");
                Issue::new("record.duration", message).help("give a longer `duration`")
            } else if first == 0 {
                Issue::new("record", format!("{message}; {needed}")).help("give a longer record")
            } else {
                Issue::new(
                    "record.start",
                    format!("fewer than {FEWEST} samples are left: {message}"),
                )
                .help("give an earlier `start`")
            });
            return None;
        }
        let is_early = si(&input.start).is_some_and(|start| start < self.start - 1.5 / rate);
        let is_cut = input.duration.is_some() && first.saturating_add(count) > length + 1;
        if is_early || is_cut {
            let [from, to] = [kept.start, kept.end].map(|place| self.start + place as f64 / rate);
            let [from, to, analysed] = [from, to, to - from].map(significant);
            problems.warn(format!(
                "the record does not hold all of the part that is asked for: {analysed} s are analysed, from {from} to {to} s"
            ));
        }
        self.keep(kept);
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
        let table = Table::from_items(&signals)
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

/// A channel, or one with a number behind its name where another has that: names are one each, also where what is between their signs,
/// the case of letters or the unit differs, as files are named by them.
fn distinct(channel: Channel, known: &[Channel]) -> Channel {
    let is_taken = |one: &Channel| {
        let mut known = known.iter();
        known.any(|other| other.name().eq_ignore_ascii_case(one.name()))
    };
    let column = channel.column();
    let numbered = (2..).map(|number| {
        let quantity = format!("{}_{number}", column.quantity);
        Channel::of_measured(Column::number(quantity, column.unit.clone()))
    });
    let mut all = std::iter::once(channel).chain(numbered);
    all.find(|one| !is_taken(one)).unwrap_or(channel)
}

impl Signal {
    /// Time of the last sample, s.
    fn end(&self) -> f64 {
        self.start + (self.values.len() - 1) as f64 / self.rate
    }

    /// Brings it to so many samples at another rate, the first at a time in s: of its own rate those that it has, else between them.
    fn bring_to(&mut self, rate: f64, start: f64, count: usize, problems: &mut Problems<'_>) {
        let first = (start - self.start) * self.rate;
        let is_of_rate = (self.rate / rate - 1.0).abs() <= SAME_RATE;
        if is_of_rate && (first - first.round()).abs() <= ON_SAMPLE {
            self.values
                .drain(..(first.round() as usize).min(self.values.len()));
            self.values.truncate(count);
            return;
        }
        if !is_of_rate {
            problems.warn(format!(
                "`{}` has {} samples a second: it is brought to {}, and holds nothing above {} Hz",
                self.source[0],
                significant(self.rate),
                significant(rate),
                significant(0.5 * self.rate)
            ));
        }
        let step = self.rate / rate;
        let samples = 0..count;
        let values = samples.map(|sample| between(&self.values, first + sample as f64 * step));
        self.values = values.collect();
    }
}
