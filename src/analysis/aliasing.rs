//! What stands near half the sampling rate, and so folds.

use super::Window;

/// A swing below this part of the mean is numerical noise.
pub(crate) const NOISE: f64 = 1e-9;
/// Where the top of the frequencies begins, of half the sampling rate.
const TOP: f64 = 0.9;

/// Power of a signal, its mean left out, and how much of it stands at the top of the frequencies.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TopPower {
    /// Power at all frequencies, the unit of the signal squared.
    pub total: f64,
    /// Power in the top tenth of the frequencies below half the sampling rate.
    pub top: f64,
}

impl TopPower {
    /// Of powers at bins 0, 1, … under a window; `None` of rest about a mean.
    ///
    /// What a signal holds above half its sampling rate is folded below it, first into the top. A
    /// spectrum that has fallen off there folds little; one that has not is sampled too seldom.
    ///
    /// ```
    /// use jeffcott::analysis::{TopPower, Window};
    /// let white = TopPower::of(&[1.0; 1001], 0.0, Window::Rectangular).unwrap();
    /// assert!((white.top / white.total - 0.1).abs() < 2e-3);
    /// assert_eq!(TopPower::of(&[0.0; 100], 5.0, Window::Hann), None);
    /// ```
    pub fn of(powers: &[f64], mean: f64, window: Window) -> Option<Self> {
        // the window spreads the mean over the first bins
        let first = window.coefficients().len().min(powers.len());
        let begin = (TOP * powers.len() as f64) as usize;
        let found = Self {
            total: powers[first..].iter().sum(),
            top: powers[begin.max(first)..].iter().sum(),
        };
        (found.total > (NOISE * mean).powi(2)).then_some(found)
    }
}
