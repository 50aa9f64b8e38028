//! RMS velocity in a band of frequencies.

use std::f64::consts::TAU;
use std::ops::Range;

use realfft::RealFftPlanner;
use realfft::num_complex::Complex;
use serde::Serialize;

use crate::analysis::{Transform, Window};

/// Equivalent noise bandwidth of the Hann window in bins: what the lobe of a line adds up to.
const NOISE_BANDWIDTH: f64 = 1.5;
/// Bins of a segment below the band.
const BINS_BELOW: f64 = 32.0;
/// Bins about an end of the band within which lines beyond it are looked for: of those further away nothing is seen in it.
const NEAR_END: f64 = 3.0;
/// Bins within which a line beyond the band is on its end.
const ON_END: f64 = 0.1;
/// Bins on either side that a line is taken out of.
const LOBES: usize = 5;
/// Fewest samples that a level is known of.
const FEWEST: usize = 16;

/// A factor at a frequency in Hz.
pub type Rate = fn(f64) -> f64;

/// What makes an amplitude in a unit that of a velocity in m/s: 2πf of a displacement, 1/(2πf) of an acceleration; none of
/// another unit.
pub fn velocity_rate(unit: &str) -> Option<Rate> {
    match unit {
        "m" => Some(|at| TAU * at),
        "m/s^2" => Some(|at| if at > 0.0 { 1.0 / (TAU * at) } else { 0.0 }),
        _ => None,
    }
}

/// RMS of a velocity in a band of frequencies.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[non_exhaustive]
pub struct VelocityLevel {
    /// RMS, m/s.
    #[serde(rename = "rms_m_s")]
    pub rms: f64,
    /// Lowest and highest frequency that counts, Hz: of the band of the speed what the record resolves.
    #[serde(rename = "band_Hz")]
    pub band: [f64; 2],
}

/// Takes the samples of a velocity in m/s and finds its RMS in a band.
///
/// `v_RMS² = Σ_k A_k²/(2 · 1.5)` over the bins in the band, A_k amplitudes under a Hann window, whose
/// lobe counts a line one and a half times, wherever it lies between bins. At either end of the band the bins of one
/// more half lobe count, so that a line on the end, as that of the shaft at 600 rpm, counts as a whole; lines beyond the end are
/// taken out of them. That of accelerations begins two bins from zero at least, beyond the lobe of the mean.
///
/// A record of less than 48 periods of the lowest frequency is transformed as a whole; of a longer one the powers of segments of
/// 32, each half over the one before, are averaged, so that memory does not grow with the record.
///
/// Source: for the quantity, ISO 20816-1:2016, broad-band RMS velocity. Its zones
/// belong to whole machines, measured at the housing; what is simulated here is the shaft.
#[derive(Debug, Clone)]
pub struct LevelRecorder {
    rate: f64,
    /// Lowest and highest frequency that is asked for, Hz.
    wanted: [f64; 2],
    /// What makes velocities of the samples, line by line; none of velocities.
    velocity: Option<Rate>,
    /// Lowest bin that counts. What lines between bins leave of the mean lies within its lobe, and is large once integrated.
    lowest_bin: usize,
    /// Samples of a segment.
    segment: usize,
    /// The last samples, less than one and a half segments.
    samples: Vec<f64>,
    /// Sum of the powers of the segments before them, and their number.
    power: f64,
    segments: u32,
}

impl LevelRecorder {
    /// For `rate` samples a second and a band in Hz.
    pub fn new(rate: f64, wanted: [f64; 2]) -> Self {
        let periods = (BINS_BELOW * rate / wanted[0]).ceil() as usize;
        Self {
            rate,
            wanted,
            velocity: None,
            lowest_bin: 1,
            segment: periods.max(FEWEST),
            samples: Vec::new(),
            power: 0.0,
            segments: 0,
        }
    }

    /// Of all samples of a quantity whose unit makes a velocity; none of another unit, or of too few.
    ///
    /// Accelerations are integrated, and displacements derived, in the frequency domain: A/(2πf) and 2πf A of every line in the
    /// band.
    pub fn level(
        samples: &[f64],
        unit: &str,
        rate: f64,
        wanted: [f64; 2],
    ) -> Option<VelocityLevel> {
        let velocity = velocity_rate(unit);
        if velocity.is_none() && unit != "m/s" {
            return None;
        }
        let lowest_bin = match unit {
            "m/s^2" => Window::Hann.lobe(),
            _ => 1,
        };
        let mut recorder = Self {
            velocity,
            lowest_bin,
            ..Self::new(rate, wanted)
        };
        let mut planner = RealFftPlanner::new();
        samples
            .iter()
            .for_each(|sample| recorder.take(*sample, &mut planner));
        recorder.finish(&mut planner)
    }

