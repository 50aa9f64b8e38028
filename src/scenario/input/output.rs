//! `[output]`.

use std::f64::consts::PI;
use std::num::NonZeroU64;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::settings::TimeInput;
use crate::analysis::{Channel, Window};
use crate::scenario::Issue;
use crate::scenario::key_path::entry;
use crate::scenario::problems::Problems;
use crate::scenario::quantity::{Frequency, Quantity, significant};
use crate::simulate::{Analyses, MotionAnalysis, Sampling};

/// Samples per revolution where neither key is given.
const SAMPLES_PER_REVOLUTION: u32 = 128;
/// Most rows that the trace has by default.
const MOST_ROWS: f64 = 1e5;
/// Most samples of a run.
const MOST_SAMPLES: f64 = 1e9;
/// Fewest samples that a spectrum is taken of.
const FEWEST_IN_SPECTRUM: f64 = 8.0;

/// What to keep of the run.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
#[schemars(extend("x-at-most-one" = ["samples_per_revolution", "sample_rate"]))]
pub struct Output {
    /// Samples per shaft revolution, 8 to 65536; where the speed varies, per revolution at its
    /// highest: the samples stand at equal times. Default: 128.
    #[schemars(range(min = 8, max = 65_536))]
    pub samples_per_revolution: Option<u32>,
    /// Samples per second, for instance "20 kHz", instead of samples per revolution; needed
    /// where the shaft is stationary.
    #[schemars(extend("x-minimum" = 1e-3))]
    pub(super) sample_rate: Option<Quantity<Frequency>>,
    /// Window of the spectra. Default: "rectangular", exact for lines on a bin, or "hann" where strong lines are not on one.
    pub window: Option<Window>,
    /// Whether the trace is written. Default: true.
    pub trace: bool,
    /// Whether energy is accounted for, in `energy.csv` and the summary; that of a driven shaft
    /// always is. Default: false.
    pub energy: bool,
    /// Whether load and contact angle of every ball at both races are written at every sample, to
    /// `trace_balls.csv`. Default: false.
    pub balls: bool,
    /// Whether every loss and return of contact and preload is written, to `events.csv`; they are
    /// counted in the summary either way. Default: true.
    pub events: bool,
    /// Whether spectra are taken, in `spectrum.csv`, of the last 131 072 samples or 256 revolutions after the settle time,
    /// whichever is more; those of `[[spectrum]]` are either way, of all. Default: where the
    /// speed is constant after the settle time; while it changes, lines smear, and `maps` has short-time spectra.
    pub spectrum: Option<bool>,
    /// Whether figures are drawn. Default: true.
    pub figures: bool,
    /// Whether `report.html` is written, one page that shows the result in a browser. Default: true.
    pub report: bool,
    /// Whether the motion after the settle time is described: statistics, points once per revolution
    /// and per ball pass (`poincare.csv`, `orbit.svg`), its period, and whether it has settled. It takes
    /// a constant speed there. Default: as `spectrum`, where the speed is constant.
    pub motion: Option<bool>,
    /// Whether a run whose speed changes is mapped: short-time spectra (`waterfall.csv`, `waterfall.svg`),
    /// orders of the shaft (`order_tracks.csv`, `order_tracks.svg`) and natural frequencies over the speed
    /// (`campbell.csv`, `campbell.svg`). Default: as `figures`, where the speed changes.
    pub maps: Option<bool>,
    /// Formats of the tables. Default: CSV alone.
    #[schemars(extend("minItems" = 1))]
    pub formats: Vec<TableFormat>,
    /// Of how many samples one is written to the trace and the tables beside it, beginning with the
    /// first; spectra, figures and the summary do not depend on it. Default: so many that at most 100 000 rows are
    /// written.
    #[schemars(range(min = 1, max = 1_000_000))]
    pub every: Option<NonZeroU64>,
    /// What the written trace shows besides the time, in this order; `bearing2_force_x`, … as `bearing1_force_x`. Default:
    /// everything but accelerations of the shaft and moments of single bearings; the force of each bearing where there are
    /// two and more.
    #[schemars(extend("minItems" = 1))]
    pub channels: Option<Vec<Channel>>,
}

