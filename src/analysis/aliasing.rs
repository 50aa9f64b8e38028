//! What stands near half the sampling rate, and so folds.

use nalgebra::Complex;

use super::{ChannelSpectrum, Window};

/// Where the top of the frequencies begins, of half the sampling rate.
const TOP: f64 = 0.9;

/// Power of a signal, its mean left out, and how much of it stands at the top of the frequencies.
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
    pub fn of(powers: &[f64], rest: f64, window: Window) -> Self {
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
            Window::Rectangular => Self::of(&hann_powers(entry), rest, Window::Hann),
            _ => {
                let powers: Vec<f64> = entry.amplitude.iter().map(|a| 0.5 * a * a).collect();
                Self::of(&powers, rest, window)
            }
        }
    }
}

/// Powers of an unweighted spectrum as the Hann window shows them, `Y_k = X_k − ½(X_{k−1} + X_{k+1})`;
/// those of the first two bins and of the last are not looked at, and zero.
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_tenth_of_white_noise_is_at_the_top() {
        let white = TopPower::of(&[1.0; 1001], 0.0, Window::Rectangular);
        assert!((white.top / white.total - 0.1).abs() < 2e-3);
    }
}