    /// Takes one sample.
    pub fn take(&mut self, velocity: f64, planner: &mut RealFftPlanner<f64>) {
        self.samples.push(velocity);
        let hop = self.segment / 2;
        if self.samples.len() == self.segment + hop {
            self.power += self.power_of(0..self.segment, planner);
            self.segments += 1;
            self.samples.drain(..hop);
        }
    }

    /// The level; none of too few samples, and where the record resolves nothing of the band.
    pub fn finish(mut self, planner: &mut RealFftPlanner<f64>) -> Option<VelocityLevel> {
        let count = self.samples.len();
        if count < FEWEST {
            return None;
        }
        // the last segment ends with the record; one that has no other is the whole record
        let first = match self.segments {
            0 => 0,
            _ => count - self.segment,
        };
        let resolution = self.rate / (count - first) as f64;
        let band = [
            self.wanted[0].max(self.lowest_bin as f64 * resolution),
            self.wanted[1].min(0.5 * self.rate),
        ];
        if band[0] >= band[1] {
            return None;
        }
        self.power += self.power_of(first..count, planner);
        let mean = self.power / f64::from(self.segments + 1);
        Some(VelocityLevel {
            rms: (mean / NOISE_BANDWIDTH).sqrt(),
            band,
        })
    }

    /// Power in the band of some samples, every line counted for its lobe.
    fn power_of(&self, samples: Range<usize>, planner: &mut RealFftPlanner<f64>) -> f64 {
        let resolution = self.rate / samples.len() as f64;
        let transform = Transform::planned(self.samples[samples].to_vec(), planner).without_mean();
        let band = self.wanted.map(|end| end / resolution);
        let first = (band[0].floor() as usize).saturating_sub(1);
        let last = (band[1].ceil() as usize + 1).min(transform.bins() - 1);
        let begin = first.saturating_sub(LOBES);
        let bins = begin..(last + LOBES).min(transform.bins());
        let mut lines: Vec<_> = bins.map(|k| transform.line(k, Window::Hann)).collect();
        take_out_lines_beyond(band, transform.length() as f64, begin, &mut lines);
        let factor = |k: usize| {
            self.velocity
                .map_or(1.0, |rate| rate(k as f64 * resolution))
        };
        let power = |k: usize| 0.5 * (factor(k) * lines[k - begin].norm()).powi(2);
        (first.max(self.lowest_bin)..=last).map(power).sum()
    }
}

/// Takes out of the bins from `begin` on of a spectrum of N samples what strong lines just beyond a band, in bins, leave in it.
///
/// A line f bins from zero whose largest bin is k has `Y_m = (−1)^(m − k) Y_k H(f − m)/H(f − k)` at bin m, with H of
/// [`Window::line_response`].
fn take_out_lines_beyond(
    [low, high]: [f64; 2],
    length: f64,
    begin: usize,
    lines: &mut [Complex<f64>],
) {
    let near = |end: f64| {
        let first = (end - NEAR_END).max(1.0) as usize;
        first.max(begin + 1)..(end + NEAR_END) as usize + 1
    };
    for k in near(low).chain(near(high)) {
        let index = |bin: usize| bin - begin;
        let three = lines.get(index(k - 1)..index(k + 2));
        let Some([below, at, above]) = three.map(|three| [0, 1, 2].map(|j| three[j].norm())) else {
            continue;
        };
        if at <= below || at < above {
            continue;
        }
        let (ratio, side) = match above >= below {
            true => (above / at, 1.0),
            false => (below / at, -1.0),
        };
        let place = k as f64 + side * Window::Hann.line_offset(ratio, length);
        if (low - ON_END..=high + ON_END).contains(&place) {
            continue;
        }
        let response = |bin: usize| Window::Hann.line_response(place - bin as f64, length);
        let line = lines[index(k)] / response(k);
        let bins = k.saturating_sub(LOBES).max(begin)..(k + LOBES + 1).min(begin + lines.len());
        for (bin, own) in bins.clone().zip(&mut lines[index(bins.start)..]) {
            let sign = if bin.abs_diff(k) % 2 == 0 { 1.0 } else { -1.0 };
            *own -= line * (sign * response(bin));
        }
    }
}

#[cfg(test)]
mod tests {
    use std::f64::consts::TAU;

    use super::*;

    fn level(
        samples: impl Iterator<Item = f64>,
        rate: f64,
        band: [f64; 2],
    ) -> Option<VelocityLevel> {
        let mut planner = RealFftPlanner::new();
        let mut recorder = LevelRecorder::new(rate, band);
        for velocity in samples {
            recorder.take(velocity, &mut planner);
            assert!(recorder.samples.len() < recorder.segment + recorder.segment / 2);
        }
        recorder.finish(&mut planner)
    }

