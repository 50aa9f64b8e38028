//! Band-limited noise, and the random numbers of all loads.

use std::f64::consts::TAU;

use super::MainVibration;
use crate::bearing::Vector5;

/// What noise is asked for.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct NoiseBand {
    /// Root mean square of each component, N and N m.
    pub rms: Vector5,
    /// Lowest frequency, Hz.
    pub low: f64,
    /// Highest frequency, Hz.
    pub high: f64,
    /// Number of cosines of each component.
    pub lines: u32,
    /// Seed: the same one gives the same noise.
    pub seed: u64,
}

/// Noise of a flat spectrum between two frequencies: a sum of cosines.
///
/// ```text
/// P(t) = P_rms √(2/N) Σ_k cos(2π f_k t + φ_k),   k = 0 … N−1
/// f_k = f_low + (k + u_k)(f_high − f_low)/N,     φ_k = 2π u'_k,   u, u' uniform in 0 … 1
/// ```
///
/// Exactly limited to its band and a pure function of time. The frequencies are irregular, so
/// it does not repeat; its values are Gaussian for many lines. Components are independent. An
/// evaluation costs N cosines for each component that is not zero.
///
/// Source: Shinozuka & Deodatis, *Simulation of stochastic processes by spectral representation*,
/// Appl. Mech. Rev. 44 (1991) 191; frequencies shifted after Shinozuka & Jan, J. Sound Vib. 25
/// (1972) 111.
#[derive(Debug, Clone, PartialEq)]
pub struct Noise {
    main_vibration: MainVibration,
    /// Component, angular frequency in rad/s, phase in rad, and amplitude of every cosine.
    lines: Vec<Line>,
}

#[derive(Debug, Clone, Copy, PartialEq)]
struct Line {
    axis: usize,
    frequency: f64,
    phase: f64,
    amplitude: f64,
}

impl Noise {
    /// The noise of a band and a seed.
    pub fn new(band: &NoiseBand) -> Self {
        let count = f64::from(band.lines);
        let width = (band.high - band.low) / count;
        let mut lines = Vec::new();
        let axes = band.rms.into_iter().enumerate();
        for (axis, rms) in axes.filter(|(_, rms)| *rms > 0.0) {
            let random = SplitMix64::new(band.seed).stream(axis as u64);
            lines.extend((0..band.lines).map(|k| {
                let (shift, phase) = (2 * u64::from(k), 2 * u64::from(k) + 1);
                let frequency = band.low + (f64::from(k) + random.uniform(shift)) * width;
                Line {
                    axis,
                    frequency: TAU * frequency,
                    phase: TAU * random.uniform(phase),
                    amplitude: rms * (2.0 / count).sqrt(),
                }
            }));
        }
        Self {
            main_vibration: MainVibration::at(TAU * band.low, band.rms),
            lines,
        }
    }

    /// The load at a time in s.
    #[inline]
    pub fn at(&self, time: f64) -> Vector5 {
        let mut sum = [0.0; 5];
        for line in &self.lines {
            sum[line.axis] += line.amplitude * (line.frequency * time + line.phase).cos();
        }
        sum
    }

    /// Its root mean square at its lowest frequency.
    pub fn main_vibration(&self) -> MainVibration {
        self.main_vibration
    }
}

/// The generator SplitMix64: number n is a mix of `seed + (n + 1)·0x9e3779b97f4a7c15`.
///
/// Every number can be had by itself, on every machine the same. Its period is 2⁶⁴.
///
/// Source: Steele, Lea & Flood, *Fast splittable pseudorandom number generators*, OOPSLA 2014,
/// with the constants of Vigna's `splitmix64.c`.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct SplitMix64 {
    seed: u64,
}

impl SplitMix64 {
    /// The sequence of a seed.
    pub fn new(seed: u64) -> Self {
        Self { seed }
    }

    /// A sequence of its own for each stream of one seed.
    pub fn stream(self, number: u64) -> Self {
        Self::new(self.bits(number))
    }

    /// 64 random bits.
    pub fn bits(self, counter: u64) -> u64 {
        let step = counter.wrapping_add(1).wrapping_mul(0x9e37_79b9_7f4a_7c15);
        let mut mixed = self.seed.wrapping_add(step);
        mixed = (mixed ^ (mixed >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        mixed = (mixed ^ (mixed >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        mixed ^ (mixed >> 31)
    }

    /// A number uniform between 0 and 1, both left out.
    pub fn uniform(self, counter: u64) -> f64 {
        // the middle of one of 2⁵² equal parts
        ((self.bits(counter) >> 12) as f64 + 0.5) / (1_u64 << 52) as f64
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_those_of_splitmix64_c() {
        // the first number that splitmix64.c gives for the seed 1234567
        assert_eq!(
            SplitMix64::new(1_234_567).bits(0),
            6_457_827_717_110_365_317
        );
    }
}
