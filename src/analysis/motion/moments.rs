//! Mean, spread and shape of a signal, a row of values at a time.

use serde::{Serialize, Serializer};

/// Moments of the values taken so far.
///
/// Those of a row are found about its own mean, and added to those of all rows before without cancellation.
///
/// Source: P. Pébay, *Formulas for robust, one-pass parallel computation of covariances and
/// arbitrary-order statistical moments*, Sandia report SAND2008-6212 (2008), eq. 2.1 and 3.1.
///
/// ```
/// use jeffcott::analysis::Moments;
/// let sine = |n| 5.0 + 2.0 * (std::f64::consts::TAU * f64::from(n) / 1000.0).cos();
/// let mut moments = Moments::default();
/// moments.take(&(0..700).map(sine).collect::<Vec<_>>());
/// moments.take(&(700..1000).map(sine).collect::<Vec<_>>());
/// // a sine: RMS 2/√2, crest factor √2, kurtosis 3/2
/// assert!((moments.mean() - 5.0).abs() < 1e-12);
/// assert!((moments.rms() - 2f64.sqrt()).abs() < 1e-12);
/// assert!((moments.crest_factor().unwrap() - 2f64.sqrt()).abs() < 1e-12);
/// assert!((moments.kurtosis().unwrap() - 1.5).abs() < 1e-12);
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Moments {
    count: f64,
    mean: f64,
    /// Sums of the second, third and fourth powers of the distances from the mean.
    powers: [f64; 3],
    lowest: f64,
    highest: f64,
}

impl Serialize for Moments {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_map([
            ("mean", Some(self.mean())),
            ("rms", Some(self.rms())),
            ("peak", Some(self.peak())),
            ("peak_to_peak", Some(self.peak_to_peak())),
            ("crest_factor", self.crest_factor()),
            ("kurtosis", self.kurtosis()),
        ])
    }
}

impl Default for Moments {
    fn default() -> Self {
        Self {
            count: 0.0,
            mean: 0.0,
            powers: [0.0; 3],
            lowest: f64::INFINITY,
            highest: f64::NEG_INFINITY,
        }
    }
}

impl Moments {
    /// Takes a row of values.
    pub fn take(&mut self, values: &[f64]) {
        let count = values.len() as f64;
        let [sum] = sums(values, |value| [value]);
        let mean = sum / count.max(1.0);
        let of_powers = |value: f64| {
            let distance = value - mean;
            let square = distance * distance;
            [square, square * distance, square * square]
        };
        self.add(&Self {
            count,
            mean,
            powers: sums(values, of_powers),
            lowest: values.iter().copied().fold(f64::INFINITY, f64::min),
            highest: values.iter().copied().fold(f64::NEG_INFINITY, f64::max),
        });
    }

    /// Adds the moments of other values.
    fn add(&mut self, other: &Self) {
        let (a, b) = (self.count, other.count);
        let n = a + b;
        if b == 0.0 {
            return;
        }
        let delta = other.mean - self.mean;
        let part = delta / n;
        let square = part * part;
        let ([second, third, fourth], [own, own_third, own_fourth]) = (other.powers, self.powers);
        self.powers = [
            own + second + delta * part * a * b,
            own_third
                + third
                + delta * square * a * b * (a - b)
                + 3.0 * part * (a * second - b * own),
            own_fourth
                + fourth
                + delta * part * square * a * b * (a * a - a * b + b * b)
                + 6.0 * square * (a * a * second + b * b * own)
                + 4.0 * part * (a * third - b * own_third),
        ];
        self.count = n;
        self.mean += part * b;
        self.lowest = self.lowest.min(other.lowest);
        self.highest = self.highest.max(other.highest);
    }

    /// Mean; zero of no values.
    pub fn mean(&self) -> f64 {
        self.mean
    }

    /// Root of the mean square distance from the mean: the RMS of the vibration.
    pub fn rms(&self) -> f64 {
        if self.count > 0.0 {
            (self.powers[0] / self.count).sqrt()
        } else {
            0.0
        }
    }

    /// Largest distance from the mean, either way; zero of no values.
    pub fn peak(&self) -> f64 {
        let (above, below) = (self.highest - self.mean, self.mean - self.lowest);
        above.max(below).max(0.0)
    }

    /// Distance from the lowest to the highest value; zero of no values.
    pub fn peak_to_peak(&self) -> f64 {
        (self.highest - self.lowest).max(0.0)
    }

    /// Peak over RMS; none without vibration.
    pub fn crest_factor(&self) -> Option<f64> {
        let rms = self.rms();
        (rms > 0.0).then(|| self.peak() / rms)
    }

    /// Fourth moment over the square of the second, 3 for Gaussian noise; none without vibration.
    pub fn kurtosis(&self) -> Option<f64> {
        let [second, _, fourth] = self.powers;
        (second > 0.0).then(|| self.count * fourth / (second * second))
    }
}

/// Sums over values of some numbers of each; four sums a number, so that none waits for the addition before.
fn sums<const K: usize>(values: &[f64], of: impl Fn(f64) -> [f64; K]) -> [f64; K] {
    let mut sums = [[0.0; 4]; K];
    let (fours, rest) = values.as_chunks::<4>();
    for four in fours.iter().map(|four| four.as_slice()).chain([rest]) {
        for (place, value) in four.iter().enumerate() {
            for (sums, number) in sums.iter_mut().zip(of(*value)) {
                sums[place] += number;
            }
        }
    }
    sums.map(|[a, b, c, d]| (a + b) + (c + d))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn values() -> Vec<f64> {
        let value = |n| 1e-3 + (0.37 * f64::from(n)).sin().powi(3);
        (0..1003).map(value).collect()
    }

    #[test]
    fn moments_of_rows_are_those_of_all_values_at_once() {
        let values = values();
        let count = values.len() as f64;
        let mean = values.iter().sum::<f64>() / count;
        let power = |n: i32| {
            let powers = values.iter().map(|value| (value - mean).powi(n));
            powers.sum::<f64>() / count
        };
        for length in [1, 3, 64, 2000] {
            let mut moments = Moments::default();
            for row in values.chunks(length) {
                moments.take(row);
            }
            assert!((moments.mean() - mean).abs() < 1e-15, "{length}");
            assert!((moments.rms() - power(2).sqrt()).abs() < 1e-14, "{length}");
            let kurtosis = moments.kurtosis().expect("a vibration");
            let expected = power(4) / power(2).powi(2);
            assert!((kurtosis - expected).abs() < 1e-13, "{length}: {kurtosis}");
            let highest = values.iter().copied().fold(0.0, f64::max);
            assert_eq!(moments.highest, highest);
        }
    }

    #[test]
    fn a_row_of_nothing_changes_nothing() {
        let mut moments = Moments::default();
        moments.take(&[]);
        assert_eq!(moments, Moments::default());
    }
}
