//! What was measured, as a fit file says it: a number of an answer, or lines of a channel.

use std::fs;
use std::path::Path;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use serde_json::Value;

use super::axis::Scalar;
use super::measured_value::{Amplitude, deviation, percent, positive_deviation, read};
use super::problems::{Issue, Problems};
use super::set_input::SetInput;
use crate::analysis::Channel;
use crate::fit::{Kind, Observation, Wanted};
use crate::rotor::RotorDefinition;

/// Something that was measured: a number, or lines of a channel by their amplitude, phase or both.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(super) struct ObservationInput {
    /// Which question the number answers. Default: the first of "bearing", "campbell" and "steady" that has it; of lines "steady".
    pub ask: Option<Kind>,
    /// Name of a number, as in the tables of studies: "stiffness_x_N_m", "natural_frequency_1_Hz", "y_rms_m".
    #[schemars(extend("examples" = ["natural_frequency_1_Hz"]))]
    pub number: Option<String>,
    /// Its value; what has a unit is written with one.
    #[schemars(extend("examples" = ["125 Hz"]))]
    pub value: Option<Scalar>,
    /// Displacement or force whose line was measured, as in `[output] channels`: "y", "housing1_x", "force_y".
    #[schemars(extend("examples" = ["housing1_y"]))]
    pub channel: Option<String>,
    /// What causes the line, as the tables of spectra name it: "1×" (or "1x"), "BPFO", "2×BPFO of bearing 2".
    #[schemars(extend("examples" = ["1x"]))]
    pub line: Option<String>,
    /// Its amplitude; of a displacement also as velocity or acceleration, "2.1 mm/s", "0.4 g".
    #[schemars(extend("examples" = ["2.1 mm/s"]))]
    pub amplitude: Option<Scalar>,
    /// How the amplitude is reported. Default: "peak".
    #[serde(default)]
    pub detector: Detector,
    /// Its phase φ of cos(2πft + φ), of what the unit of the amplitude says; time counts from where the mark that the unbalance
    /// angles count from points along +X.
    #[schemars(extend("examples" = ["35 deg"]))]
    pub phase: Option<Scalar>,
    /// Folder that `jeffcott analyze` has written, from which the amplitudes of `lines` are taken.
    #[schemars(extend("examples" = ["output/motor"]))]
    pub record: Option<String>,
    /// Channel of the record. Default: `channel`.
    pub column: Option<String>,
    /// Lines that are taken from the record.
    #[serde(default)]
    #[schemars(extend("examples" = [["1x", "BPFO"]]))]
    pub lines: Vec<String>,
    /// Standard deviation of value or amplitude, in its unit or as "5 %". Without any in the file all are taken for equal parts of
    /// what was measured, and their size for what the residuals show.
    #[schemars(extend("examples" = ["5 %"]))]
    pub sigma: Option<Scalar>,
    /// Standard deviation of the phase. Default: as many radians as `sigma` is of the amplitude.
    pub phase_sigma: Option<Scalar>,
    /// What was otherwise than in the base when it was measured.
    #[serde(default)]
    pub set: Vec<SetInput>,
}

/// How an amplitude is reported.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub(super) enum Detector {
    /// Peak value of the line.
    #[default]
    Peak,
    /// Its root mean square.
    Rms,
    /// Twice its peak value.
    PeakToPeak,
}

impl Detector {
    /// Peak value of what it tells.
    fn peak(self) -> f64 {
        match self {
            Self::Peak => 1.0,
            Self::Rms => 2f64.sqrt(),
            Self::PeakToPeak => 0.5,
        }
    }
}

/// An observation, and what it is compared with.
pub(super) type Reading = (Kind, Wanted, Observation);

/// The name of a line as the tables write it.
fn line_name(text: &str) -> String {
    let mut name = String::new();
    for c in text.trim().chars() {
        let times = c == 'x' && name.ends_with(|c: char| c.is_ascii_digit());
        name.push(if times {
            '×'
        } else if c == '-' {
            '−'
        } else {
            c
        });
    }
    name
}

impl ObservationInput {
    /// The observations that it makes, each with what it is compared with, called by what was set for them.
    pub fn build(
        &self,
        rotor: &RotorDefinition,
        folder: &Path,
        problems: &mut Problems<'_>,
    ) -> Option<Vec<Reading>> {
        let mut readings = self.readings(rotor, folder, problems)?;
        for (.., observation) in &mut readings {
            for SetInput { key, value } in &self.set {
                let value = value
                    .0
                    .as_str()
                    .map_or_else(|| value.0.to_string(), str::to_owned);
                observation.name += &format!(", {} = {value}", key.all().join(" = "));
            }
        }
        Some(readings)
    }

