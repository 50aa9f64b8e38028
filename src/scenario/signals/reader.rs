//! Channels of a record become signals in SI units.

use std::ops::RangeInclusive;

use super::sampled::{ALMOST_THE_RATE, SampledValues};
use super::{Issue, Problems};
use crate::analysis::Channel;
use crate::record::{Record, RecordChannel, Sampling, in_brackets};
use crate::scenario::input::{RecordInput, RecordSpeedInput, SignalInput};
use crate::scenario::quantity::{sensor_unit, si};
use crate::table::Column;

/// Most channels that are analysed at a time.
const MOST_SIGNALS: usize = 64;
/// Channels that a message names at most.
const MOST_NAMED: usize = 12;
/// Letters of a name.
const LONGEST_NAME: usize = 64;
/// Least and largest magnitude of a scale.
const SCALES: RangeInclusive<f64> = 1e-30..=1e30;
/// Largest magnitude of a sample in SI units: sums of fourth powers, as in the kurtosis, do not overflow.
const LARGEST: f64 = 1e60;
/// Units in which times may be, in parts of a second.
const PER_SECOND: [f64; 4] = [1.0, 1e3, 1e6, 1e9];
/// What a channel is called whose name has no sign that names of columns have.
const NAMELESS: &str = "signal";
/// A number of a file above this one may be a rate in Hz.
const SLOWEST: f64 = 100.0;

/// A channel in SI units.
pub(super) struct Signal {
    pub channel: Channel,
    pub values: Vec<f64>,
    /// Samples a second.
    pub rate: f64,
    /// Time of the first, s.
    pub start: f64,
    /// What it is in the file: its name there, unit, quantity, direction.
    pub source: [String; 4],
}

/// Reads the channels of a record one after the other.
pub(super) struct SignalReader<'a> {
    pub(super) input: &'a RecordInput,
    channels: Vec<Option<RecordChannel>>,
    /// Names of all, as in the file.
    pub names: Vec<String>,
    /// Numbers that the file holds besides.
    numbers: Vec<(String, f64)>,
}

impl<'a> SignalReader<'a> {
    pub fn new(input: &'a RecordInput, record: Record) -> Self {
        Self {
            input,
            names: record.channels.iter().map(|one| one.name.clone()).collect(),
            channels: record.channels.into_iter().map(Some).collect(),
            numbers: record.numbers,
        }
    }

    /// The place of a channel that is named, or numbered from 1.
    pub fn find(&self, named: &str, path: &str) -> Result<usize, Issue> {
        let by_name = self.names.iter().position(|name| name == named);
        let by_number = || named.parse::<usize>().ok()?.checked_sub(1);
        let found = by_name.or_else(by_number);
        let found = found.filter(|place| *place < self.names.len());
        found.ok_or_else(|| {
            let shown = self.names[..self.names.len().min(MOST_NAMED)].join(", ");
            let more = if self.names.len() > MOST_NAMED {
                ", …"
            } else {
                ""
            };
            let names = self.names.iter().map(String::as_str);
            let message = format!("the record has no channel `{named}`");
            Issue::new(path, message).help_nearest(named, names, &format!("it has {shown}{more}"))
        })
    }

    /// Unit of a channel in the file.
    pub fn unit(&self, index: usize) -> Option<String> {
        self.channels[index].as_ref()?.unit.clone()
    }

    /// Samples of a channel that is not taken yet.
    pub fn samples(&mut self, index: usize) -> Option<&mut [f64]> {
        Some(&mut self.channels[index].as_mut()?.samples)
    }

    /// The place of a channel of a run of this program.
    pub fn of_run(&self, wanted: Channel) -> Option<usize> {
        let mut channels = self.channels.iter();
        channels.position(|one| one.as_ref().and_then(native) == Some(wanted))
    }

    /// The first number of the file above a limit whose name has one of the words in it.
    pub fn number(&self, words: &[&str], limit: f64) -> Option<&(String, f64)> {
        let is_named = |name: &str| words.iter().any(|word| name.contains(word));
        let mut numbers = self.numbers.iter();
        numbers.find(|(name, value)| *value > limit && is_named(&name.to_lowercase()))
    }

    /// The channels that are given, or those that are taken by default.
    pub fn chosen(
        &self,
        speed: Option<&RecordSpeedInput>,
        problems: &mut Problems<'_>,
    ) -> Option<Vec<(usize, SignalInput)>> {
        let chosen = match &self.input.channel[..] {
            [] => self.default_channels(speed, problems),
            given => problems.each("record.channel", given, |signal, problems| {
                let index = problems.take(self.find(&signal.column, ".column"))?;
                Some((index, signal.clone()))
            })?,
        };
        let message = match chosen.len() {
            0 => "no channel is left to analyse".to_owned(),
            count if count > MOST_SIGNALS => {
                format!("{count} channels are too many for one analysis: {MOST_SIGNALS} at most")
            }
            _ => return Some(chosen),
        };
        let issue = Issue::new("record.channel", message);
        problems.refuse(
            issue.help("choose with `--channel NAME`, or [[record.channel]]; `--list` shows all"),
        );
        None
    }

