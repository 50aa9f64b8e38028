//! `[[spectrum]]`.

mod channels;
mod checks;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::analysis::{Axis, Detrend, Scaling, Segment, SpectrumKind, SpectrumRequest, Window};
use crate::scenario::problems::Problems;
use crate::scenario::quantity::{Frequency, Quantity, Time};
use channels::ChannelName;
pub use checks::Recorded;

/// Share of a segment that the next one holds, where none is given: as in SciPy and Matlab.
const OVERLAP: f64 = 0.5;

/// A spectrum of its own, in `spectrum_<name>.csv` and `.svg`; its settings stand in `summary.json`. It is taken
/// of what comes after `settle`.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(extend("x-at-most-one" = ["segment", "segment_revolutions", "segment_samples"]))]
pub struct SpectrumInput {
    /// Its name, of letters, digits, `_` and `-`. Default: made of kind, scaling and `over`, for
    /// instance "envelope_peak".
    #[schemars(extend("examples" = ["velocity"]))]
    pub name: Option<String>,
    /// Channels, or groups of them: "displacement", "velocity", "acceleration" and "force" stand for
    /// all freedoms that move. A whirl takes pairs of x and y; a cross spectrum takes the first
    /// channel as reference of each of the others.
    #[schemars(extend("minItems" = 1, "examples" = [["displacement"]]))]
    pub channels: Vec<ChannelName>,
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
    /// The same in revolutions, 1 to 1000000.
    #[schemars(range(min = 1, max = 1_000_000))]
    pub segment_revolutions: Option<u32>,
    /// The same in samples, at least 16.
    #[schemars(range(min = 16, max = 1_000_000_000))]
    pub segment_samples: Option<u32>,
    /// Share of a segment that the next one holds too, 0 to 0.95. Default: 0.5.
    #[serde(default = "overlap")]
    #[schemars(range(min = 0.0, max = 0.95))]
    pub overlap: f64,
    /// What is taken out of every segment before its window. Default: "constant".
    #[serde(default)]
    pub detrend: Detrend,
    /// What the spectrum stands over. Default: "frequency".
    #[serde(default)]
    pub over: Axis,
    /// Lowest and highest frequency of what the envelope is taken of, for instance
    /// ["1 kHz", "5 kHz"].
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
    /// The same of the envelope of what stands in a `band`: what knocks regularly.
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

fn overlap() -> f64 {
    OVERLAP
}

/// The spectra that are asked for, as far as nothing contradicts them.
pub fn build(
    spectra: &[SpectrumInput],
    recorded: &Recorded<'_>,
    problems: &mut Problems<'_>,
) -> Vec<SpectrumRequest> {
    let mut requests: Vec<SpectrumRequest> = Vec::new();
    for (index, input) in spectra.iter().enumerate() {
        let request = problems.inside(format!("spectrum[{index}]"), |problems| {
            let name = input.name();
            input.check_name(&name, &requests, problems);
            input.request(name, recorded, problems)
        });
        requests.extend(request);
    }
    requests
}

impl SpectrumInput {
    fn request(
        &self,
        name: String,
        recorded: &Recorded<'_>,
        problems: &mut Problems<'_>,
    ) -> Option<SpectrumRequest> {
        let channels = self.channels(recorded.freedoms, problems);
        self.check_scaling(problems);
        self.check_segment(recorded, problems);
        let band = self.band(recorded, problems);
        Some(SpectrumRequest {
            name,
            kind: match self.kind {
                KindChoice::Plain => SpectrumKind::Plain,
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

    fn segment(&self) -> Segment {
        let seconds = self.segment.as_ref();
        let seconds = seconds.map(|segment| Segment::Seconds(segment.si()));
        let revolutions = self.segment_revolutions.map(Segment::Revolutions);
        let samples = self.segment_samples;
        let samples = samples.map(|count| Segment::Samples(count as usize));
        seconds
            .or(revolutions)
            .or(samples)
            .unwrap_or(Segment::Whole)
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
}