/// How the shaft turns, as far as samples and spectra ask.
#[derive(Clone, Copy)]
pub struct Turning<'a> {
    /// The key that says so.
    pub key: &'a str,
    /// Highest speed, rad/s.
    pub highest: f64,
    /// Speed after the settle time, rad/s; none where it changes.
    pub steady: Option<f64>,
    /// Whether it changes at all.
    pub changes: bool,
}

impl Default for Output {
    fn default() -> Self {
        Self {
            samples_per_revolution: None,
            sample_rate: None,
            window: None,
            trace: true,
            energy: false,
            balls: false,
            events: true,
            spectrum: None,
            figures: true,
            report: true,
            motion: None,
            maps: None,
            formats: vec![TableFormat::Csv],
            every: None,
            channels: None,
        }
    }
}

impl Output {
    /// Whether spectra are taken of a run whose speed is constant after the settle time, or changes.
    pub fn takes_spectra(&self, steady: bool) -> bool {
        self.spectrum.unwrap_or(steady)
    }

    /// Of how many samples one is written, of a number of samples.
    pub fn written_of(&self, samples: f64) -> NonZeroU64 {
        let least = NonZeroU64::new((samples / MOST_ROWS).ceil() as u64);
        self.every.or(least).unwrap_or(NonZeroU64::MIN)
    }

    /// Refuses formats that this build cannot write, and what is asked for twice.
    pub(super) fn check_written(&self, problems: &mut Problems<'_>) {
        for (index, format) in self.formats.iter().enumerate() {
            let path = entry("output.formats", index);
            if !format.is_built() {
                let issue = Issue::new(path, "this `jeffcott` is built without Parquet");
                let help = "take \"csv\", or build it with `--features parquet`";
                problems.refuse(issue.help(help));
            } else if self.formats[..index].contains(format) {
                problems.refuse(twice(path, format.extension()));
            }
        }
        let channels = self.channels.as_deref().unwrap_or_default();
        for (index, channel) in channels.iter().enumerate() {
            if channels[..index].contains(channel) {
                let path = entry("output.channels", index);
                problems.refuse(twice(path, channel.name()));
            }
        }
    }

    /// Sampling of the run, where it suits time and speed.
    pub(super) fn sampling(
        &self,
        turning: Turning<'_>,
        time: &TimeInput,
        problems: &mut Problems<'_>,
    ) -> Option<Sampling> {
        let (key, speed) = (turning.key, turning.highest);
        let per_revolution = self.samples_per_revolution;
        let sampling = match &self.sample_rate {
            Some(rate) => Sampling::Rate(rate.si()),
            None if speed > 0.0 => {
                Sampling::PerRevolution(per_revolution.unwrap_or(SAMPLES_PER_REVOLUTION))
            }
            None => {
                self.refuse_angle_grid(key, problems);
                return None;
            }
        };
        let rate = sampling.rate(speed);
        self.check_count(rate, key, time, problems);
        if self.takes_spectra(turning.steady.is_some()) && time.window() > 0.0 {
            // where the speed changes, a spectrum rests on no revolution
            check_window((key, turning.steady.unwrap_or(0.0)), rate, time, problems);
        }
        Some(sampling)
    }

    /// What is made of the samples besides the spectra.
    pub(super) fn analyses(&self, turning: Turning<'_>, problems: &mut Problems<'_>) -> Analyses {
        let (steady, changes) = (turning.steady.is_some(), turning.changes);
        if self.motion == Some(true) && !steady {
            let message =
                "the speed changes after `settle`: only a motion at constant speed has a period";
            let issue = Issue::new("output.motion", message)
                .help("remove it, or set `settle` in `[time]` to where the speed is constant");
            problems.refuse(issue.against("time.settle"));
        }
        if self.maps == Some(true) && !changes {
            let message = "the speed does not change: there is nothing to map";
            let issue = Issue::new("output.maps", message)
                .help("remove it; `jeffcott campbell` follows natural frequencies over the speed");
            problems.refuse(issue.against("speed.constant"));
        }
        let motion = steady && self.motion.unwrap_or(self.takes_spectra(true));
        Analyses {
            motion: match motion {
                true => MotionAnalysis::Kind,
                false => MotionAnalysis::None,
            },
            maps: changes && self.maps.unwrap_or(self.figures),
            ..Analyses::default()
        }
    }

