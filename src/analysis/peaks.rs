//! Peaks of a spectrum, refined between the bins.
//!
//! They are sought in the Hann-weighted spectrum whatever window the output uses: its side lobes
//! fall by 18 dB an octave, and the ratio of two neighbouring bins gives the frequency exactly.

use std::f64::consts::{PI, TAU};

use super::causes::BINS_KNOWN;
use super::{Channel, Line, Precision, Transform, Window, nearest_cause, other_causes};

/// Part of the difference of two estimates of a frequency that it is known to, and the least of it in bins.
const UNCERTAIN: f64 = 2.0;
const LEAST_UNCERTAINTY: f64 = 0.05;

/// Largest number of peaks kept of one channel.
pub const MOST_PEAKS: usize = 12;

/// A peak below this part of the channel's strongest is not reported.
const RELATIVE_THRESHOLD: f64 = 1e-6;

/// A local maximum of an amplitude spectrum.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct Peak {
    /// Quantity it was found in.
    pub channel: Channel,
    /// Frequency estimated between the bins, Hz.
    pub frequency: f64,
    /// Amplitude (peak value) in the unit of the channel.
    pub amplitude: f64,
    /// Phase in rad of `cos(2πft + phase)` at the refined frequency, time counted from the start of the
    /// window.
    pub phase: f64,
    /// The nearest known cause within the uncertainty of the frequency, if any.
    pub line: Option<Line>,
    /// Further causes as near, nearest first.
    pub others: Vec<Line>,
}

/// Peaks of one channel, strongest first, each with its nearest cause.
///
/// `centred` is the transform of the channel less its mean, `resolution` the width of a bin in Hz; amplitudes below `floor`
/// are round-off.
pub(super) fn peaks(
    channel: Channel,
    centred: &Transform,
    resolution: f64,
    causes: &[Line],
    floor: f64,
) -> Vec<Peak> {
    let hann = HannSpectrum::new(centred);
    let mut found: Vec<Refined> = Vec::with_capacity(MOST_PEAKS + 1);
    for peak in hann.maxima().filter_map(|k| hann.refine(k)) {
        // of equal ones the lower in frequency stays first
        let is_before = |other: &Refined| other.amplitude.total_cmp(&peak.amplitude).is_ge();
        found.insert(found.partition_point(is_before), peak);
        found.truncate(MOST_PEAKS);
    }
    let strongest = found.first().map_or(0.0, |peak| peak.amplitude);
    let threshold = floor.max(RELATIVE_THRESHOLD * strongest);
    let causes = &seen_in(channel, causes);
    found
        .into_iter()
        .take_while(|peak| peak.amplitude > threshold)
        .map(|refined| hann.named(&refined, channel, resolution, causes))
        .collect()
}

/// The causes with those waves first that a channel of this direction shows under thrust: of equal ones the first names a
/// line.
pub(super) fn seen_in(channel: Channel, causes: &[Line]) -> Vec<Line> {
    let mut causes = causes.to_vec();
    causes.sort_by_key(|line| !line.kind.is_of_wave(channel.is_axial()));
    causes
}

/// A maximum between the bins.
struct Refined {
    /// The bin that is above its neighbours.
    maximum: usize,
    /// Distance of the line from it, in bins, and how far that may be off.
    beside: f64,
    uncertainty: f64,
    /// Peak value.
    amplitude: f64,
}

/// Hann-weighted amplitudes of a signal less its mean.
struct HannSpectrum<'a> {
    centred: &'a Transform,
    amplitude: Vec<f64>,
    length: f64,
}

impl<'a> HannSpectrum<'a> {
    fn new(centred: &'a Transform) -> Self {
        let bins = 0..centred.bins();
        Self {
            amplitude: bins.map(|k| centred.amplitude(k, Window::Hann)).collect(),
            length: centred.length() as f64,
            centred,
        }
    }

    /// Bins that are above both neighbours; the first and the last have only one.
    fn maxima(&self) -> impl Iterator<Item = usize> {
        let triples = self.amplitude.windows(3).enumerate();
        triples
            .filter(|(_, three)| three[1] > three[0] && three[1] >= three[2])
            .map(|(k, _)| k + 1)
    }

    /// The line that makes the maximum at bin `k`; none where the maximum is narrower than the
    /// main lobe of the window, as beside bin 0 where the mean was taken away.
    fn refine(&self, k: usize) -> Option<Refined> {
        let amplitude = &self.amplitude;
        let last = amplitude.len() - 1;
        // Bin 0 and the last bin are mixed with the image of the line.
        let upwards = k == 1 || (k + 1 < last && amplitude[k + 1] >= amplitude[k - 1]);
        let neighbour = if upwards { k + 1 } else { k - 1 };
        let offset = Window::Hann.line_offset(amplitude[neighbour] / amplitude[k], self.length);
        if offset < -0.5 {
            return None;
        }
        let beside = if upwards { offset } else { -offset };
        // a single line has the same offset by the pair of bins on the other side
        let ratio = |near: usize, far: usize| {
            Window::Hann.line_offset(amplitude[near] / amplitude[far], self.length)
        };
        let again = match (upwards, k) {
            (true, 1) if k + 2 <= last => ratio(k + 2, k + 1) + 1.0,
            (true, 1) => f64::NAN,
            (true, _) => ratio(k, k - 1) - 1.0,
            (false, _) => ratio(k, k + 1) - 1.0,
        };
        let uncertainty = UNCERTAIN * (again - offset).abs();
        Some(Refined {
            maximum: k,
            beside,
            uncertainty: match uncertainty.is_nan() {
                true => BINS_KNOWN,
                false => uncertainty.clamp(LEAST_UNCERTAINTY, BINS_KNOWN),
            },
            amplitude: amplitude[k] / Window::Hann.line_response(offset, self.length),
        })
    }

    fn named(&self, found: &Refined, channel: Channel, resolution: f64, causes: &[Line]) -> Peak {
        let frequency = (found.maximum as f64 + found.beside) * resolution;
        let precision = Precision {
            resolution,
            uncertainty: found.uncertainty * resolution,
        };
        let line = nearest_cause(frequency, precision, causes);
        // the periodic window is even about its middle: a line δ bins off its bin turns by πδ
        let phase = self.centred.line(found.maximum, Window::Hann).arg() - PI * found.beside;
        Peak {
            channel,
            frequency,
            amplitude: found.amplitude,
            phase: wrapped(phase),
            line,
            others: other_causes(frequency, precision, causes, line),
        }
    }
}

/// An angle turned into −π … π.
fn wrapped(angle: f64) -> f64 {
    angle - TAU * (angle / TAU).round()
}
