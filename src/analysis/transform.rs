//! The discrete Fourier transform of a real signal, and the same seen through any window.

use std::cell::RefCell;
use std::collections::VecDeque;
use std::ops::RangeInclusive;
use std::sync::Arc;

use realfft::num_complex::Complex;
use realfft::{RealFftPlanner, RealToComplex};

use super::Window;

/// Plans that a thread remembers: the last ones.
const REMEMBERED: usize = 4;

/// The plan for so many samples. Plans cost more than what they are for, and runs alike have spectra of
/// the same lengths: each thread remembers its last ones.
pub(super) fn plan(length: usize) -> Arc<dyn RealToComplex<f64>> {
    thread_local! {
        static PLANS: RefCell<VecDeque<Arc<dyn RealToComplex<f64>>>> = const { RefCell::new(VecDeque::new()) };
    }
    PLANS.with_borrow_mut(|plans| {
        if let Some(known) = plans.iter().find(|plan| plan.len() == length) {
            return Arc::clone(known);
        }
        let made = RealFftPlanner::new().plan_fft_forward(length);
        plans.truncate(REMEMBERED - 1);
        plans.push_front(Arc::clone(&made));
        made
    })
}

/// Coefficients `c_k = (1/N) Σ_n z_n exp(−2πikn/N)`, k = 0 … N−1, of complex samples over one period.
pub fn fourier_coefficients(samples: &[Complex<f64>]) -> Vec<Complex<f64>> {
    let mut planner = RealFftPlanner::new();
    let real = Transform::planned(samples.iter().map(|z| z.re).collect(), &mut planner);
    let imaginary = Transform::planned(samples.iter().map(|z| z.im).collect(), &mut planner);
    let bins = 0..samples.len() as isize;
    bins.map(|k| real.bin(k) + Complex::<f64>::I * imaginary.bin(k))
        .collect()
}

/// Discrete Fourier transform of real samples, divided by their number.
///
/// `X_k = (1/N) Σ_n x_n exp(−2πikn/N)`
///
/// A window that is a sum of cosines is applied here, after the transform: it mixes neighbouring
/// bins with its own coefficients. One transform so serves every window.
#[derive(Debug, Clone, PartialEq)]
pub struct Transform {
    length: usize,
    bins: Vec<Complex<f64>>,
}

impl Transform {
    /// Transforms samples of any number.
    pub fn new(samples: Vec<f64>) -> Self {
        if samples.is_empty() {
            return Self::planned(samples, &mut RealFftPlanner::new());
        }
        let plan = plan(samples.len());
        Self::by_plan(samples, plan.as_ref())
    }

    /// The same with a planner that remembers the lengths it has met.
    pub(super) fn planned(samples: Vec<f64>, planner: &mut RealFftPlanner<f64>) -> Self {
        let length = samples.len();
        if length == 0 {
            return Self {
                length,
                bins: Vec::new(),
            };
        }
        Self::by_plan(samples, planner.plan_fft_forward(length).as_ref())
    }

    /// The same by a plan for this number of samples.
    pub(super) fn by_plan(mut samples: Vec<f64>, plan: &dyn RealToComplex<f64>) -> Self {
        let length = samples.len();
        let mut bins = plan.make_output_vec();
        plan.process(&mut samples, &mut bins)
            .expect("the output was made by the plan for this very length");
        let scale = 1.0 / length as f64;
        bins.iter_mut().for_each(|bin| *bin *= scale);
        Self { length, bins }
    }

    /// Number of samples N.
    pub fn length(&self) -> usize {
        self.length
    }

    /// Number of bins of the one-sided spectrum, ⌊N/2⌋ + 1, or none without samples.
    pub fn bins(&self) -> usize {
        self.bins.len()
    }

    /// The signal less its mean.
    pub fn without_mean(mut self) -> Self {
        if let Some(mean) = self.bins.first_mut() {
            *mean = Complex::ZERO;
        }
        self
    }

    /// The mean, if there are samples, and the signal less it.
    pub(super) fn split_mean(self) -> (Option<f64>, Self) {
        (self.bins.first().map(|bin| bin.re), self.without_mean())
    }

    /// One-sided amplitude (peak value) at bin `k` under `window`.
    ///
    /// Every line inside counts twice, for its image at −f; the mean and the line at half the
    /// sampling rate have none.
    pub fn amplitude(&self, k: usize, window: Window) -> f64 {
        let sides = if self.has_image(k) { 2.0 } else { 1.0 };
        sides * self.windowed(k, window).norm()
    }

