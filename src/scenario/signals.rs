//! The channels of a record as signals in SI units at one rate, and how the shaft turned.

use super::Issue;
use super::input::{RecordFileInput, RecordInput, RecordSpeedInput, SignalInput};
use super::key::entry;
use super::problems::Problems;
use super::quantity::{Dimension, parse, sensor_unit, si, significant};
use crate::analysis::Channel;
use crate::measurement::Turning;
use crate::record::{Record, RecordChannel, Sampling};
use crate::table::{Column, Table};

/// Most channels that are analysed at a time.
const MOST_SIGNALS: usize = 64;
/// Part of a rate by which two are the same.
const SAME_RATE: f64 = 1e-6;
/// Part of a constant speed that round-off may change it by.
const CONSTANT: f64 = 1e-12;

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

/// A channel while it is read.
struct Signal {
    channel: Channel,
    values: Vec<f64>,
    /// Samples a second.
    rate: f64,
    /// Time of the first, s.
    start: f64,
    source: [String; 4],
}

/// Reads the channels of a record one after the other.
struct SignalReader<'a> {
    input: &'a RecordInput,
    channels: Vec<Option<RecordChannel>>,
    /// Names of all, as in the file.
    names: Vec<String>,
    /// Numbers that the file holds besides.
    numbers: Vec<(String, f64)>,
}

impl Signals {
    /// The signals that a description asks for.
    pub fn new(
        input: &RecordFileInput,
        record: Record,
        problems: &mut Problems<'_>,
    ) -> Option<Self> {
        let mut reader = SignalReader {
            input: &input.record,
            names: record.channels.iter().map(|one| one.name.clone()).collect(),
            channels: record.channels.into_iter().map(Some).collect(),
            numbers: record.numbers,
        };
        let chosen = match &input.record.channel[..] {
            [] => reader.default_channels(input.speed.as_ref(), problems)?,
            given => problems.each("record.channel", given, |signal, problems| {
                let index = problems.take(reader.find(&signal.column, ".column"))?;
                Some((index, signal.clone()))
            })?,
        };
        reader.check_count(&chosen, problems)?;
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
        found.turning = found.with_turning(turning?, problems)?;
        Some(found)
    }