    #[test]
    fn the_level_counts_what_is_in_the_band() {
        // 3 mm/s at 50 Hz counts, 40 mm/s at 5 Hz and 20 mm/s at 1200 Hz do not
        let line = |amplitude: f64, frequency: f64, n: u32| {
            amplitude * (TAU * frequency * f64::from(n) / 4000.0).cos()
        };
        let signal = |n| line(3e-3, 50.0, n) + line(4e-2, 5.0, n) + line(2e-2, 1200.0, n);
        let level = level((0..4000).map(signal), 4000.0, [10.0, 1e3]).unwrap();
        assert!((level.rms - 3e-3 / 2f64.sqrt()).abs() < 1e-15);
        assert_eq!(level.band, [10.0, 1e3]);
    }

    /// 3 mm/s at 50 Hz as an acceleration and as a displacement.
    #[test]
    fn accelerations_are_integrated_and_displacements_derived() {
        for (unit, size) in [
            ("m/s^2", TAU * 50.0),
            ("m", 1.0 / (TAU * 50.0)),
            ("m/s", 1.0),
        ] {
            let line = |n: u32| 3e-3 * size * (TAU * 50.0 * f64::from(n) / 4000.0).cos();
            let samples: Vec<f64> = (0..8000).map(line).collect();
            let level = LevelRecorder::level(&samples, unit, 4000.0, [10.0, 1e3]).unwrap();
            let error = level.rms * 2f64.sqrt() / 3e-3 - 1.0;
            // the lobe of a line counts at its bins' own frequencies
            assert!(error.abs() < 1e-3, "{unit}: {error}");
        }
        assert!(LevelRecorder::level(&[0.0; 100], "N", 4000.0, [10.0, 1e3]).is_none());
    }

    #[test]
    fn a_line_between_bins_or_on_the_end_counts_as_a_whole() {
        // bins of 0.5 Hz
        for frequency in [2.0, 2.2, 5.0, 5.13, 9.77, 600.4, 999.9, 1000.0] {
            let line = |n: u32| (TAU * frequency * f64::from(n) / 3000.0 + 0.7).cos();
            let level = level((0..6000).map(line), 3000.0, [2.0, 1e3]).unwrap();
            let error = level.rms * 2f64.sqrt() - 1.0;
            assert!(error.abs() < 2e-3, "{frequency} Hz: {error}");
        }
    }

    /// 20 mm/s at 8.3 or 1001.5 Hz beside 1 mm/s at 50 Hz, whatever the length of the record.
    #[test]
    fn a_line_just_beyond_the_band_does_not_count() {
        for (count, beyond) in [
            (3000, 8.3),
            (3000, 9.4),
            (6000, 9.2),
            (3000, 1001.5),
            (30_000, 9.9),
        ] {
            let line = |amplitude: f64, frequency: f64, n: u32| {
                amplitude * (TAU * frequency * f64::from(n) / 3000.0 + 0.4).cos()
            };
            let signal = |n| line(20e-3, beyond, n) + line(1e-3, 50.0, n);
            let level = level((0..count).map(signal), 3000.0, [10.0, 1e3]).unwrap();
            let error = level.rms * 2f64.sqrt() / 1e-3 - 1.0;
            assert!(error.abs() < 0.05, "{beyond} Hz in {count}: {error}");
        }
    }

    /// A line of 100 m/s² at 2.36 kHz moves at 6.7 mm/s; of the mean that it has over 0.1 or 0.2 s nothing counts from 10 Hz on.
    #[test]
    fn an_acceleration_beyond_the_band_has_no_velocity_in_it() {
        for count in [2400, 4800] {
            let line = |n: u32| 100.0 * (TAU * 2362.3 * f64::from(n) / 24e3).cos();
            let samples: Vec<f64> = (0..count).map(line).collect();
            let level = LevelRecorder::level(&samples, "m/s^2", 24e3, [10.0, 1e3]).unwrap();
            assert!(level.rms < 2e-5, "{level:?}");
            assert_eq!(level.band[0], 2.0 * 24e3 / f64::from(count));
        }
    }

    /// Samples that are kept at a time are bounded, and a line has its level whatever segments it is cut into.
    #[test]
    fn a_long_record_is_averaged_over_segments() {
        for count in [48_000, 48_001, 70_123, 320_000] {
            let line = |n: u32| (TAU * 31.7 * f64::from(n) / 10_000.0).cos();
            let level = level((0..count).map(line), 10_000.0, [10.0, 1e3]).unwrap();
            let error = level.rms * 2f64.sqrt() - 1.0;
            assert!(error.abs() < 1e-6, "{count}: {error}");
            assert_eq!(level.band, [10.0, 1e3]);
        }
    }
}
