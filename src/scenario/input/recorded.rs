//! What a recording allows of a spectrum.

use std::f64::consts::TAU;

use super::output::Turning;
use super::spectrum::{KindChoice, SpectrumInput};
use crate::analysis::{Axis, Channel, Segment};
use crate::rotor::Freedoms;
use crate::scenario::Issue;
use crate::scenario::problems::Problems;
use crate::scenario::quantity::significant;

impl<C: AsRef<str>> SpectrumInput<C> {
    /// The band of an envelope, inside of what the samples hold.
    pub(super) fn band(&self, recorded: &Recorded<'_>) -> Result<Option<[f64; 2]>, Issue> {
        let (message, help) = match (self.band.as_deref(), self.kind) {
            (None, _) => return Ok(None),
            (Some([low, high]), KindChoice::Envelope) => {
                let band = [low.si(), high.si()];
                return check_band(band, recorded.rate).map(|()| Some(band));
            }
            (Some(_), KindChoice::Envelope) => {
                let message = "`band` must be a lowest and a highest frequency";
                (message, fitting_band(recorded.rate))
            }
            (Some(_), _) => {
                let message = "`band` needs kind = \"envelope\": no other spectrum has one";
                (message, "remove it".to_owned())
            }
        };
        Err(Issue::new(".band", message).help(help).against(".kind"))
    }

    pub(super) fn check_segment(&self, recorded: &Recorded<'_>, problems: &mut Problems<'_>) {
        let over = ".over";
        let (speed, turns) = (recorded.turning.key, recorded.turning.highest > 0.0);
        if self.over == Axis::Order && !turns {
            let issue = Issue::new(over, "a stationary shaft has no orders")
                .help("set over = \"frequency\"");
            problems.refuse(issue.against(speed));
        } else if self.over == Axis::Order && self.segment.is_some() {
            let message = "a spectrum over orders has segments in revolutions, not in seconds";
            let issue =
                Issue::new(".segment", message).help("for instance: segment_revolutions = 16");
            problems.refuse(issue.against(over));
        } else if self.over == Axis::Frequency
            && self.segment_revolutions.is_some()
            && recorded.turning.steady.is_none_or(|speed| speed == 0.0)
        {
            let message = "revolutions are not equally long where the speed changes or is zero";
            let issue = Issue::new(".segment_revolutions", message)
                .help("give `segment` in seconds, or set over = \"order\"");
            problems.refuse(issue.against(over).against(speed));
        } else {
            self.check_length(recorded, problems);
        }
    }

    /// Refuses a segment that is longer than what is recorded, or of hardly any samples, where the
    /// number of its samples is known.
    pub(super) fn check_length(&self, recorded: &Recorded<'_>, problems: &mut Problems<'_>) {
        let (key, samples) = match self.segment() {
            Segment::Seconds(seconds) => ("segment", seconds * recorded.rate),
            Segment::Samples(count) if self.over == Axis::Frequency => {
                ("segment_samples", count as f64)
            }
            Segment::Revolutions(turns) => {
                let Some(speed) = recorded.turning.steady.filter(|speed| *speed > 0.0) else {
                    return;
                };
                let turn = TAU / speed * recorded.rate;
                ("segment_revolutions", f64::from(turns) * turn)
            }
            _ => return,
        };
        let there = (recorded.window * recorded.rate).floor() + 1.0;
        let message = if samples > there {
            format!(
                "a segment of {samples:.0} samples is longer than what comes after `settle`, {there:.0} \
                 samples in {} s",
                significant(recorded.window)
            )
        } else if samples < FEWEST_SAMPLES {
            format!("the segment is too short: {samples:.0} of at least {FEWEST_SAMPLES} samples")
        } else {
            return;
        };
        let others = [
            "time.duration",
            "time.settle",
            "output.sample_rate",
            "output.samples_per_revolution",
        ];
        let issue = Issue::new(format!(".{key}"), message);
        problems.refuse(issue.against_all(others));
    }
}

/// Fewest samples of a segment.
pub const FEWEST_SAMPLES: f64 = 16.0;

/// What the spectra are taken of.
pub struct Recorded<'a> {
    /// Freedoms that move.
    pub freedoms: Freedoms,
    /// The channels of a record, which no simulation made.
    pub measured: Option<&'a [Channel]>,
    /// Time after the settle time, s.
    pub window: f64,
    /// Samples a second.
    pub rate: f64,
    /// How the shaft turns.
    pub turning: Turning<'a>,
}

/// Refuses a band in Hz that `rate` samples a second do not hold.
pub fn check_band([low, high]: [f64; 2], rate: f64) -> Result<(), Issue> {
    let (message, remedy) = if high <= low {
        let message = format!("`band` must rise: {high} Hz is not above {low} Hz");
        (message, "")
    } else if high > 0.5 * rate {
        let half = significant(0.5 * rate);
        let message = format!("`band` reaches {high} Hz, above {half} Hz, half the sampling rate");
        (message, ", or sample more often, in `[output]`")
    } else {
        return Ok(());
    };
    Err(Issue::new(".band", message).help(fitting_band(rate) + remedy))
}

/// How a band is written that `rate` samples a second hold.
pub fn fitting_band(rate: f64) -> String {
    // one digit, rounded down
    let round = |frequency: f64| {
        let unit = 10_f64.powf(frequency.log10().floor());
        significant((frequency / unit).floor() * unit)
    };
    let [low, high] = [0.1, 0.4].map(|part| round(part * rate));
    format!("for instance: band = [\"{low} Hz\", \"{high} Hz\"]")
}
