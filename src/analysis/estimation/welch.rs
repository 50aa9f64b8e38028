//! Welch's method: the powers of overlapping, weighted segments, averaged.

use std::array;
use std::ops::MulAssign;
use std::sync::Arc;

use realfft::num_complex::Complex;
use realfft::{RealFftPlanner, RealToComplex};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::signal::Signal;
use crate::analysis::Window;

/// Powers of signals, averaged over overlapping segments.
///
/// Every segment loses its trend, is weighted by the periodic window and transformed; powers are
/// averaged and divided by (Σ w)². Samples at the end that fill no segment are left out. This is what
/// `scipy.signal.welch` does with `window=(name, fftbins=True)`, `nperseg`, `noverlap`, `detrend` and
/// the average "mean"; [`super::Scaling`] gives its results their scale.
///
/// Source: P. D. Welch, IEEE Trans. Audio Electroacoust. 15 (1967) 70–73.
pub struct Welch {
    /// Samples of a segment.
    pub length: usize,
    /// Samples that a segment shares with the next.
    pub overlap: usize,
    detrend: Detrend,
    weights: Vec<f64>,
    /// Σ w, to which the powers are referred.
    sum: f64,
    plan: Arc<dyn RealToComplex<f64>>,
}

/// Cross power of two signals with what it is compared to.
#[derive(Debug, Clone, PartialEq)]
pub struct CrossPower {
    /// Mean of `conj(X) Y`, X of the reference.
    pub cross: Vec<Complex<f64>>,
    /// Power of the reference.
    pub reference: Vec<f64>,
    /// Power of the other signal.
    pub other: Vec<f64>,
}

impl CrossPower {
    /// Coherence `|P_xy|²/(P_xx P_yy)` of bin `k`, 0 … 1; zero where one of the signals has no power.
    /// It says something of averages only: of a single segment it is 1.
    pub fn coherence(&self, k: usize) -> f64 {
        let powers = self.reference[k] * self.other[k];
        if powers > 0.0 {
            self.cross[k].norm_sqr() / powers
        } else {
            0.0
        }
    }
}

impl Welch {
    /// Segments of `length` samples, at least one, that share `overlap` samples, less than `length`,
    /// with their neighbours.
    pub fn new(window: Window, length: usize, overlap: usize, detrend: Detrend) -> Self {
        let length = length.max(1);
        let weights: Vec<f64> = (0..length).map(|n| window.weight(n, length)).collect();
        Self {
            length,
            overlap: overlap.min(length - 1),
            detrend,
            sum: weights.iter().sum(),
            weights,
            plan: RealFftPlanner::new().plan_fft_forward(length),
        }
    }

    /// Number of segments in so many samples.
    pub fn averages(&self, samples: usize) -> usize {
        if samples < self.length {
            return 0;
        }
        (samples - self.overlap) / (self.length - self.overlap)
    }

    /// How often bin `k` of a one-sided spectrum counts: twice where it has an image at −f.
    pub fn sides(&self, k: usize) -> f64 {
        sides(k, self.length)
    }

    /// Power of bins 0 … N/2, images not counted.
    pub fn power(&self, signal: &mut impl Signal) -> Vec<f64> {
        let mut powers = vec![0.0; self.bins()];
        let samples = signal.length();
        self.for_each_segment([signal], |[bins]| {
            for (power, bin) in powers.iter_mut().zip(bins) {
                *power += bin.norm_sqr();
            }
        });
        self.averaged(&mut powers, samples);
        powers
    }

