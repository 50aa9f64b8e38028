//! What stands near half the sampling rate, and so folds; and what is too small to fold.

use super::{Channel, Window};

/// A swing below this part of its reference is numerical noise.
const NOISE: f64 = 1e-9;
/// Where the top of the frequencies begins, of half the sampling rate.
const TOP: f64 = 0.9;

/// Amplitude below which a channel is at rest: a part of its mean; of what has no mean, velocities and
/// accelerations, of their SI unit.
pub fn rest_amplitude(channel: Channel, mean: f64) -> f64 {
    let reference = match channel {
        Channel::Displacement(_) | Channel::Force(_) => mean.abs(),
        Channel::Velocity(_) | Channel::Acceleration(_) => 1.0,
    };
    NOISE * reference
}

/// Power of a signal, its mean left out, and how much of it stands at the top of the frequencies.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TopPower {
    /// Power at all frequencies, the unit of the signal squared.
    pub total: f64,
    /// Power in the top tenth of the frequencies below half the sampling rate.
    pub top: f64,
    /// Power below which the signal is at rest.
    pub rest: f64,
}

impl TopPower {
    /// Of powers at bins 0, 1, … under a window; the amplitude `rest` is rest.
    ///
    /// What a signal holds above half its sampling rate is folded below it, first into the top. A
    /// spectrum that has fallen off there folds little; one that has not is sampled too seldom.
    ///
    /// ```
    /// use jeffcott::analysis::{TopPower, Window};
    /// let white = TopPower::of(&[1.0; 1001], 0.0, Window::Rectangular);
    /// assert!((white.top / white.total - 0.1).abs() < 2e-3);
    /// ```
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
}
