//! Windows: how the samples of a spectrum are weighted.

use std::f64::consts::{PI, TAU};

use realfft::num_complex::Complex;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::numerics::root::root;

/// Part of a bin to which an offset is sought.
const OFFSET_KNOWN: f64 = 1e-6;

/// Window of a spectrum, periodic over the samples (DFT-even).
///
/// ```text
/// w_n = Σ_j (−1)^j a_j cos(2πjn/N),   n = 0 … N−1
/// ```
///
/// Source: F. J. Harris, Proc. IEEE 66 (1978) 51–83 for Hann, Hamming and the four-term
/// Blackman–Harris; G. D'Antona & A. Ferrero, *Digital
/// Signal Processing for Measurement Systems* (2006), p. 72, for the five-term flat top.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
#[non_exhaustive]
pub enum Window {
    /// No weighting: exact for lines on a bin, as on whole revolutions at constant speed.
    #[default]
    Rectangular,
    /// Hann: narrow lines, amplitudes up to 15 % low between bins.
    Hann,
    /// Hamming: as Hann, its nearest side lobes lower and its far ones higher.
    Hamming,
    /// Four-term Blackman-Harris: no side lobe above -92 dB, lines eight bins wide.
    BlackmanHarris,
    /// Flat top: amplitudes within 1 % anywhere between bins.
    FlatTop,
}

