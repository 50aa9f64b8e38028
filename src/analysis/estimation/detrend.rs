//! What is taken out of a segment before it is weighted.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

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
    /// use jeffcott::analysis::Detrend;
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

    /// Name as in the files: `none`, `constant`, `linear`.
    pub fn name(self) -> &'static str {
        match self {
            Self::None => "none",
            Self::Constant => "constant",
            Self::Linear => "linear",
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