    /// The channels where none are given: those of the highest rate that are not of the speed; of a run the displacements and forces.
    fn default_channels(
        &self,
        speed: Option<&RecordSpeedInput>,
        problems: &mut Problems<'_>,
    ) -> Vec<(usize, SignalInput)> {
        let of_speed = speed.and_then(|speed| speed.channel.as_ref().or(speed.tacho.as_ref()));
        let of_speed = of_speed.and_then(|name| self.find(name, "").ok());
        let known = self.channels.iter().enumerate();
        let known = known.filter(|(index, _)| Some(*index) != of_speed);
        let known = known.filter_map(|(index, channel)| Some((index, channel.as_ref()?)));
        let (times, known): (Vec<_>, Vec<_>) =
            known.partition(|(_, channel)| self.is_time(channel));
        for (_, channel) in times {
            problems.warn(format!(
                "`{}` rises by a step of the rate from sample to sample: it is taken for the time, and left out; `--channel` takes it",
                channel.name
            ));
        }
        let is_of_run = |channel: &RecordChannel| {
            let is_shown = match native(channel) {
                Some(Channel::Displacement(_) | Channel::Force(_)) => true,
                Some(of_body @ Channel::Body { .. }) => of_body.needs_acceleration(),
                _ => false,
            };
            is_shown && channel.samples.iter().any(|value| *value != 0.0)
        };
        let rank = |channel: &RecordChannel| {
            let rate = channel.sampling.rate().unwrap_or(0.0);
            (rate, channel.samples.len())
        };
        let ranks = known.iter().map(|(_, channel)| rank(channel));
        let most = ranks.max_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
        let has_run = known.iter().any(|(_, channel)| is_of_run(channel));
        let (chosen, others): (Vec<_>, Vec<_>) = known.into_iter().partition(|(_, channel)| {
            // beside columns of a run there may be others
            let is_of_other = !has_run || native(channel).is_none();
            is_of_run(channel) || (is_of_other && Some(rank(channel)) == most)
        });
        let left_out = others
            .iter()
            .filter(|(_, channel)| native(channel).is_none());
        let left_out = left_out.map(|(_, channel)| format!("`{}`", channel.name));
        let left_out = left_out.collect::<Vec<_>>().join(", ");
        if !left_out.is_empty() {
            problems.warn(format!(
                "left out, as their rate or length differs: {left_out}; `--channel` takes others"
            ));
        }
        let signal = |(index, _): (usize, _)| (index, SignalInput::of_column(&self.names[index]));
        chosen.into_iter().map(signal).collect()
    }

    /// Whether a channel without a unit holds the times of samples at the rate that is given, in s or parts of it.
    fn is_time(&self, channel: &RecordChannel) -> bool {
        let rate = si(&self.input.rate).filter(|_| channel.unit.is_none());
        let steps = rate.zip(Sampling::from_times(&channel.samples).rate());
        steps.is_some_and(|(rate, found)| {
            let is_unit =
                |per_second: &f64| (found * per_second / rate - 1.0).abs() <= ALMOST_THE_RATE;
            PER_SECOND.iter().any(is_unit)
        })
    }

