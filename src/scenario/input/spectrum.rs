//! `[[spectrum]]`.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::channel_name::{ChannelName, GROUPS, every_channel, refuse_held, refuse_single};
use super::recorded::Recorded;
use crate::analysis::{
    Axis, Channel, Detrend, Scaling, Segment, SpectrumKind, SpectrumRequest, Window,
};
use crate::numerics::distinct::each_once;
use crate::rotor::Freedoms;
use crate::scenario::Issue;
use crate::scenario::key_path::entry;
use crate::scenario::problems::Problems;
use crate::scenario::quantity::{Frequency, Quantity, Time, si};

/// A spectrum of its own, in `spectrum_<name>.csv` and `.svg`; its settings stand in `summary.json`. It is taken
/// of what comes after `settle`.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(extend("x-at-most-one" = ["segment", "segment_revolutions", "segment_samples"]))]
pub struct SpectrumInput<C = ChannelName> {
    /// Its name, of letters, digits, `_` and `-`. Default: made of kind, scaling and `over`, for
    /// instance "envelope_peak".
    #[schemars(extend("examples" = ["velocity"]))]
    pub name: Option<String>,
    /// Channels, or groups of them: "displacement", "velocity", "acceleration" and "force" stand for
    /// all freedoms that move. A whirl takes pairs of x and y; a cross spectrum takes the first
    /// channel as reference of each of the others.
    #[schemars(extend("minItems" = 1, "examples" = [["displacement"]]))]
    pub channels: Vec<C>,
    /// What is made of the channels. Default: "plain".
    #[serde(default)]
    pub kind: KindChoice,
    /// What the values are. Default: "peak"; of a cross spectrum "density".
    pub scaling: Option<Scaling>,
    /// Window of every segment, periodic. Default: "hann".
    #[serde(default = "hann")]
    pub window: Window,
    /// Length of the segments whose powers are averaged (Welch). Default: one segment, all there is;
    /// with samples per revolution the last whole revolutions.
    #[schemars(extend("examples" = ["0.1 s"], "x-above" = 0.0))]
    pub segment: Option<Quantity<Time>>,
    /// Length of the segments in revolutions, 1 to 1000000.
    #[schemars(range(min = 1, max = 1_000_000))]
    pub segment_revolutions: Option<u32>,
    /// Length of the segments in samples, at least 16.
    #[schemars(range(min = 16, max = 1_000_000_000))]
    pub segment_samples: Option<u32>,
    /// Share of a segment that the next one holds too, 0 to 0.95. Default: 0.5.
    #[serde(default = "overlap")]
    #[schemars(range(min = 0.0, max = 0.95))]
    pub overlap: f64,
    /// What is taken out of every segment before its window. Default: "constant".
    #[serde(default)]
    pub detrend: Detrend,
    /// What the spectrum is over. Default: "frequency".
    #[serde(default)]
    pub over: Axis,
    /// Lowest and highest frequency of what the envelope is taken of, for instance
    /// ["1 kHz", "5 kHz"]. Default: the band in which the first channel knocks most, by its spectral kurtosis.
    #[schemars(extend("maxItems" = 2, "examples" = [["1 kHz", "5 kHz"]]))]
    pub band: Option<Vec<Quantity<Frequency>>>,
}

/// What is made of the channels.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum KindChoice {
    /// A one-sided spectrum of each.
    #[default]
    Plain,
    /// A one-sided spectrum of the envelope of each in a `band`: what knocks regularly.
    Envelope,
    /// Two-sided spectra of x + iy: positive frequencies turn with the shaft, negative ones against it.
    Whirl,
    /// Cross spectra of the first channel with each other one: magnitude, phase and, where segments
    /// are averaged, coherence.
    Cross,
}

fn hann() -> Window {
    Window::Hann
}

/// As in SciPy and Matlab.
fn overlap() -> f64 {
    0.5
}

/// The spectra that are asked for, as far as nothing contradicts them.
pub fn build<C: AsRef<str>>(
    spectra: &[SpectrumInput<C>],
    recorded: &Recorded<'_>,
    problems: &mut Problems<'_>,
) -> Vec<SpectrumRequest> {
    let mut requests: Vec<SpectrumRequest> = Vec::new();
    for (index, input) in spectra.iter().enumerate() {
        let request = problems.inside(entry("spectrum", index), |problems| {
            let name = input.name();
            input.check_name(&name, &requests, problems);
            input.request(name, recorded, problems)
        });
        requests.extend(request);
    }
    requests
}

impl<C: AsRef<str>> SpectrumInput<C> {
    fn request(
        &self,
        name: String,
        recorded: &Recorded<'_>,
        problems: &mut Problems<'_>,
    ) -> Option<SpectrumRequest> {
        let channels = match recorded.measured {
            Some(known) => self.measured(known, problems),
            None => self.channels(recorded.freedoms, problems),
        };
        self.check_scaling(problems);
        self.check_segment(recorded, problems);
        let band = problems.take(self.band(recorded)).flatten();
        Some(SpectrumRequest {
            name,
            kind: match self.kind {
                KindChoice::Plain => SpectrumKind::Plain,
                KindChoice::Envelope if self.band.is_none() => SpectrumKind::ImpulsiveEnvelope,
                KindChoice::Envelope => SpectrumKind::Envelope { band: band? },
                KindChoice::Whirl => SpectrumKind::Whirl,
                KindChoice::Cross => SpectrumKind::Cross,
            },
            channels,
            scaling: self.scaling(),
            window: self.window,
            segment: self.segment(),
            overlap: self.overlap,
            detrend: self.detrend,
            axis: self.over,
        })
    }