    /// Cross power of a signal with a reference of the same length, images not counted.
    pub fn cross<'a>(&self, mut reference: &'a [f64], mut other: &'a [f64]) -> CrossPower {
        let (bins, samples) = (self.bins(), reference.len());
        let mut cross = vec![Complex::new(0.0, 0.0); bins];
        let mut powers = [vec![0.0; bins], vec![0.0; bins]];
        self.for_each_segment([&mut reference, &mut other], |[x, y]| {
            for k in 0..bins {
                cross[k] += x[k].conj() * y[k];
                powers[0][k] += x[k].norm_sqr();
                powers[1][k] += y[k].norm_sqr();
            }
        });
        self.averaged(&mut cross, samples);
        for powers in &mut powers {
            self.averaged(powers, samples);
        }
        let [reference, other] = powers;
        CrossPower {
            cross,
            reference,
            other,
        }
    }

    /// Power of x + iy on both sides, from the lowest frequency, −N/2 bins, upwards: at positive
    /// frequencies what turns from x to y, at negative ones what turns against it.
    pub fn rotary<'a>(&self, mut x: &'a [f64], mut y: &'a [f64]) -> Vec<f64> {
        let (length, samples) = (self.length, x.len());
        let below = length / 2;
        let mut powers = vec![0.0; length];
        self.for_each_segment([&mut x, &mut y], |[x, y]| {
            for (bin, power) in powers.iter_mut().enumerate() {
                // X_{−k} of a real signal is the conjugate of X_k
                let (x, y) = match bin.checked_sub(below) {
                    Some(k) => (x[k], y[k]),
                    None => (x[below - bin].conj(), y[below - bin].conj()),
                };
                *power += (x + Complex::<f64>::I * y).norm_sqr();
            }
        });
        self.averaged(&mut powers, samples);
        powers
    }

    /// Power of bins 0 … N/2 of a signal of one segment, images not counted, and the phase in rad of
    /// `cos(2πft + phase)` there, t from its start.
    pub fn power_and_phase(&self, signal: &mut impl Signal) -> [Vec<f64>; 2] {
        let mut both = [Vec::new(), Vec::new()];
        let samples = signal.length();
        self.for_each_segment([signal], |[bins]| {
            let powers = bins.iter().map(|bin| bin.norm_sqr()).collect();
            both = [powers, bins.iter().map(|bin| bin.arg()).collect()];
        });
        self.averaged(&mut both[0], samples);
        both
    }

    fn bins(&self) -> usize {
        self.length / 2 + 1
    }

    /// From the sums over the segments of so many samples to the means, referred to (Σ w)².
    fn averaged<T: MulAssign<f64>>(&self, powers: &mut [T], samples: usize) {
        let scale = 1.0 / (self.averages(samples).max(1) as f64 * self.sum * self.sum);
        powers.iter_mut().for_each(|power| *power *= scale);
    }

    /// Shows the transforms of the signals segment by segment.
    fn for_each_segment<const SIGNALS: usize>(
        &self,
        mut signals: [&mut impl Signal; SIGNALS],
        mut visit: impl FnMut(&[Vec<Complex<f64>>; SIGNALS]),
    ) {
        let samples = signals.iter().map(|signal| signal.length()).min();
        let mut scratch = self.plan.make_scratch_vec();
        let mut segment = self.plan.make_input_vec();
        let mut bins = array::from_fn(|_| self.plan.make_output_vec());
        for index in 0..self.averages(samples.unwrap_or(0)) {
            let start = index * (self.length - self.overlap);
            for (signal, bins) in signals.iter_mut().zip(&mut bins) {
                segment.copy_from_slice(signal.read(start..start + self.length));
                self.detrend.apply(&mut segment);
                let weighted = segment.iter_mut().zip(&self.weights);
                weighted.for_each(|(x, weight)| *x *= weight);
                self.plan
                    .process_with_scratch(&mut segment, bins, &mut scratch)
                    .expect("segment and bins were made by the plan");
            }
            visit(&bins);
        }
    }
}

/// How often bin `k` of the one-sided spectrum of `length` samples counts: twice where it has an image at −f.
pub(super) fn sides(k: usize, length: usize) -> f64 {
    if k > 0 && 2 * k < length { 2.0 } else { 1.0 }
}

/// Trend that is taken out of every segment before its window.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Detrend {
    /// Nothing.
    None,
    /// The mean.
    #[default]
    Constant,
    /// The straight line of least squares.
    Linear,
}

impl Detrend {
    /// Takes the trend out.
    ///
    /// ```
    /// use jeffcott::internals::Detrend;
    /// let mut samples = [1.0, 3.0, 5.0, 7.0];
    /// Detrend::Linear.apply(&mut samples);
    /// assert!(samples.iter().all(|x| x.abs() < 1e-15));
    /// ```
    pub fn apply(self, samples: &mut [f64]) {
        match self {
            Self::None => {}
            Self::Constant => remove_mean(samples),
            Self::Linear => {
                // on deviations from the mean a large offset costs the slope no digits
                remove_mean(samples);
                remove_slope(samples);
            }
        }
    }
}

fn remove_mean(samples: &mut [f64]) {
    let mean = samples.iter().sum::<f64>() / samples.len() as f64;
    samples.iter_mut().for_each(|x| *x -= mean);
}

/// Takes the line through the middle out, `t_n = n − (N − 1)/2`, `slope = Σ t x/Σ t²`.
fn remove_slope(samples: &mut [f64]) {
    let length = samples.len() as f64;
    let middle = 0.5 * (length - 1.0);
    let squares = length * (length * length - 1.0) / 12.0;
    if squares == 0.0 {
        return;
    }
    let moments = samples
        .iter()
        .enumerate()
        .map(|(n, x)| (n as f64 - middle) * x);
    let slope = moments.sum::<f64>() / squares;
    for (n, x) in samples.iter_mut().enumerate() {
        *x -= slope * (n as f64 - middle);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::TAU;

    #[test]
    fn power_is_that_of_one_side() {
        let turn = |n: i32| TAU * f64::from(n) / 16.0;
        let signal: Vec<f64> = (0..256).map(|n| 3.0 * (2.0 * turn(n)).cos()).collect();
        let welch = Welch::new(Window::Hann, 64, 32, Detrend::Constant);
        assert_eq!(welch.averages(signal.len()), 7);
        assert!((welch.power(&mut &signal[..])[8] - 2.25).abs() < 1e-14);
    }
}
