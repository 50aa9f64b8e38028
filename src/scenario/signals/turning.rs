//! What the speed of a record follows from.

use super::reader::{Signal, SignalReader};
use super::sampled::known_range;
use super::{ALWAYS, FEWEST, Issue, Problems, Signals};
use crate::analysis::Channel;
use crate::measurement::{TachoError, Turning};
use crate::record::bridge;
use crate::scenario::input::{RecordSpeedInput, SignalInput};
use crate::scenario::quantity::{Dimension, parse, si};

/// Part of a constant speed that round-off may change it by.
const CONSTANT: f64 = 1e-12;

/// What the speed follows from.
pub(super) enum TurningSource {
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

impl TurningSource {
    /// The times in s between which it is known, to a sample of its own.
    pub fn known(&self) -> [f64; 2] {
        let signals = match self {
            Self::Unknown | Self::Constant(_) => vec![],
            Self::Speed(signal) | Self::Tacho(signal, _) => vec![signal],
            Self::Run { angle, speed } => vec![angle, speed],
        };
        signals.into_iter().fold(ALWAYS, |[from, to], signal| {
            let step = 1.0 / signal.rate;
            [from.max(signal.start - step), to.min(signal.end() + step)]
        })
    }

    /// How the shaft turned at the samples; what lies before the first and behind the last pulse of a tacho is left out.
    pub fn at_samples(
        self,
        signals: &mut Signals,
        problems: &mut Problems<'_>,
    ) -> Option<Option<Turning>> {
        Some(match self {
            Self::Unknown => None,
            Self::Constant(speed) => Some(Turning::Constant(speed)),
            Self::Run { angle, speed } => {
                let [angle, speed] = [angle, speed].map(|signal| signals.at_samples(&signal));
                let none = [f64::INFINITY, 0.0];
                let [low, high] = speed
                    .iter()
                    .fold(none, |[low, high], value| [value.min(low), value.max(high)]);
                Some(match high - low <= CONSTANT * high {
                    true => Turning::Constant(speed[0]),
                    false => Turning::Measured { angle, speed },
                })
            }
            Self::Speed(signal) => {
                let speed = signals.at_samples(&signal);
                Some(Turning::from_speed(speed, signals.rate))
            }
            Self::Tacho(signal, pulses) => {
                let tacho = signals.at_samples(&signal);
                let found = Turning::from_tacho(&tacho, pulses, signals.rate);
                let wrong = |error: TachoError| Issue::new("speed.tacho", error.to_string());
                let found = problems.take(found.map_err(wrong))?;
                if let Some(first) = found.missed.first() {
                    problems.warn(format!(
                        "the tacho misses {} of its pulses, the first at {:.4} s, where the time from pulse to pulse is a multiple of \
                         those around it: they were put in",
                        found.missed.len(),
                        signals.start + first / signals.rate,
                    ));
                }
                if found.range.len() < FEWEST {
                    let message = format!(
                        "only {} samples lie between the first and the last pulse of the tacho, and at least {FEWEST} are needed",
                        found.range.len()
                    );
                    let issue = Issue::new("speed.tacho", message);
                    problems.refuse(
                        issue.help("check that this is its channel, or give a longer record"),
                    );
                    return None;
                }
                signals.keep(found.range);
                Some(found.turning)
            }
        })
    }
}

impl SignalReader<'_> {
    /// What the speed follows from; `None` where that is wrong.
    pub fn turning(
        &mut self,
        speed: Option<&RecordSpeedInput>,
        problems: &mut Problems<'_>,
    ) -> Option<TurningSource> {
        let Some(speed) = speed else {
            return self.turning_of_run(problems);
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
                let signal = self.signal(index, &input, problems)?;
                return Some(TurningSource::Tacho(signal, speed.pulses.unwrap_or(1.0)));
            }
            self.speed(index, input, problems).map(TurningSource::Speed)
        })
    }

    /// Angle and speed of a trace of this program; of other records the speed is not known.
    fn turning_of_run(&mut self, problems: &mut Problems<'_>) -> Option<TurningSource> {
        let [Some(angle), Some(speed)] =
            [Channel::Angle, Channel::Speed].map(|channel| self.of_run(channel))
        else {
            self.offer_speed(problems);
            return Some(TurningSource::Unknown);
        };
        let [angle, speed] = [angle, speed].map(|index| {
            let input = SignalInput::of_column(&self.names[index]);
            self.signal(index, &input, problems)
        });
        Some(TurningSource::Run {
            angle: angle?,
            speed: speed?,
        })
    }

    /// A channel of speed, in rad/s.
    fn speed(
        &mut self,
        index: usize,
        input: SignalInput,
        problems: &mut Problems<'_>,
    ) -> Option<Signal> {
        let named = self.names[index].clone();
        let unit = input.unit.clone().or(self.unit(index));
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
        // speeds change little from one to the next: however many are missing, as where they were taken less often
        if let Some(samples) = self.samples(index)
            && let Some(known) = known_range(samples)
        {
            bridge(&mut samples[known]);
        }
        let mut signal = self.signal(index, &plain, problems)?;
        signal.values.iter_mut().for_each(|value| *value *= factor);
        if signal.values.iter().any(|value| *value < 0.0) {
            let message = format!("the speed in `{named}` is negative somewhere");
            let issue = Issue::new(".channel", message);
            problems.refuse(issue.help("orders need a shaft that turns one way"));
            return None;
        }
        Some(signal)
    }

    /// Names numbers of the file that may be the speed.
    fn offer_speed(&self, problems: &mut Problems<'_>) {
        let found = self.number(&["rpm", "speed", "drehzahl"], 0.0);
        if let Some((name, value)) = found {
            problems.warn(format!(
                "no speed is given, and lines have no names; the file holds {name} = {value}: if that is the speed, give it, as in \
                 --speed \"{value} rpm\""
            ));
        }
    }
}