    fn scaling(&self) -> Scaling {
        self.scaling.unwrap_or(match self.kind {
            KindChoice::Cross => Scaling::Density,
            _ => Scaling::Peak,
        })
    }

    pub(super) fn segment(&self) -> Segment {
        if let Some(seconds) = si(&self.segment) {
            Segment::Seconds(seconds)
        } else if let Some(revolutions) = self.segment_revolutions {
            Segment::Revolutions(revolutions)
        } else if let Some(count) = self.segment_samples {
            Segment::Samples(count as usize)
        } else {
            Segment::Whole
        }
    }

    /// As given, or made of what tells spectra apart.
    fn name(&self) -> String {
        if let Some(name) = &self.name {
            return name.clone();
        }
        let kind = match self.kind {
            KindChoice::Plain => "",
            KindChoice::Envelope => "envelope_",
            KindChoice::Whirl => "whirl_",
            KindChoice::Cross => "cross_",
        };
        let over = match self.over {
            Axis::Frequency => "",
            Axis::Order => "_order",
        };
        format!("{kind}{}{over}", self.scaling().name())
    }

    /// The channels, each once, in the order of the table.
    fn channels(&self, freedoms: Freedoms, problems: &mut Problems<'_>) -> Vec<Channel> {
        let mut channels = Vec::new();
        for (index, word) in self.channels.iter().enumerate() {
            let word = word.as_ref();
            let found = match GROUPS.iter().find(|(name, _)| *name == word) {
                // a whirl takes those that turn
                Some((_, of)) => freedoms
                    .axes()
                    .iter()
                    .copied()
                    .filter(|freedom| self.kind != KindChoice::Whirl || *freedom != 2)
                    .map(of)
                    .collect(),
                None => {
                    let named: Vec<_> = every_channel().filter(|c| c.name() == word).collect();
                    let path = entry(".channels", index);
                    for channel in &named {
                        refuse_held(&path, *channel, freedoms, problems);
                    }
                    named
                }
            };
            channels.extend(found);
        }
        let channels = each_once(channels);
        if self.kind == KindChoice::Whirl {
            refuse_single(&channels, problems);
        }
        self.check_cross(&channels, problems);
        channels
    }

    /// The channels of a record, each once, as they are named.
    fn measured(&self, known: &[Channel], problems: &mut Problems<'_>) -> Vec<Channel> {
        let mut channels = Vec::new();
        for (index, word) in self.channels.iter().enumerate() {
            let word = word.as_ref();
            let mut named = known.iter().filter(|channel| channel.name() == word);
            let Some(channel) = named.next() else {
                let names: Vec<_> = known.iter().map(|channel| channel.name()).collect();
                let message = format!("no channel that is analysed is called `{word}`");
                let all = format!("they are {}", names.join(", "));
                let issue = Issue::new(entry(".channels", index), message);
                problems.refuse(issue.help_nearest(word, names, &all));
                continue;
            };
            if !channels.contains(channel) {
                channels.push(*channel);
            }
        }
        let has_units = |pair: &[Channel]| pair.len() == 2 && pair[0].unit() == pair[1].unit();
        if self.kind == KindChoice::Whirl && !channels.chunks(2).all(has_units) {
            let message = "a whirl takes pairs of x and y in one unit";
            let issue =
                Issue::new(".channels", message).help("for instance: channels = [\"x\", \"y\"]");
            problems.refuse(issue.against(".kind"));
        }
        self.check_cross(&channels, problems);
        channels
    }

    fn check_cross(&self, channels: &[Channel], problems: &mut Problems<'_>) {
        if self.kind == KindChoice::Cross && channels.len() < 2 {
            let message = "a cross spectrum takes two channels or more: the first is the reference";
            let issue = Issue::new(".channels", message)
                .help("for instance: channels = [\"force_x\", \"x\"]");
            problems.refuse(issue.against(".kind"));
        }
    }

    fn check_name(&self, name: &str, earlier: &[SpectrumRequest], problems: &mut Problems<'_>) {
        let path = self.name.as_ref().map_or(".", |_| ".name");
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
            problems.refuse(Issue::new(path, message).help("give each a `name` of its own"));
        }
    }

    fn check_scaling(&self, problems: &mut Problems<'_>) {
        if self.kind == KindChoice::Cross && !self.scaling().is_square() {
            let message = "a cross spectrum is the product of two channels and has no amplitude";
            let issue =
                Issue::new(".scaling", message).help("set scaling = \"density\" or \"power\"");
            problems.refuse(issue.against(".kind"));
        }
    }
}

/// Longest name.
const LONGEST_NAME: usize = 64;