impl Window {
    /// Coefficients a_0, a_1, … of the sum of cosines.
    pub fn coefficients(self) -> &'static [f64] {
        match self {
            Self::Rectangular => &[1.0],
            Self::Hann => &[0.5, 0.5],
            Self::Hamming => &[0.54, 0.46],
            Self::BlackmanHarris => &[0.358_75, 0.488_29, 0.141_28, 0.011_68],
            Self::FlatTop => &[
                0.215_578_95,
                0.416_631_58,
                0.277_263_158,
                0.083_578_947,
                0.006_947_368,
            ],
        }
    }

    /// Half the width of the lobe of a line, in bins.
    pub(crate) fn lobe(self) -> usize {
        self.coefficients().len()
    }

    /// Mean weight a_0: the factor by which the window reduces a line on a bin.
    ///
    /// ```
    /// use jeffcott::analysis::Window;
    /// assert_eq!(Window::Hann.coherent_gain(), 0.5);
    /// ```
    pub fn coherent_gain(self) -> f64 {
        self.coefficients()[0]
    }

    /// Equivalent noise bandwidth in bins: the width of the box that passes as much of white noise.
    ///
    /// ```text
    /// ENBW = N Σ w_n²/(Σ w_n)² = 1 + Σ_{j≥1} a_j²/(2 a_0²)
    /// ```
    ///
    /// The closed form holds from eleven samples on. Source: Harris, eq. (15).
    ///
    /// ```
    /// use jeffcott::analysis::Window;
    /// assert_eq!(Window::Hann.equivalent_noise_bandwidth(), 1.5);
    /// assert!((Window::BlackmanHarris.equivalent_noise_bandwidth() - 2.0044).abs() < 1e-4);
    /// ```
    pub fn equivalent_noise_bandwidth(self) -> f64 {
        let mean = self.coherent_gain();
        let others = self.coefficients()[1..].iter();
        1.0 + others.map(|a| 0.5 * (a / mean).powi(2)).sum::<f64>()
    }

    /// Weight of sample `index` of `length`.
    ///
    /// ```
    /// use jeffcott::analysis::Window;
    /// assert_eq!(Window::Hann.weight(0, 8), 0.0);
    /// assert_eq!(Window::Hann.weight(4, 8), 1.0);
    /// ```
    pub fn weight(self, index: usize, length: usize) -> f64 {
        let angle = TAU * index as f64 / length as f64;
        let signs = [1.0, -1.0].into_iter().cycle();
        let terms = self.coefficients().iter().zip(signs).enumerate();
        terms
            .map(|(j, (a, sign))| sign * a * (j as f64 * angle).cos())
            .sum()
    }

    /// Offset δ in bins of a line from bin k towards k + 1, from the ratio α = |Y_{k+1}|/|Y_k|, of N samples.
    ///
    /// The Hann window has a closed form, also where the line is not between the two bins:
    ///
    /// ```text
    /// s T² + (1 + α cos 2h) T + s (1 − 2α) = 0,   s = sin h cos h,  h = π/N,   δ = arctan(T)/h
    /// ```
    ///
    /// This is exact for a single complex line; for large N it becomes δ = (2α − 1)/(α + 1). Of other windows it is the δ of
    /// 0 … 0.5 with `H(1 − δ) = α H(δ)`.
    ///
    /// Source: the limit in D. C. Rife & G. A. Vincent, Bell Syst. Tech. J. 49 (1970) 197–228; the
    /// exact form follows from [`Self::line_response`] at δ and δ − 1.
    pub(super) fn line_offset(self, ratio: f64, length: f64) -> f64 {
        if self != Self::Hann {
            let difference = |offset: f64| {
                self.line_response(1.0 - offset, length)
                    - ratio * self.line_response(offset, length)
            };
            let ends = [0.0, 0.5];
            let found = root(difference, ends, ends.map(difference), OFFSET_KNOWN);
            // a maximum sharper than a line on a bin makes it
            return found.unwrap_or(0.0);
        }
        let h = PI / length;
        let s = h.sin() * h.cos();
        let b = 1.0 + ratio * (2.0 * h).cos();
        let above = 2.0 * ratio - 1.0;
        // The root that vanishes with s, in the form without cancellation.
        let t = 2.0 * s * above / (b + (b * b + 4.0 * s * s * above).sqrt());
        t.atan() / h
    }

    /// Amplitude H(δ) that the window of N samples shows of a unit line δ bins off the bin; H(0) = 1.
    ///
    /// ```text
    /// H(δ) = |Σ_j (−1)^j a_|j| D(δ − j)|/a_0 with half of a_j at ±j,   D(x) = sin πx/(N sin πx/N) exp(−iπx(N − 1)/N)
    /// Hann: sin²h cos a sin πδ/[N sin a (sin²h − sin²a)],   a = hδ,  h = π/N
    /// ```
    pub(super) fn line_response(self, offset: f64, length: f64) -> f64 {
        let h = PI / length;
        // sin πx/(N sin hx) → 1 at x = 0
        let dirichlet = |x: f64| match x == 0.0 {
            true => 1.0,
            false => (PI * x).sin() / (length * (h * x).sin()),
        };
        if self == Self::Hann {
            let a = h * offset;
            return dirichlet(offset) * a.cos() * h.sin().powi(2) / ((h - a).sin() * (h + a).sin());
        }
        let turned = |x: f64| Complex::from_polar(dirichlet(x), -(PI - h) * x);
        let terms = self.coefficients().iter().enumerate();
        let sum: Complex<f64> = terms
            .map(|(j, a)| {
                let (sign, j) = (if j % 2 == 0 { 0.5 } else { -0.5 }, j as f64);
                (turned(offset - j) + turned(offset + j)) * (sign * a)
            })
            .sum();
        sum.norm() / self.coherent_gain()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::analysis::Transform;

    const ALL: [Window; 5] = [
        Window::Rectangular,
        Window::Hann,
        Window::Hamming,
        Window::BlackmanHarris,
        Window::FlatTop,
    ];

    /// Against the transform of a tone far from zero frequency and from half the sampling rate, whose image is weak.
    #[test]
    fn a_tone_between_bins_has_its_offset_and_amplitude() {
        let length = 4096;
        for window in ALL {
            for beside in [0.0, 0.1, 0.25, 0.49] {
                let pace = TAU * (1024.0 + beside) / length as f64;
                let tone = (0..length).map(|n| 3.0 * (pace * n as f64).cos());
                let found = Transform::new(tone.collect());
                let [at, next] = [1024, 1025].map(|k| found.amplitude(k, window));
                let offset = window.line_offset(next / at, length as f64);
                let amplitude = at / window.line_response(offset, length as f64);
                assert!(
                    (offset - beside).abs() < 1e-2,
                    "{window:?} {beside}: {offset}"
                );
                assert!(
                    (amplitude - 3.0).abs() < 3e-3,
                    "{window:?} {beside}: {amplitude}"
                );
            }
        }
    }
}
