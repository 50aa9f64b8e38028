//! The speed of a shaft that nobody gave, by the lines of its bearing.

use std::f64::consts::TAU;

use serde::Serialize;

use super::{MeasuredBearing, lines, slip};
use crate::analysis::{
    Axis, BearingFrequencies, EstimatedSpectrum, Peak, Precision, SpectrumKind, nearest_cause,
};
use crate::physics::Race;

/// Lines of each envelope, and peaks of each spectrum, that are looked at: the strongest.
const MOST_LINES: usize = 12;
/// Speeds that are reported.
const MOST_REPORTED: usize = 3;
/// Fewest lines that a speed explains, and part of their power.
const FEWEST: usize = 3;
const LEAST_SHARE: f64 = 0.5;
/// Races whose ball pass a line may be.
const RACES: [Race; 2] = [Race::Outer, Race::Inner];
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
        for column in spectrum.value_columns() {
            let mut all = spectrum.lines_above_noise(column);
            all.sort_by(|a, b| b.1.total_cmp(&a.1));
            all.truncate(MOST_LINES);
            let lines = EnvelopeLines {
                all: &all,
                resolution: spectrum.resolution,
            };
            for own in bearings {
                let places = all.iter().take(4).flat_map(|(at, _)| [*at, 0.5 * at]);
                let passes = places.flat_map(|at| RACES.map(|race| (at, race)));
                estimates.extend(passes.filter_map(|pass| lines.estimate(own, pass, peaks)));
            }
        }
    }
    estimates.sort_by(|a, b| {
        let rank = |it: &SpeedEstimate| (it.is_peak, it.lines[0]);
        rank(b).cmp(&rank(a)).then(b.share.total_cmp(&a.share))
    });
    let mut reported: Vec<SpeedEstimate> = Vec::new();
    for estimate in estimates {
        let known = |other: &SpeedEstimate| {
            (other.shaft_frequency / estimate.shaft_frequency - 1.0).abs() < REACH
        };
        if !reported.iter().any(known) {
            reported.push(estimate);
        }
    }
    reported.truncate(MOST_REPORTED);
    reported
}

/// The strongest lines of an envelope.
struct EnvelopeLines<'a> {
    /// Places in Hz and amplitudes, the strongest first.
    all: &'a [(f64, f64)],
    resolution: f64,
}

impl EnvelopeLines<'_> {
    /// The speed at which a line in Hz is the ball pass of a race; none where it explains little of all lines.
    ///
    /// A speed whose own line is a peak of the spectrum is likelier, and known by that: from there to where the cage would roll, it
    /// slips.
    fn estimate(
        &self,
        own: &MeasuredBearing,
        (at, race): (f64, Race),
        peaks: &[Peak],
    ) -> Option<SpeedEstimate> {
        let known = own.slip.unwrap_or(0.0);
        let pass = own.bearing.rolling_ball_pass(known, TAU);
        let shaft = match race {
            Race::Outer => at / pass.outer,
            Race::Inner => at / pass.inner,
        };
        let near = |peak: &&Peak| (peak.frequency / shaft - 1.0).abs() < REACH;
        let near = peaks.iter().filter(near);
        let peak = near.max_by(|a, b| a.amplitude.total_cmp(&b.amplitude));
        let by_peak = peak.and_then(|peak| {
            let slipping = || slip::cage_slip(own, Some(race), at / peak.frequency);
            let slip = own.slip.unwrap_or_else(slipping);
            self.judge(own, peak.frequency, slip)
        });
        match by_peak {
            Some(estimate) => Some(SpeedEstimate {
                is_peak: true,
                ..estimate
            }),
            None => self.judge(own, shaft, known),
        }
    }

    /// What a shaft frequency in Hz explains of the lines, with a slip of the cage; none where that is little.
    fn judge(&self, own: &MeasuredBearing, shaft: f64, slip: f64) -> Option<SpeedEstimate> {
        let pass = own.bearing.rolling_ball_pass(slip, TAU * shaft);
        let passes = BearingFrequencies {
            simulated: pass,
            nominal: pass,
        };
        // with all sidebands and multiples of shaft, cage and spin anything would be explained
        let mut causes = lines(std::slice::from_ref(own), &[passes], shaft);
        causes.retain(|line| line.kind.is_main());
        let precision = Precision {
            resolution: self.resolution,
            uncertainty: KNOWN * self.resolution,
        };
        let named = self.all.iter().filter_map(|(at, value)| {
            let line = nearest_cause(*at, precision, &causes)?;
            Some((value * value, line.kind.to_string()))
        });
        let named: Vec<_> = named.collect();
        let power: f64 = self.all.iter().map(|(_, value)| value * value).sum();
        let share = named.iter().map(|(power, _)| power).sum::<f64>() / power;
        (named.len() >= FEWEST && share >= LEAST_SHARE).then(|| SpeedEstimate {
            shaft_frequency: shaft,
            lines: [named.len(), self.all.len()],
            is_peak: false,
            share,
            strongest: named[0].1.clone(),
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::analysis::Channel;
    use crate::bearing::{Bearing, FreePosition, Geometry};

    fn bearing() -> MeasuredBearing {
        let free = FreePosition::ContactAngle(0.0);
        let geometry = Geometry::new(9, 7.94e-3, 39.04e-3, free, 0.52, 0.52);
        MeasuredBearing {
            name: "6205".to_owned(),
            bearing: Bearing::of_steel(geometry.expect("it can be built")),
            slip: None,
        }
    }

    /// By the ball pass at the outer race, beside a peak at 30 Hz.
    fn estimate(own: &MeasuredBearing, places: &[f64]) -> SpeedEstimate {
        let all: Vec<_> = places.iter().map(|place| (*place, 1.0)).collect();
        let lines = EnvelopeLines {
            all: &all,
            resolution: 0.2,
        };
        let peak = Peak {
            channel: Channel::Displacement(0),
            frequency: 30.0,
            amplitude: 1.0,
            phase: 0.0,
            line: None,
            others: Vec::new(),
        };
        let found = lines.estimate(own, (places[0], Race::Outer), &[peak]);
        found.expect("it explains the lines")
    }

    #[test]
    fn a_slipping_cage_is_judged_at_the_speed_of_the_peak() {
        let own = bearing();
        let outer = own.bearing.rolling_ball_pass(0.01, TAU * 30.0).outer;
        let found = estimate(&own, &[outer, 2.0 * outer, 3.0 * outer, 30.0, 60.0]);
        assert_eq!((found.shaft_frequency, found.is_peak), (30.0, true));
        assert_eq!(found.lines, [5, 5]);
        assert!((found.share - 1.0).abs() < 1e-12, "{found:?}");
    }

    #[test]
    fn a_peak_that_explains_few_lines_is_not_taken_for_the_speed() {
        let own = bearing();
        let pass = own.bearing.rolling_ball_pass(0.0, TAU * 29.7);
        let found = estimate(&own, &[pass.outer, pass.inner, 2.0 * pass.inner, 29.7]);
        assert!((found.shaft_frequency / 29.7 - 1.0).abs() < 1e-12);
        assert_eq!((found.lines, found.is_peak), ([4, 4], false));
    }
}