    fn readings(
        &self,
        rotor: &RotorDefinition,
        folder: &Path,
        problems: &mut Problems<'_>,
    ) -> Option<Vec<Reading>> {
        match (&self.number, &self.channel) {
            (Some(name), None) => problems.take(self.number(name, rotor)).map(|one| vec![one]),
            (None, Some(channel)) => problems.take(self.lines(channel, rotor, folder)),
            _ => {
                let message = "an observation is of a `number`, or of a line of a `channel`";
                problems.refuse(Issue::new("", message).help("give one of them"));
                None
            }
        }
    }

    fn number(&self, name: &str, rotor: &RotorDefinition) -> Result<Reading, Issue> {
        let kinds = match self.ask {
            Some(kind) => vec![kind],
            None => vec![Kind::Bearing, Kind::Campbell, Kind::Steady],
        };
        let known: Vec<_> = kinds
            .iter()
            .map(|kind| (*kind, kind.columns(rotor)))
            .collect();
        let all = || {
            known
                .iter()
                .flat_map(|(kind, columns)| columns.iter().map(move |own| (*kind, own)))
        };
        let found = all().find(|(_, column)| column.name() == name);
        let (kind, column) = found.ok_or_else(|| {
            let issue = Issue::new(
                ".number",
                format!("no answer of this scene has a number `{name}`"),
            );
            let names: Vec<String> = all().map(|(_, column)| column.name()).collect();
            let list = format!("its numbers are {}", names.join(", "));
            issue.help_nearest(name, names.iter().map(String::as_str), &list)
        })?;
        let value = self.value.as_ref().ok_or_else(|| {
            Issue::new(".value", format!("`{name}` has no `value`")).help("give what was measured")
        })?;
        let measured = read(&value.0, &column.unit, ".value")?;
        let sigma = self
            .sigma
            .as_ref()
            .map(|sigma| deviation(&sigma.0, measured, &column.unit, ".sigma"));
        let sigma = sigma.transpose()?;
        has_scale(measured, sigma, ".value")?;
        let observation = Observation {
            name: name.to_owned(),
            unit: column.unit.clone().into_owned(),
            measured,
            sigma,
            wraps: false,
        };
        Ok((kind, Wanted::Number(name.to_owned()), observation))
    }

    fn lines(
        &self,
        channel: &str,
        rotor: &RotorDefinition,
        folder: &Path,
    ) -> Result<Vec<Reading>, Issue> {
        let known = Channel::of_motion(rotor);
        let own = known.iter().find(|known| known.name() == channel);
        let channel = *own.ok_or_else(|| {
            let names: Vec<_> = known.iter().map(|known| known.name()).collect();
            let message = format!("lines of `{channel}` are not computed here");
            let help = format!(
                "give one of {}; the unit of the amplitude says whether it is a velocity or an acceleration",
                names.join(", ")
            );
            Issue::new(".channel", message).help(help)
        })?;
        if let Some(record) = &self.record {
            return self.of_record(channel, &folder.join(record));
        }
        let Some(line) = &self.line else {
            let issue = Issue::new(".channel", "which line of it was measured?");
            return Err(
                issue.help("give its `line`, as \"1x\" or \"BPFO\", or a `record` and its `lines`")
            );
        };
        let name = line_name(line);
        let amplitude = self
            .amplitude
            .as_ref()
            .map(|given| Amplitude::read(&given.0, channel, ".amplitude"));
        let amplitude = amplitude.transpose()?;
        let rate = amplitude.as_ref().map_or(0, |amplitude| amplitude.rate);
        let mut readings = Vec::new();
        if let Some(amplitude) = &amplitude {
            let peak = self.detector.peak();
            let measured = peak * amplitude.value;
            if measured < 0.0 {
                let issue = Issue::new(".amplitude", "an amplitude is not negative");
                return Err(issue.help("half a turn of the `phase` changes the sign of a line"));
            }
            let sigma = self
                .sigma
                .as_ref()
                .map(|sigma| Ok(peak * amplitude.deviation(&sigma.0, channel, ".sigma")?));
            let sigma = sigma.transpose()?;
            has_scale(measured, sigma, ".amplitude")?;
            readings.push(reading(channel, &name, rate, measured, sigma));
        }
        if let Some(phase) = &self.phase {
            let measured = read(&phase.0, "rad", ".phase")?;
            let own = self.phase_sigma.as_ref().map(|sigma| {
                positive_deviation(read(&sigma.0, "rad", ".phase_sigma")?, ".phase_sigma")
            });
            let of_amplitude = readings
                .first()
                .and_then(|(_, _, own): &Reading| Some(own.sigma? / own.measured));
            let sigma = own.transpose()?.or(of_amplitude);
            let wanted = Wanted::Phase {
                channel,
                line: name.clone(),
                rate,
            };
            let observation = Observation {
                name: wanted.to_string(),
                unit: "rad".to_owned(),
                measured,
                sigma,
                wraps: true,
            };
            readings.push((Kind::Steady, wanted, observation));
        }
        match readings.is_empty() {
            true => Err(Issue::new(
                ".line",
                "neither its `amplitude` nor its `phase` is given",
            )),
            false => Ok(readings),
        }
    }

