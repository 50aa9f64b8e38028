//! Mean, spread and shape of a signal, a row of values at a time.

use fearless_simd::{Level, Simd, SimdBase, SimdFloat, dispatch};

use crate::bearing::{LANES, Lanes};

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
        self.take_by(Level::new(), values);
    }

    /// As [`Moments::take`], in registers of a level of the processor.
    pub(super) fn take_by(&mut self, level: Level, values: &[f64]) {
        let row = dispatch!(level, simd => Self::of::<_, true>(simd, values));
        self.add(&row);
    }

    /// As [`Moments::take_by`] without its part in the shape: mean, RMS and extremes are those of
    /// [`Moments::take`], bit by bit, and the kurtosis means nothing.
    pub(super) fn take_plainly(&mut self, level: Level, values: &[f64]) {
        let row = dispatch!(level, simd => Self::of::<_, false>(simd, values));
        self.add(&row);
    }

    /// Of a row of values, a few side by side; with their part in the shape or without.
    #[inline(always)]
    fn of<S: Simd, const SHAPE: bool>(simd: S, values: &[f64]) -> Self {
        let (rows, rest) = values.as_chunks::<LANES>();
        let mut sum = Lanes::splat(simd, 0.0);
        let mut lowest = Lanes::splat(simd, f64::INFINITY);
        let mut highest = Lanes::splat(simd, f64::NEG_INFINITY);
        for row in rows {
            let row = simd.load_array_ref_f64x4(row);
            sum += row;
            lowest = row.min(lowest);
            highest = row.max(highest);
        }
        let mut sum = across(sum);
        let [mut lowest, mut highest] = [lowest_of(lowest), highest_of(highest)];
        for value in rest {
            sum += value;
            lowest = lowest.min(*value);
            highest = highest.max(*value);
        }
        let mean = sum / values.len().max(1) as f64;
        let mut powers = [Lanes::splat(simd, 0.0); 3];
        for row in rows {
            add_powers::<S, SHAPE>(simd, row, mean, &mut powers);
        }
        if !rest.is_empty() {
            // the mean adds nothing
            let mut last = [mean; LANES];
            last[..rest.len()].copy_from_slice(rest);
            add_powers::<S, SHAPE>(simd, &last, mean, &mut powers);
        }
        Self {
            count: values.len() as f64,
            mean,
            powers: [across(powers[0]), across(powers[1]), across(powers[2])],
            lowest,
            highest,
        }
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

/// Adds powers of the distances of values from their mean: the second, and for the shape the third and fourth.
#[inline(always)]
fn add_powers<S: Simd, const SHAPE: bool>(
    simd: S,
    values: &[f64; LANES],
    mean: f64,
    powers: &mut [Lanes<S>; 3],
) {
    let distance = simd.load_array_ref_f64x4(values) - mean;
    let square = distance * distance;
    powers[0] += square;
    if SHAPE {
        powers[1] += square * distance;
        powers[2] += square * square;
    }
}

/// Sum over the lanes.
#[inline(always)]
pub(super) fn across<S: Simd>(lanes: Lanes<S>) -> f64 {
    let [a, b, c, d] = *lanes;
    (a + b) + (c + d)
}

#[inline(always)]
fn lowest_of<S: Simd>(lanes: Lanes<S>) -> f64 {
    let [a, b, c, d] = *lanes;
    a.min(b).min(c.min(d))
}

#[inline(always)]
fn highest_of<S: Simd>(lanes: Lanes<S>) -> f64 {
    let [a, b, c, d] = *lanes;
    a.max(b).max(c.max(d))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn values() -> Vec<f64> {
        let value = |n| 1e-3 + (0.37 * f64::from(n)).sin().powi(3);
        (0..1003).map(value).collect()
    }

    #[test]
    fn values_taken_plainly_have_the_same_mean_spread_and_extremes() {
        let (mut whole, mut plain) = (Moments::default(), Moments::default());
        for row in values().chunks(64) {
            whole.take(row);
            plain.take_plainly(Level::new(), row);
        }
        let of = |moments: &Moments| {
            let extremes = [moments.peak(), moments.peak_to_peak()];
            ([moments.mean(), moments.rms()], extremes)
        };
        assert_eq!(of(&whole), of(&plain));
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
    fn widths_of_registers_change_no_byte() {
        let [mut wide, mut narrow] = [Moments::default(); 2];
        for row in values().chunks(65) {
            wide.take_by(Level::new(), row);
            narrow.take_by(Level::baseline(), row);
        }
        assert_eq!(wide, narrow);
    }

    #[test]
    fn a_row_of_nothing_changes_nothing() {
        let mut moments = Moments::default();
        moments.take(&[]);
        assert_eq!(moments, Moments::default());
    }
}