    /// Signals of one rate.
    fn joined(signals: Vec<Signal>, problems: &mut Problems<'_>) -> Option<Self> {
        let first = signals.first()?;
        let (rate, start) = (first.rate, first.start);
        let other = signals
            .iter()
            .find(|one| (one.rate / rate - 1.0).abs() > SAME_RATE);
        if let Some(other) = other {
            let message = format!(
                "`{}` has {rate} samples a second and `{}` {}: one analysis takes channels of one rate",
                first.source[0], other.source[0], other.rate
            );
            let issue = Issue::new("record.channel", message);
            problems.refuse(issue.help("analyse them one after the other, with `--channel`"));
            return None;
        }
        let length = signals
            .iter()
            .map(|one| one.values.len())
            .min()
            .unwrap_or(0);
        let mut names: Vec<Channel> = Vec::new();
        let (mut values, mut sources) = (Vec::new(), Vec::new());
        for mut signal in signals {
            signal.values.truncate(length);
            let column = signal.channel.column();
            let same = names
                .iter()
                .filter(|known| **known == signal.channel)
                .count();
            names.push(signal.channel);
            if same > 0 {
                // names are one each, also where what is between their signs differs
                let quantity = format!("{}_{}", column.quantity, same + 1);
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
        if first + 16 > length {
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

    /// How the shaft turned at the samples; what lies before the first and behind the last pulse of a tacho is left out.
    fn with_turning(
        &mut self,
        source: TurningSource,
        problems: &mut Problems<'_>,
    ) -> Option<Option<Turning>> {
        Some(match source {
            TurningSource::Unknown => None,
            TurningSource::Constant(speed) => Some(Turning::Constant(speed)),
            TurningSource::Run { angle, speed } => {
                let [angle, speed] = [angle, speed].map(|signal| self.at_samples(&signal));
                let ends = speed
                    .iter()
                    .fold([f64::INFINITY, 0.0], |[low, high], value| {
                        [value.min(low), value.max(high)]
                    });
                Some(match ends[1] - ends[0] <= CONSTANT * ends[1] {
                    true => Turning::Constant(speed[0]),
                    false => Turning::Measured { angle, speed },
                })
            }
            TurningSource::Speed(signal) => {
                let speed = self.at_samples(&signal);
                Some(Turning::from_speed(speed, self.rate))
            }
            TurningSource::Tacho(signal, pulses) => {
                let tacho = self.at_samples(&signal);
                let found = Turning::from_tacho(&tacho, pulses, self.rate);
                let wrong = |error: crate::measurement::TachoError| {
                    Issue::new("speed.tacho", error.to_string())
                };
                let (turning, range) = problems.take(found.map_err(wrong))?;
                self.keep(range);
                Some(turning)
            }
        })
    }

    /// Values of another signal at the samples, on straight lines where its rate differs.
    fn at_samples(&self, signal: &Signal) -> Vec<f64> {
        let last = signal.values.len() - 1;
        let at = |sample: usize| {
            let time = self.start - signal.start + sample as f64 / self.rate;
            let place = (time * signal.rate).clamp(0.0, last as f64);
            // of the same times the very values
            let place = if (place - place.round()).abs() < 1e-6 {
                place.round()
            } else {
                place
            };
            let before = place as usize;
            let part = place - before as f64;
            let after = signal.values[(before + 1).min(last)];
            signal.values[before] + part * (after - signal.values[before])
        };
        (0..self.length()).map(at).collect()
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
        let words = ["column", "unit_in_file", "measured", "direction"].into_iter();
        let words = words.enumerate();
        words
            .fold(table, |table, (place, word)| {
                table.word(word, |(_, source)| &source[place])
            })
            .end()
    }
}

/// What the speed follows from.
enum TurningSource {
    Unknown,
    Constant(f64),
    Speed(Signal),
    Tacho(Signal, f64),
    /// Angle and speed of a run of this program.
    Run {
        angle: Signal,
        speed: Signal,
    },
}

impl SignalReader<'_> {
    /// The place of a channel that is named, or numbered from 1.
    fn find(&self, named: &str, path: &str) -> Result<usize, Issue> {
        let by_name = self.names.iter().position(|name| name == named);
        let by_number = || named.parse::<usize>().ok()?.checked_sub(1);
        let found = by_name.or_else(by_number);
        found
            .filter(|place| *place < self.names.len())
            .ok_or_else(|| {
                let names = self.names.iter().map(String::as_str);
                let shown = self
                    .names
                    .iter()
                    .take(12)
                    .cloned()
                    .collect::<Vec<_>>()
                    .join(", ");
                let more = if self.names.len() > 12 { ", …" } else { "" };
                let message = format!("the record has no channel `{named}`");
                let all = format!("it has {shown}{more}");
                Issue::new(path, message).help_nearest(named, names, &all)
            })
    }

    /// The channels where none are given: those of the highest rate that are not of the speed; of a run the displacements and forces.
    fn default_channels(
        &self,
        speed: Option<&RecordSpeedInput>,
        problems: &mut Problems<'_>,
    ) -> Option<Vec<(usize, SignalInput)>> {
        let of_speed = speed.and_then(|speed| speed.channel.as_ref().or(speed.tacho.as_ref()));
        let of_speed = of_speed.and_then(|name| self.find(name, "").ok());
        let known = || {
            self.channels
                .iter()
                .enumerate()
                .filter_map(|(index, channel)| {
                    let channel = channel.as_ref().filter(|_| Some(index) != of_speed)?;
                    Some((index, channel))
                })
        };
        let of_run = known().filter(|(_, channel)| {
            native(channel).is_some_and(|native| match native {
                Channel::Displacement(_) | Channel::Force(_) => true,
                Channel::Body { .. } => native.needs_acceleration(),
                _ => false,
            }) && channel.samples.iter().any(|value| *value != 0.0)
        });
        let of_run: Vec<usize> = of_run.map(|(index, _)| index).collect();
        let rank = |channel: &RecordChannel| {
            (
                channel.sampling.rate().unwrap_or(0.0),
                channel.samples.len(),
            )
        };
        let most = known().map(|(_, channel)| rank(channel));
        let most = most.max_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
        let fastest = known().filter(|(_, channel)| Some(rank(channel)) == most);
        let chosen = match of_run.is_empty() {
            true => fastest.map(|(index, _)| index).collect(),
            false => of_run,
        };
        let left_out =
            known().filter(|(index, channel)| !chosen.contains(index) && native(channel).is_none());
        let left_out: Vec<_> = left_out
            .map(|(_, channel)| format!("`{}`", channel.name))
            .collect();
        if !left_out.is_empty() {
            problems.warn(format!(
                "left out, as their rate or length differs: {}; `--channel` takes others",
                left_out.join(", ")
            ));
        }
        let signal = |index: usize| (index, SignalInput::of_column(&self.names[index]));
        Some(chosen.into_iter().map(signal).collect())
    }

    fn check_count(
        &self,
        chosen: &[(usize, SignalInput)],
        problems: &mut Problems<'_>,
    ) -> Option<()> {
        let message = match chosen.len() {
            0 => "no channel is left to analyse".to_owned(),
            count if count > MOST_SIGNALS => {
                format!("{count} channels are too many for one analysis: {MOST_SIGNALS} at most")
            }
            _ => return Some(()),
        };
        let issue = Issue::new("record.channel", message);
        problems.refuse(
            issue.help("choose with `--channel NAME`, or [[record.channel]]; `--list` shows all"),
        );
        None
    }

    /// What the speed follows from; `None` where that is wrong.
    fn turning(
        &mut self,
        speed: Option<&RecordSpeedInput>,
        problems: &mut Problems<'_>,
    ) -> Option<TurningSource> {
        let Some(speed) = speed else {
            let of = |wanted: Channel| {
                let mut channels = self.channels.iter();
                channels.position(|one| one.as_ref().and_then(native) == Some(wanted))
            };
            let [Some(angle), Some(turning)] = [Channel::Angle, Channel::Speed].map(of) else {
                self.offer_speed(problems);
                return Some(TurningSource::Unknown);
            };
            let [angle, speed] = [angle, turning].map(|index| {
                let input = SignalInput::of_column(&self.names[index]);
                self.signal(index, &input, problems)
            });
            return Some(TurningSource::Run {
                angle: angle?,
                speed: speed?,
            });
        };
        if let Some(constant) = si(&speed.constant) {
            return Some(TurningSource::Constant(constant));
        }
        let (key, named) = match (&speed.channel, &speed.tacho) {
            (Some(channel), _) => (".channel", channel),
            (None, Some(tacho)) => (".tacho", tacho),
            (None, None) => return None,
        };
        problems.inside("speed", |problems| {
            let index = problems.take(self.find(named, key))?;
            let input = SignalInput {
                unit: speed.unit.clone(),
                rate: speed.rate.clone(),
                scale: Some(1.0),
                ..SignalInput::of_column(named)
            };
            if key == ".tacho" {
                let pulses = speed.pulses.unwrap_or(1.0);
                return Some(TurningSource::Tacho(
                    self.signal(index, &input, problems)?,
                    pulses,
                ));
            }
            let channel = self.channels[index].as_ref()?;
            let unit = input.unit.clone().or(channel.unit.clone());
            let factor = unit.as_ref().and_then(|unit| {
                let parsed = parse(&format!("1 {unit}"), &[Dimension::AngularSpeed]);
                parsed.ok().map(|one| one.si)
            });
            let Some(factor) = factor else {
                let message = match unit {
                    Some(unit) => format!("`{unit}` is no unit of a speed"),
                    None => format!("the file has no unit of `{named}`"),
                };
                problems.refuse(Issue::new(".unit", message).help("for instance: unit = \"rpm\""));
                return None;
            };
            let plain = SignalInput {
                unit: Some(String::new()),
                ..input
            };
            let mut signal = self.signal(index, &plain, problems)?;
            signal.values.iter_mut().for_each(|value| *value *= factor);
            if signal.values.iter().any(|value| *value < 0.0) {
                let message = format!("the speed in `{named}` is negative somewhere");
                problems.refuse(
                    Issue::new(key, message).help("orders need a shaft that turns one way"),
                );
                return None;
            }
            Some(TurningSource::Speed(signal))
        })
    }

    /// Names numbers of the file that may be the speed.
    fn offer_speed(&self, problems: &mut Problems<'_>) {
        let is_speed = |name: &str| {
            ["rpm", "speed", "drehzahl"]
                .iter()
                .any(|word| name.contains(word))
        };
        let found = self
            .numbers
            .iter()
            .find(|(name, _)| is_speed(&name.to_lowercase()));
        if let Some((name, value)) = found {
            problems.warn(format!(
                "no speed is given, and lines have no names; the file holds {name} = {value}: if that is the speed, give it, as in \
                 --speed \"{value} rpm\""
            ));
        }
    }

    /// A channel in SI units.
    fn signal(
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
        let unit = input
            .unit
            .clone()
            .or(channel.unit.clone())
            .or(self.input.unit.clone());
        let known = unit
            .as_deref()
            .filter(|unit| !unit.is_empty())
            .map(|unit| (unit, sensor_unit(unit)));
        let name = &input.name.clone().unwrap_or_else(|| channel.name.clone());
        if let Some((unit, None)) = known {
            problems.warn(format!(
                "`{unit}`, the unit of `{name}`, is not known: values stay in it, and make no velocity"
            ));
        }
        let scale = input.scale.or(self.input.scale).unwrap_or(1.0);
        let (rate, start, mut values) = self.sampled(&mut channel, input, problems)?;
        for value in &mut values {
            let in_unit = scale * *value + input.offset;
            *value = match &known {
                Some((_, Some((unit, _)))) => unit.si(in_unit),
                _ => in_unit,
            };
        }
        let symbol = match &known {
            Some((_, Some((_, symbol)))) => (*symbol).to_owned(),
            Some((unit, None)) => (*unit).to_owned(),
            None => String::new(),
        };
        let column = match native_column(&channel).filter(|_| input.name.is_none()) {
            Some(column) if column.unit == symbol => column,
            _ => Column::number(identifier(name), symbol),
        };
        let word = |text: &Option<String>, other: &Option<String>| {
            text.clone().or(other.clone()).unwrap_or_default()
        };
        let source = [
            channel.name.clone(),
            unit.clone().unwrap_or_default(),
            word(&input.quantity, &channel.quantity),
            word(&input.direction, &channel.direction),
        ];
        Some(Signal {
            channel: Channel::of_measured(column),
            values,
            rate,
            start,
            source,
        })
    }

    /// Rate, time of the first sample and samples at equal times, none of them missing.
    fn sampled(
        &self,
        channel: &mut RecordChannel,
        input: &SignalInput,
        problems: &mut Problems<'_>,
    ) -> Option<(f64, f64, Vec<f64>)> {
        let name = &channel.name;
        let given = si(&input.rate).or(si(&self.input.rate));
        let mut values = std::mem::take(&mut channel.samples);
        let missing = bridge(&mut values);
        if missing == values.len() {
            let message = format!("all samples of `{name}` are missing");
            problems.refuse(Issue::new(".column", message).help("leave it out"));
            return None;
        }
        if missing > 0 {
            problems.warn(format!(
                "missing samples of `{name}`, {missing}, are bridged by straight lines"
            ));
        }
        Some(match (&channel.sampling, given) {
            (Sampling::Even { rate, start }, None) => (*rate, *start, values),
            (Sampling::Even { rate, start }, Some(given)) => {
                if (given / rate - 1.0).abs() > 1e-3 {
                    problems.warn(format!(
                        "the file says that `{name}` has {} samples a second, and {} are taken as given",
                        significant(*rate),
                        significant(given)
                    ));
                }
                (given, *start, values)
            }
            (Sampling::Times(_) | Sampling::Unknown, Some(given)) => (given, 0.0, values),
            (Sampling::Times(times), None) => {
                let (first, last) = (times[0], times[times.len() - 1]);
                let rate = (times.len() - 1) as f64 / (last - first);
                problems.warn(format!(
                    "`{name}` was sampled at uneven times: it is brought to the mean rate of {} Hz on straight lines, which damps \
                     what is above about a fifth of it; give the `rate` if the times are inexact and the samples even",
                    significant(rate)
                ));
                (rate, first, at_even_times(times, &values, rate))
            }
            (Sampling::Unknown, None) => {
                let message =
                    format!("the file does not say how many samples a second `{name}` has");
                let is_rate = |name: &str| {
                    let mut words = ["rate", "sr", "fs", "freq"].iter();
                    words.any(|word| name.rsplit(['.', '_', ' ']).any(|part| part.contains(word)))
                };
                let mut numbers = self.numbers.iter();
                let offered =
                    numbers.find(|(name, value)| is_rate(&name.to_lowercase()) && *value > 100.0);
                let help = match offered {
                    Some((name, value)) => {
                        format!(
                            "it holds {name} = {value}: if that is the rate, give it, as in --rate \"{value} Hz\""
                        )
                    }
                    None => "give it, as in --rate \"12 kHz\", or `rate` in [record]".to_owned(),
                };
                problems.refuse(Issue::new("", message).help(help));
                return None;
            }
        })
    }
}

impl SignalInput {
    /// A column as it is.
    fn of_column(name: &str) -> Self {
        Self {
            column: name.to_owned(),
            name: None,
            quantity: None,
            unit: None,
            direction: None,
            rate: None,
            scale: None,
            offset: 0.0,
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

/// A name of letters, digits and `_`, as columns have.
fn identifier(name: &str) -> String {
    let plain = |sign: char| {
        if sign.is_ascii_alphanumeric() {
            sign
        } else {
            ' '
        }
    };
    let words: String = name.chars().map(plain).collect();
    let joined = words.split_whitespace().collect::<Vec<_>>().join("_");
    match joined.chars().next() {
        None => "signal".to_owned(),
        Some(first) if first.is_ascii_digit() => format!("c{joined}"),
        Some(_) => joined,
    }
}

/// Puts straight lines in place of what is missing, at the ends the nearest value; how many were.
fn bridge(values: &mut [f64]) -> usize {
    let missing = values.iter().filter(|value| !value.is_finite()).count();
    if missing == 0 || missing == values.len() {
        return missing;
    }
    let mut known: Option<usize> = None;
    for index in 0..values.len() {
        if !values[index].is_finite() {
            continue;
        }
        let first = known.map_or(0, |known| known + 1);
        for gap in first..index {
            values[gap] = match known {
                None => values[index],
                Some(before) => {
                    let part = (gap - before) as f64 / (index - before) as f64;
                    values[before] + part * (values[index] - values[before])
                }
            };
        }
        known = Some(index);
    }
    let last = known.unwrap_or(0);
    let value = values[last];
    values[last..].fill(value);
    missing
}

/// Values at equal times, on straight lines between those that are known.
fn at_even_times(times: &[f64], values: &[f64], rate: f64) -> Vec<f64> {
    let mut after = 1;
    let at = |index: usize| {
        let time = times[0] + index as f64 / rate;
        while after + 1 < times.len() && times[after] < time {
            after += 1;
        }
        let [from, to] = [times[after - 1], times[after]];
        let part = ((time - from) / (to - from)).clamp(0.0, 1.0);
        values[after - 1] + part * (values[after] - values[after - 1])
    };
    (0..times.len()).map(at).collect()
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

    #[test]
    fn gaps_are_bridged() {
        let mut values = [f64::NAN, 1.0, f64::NAN, f64::NAN, 4.0, f64::INFINITY];
        assert_eq!(bridge(&mut values), 4);
        assert_eq!(values, [1.0, 1.0, 2.0, 3.0, 4.0, 4.0]);
    }

    #[test]
    fn uneven_times_become_even() {
        let even = at_even_times(&[0.0, 1.0, 3.0], &[0.0, 2.0, 6.0], 2.0 / 3.0);
        assert_eq!(even, [0.0, 3.0, 6.0]);
    }
}