    /// The amplitudes of lines that were found in a record.
    fn of_record(&self, channel: Channel, folder: &Path) -> Result<Vec<Reading>, Issue> {
        let path = folder.join("record.json");
        let unread = |error: &dyn std::fmt::Display| {
            let issue = Issue::new(".record", format!("{}: {error}", path.display()));
            issue.help("give a folder that `jeffcott analyze` has written")
        };
        let text = fs::read_to_string(&path).map_err(|error| unread(&error))?;
        let document: Value = serde_json::from_str(&text).map_err(|error| unread(&error))?;
        let column = self.column.as_deref().unwrap_or(channel.name());
        let peaks = document["peaks"].as_array().into_iter().flatten();
        let peaks: Vec<&Value> = peaks.filter(|peak| peak["channel"] == column).collect();
        if self.lines.is_empty() {
            let issue = Issue::new(".record", "which lines of the record are taken?");
            return Err(issue.help("for instance: lines = [\"1x\", \"BPFO\"]"));
        }
        let taken = self.lines.iter().map(|line| {
            let name = line_name(line);
            let found = peaks.iter().find(|peak| peak["name"] == name.as_str());
            let peak = found.ok_or_else(|| {
                let names = peaks.iter().filter_map(|peak| peak["name"].as_str());
                let names: Vec<_> = names.collect();
                let message = format!("the record has no line `{name}` in its channel `{column}`");
                Issue::new(".lines", message).help(format!("it has {}", names.join(", ")))
            })?;
            let (value, unit) = (peak["amplitude"].as_f64(), peak["unit"].as_str());
            let text = format!("{} {}", value.unwrap_or(f64::NAN), unit.unwrap_or_default());
            let amplitude = Amplitude::read(&text.into(), channel, ".record")?;
            let sigma = self.sigma.as_ref().map(|sigma| {
                let part = percent(&sigma.0).ok_or_else(|| {
                    Issue::new(".sigma", "of lines of a record it is a part of each")
                        .help("as \"10 %\"")
                })?;
                positive_deviation(part * amplitude.value, ".sigma")
            });
            Ok(reading(
                channel,
                &name,
                amplitude.rate,
                amplitude.value,
                sigma.transpose()?,
            ))
        });
        taken.collect()
    }
}

/// Refuses a zero without a standard deviation: without any, residuals are parts of what was measured.
fn has_scale(measured: f64, sigma: Option<f64>, place: &str) -> Result<(), Issue> {
    match measured == 0.0 && sigma.is_none() {
        true => Err(Issue::new(
            place,
            "a measured zero says nothing without its standard deviation",
        )
        .help("give `sigma` of all observations, in the unit of each or as \"5 %\"")),
        false => Ok(()),
    }
}

fn reading(channel: Channel, line: &str, rate: i32, measured: f64, sigma: Option<f64>) -> Reading {
    let wanted = Wanted::Amplitude {
        channel,
        line: line.to_owned(),
        rate,
    };
    let per = ["", "/s", "/s^2"][rate as usize];
    let observation = Observation {
        name: wanted.to_string(),
        unit: format!("{}{per}", channel.unit()),
        measured,
        sigma,
        wraps: false,
    };
    (Kind::Steady, wanted, observation)
}
