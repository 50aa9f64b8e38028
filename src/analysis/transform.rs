//! The discrete Fourier transform of a real signal, and the same seen through any window.

use realfft::RealFftPlanner;
use realfft::num_complex::Complex;

use super::Window;

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
        Self::planned(samples, &mut RealFftPlanner::new())
    }

    /// The transform by a planner that remembers the lengths it has met.
    pub(super) fn planned(mut samples: Vec<f64>, planner: &mut RealFftPlanner<f64>) -> Self {
        let length = samples.len();
        if length == 0 {
            return Self {
                length,
                bins: Vec::new(),
            };
        }
        let plan = planner.plan_fft_forward(length);
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

    /// One-sided line at bin `k` under `window`: its magnitude is the peak value, its argument the phase in rad of
    /// `cos(2πft + phase)`, t from the first sample.
    ///
    /// Every line inside counts twice, for its image at −f; the mean and the line at half the
    /// sampling rate have none.
    pub fn line(&self, k: usize, window: Window) -> Complex<f64> {
        let sides = if self.has_image(k) { 2.0 } else { 1.0 };
        self.windowed(k, window) * sides
    }

    /// Magnitude of [`Transform::line`].
    pub fn amplitude(&self, k: usize, window: Window) -> f64 {
        self.line(k, window).norm()
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
    pub fn bin(&self, k: isize) -> Complex<f64> {
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
