//! The speed of a shaft that nobody gave, by the lines of its bearing.

use std::f64::consts::TAU;

use serde::Serialize;

use super::{MeasuredBearing, lines};
use crate::analysis::{
    Axis, BearingFrequencies, EstimatedSpectrum, Peak, Precision, SpectrumKind, nearest_cause,
};

/// Lines of each envelope, and peaks of each spectrum, that are looked at: the strongest.
const MOST_LINES: usize = 12;
/// Speeds that are told.
const MOST_TOLD: usize = 3;
/// Fewest lines that a speed explains, and part of their power.
const FEWEST: usize = 3;
const LEAST_SHARE: f64 = 0.5;
/// Part of a speed within which a peak is taken for its own.
const REACH: f64 = 0.02;
/// Bins within which a line is explained.
const KNOWN: f64 = 0.5;

/// A speed at which the lines would be those of shaft and bearing.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct SpeedEstimate {
    /// Frequency of the shaft, Hz.
    #[serde(rename = "shaft_frequency_Hz")]
    pub shaft_frequency: f64,
    /// Lines that it explains, and how many there are.
    pub lines: [usize; 2],
    /// Whether the spectrum has a peak there.
    pub is_peak: bool,
    /// Their part of the power of the lines.
    pub share: f64,
    /// What the strongest of them would be.
    pub strongest: String,
}

/// Speeds that explain most of the lines of envelopes, the best first: each is that of a shaft whose ball pass, or its double,
/// is one of the lines.
pub(super) fn found(
    bearings: &[MeasuredBearing],
    spectra: &[EstimatedSpectrum],
    peaks: &[Peak],
) -> Vec<SpeedEstimate> {
    let mut estimates: Vec<SpeedEstimate> = Vec::new();
    let is_envelope = |spectrum: &&EstimatedSpectrum| {
        matches!(spectrum.request.kind, SpectrumKind::Envelope { .. })
            && spectrum.request.axis == Axis::Frequency
    };
    for spectrum in spectra.iter().filter(is_envelope) {
        let mut all = spectrum.lines_above_noise(0);
        all.sort_by(|a, b| b.1.total_cmp(&a.1));
        all.truncate(MOST_LINES);
        for own in bearings {
            let rolling = own.bearing.rolling_ball_pass(own.slip.unwrap_or(0.0), TAU);
            let orders = [rolling.outer, rolling.inner];
            let places = all.iter().take(4).flat_map(|(at, _)| [*at, 0.5 * at]);
            let shafts = places.flat_map(|at| orders.map(|order| at / order));
            let judged = shafts.filter_map(|shaft| judge(own, &all, shaft, spectrum.resolution));
            estimates.extend(judged);
        }
    }
    // a speed whose own line is a peak of the spectrum is likelier, and known by that: the cage may slip
    for estimate in &mut estimates {
        let near = |peak: &&Peak| (peak.frequency / estimate.shaft_frequency - 1.0).abs() < REACH;
        let near = peaks.iter().filter(near);
        let own = near.max_by(|a, b| a.amplitude.total_cmp(&b.amplitude));
        estimate.is_peak = own.is_some();
        estimate.shaft_frequency = own.map_or(estimate.shaft_frequency, |peak| peak.frequency);
    }
    estimates.sort_by(|a, b| {
        let rank = |it: &SpeedEstimate| (it.is_peak, it.lines[0]);
        rank(b).cmp(&rank(a)).then(b.share.total_cmp(&a.share))
    });
    let mut told: Vec<SpeedEstimate> = Vec::new();
    for estimate in estimates {
        let known = |other: &SpeedEstimate| {
            (other.shaft_frequency / estimate.shaft_frequency - 1.0).abs() < REACH
        };
        if !told.iter().any(known) {
            told.push(estimate);
        }
    }
    told.truncate(MOST_TOLD);
    told
}

/// What a shaft frequency in Hz explains of lines in Hz; none where that is little.
fn judge(
    own: &MeasuredBearing,
    all: &[(f64, f64)],
    shaft: f64,
    resolution: f64,
) -> Option<SpeedEstimate> {
    let slip = own.slip.unwrap_or(0.0);
    let pass = own.bearing.rolling_ball_pass(slip, TAU * shaft);
    let passes = BearingFrequencies {
        simulated: pass,
        nominal: pass,
    };
    // with all sidebands and multiples of shaft, cage and spin anything would be explained
    let mut causes = lines(std::slice::from_ref(own), &[passes], shaft);
    causes.retain(|line| line.kind.is_main());
    let precision = Precision {
        resolution,
        uncertainty: KNOWN * resolution,
    };
    let named = all.iter().filter_map(|(at, value)| {
        let line = nearest_cause(*at, precision, &causes)?;
        Some((value * value, line.kind.to_string()))
    });
    let named: Vec<_> = named.collect();
    let power: f64 = all.iter().map(|(_, value)| value * value).sum();
    let share = named.iter().map(|(power, _)| power).sum::<f64>() / power;
    (named.len() >= FEWEST && share >= LEAST_SHARE).then(|| SpeedEstimate {
        shaft_frequency: shaft,
        lines: [named.len(), all.len()],
        is_peak: false,
        share,
        strongest: named[0].1.clone(),
    })
}
