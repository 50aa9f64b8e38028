//! What sampling and its end do to a spectrum: aliasing of what is above half the sampling rate, and leakage of lines
//! that lie between the bins of an unweighted one.

use std::f64::consts::PI;

use nalgebra::Complex;

use super::{Channel, ChannelSpectrum, Window};

/// What sampling and its end did to a channel of a spectrum.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ChannelCheck {
    /// The channel.
    pub channel: Channel,
    /// Its power, and that in the top tenth of the axis, which shows aliasing.
    pub top_power: Option<TopPower>,
    /// The line that leaks most, where it does.
    pub leak: Option<Leak>,
}

/// Where the top of the frequencies begins, of half the sampling rate.
const TOP: f64 = 0.9;

/// Power of a signal, its mean left out, and how much of it is at the top of the frequencies.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TopPower {
    /// Power at all frequencies, the unit of the signal squared.
    pub total: f64,
    /// Power in the top tenth of the frequencies below half the sampling rate.
    pub top: f64,
    /// Power below which the signal is round-off.
    pub rest: f64,
}

impl TopPower {
    /// Of powers at bins 0, 1, … under a window; amplitudes below `rest` are round-off.
    ///
    /// What a signal holds above half its sampling rate is folded below it, first into the top. A
    /// spectrum that has fallen off there folds little; one that has not is sampled too seldom.
    pub fn new(powers: &[f64], rest: f64, window: Window) -> Self {
        // the window spreads the mean over the first bins
        let first = window.coefficients().len().min(powers.len());
        let begin = (TOP * powers.len() as f64) as usize;
        Self {
            total: powers[first..].iter().sum(),
            top: powers[begin.max(first)..].iter().sum(),
            rest: rest * rest,
        }
    }

    /// Of a channel of a spectrum under a window. Of an unweighted one the skirts of lines and of ends
    /// that do not meet reach up to the top: it is weighted after Hann first.
    pub fn of_channel(entry: &ChannelSpectrum, window: Window, rest: f64) -> Self {
        match window {
            Window::Rectangular => Self::new(&hann_powers(entry), rest, Window::Hann),
            _ => {
                let powers: Vec<f64> = entry.amplitude.iter().map(|a| 0.5 * a * a).collect();
                Self::new(&powers, rest, window)
            }
        }
    }
}

/// Powers of an unweighted spectrum as the Hann window shows them, `Y_k = X_k − ½(X_{k−1} + X_{k+1})`;
/// those of the first two bins and of the last are left out, and zero.
fn hann_powers(entry: &ChannelSpectrum) -> Vec<f64> {
    let bins = entry.amplitude.iter().zip(&entry.phase);
    let bins: Vec<_> = bins
        .map(|(a, phase)| Complex::from_polar(*a, *phase))
        .collect();
    let mut powers = vec![0.0; bins.len()];
    for k in 2..bins.len().saturating_sub(1) {
        let weighted = bins[k] - (bins[k - 1] + bins[k + 1]) * 0.5;
        powers[k] = 0.5 * weighted.norm_sqr();
    }
    powers
}

/// Lines below this part of the strongest are left out.
const STRONG: f64 = 0.1;
/// Fewest bins from either end of the spectrum: nearer ones are mixed with their image.
const MARGIN: usize = 3;
/// How far the neighbours of a line may be from what a single line leaves there, of its height.
const LIKENESS: f64 = 0.1;
/// Lines nearer to their bin than this show 99 % of their amplitude.
const SMALLEST_OFFSET: f64 = 0.08;
/// Lines with less than this part of the power are no lines but the hills of noise.
const POWER: f64 = 0.01;
/// Skirts are followed down to this part of their line.
const SKIRT: f64 = 0.01;

/// A line that leaks.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Leak {
    /// The bin next to it.
    pub bin: usize,
    /// How far it is off that bin, −½ … ½ bins.
    pub offset: f64,
    /// Its amplitude.
    pub amplitude: f64,
}