    /// A channel in SI units.
    pub fn signal(
        &mut self,
        index: usize,
        input: &SignalInput,
        problems: &mut Problems<'_>,
    ) -> Option<Signal> {
        let Some(mut channel) = self.channels[index].take() else {
            let message = format!("`{}` is taken twice", self.names[index]);
            problems.refuse(Issue::new(".column", message).help("leave one out"));
            return None;
        };
        let name = &input.name.clone().unwrap_or_else(|| channel.name.clone());
        let general = self.input.unit.as_ref().filter(|_| input.unit.is_none());
        if let Some((asked, own)) = general.zip(channel.unit.as_ref())
            && asked != own
        {
            problems.warn(format!(
                "`{name}` is in {own} by its file: the `unit` {asked} of the record is for channels that do not say theirs; give \
                 this one a `unit` of its own to overrule that"
            ));
        }
        let unit = input.unit.clone().or(channel.unit.clone());
        let unit = unit.or(self.input.unit.clone()).unwrap_or_default();
        let known = sensor_unit(&unit).filter(|_| !unit.is_empty());
        if known.is_none() && !unit.is_empty() {
            problems.warn(format!(
                "`{unit}`, the unit of `{name}`, is not known: values stay in it, and make no velocity"
            ));
        }
        if let Some(text) = in_brackets(&channel.name).filter(|_| unit.is_empty()) {
            problems.warn(format!(
                "`{text}` in the name of `{}` is not understood as a unit: its values are taken as bare numbers; give it, as in --unit \
                 \"mm/s\", or `unit` in [[record.channel]]",
                channel.name
            ));
        }
        let scale = input.scale.or(self.input.scale).unwrap_or(1.0);
        if !SCALES.contains(&scale.abs()) {
            let path = match input.scale {
                Some(_) => ".scale",
                None => "record.scale",
            };
            let [least, most] = [SCALES.start(), SCALES.end()];
            let message = format!("{scale:?} is no scale");
            let help = format!(
                "its magnitude is {least:e} to {most:e}; it is what one in the file means in the unit"
            );
            problems.refuse(Issue::new(path, message).help(help));
            return None;
        }
        let SampledValues {
            rate,
            start,
            mut values,
        } = self.sampled(&mut channel, input, problems)?;
        for value in &mut values {
            let in_unit = scale * *value + input.offset;
            *value = known.as_ref().map_or(in_unit, |(unit, _)| unit.si(in_unit));
        }
        let is_too_large = |value: &&f64| !(-LARGEST..=LARGEST).contains(*value);
        if let Some(value) = values.iter().find(is_too_large) {
            let message =
                format!("a sample of `{name}` is {value:e} in SI units: {LARGEST:e} is the most");
            let issue = Issue::new(".column", message);
            problems.refuse(issue.help("check its unit, `scale` and `offset`"));
            return None;
        }
        let symbol = known.map_or_else(|| unit.clone(), |(_, symbol)| symbol.to_owned());
        let column = match native_column(&channel).filter(|_| input.name.is_none()) {
            Some(column) if column.unit == symbol && is_identifier(&column.quantity) => column,
            _ => Column::number(identifier(name), symbol),
        };
        if column.quantity == NAMELESS && name != NAMELESS {
            problems.warn(format!(
                "no letter from a to z and no digit is in `{name}`: results call it `{NAMELESS}`"
            ));
        }
        let either = |given: &Option<String>, own: &Option<String>| {
            given.clone().or(own.clone()).unwrap_or_default()
        };
        let quantity = either(&input.quantity, &channel.quantity);
        let direction = either(&input.direction, &channel.direction);
        Some(Signal {
            channel: Channel::of_measured(column),
            values,
            rate,
            start,
            source: [channel.name, unit, quantity, direction],
        })
    }

    /// The rate of a channel is not known; a number of the file may be it.
    pub(super) fn no_rate(&self, name: &str) -> Issue {
        let message = format!("the file does not say how many samples a second `{name}` has");
        let offered = self.number(&["rate", "sr", "fs", "freq"], SLOWEST);
        Issue::new("", message).help(match offered {
            Some((name, value)) => format!(
                "it holds {name} = {value}: if that is the rate, give it, as in --rate \"{value} Hz\""
            ),
            None => "give it, as in --rate \"12 kHz\", or `rate` in [record]".to_owned(),
        })
    }
}

impl SignalInput {
    /// A column as it is.
    pub(super) fn of_column(name: &str) -> Self {
        Self {
            column: name.to_owned(),
            ..Self::default()
        }
    }
}

/// The column of a trace of this program.
fn native_column(channel: &RecordChannel) -> Option<Column> {
    let quantity = channel.quantity.clone()?;
    let column = Column::number(quantity, channel.unit.clone().unwrap_or_default());
    (column.name() == channel.name).then_some(column)
}

/// The channel of a run that a column is of.
fn native(channel: &RecordChannel) -> Option<Channel> {
    Channel::of_column(&native_column(channel)?)
}

/// A name of letters, digits and `_`, as columns and files have, and of a length that files may have.
fn identifier(name: &str) -> String {
    let words = name.split(|sign: char| !sign.is_ascii_alphanumeric());
    let words: Vec<&str> = words.filter(|word| !word.is_empty()).collect();
    let mut joined = words.join("_");
    joined.truncate(LONGEST_NAME);
    match joined.chars().next() {
        None => NAMELESS.to_owned(),
        Some(first) if first.is_ascii_digit() => format!("c{joined}"),
        Some(_) => joined,
    }
}

/// Whether a name may be that of a file.
fn is_identifier(name: &str) -> bool {
    let is_of_name = |sign: char| sign.is_ascii_alphanumeric() || sign == '_';
    name.len() <= LONGEST_NAME && name.chars().all(is_of_name)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_become_names_of_columns() {
        for (name, expected) in [
            ("X112_DE_time", "X112_DE_time"),
            ("acc x", "acc_x"),
            ("3: Motor (DE)", "c3_Motor_DE"),
            ("µ", "signal"),
        ] {
            assert_eq!(identifier(name), expected);
        }
    }
}
