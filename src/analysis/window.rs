//! Windows: how the samples of a spectrum are weighted.

use std::f64::consts::TAU;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

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
}
