//! How the height of a line or of a noise floor is told.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// Scaling of a spectrum.
///
/// With P the power of a bin, the mean over the segments of `|Σ w x exp(−2πikn/N)|²/(Σ w)²`, and
/// s = 2 for the image at −f that a one-sided spectrum folds in (s = 1 at zero frequency, at half the
/// sampling rate of an even length, and in a two-sided spectrum):
///
/// ```text
/// peak = s √P    peak to peak = 2 s √P    rms = √(s P)    power = s P    density = s P/ENBW
/// ```
///
/// `scipy.signal.welch` calls power `scaling="spectrum"` and density `scaling="density"`; Matlab's
/// `pwelch` calls them "power" and "psd".
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Scaling {
    /// Amplitude.
    Peak,
    /// Root mean square.
    Rms,
    /// Twice the amplitude.
    PeakToPeak,
    /// Mean square: "spectrum" of SciPy, "power" of Matlab.
    Power,
    /// Mean square per Hz or per order: "density" of SciPy, "psd" of Matlab.
    Density,
}

impl Scaling {
    /// The value of a bin of power `power` that counts `sides` times, under a window of the
    /// equivalent noise bandwidth `bandwidth` in units of the axis.
    ///
    /// ```
    /// use jeffcott::analysis::Scaling;
    /// // a cosine of amplitude 3 has (3/2)² at f and at −f
    /// assert_eq!(Scaling::Peak.value(2.25, 2.0, 1.5), 3.0);
    /// assert_eq!(Scaling::Power.value(2.25, 2.0, 1.5), 4.5);
    /// assert_eq!(Scaling::Density.value(2.25, 2.0, 1.5), 3.0);
    /// ```
    pub fn value(self, power: f64, sides: f64, bandwidth: f64) -> f64 {
        match self {
            Self::Peak => sides * power.sqrt(),
            Self::PeakToPeak => 2.0 * sides * power.sqrt(),
            Self::Rms => (sides * power).sqrt(),
            Self::Power => sides * power,
            Self::Density => sides * power / bandwidth,
        }
    }

    /// Whether values are in the unit squared.
    pub fn is_square(self) -> bool {
        matches!(self, Self::Power | Self::Density)
    }

    /// Name as in the files: `peak`, `rms`, `peak_to_peak`, `power`, `density`.
    pub fn name(self) -> &'static str {
        match self {
            Self::Peak => "peak",
            Self::Rms => "rms",
            Self::PeakToPeak => "peak_to_peak",
            Self::Power => "power",
            Self::Density => "density",
        }
    }
}