impl Leak {
    /// Part of the amplitude that the bin shows, `sin πδ/πδ`.
    pub fn shown(&self) -> f64 {
        (PI * self.offset).sin() / (PI * self.offset)
    }

    /// Bins to either side within which the skirts are above a hundredth of the line:
    /// at d bins they are `sin πδ/πd` of it.
    pub fn reach(&self) -> f64 {
        (PI * self.offset).sin().abs() / (PI * SKIRT)
    }
}

/// The line of an unweighted amplitude spectrum (peak values at bins 0, 1, …) that leaks most, of the
/// strong ones that are off their bin; amplitudes up to `noise` are none.
///
/// A line δ bins off bin k leaves 1/|δ|, 1/(1 − δ) and 1/(1 + δ) at bins k and k ± 1, and 1/(2 ∓ δ)
/// beyond; what is not so is no line. Source: Harris, Proc. IEEE 66 (1978), sect. IV.
pub fn leak(amplitudes: &[f64], noise: f64) -> Option<Leak> {
    let inner = MARGIN..amplitudes.len().saturating_sub(MARGIN);
    let powers = amplitudes.iter().skip(1).map(|a| a * a);
    let total: f64 = powers.sum();
    let strongest = amplitudes.iter().skip(1).copied().fold(0.0, f64::max);
    let leaked = |line: &Leak| line.amplitude * (PI * line.offset).sin().abs();
    inner
        .filter(|k| amplitudes[*k] > noise && amplitudes[*k] >= STRONG * strongest)
        .filter(|k| amplitudes[*k].powi(2) > POWER * total)
        .filter_map(|k| line(amplitudes, k))
        .filter(|line| line.offset.abs() > SMALLEST_OFFSET)
        .max_by(|a, b| leaked(a).total_cmp(&leaked(b)))
}

/// The single line that makes a maximum at bin `k`.
fn line(amplitudes: &[f64], k: usize) -> Option<Leak> {
    let height = amplitudes[k];
    let [below, above] = [k - 1, k + 1].map(|k| amplitudes[k] / height);
    if below > 1.0 || above >= 1.0 {
        return None;
    }
    let side = if above >= below { 1.0 } else { -1.0 };
    let ratio = above.max(below);
    let offset = ratio / (1.0 + ratio);
    let [far, beyond, behind] = if side > 0.0 {
        [k - 1, k + 2, k - 2]
    } else {
        [k + 1, k - 2, k + 2]
    };
    let expected = [
        (far, offset / (1.0 + offset)),
        (beyond, offset / (2.0 - offset)),
        (behind, offset / (2.0 + offset)),
    ];
    let alike = |(k, part): (usize, f64)| (amplitudes[k] / height - part).abs() < LIKENESS;
    let mut found = Leak {
        bin: k,
        offset: side * offset,
        amplitude: height,
    };
    if offset > 0.0 {
        found.amplitude /= found.shown();
    }
    expected.into_iter().all(alike).then_some(found)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::analysis::Transform;
    use std::f64::consts::TAU;

    #[test]
    fn a_tenth_of_white_noise_is_at_the_top() {
        let white = TopPower::new(&[1.0; 1001], 0.0, Window::Rectangular);
        assert!((white.top / white.total - 0.1).abs() < 2e-3);
    }

    #[test]
    fn a_line_between_bins_is_found() {
        let line = |n: usize| 3.0 * (TAU * 20.3 * n as f64 / 256.0).cos();
        let transform = Transform::new((0..256).map(line).collect());
        let amplitudes: Vec<f64> = (0..transform.bins())
            .map(|k| transform.amplitude(k, Window::Rectangular))
            .collect();
        let found = leak(&amplitudes, 1e-12).unwrap();
        assert_eq!(found.bin, 20);
        assert!((found.offset - 0.3).abs() < 0.02 && (found.amplitude - 3.0).abs() < 0.1);
    }
}
