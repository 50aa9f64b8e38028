//! Mean, spread and shape of a signal, one value at a time.

/// Moments of the values taken so far.
///
/// Updated value by value without cancellation.
///
/// Source: P. Pébay, *Formulas for robust, one-pass parallel computation of covariances and
/// arbitrary-order statistical moments*, Sandia report SAND2008-6212 (2008), eq. 2.1–2.4 for single
/// values.
///
/// ```
/// use jeffcott::analysis::Moments;
/// let mut moments = Moments::default();
/// for n in 0..1000 {
///     moments.take(5.0 + 2.0 * (std::f64::consts::TAU * f64::from(n) / 1000.0).cos());
/// }
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
    /// Takes a value.
    pub fn take(&mut self, value: f64) {
        let before = self.count;
        self.count += 1.0;
        let n = self.count;
        let delta = value - self.mean;
        let part = delta / n;
        let square = part * part;
        let term = delta * part * before;
        let [second, third, fourth] = self.powers;
        self.mean += part;
        self.powers = [
            second + term,
            third + term * part * (n - 2.0) - 3.0 * part * second,
            fourth + term * square * (n * n - 3.0 * n + 3.0) + 6.0 * square * second
                - 4.0 * part * third,
        ];
        self.lowest = self.lowest.min(value);
        self.highest = self.highest.max(value);
    }

    /// Takes a value without its part in the shape: mean, RMS and extremes are those of [`Moments::take`], bit
    /// by bit, and the kurtosis means nothing.
    pub fn take_plainly(&mut self, value: f64) {
        let before = self.count;
        self.count += 1.0;
        let delta = value - self.mean;
        let part = delta / self.count;
        self.mean += part;
        self.powers[0] += delta * part * before;
        self.lowest = if value < self.lowest {
            value
        } else {
            self.lowest
        };
        self.highest = if value > self.highest {
            value
        } else {
            self.highest
        };
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn values_taken_plainly_have_the_same_mean_spread_and_extremes() {
        let (mut whole, mut plain) = (Moments::default(), Moments::default());
        for n in 0..1000 {
            let value = 1e-3 + (0.37 * f64::from(n)).sin().powi(3);
            whole.take(value);
            plain.take_plainly(value);
        }
        let of = |moments: &Moments| {
            let extremes = [moments.peak(), moments.peak_to_peak()];
            ([moments.mean(), moments.rms()], extremes)
        };
        assert_eq!(of(&whole), of(&plain));
    }
}