    /// Refuses a trace of balls where no bearing knows any.
    pub(super) fn check_balls(&self, known: bool, problems: &mut Problems<'_>) {
        if self.balls && !known {
            let message = "a linear bearing knows no rolling elements that could be traced";
            let issue = Issue::new("output.balls", message)
                .help("remove it, or set contact = \"hertz\" or \"jones\" in `[model]`");
            problems.refuse(issue.against("model.contact"));
        }
    }

    fn refuse_angle_grid(&self, speed: &str, problems: &mut Problems<'_>) {
        let given = self.samples_per_revolution.is_some();
        let path = if given {
            "output.samples_per_revolution"
        } else {
            speed
        };
        let message = match speed {
            _ if given => "a standing shaft makes no revolutions to sample",
            "speed.drive" => {
                "a drive from rest without `no_load_speed` needs a `sample_rate` in `[output]`"
            }
            _ => "a standing shaft needs a `sample_rate` in `[output]`",
        };
        let issue = Issue::new(path, message).help("for instance: sample_rate = \"20 kHz\"");
        let others = [speed, "output.sample_rate"];
        problems.refuse(issue.against_all(others));
    }

    fn check_count(&self, rate: f64, speed: &str, time: &TimeInput, problems: &mut Problems<'_>) {
        let count = time.duration.si() * rate;
        if count > MOST_SAMPLES {
            let key = match self.sample_rate {
                Some(_) => "output.sample_rate",
                None => "output.samples_per_revolution",
            };
            let message =
                format!("{count:.3e} samples are too many: at most {MOST_SAMPLES:e} in a run");
            let issue =
                Issue::new("time.duration", message).help("shorten it or sample less often");
            problems.refuse(issue.against_all([key, speed]));
        }
    }
}

fn twice(path: String, word: &str) -> Issue {
    Issue::new(path, format!("\"{word}\" is asked for twice")).help("remove one")
}

/// Refuses a spectrum of less than one revolution, or of hardly any samples.
fn check_window(
    (key, speed): (&str, f64),
    rate: f64,
    time: &TimeInput,
    problems: &mut Problems<'_>,
) {
    let window = time.window();
    let (needed, what) = if speed > 0.0 && window < 2.0 * PI / speed {
        (2.0 * PI / speed, "one revolution takes")
    } else if window * rate < FEWEST_IN_SPECTRUM {
        (FEWEST_IN_SPECTRUM / rate, "eight samples take")
    } else {
        return;
    };
    let message = format!(
        "the spectrum has {} s after `settle`, and {what} {} s",
        significant(window),
        significant(needed)
    );
    // Rounded up to the microsecond, so that the advice holds.
    let shortest = ((time.settle.si() + needed) * 1e6).ceil() / 1e6;
    let help = format!("make it {shortest} s or longer, or set `spectrum = false` in `[output]`");
    let issue = Issue::new("time.duration", message).help(help);
    problems.refuse(issue.against_all(["time.settle", key, "output.sample_rate"]));
}

/// Format of the tables of a run.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum TableFormat {
    /// Comma-separated values.
    Csv,
    /// Apache Parquet; only where `jeffcott` is built with it.
    Parquet,
}

impl TableFormat {
    /// All formats.
    pub const ALL: [Self; 2] = [Self::Csv, Self::Parquet];

    /// Name in a scenario, and the ending of its files.
    pub fn extension(self) -> &'static str {
        match self {
            Self::Csv => "csv",
            Self::Parquet => "parquet",
        }
    }

    /// Whether this build can write it.
    pub fn is_built(self) -> bool {
        self != Self::Parquet || cfg!(feature = "parquet")
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_are_those_of_a_scenario() {
        for format in TableFormat::ALL {
            assert_eq!(serde_json::json!(format), format.extension());
        }
    }
}