    /// Sum over bins of half the square of [`Transform::amplitude`] under a Hann window: the mean square of the
    /// lines there, each as often as its lobe counts it.
    pub(super) fn mean_square(&self, bins: RangeInclusive<usize>) -> f64 {
        // bins with an image and with a bin at either side: X_k − (X_{k−1} + X_{k+1})/2
        let highest = self.bins.len().saturating_sub(1);
        let inner = bins.start().saturating_sub(1)..(bins.end() + 2).min(highest + 1);
        let inner = self.bins.get(inner).unwrap_or_default().windows(3);
        let squares = inner.map(|around| (around[1] - (around[0] + around[2]) * 0.5).norm_sqr());
        let inner: f64 = squares.sum();
        let edges = [0, highest].into_iter();
        let edges = edges.filter(|k| bins.contains(k) && *k < self.bins.len());
        let edge = |k| {
            let half = if self.has_image(k) { 2.0 } else { 0.5 };
            half * self.windowed(k, Window::Hann).norm_sqr()
        };
        2.0 * inner + edges.map(edge).sum::<f64>()
    }

    /// [`Transform::amplitude`] and [`Transform::phase`] of bin `k`.
    pub(super) fn amplitude_and_phase(&self, k: usize, window: Window) -> (f64, f64) {
        let sides = if self.has_image(k) { 2.0 } else { 1.0 };
        let line = self.windowed(k, window);
        (sides * line.norm(), line.arg())
    }

    /// Phase in rad of `cos(2πft + phase)` at bin `k` under `window`, t from the first sample.
    pub fn phase(&self, k: usize, window: Window) -> f64 {
        self.windowed(k, window).arg()
    }

    fn has_image(&self, k: usize) -> bool {
        k > 0 && 2 * k < self.length
    }

    /// X_k of the weighted samples, divided by the coherent gain.
    ///
    /// `Y_k = X_k + Σ_j (−1)^j (a_j/2a_0)(X_{k−j} + X_{k+j})`
    fn windowed(&self, k: usize, window: Window) -> Complex<f64> {
        let coefficients = window.coefficients();
        let mut sum = self.bins[k];
        let mut sign = -1.0;
        for (j, a) in coefficients.iter().enumerate().skip(1) {
            let pair = self.bin(k as isize - j as isize) + self.bin(k as isize + j as isize);
            sum += pair * (sign * a / (2.0 * coefficients[0]));
            sign = -sign;
        }
        sum
    }

    /// X at any index: periodic in N, and conjugate at the negative.
    fn bin(&self, k: isize) -> Complex<f64> {
        if let Some(bin) = usize::try_from(k).ok().and_then(|k| self.bins.get(k)) {
            return *bin;
        }
        let k = k.rem_euclid(self.length as isize) as usize;
        match self.bins.get(k) {
            Some(bin) => *bin,
            None => self.bins[self.length - k].conj(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use nalgebra::Complex;
    use std::f64::consts::TAU;

    #[test]
    fn the_mean_square_of_bins_is_that_of_their_amplitudes() {
        for length in [16_u32, 17] {
            let value = |n| (0.4 + 1.7 * f64::from(n)).sin() + 0.3 * f64::from(n % 5);
            let transform = Transform::new((0..length).map(value).collect());
            let last = transform.bins() - 1;
            for bins in [0..=last, 1..=last, 1..=1, 2..=last - 1, last..=last] {
                let amplitudes = bins.clone().map(|k| transform.amplitude(k, Window::Hann));
                let expected: f64 = amplitudes
                    .map(|amplitude| 0.5 * amplitude * amplitude)
                    .sum();
                let found = transform.mean_square(bins.clone());
                assert!((found / expected - 1.0).abs() < 1e-13, "{length} {bins:?}");
            }
        }
    }

    #[test]
    fn coefficients_of_a_turning_pointer() {
        let turning = |n: i32| Complex::from_polar(2.0, 0.3 - TAU * f64::from(n) / 8.0);
        let coefficients = fourier_coefficients(&(0..8).map(turning).collect::<Vec<_>>());
        assert!((coefficients[7] - Complex::from_polar(2.0, 0.3)).norm() < 1e-14); // k = −1
    }

    #[test]
    fn amplitudes_of_a_cosine_and_its_mean() {
        let samples = (0..10)
            .map(|n| 3.0 + (TAU * 0.2 * n as f64).cos())
            .collect();
        let transform = Transform::new(samples);
        assert!((transform.amplitude(0, Window::Rectangular) - 3.0).abs() < 1e-14);
        assert!((transform.amplitude(2, Window::Rectangular) - 1.0).abs() < 1e-14);
    }
}
