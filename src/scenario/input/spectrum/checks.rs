//! What a `[[spectrum]]` must agree with.

use std::f64::consts::TAU;

use super::{KindChoice, SpectrumInput};
use crate::analysis::{Axis, Segment, SpectrumRequest};
use crate::rotor::Freedoms;
use crate::scenario::Issue;
use crate::scenario::dimension::significant;
use crate::scenario::problems::Problems;

/// Longest name.
const LONGEST_NAME: usize = 64;
/// Fewest samples of a segment.
const FEWEST_SAMPLES: f64 = 16.0;

/// What the spectra are taken of.
pub struct Recorded<'a> {
    /// Freedoms that move.
    pub freedoms: Freedoms,
    /// Time after the settle time, s.
    pub window: f64,
    /// Samples a second.
    pub rate: f64,
    /// The key that the speed is given by.
    pub speed: &'a str,
    /// Highest speed, rad/s.
    pub highest: f64,
    /// Speed after the settle time, rad/s; zero where it changes.
    pub steady: f64,
}

impl SpectrumInput {
    pub(super) fn check_name(
        &self,
        name: &str,
        earlier: &[SpectrumRequest],
        problems: &mut Problems<'_>,
    ) {
        let path = match self.name {
            Some(_) => ".name",
            None => ".",
        };
        let plain = |c: char| c.is_ascii_alphanumeric() || c == '_' || c == '-';
        if name.is_empty() || name.len() > LONGEST_NAME || !name.chars().all(plain) {
            let message = format!(
                "`name` must be 1 to {LONGEST_NAME} letters, digits, `_` or `-`: a file is called by it"
            );
            problems.refuse(Issue::new(path, message));
        }
        // file names of some systems do not tell cases apart
        let same = |request: &SpectrumRequest| request.name.eq_ignore_ascii_case(name);
        if earlier.iter().any(same) {
            let message = format!("there are two spectra of the name \"{name}\"");
            let issue = Issue::new(path, message).help("give each a `name` of its own");
            problems.refuse(issue);
        }
    }

    pub(super) fn check_scaling(&self, problems: &mut Problems<'_>) {
        if self.kind == KindChoice::Cross && !self.scaling().is_square() {
            let message = "a cross spectrum is the product of two channels and has no amplitude";
            let issue =
                Issue::new(".scaling", message).help("set scaling = \"density\" or \"power\"");
            problems.refuse(issue.against(".kind"));
        }
    }

    /// The band of an envelope, inside of what the samples hold.
    pub(super) fn band(
        &self,
        recorded: &Recorded<'_>,
        problems: &mut Problems<'_>,
    ) -> Option<[f64; 2]> {
        let inner = ".band";
        let is_envelope = self.kind == KindChoice::Envelope;
        let issue = match (self.band.as_deref(), is_envelope) {
            (None, false) => return None,
            (None, true) => {
                Issue::new(".", "an envelope needs a `band`").help(fitting_band(recorded.rate))
            }
            (Some(_), false) => {
                let message = "`band` needs kind = \"envelope\": no other spectrum has one";
                Issue::new(inner, message).help("remove it")
            }
            (Some([low, high]), true) => {
                let band = [low.si(), high.si()];
                match wrong_band(band, recorded.rate) {
                    None => return Some(band),
                    Some(issue) => issue,
                }
            }
            (Some(_), true) => {
                let message = "`band` must be a lowest and a highest frequency";
                Issue::new(inner, message).help(fitting_band(recorded.rate))
            }
        };
        problems.refuse(issue.against(inner));
        None
    }

    pub(super) fn check_segment(&self, recorded: &Recorded<'_>, problems: &mut Problems<'_>) {
        let over = ".over";
        let speed = recorded.speed;
        if self.over == Axis::Order && recorded.highest == 0.0 {
            let issue = Issue::new(over, "a shaft that stands has no orders")
                .help("set over = \"frequency\"");
            problems.refuse(issue.against(speed));
        } else if self.over == Axis::Order && self.segment.is_some() {
            let message = "a spectrum over orders has segments in revolutions, not in seconds";
            let issue =
                Issue::new(".segment", message).help("for instance: segment_revolutions = 16");
            problems.refuse(issue.against(over));
        } else if self.over == Axis::Frequency
            && self.segment_revolutions.is_some()
            && recorded.steady == 0.0
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
    fn check_length(&self, recorded: &Recorded<'_>, problems: &mut Problems<'_>) {
        let (key, samples) = match self.segment() {
            Segment::Seconds(seconds) => ("segment", seconds * recorded.rate),
            Segment::Samples(count) if self.over == Axis::Frequency => {
                ("segment_samples", count as f64)
            }
            Segment::Revolutions(turns) if recorded.steady > 0.0 => {
                let turn = TAU / recorded.steady * recorded.rate;
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
        let others = ["time.duration", "time.settle", "output.sample_rate"];
        let issue = Issue::new(format!(".{key}"), message);
        problems.refuse(issue.against_all(others));
    }
}

/// What is wrong with a band in Hz of `rate` samples a second.
fn wrong_band([low, high]: [f64; 2], rate: f64) -> Option<Issue> {
    if high <= low {
        let message = format!("`band` must rise: {high} Hz is not above {low} Hz");
        return Some(Issue::new(".band", message).help(fitting_band(rate)));
    }
    (high > 0.5 * rate).then(|| {
        let message = format!(
            "`band` reaches {high} Hz, above {} Hz, half the sampling rate",
            significant(0.5 * rate)
        );
        let help = format!(
            "{}, or sample more often, in `[output]`",
            fitting_band(rate)
        );
        Issue::new(".band", message).help(help)
    })
}

/// How a band is written that `rate` samples a second hold.
fn fitting_band(rate: f64) -> String {
    // one digit, rounded down
    let round = |frequency: f64| {
        let unit = 10_f64.powf(frequency.log10().floor());
        significant((frequency / unit).floor() * unit)
    };
    let [low, high] = [0.1, 0.4].map(|part| round(part * rate));
    format!("for instance: band = [\"{low} Hz\", \"{high} Hz\"]")
}
