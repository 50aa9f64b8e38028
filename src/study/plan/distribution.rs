//! Distributions of what is drawn, by their quantiles.

use std::cmp::Ordering;

use statrs::distribution::{ContinuousCDF, Normal};

/// A distribution between two values.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Distribution {
    /// Least value; −∞ cuts off nothing of a normal distribution.
    pub lowest: f64,
    /// Largest value; ∞ cuts off nothing of a normal distribution.
    pub highest: f64,
    /// How the values between them are distributed.
    pub shape: Shape,
}

/// How the values between two bounds are distributed.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Shape {
    /// All equally likely.
    Uniform,
    /// Normal, cut off at the bounds.
    Normal {
        /// Mean before it is cut off.
        mean: f64,
        /// Standard deviation before it is cut off, above zero.
        deviation: f64,
    },
    /// Of a density that rises in a line to its mode and falls in a line from there.
    Triangular {
        /// Most likely value.
        mode: f64,
    },
}

/// Why numbers make no distribution.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
pub enum DistributionError {
    /// The bounds are no range.
    #[error("the least value {lowest:e} is not below the largest, {highest:e}")]
    Bounds {
        /// Least value.
        lowest: f64,
        /// Largest value.
        highest: f64,
    },
    /// The deviation is none.
    #[error("a standard deviation of {deviation:e} is not above zero")]
    Deviation {
        /// As given.
        deviation: f64,
    },
    /// The mode lies outside.
    #[error("the most likely value {mode:e} lies outside {lowest:e} to {highest:e}")]
    Mode {
        /// As given.
        mode: f64,
        /// Least value.
        lowest: f64,
        /// Largest value.
        highest: f64,
    },
    /// Hardly any of the normal distribution lies between its bounds.
    #[error(
        "from {lowest:e} to {highest:e} lies no part of the normal distribution that could be drawn from"
    )]
    Empty {
        /// Least value.
        lowest: f64,
        /// Largest value.
        highest: f64,
    },
}

/// Least part of a normal distribution that may lie between its bounds.
const LEAST_PART: f64 = 1e-9;

impl Distribution {
    /// The distribution, if its numbers make one.
    ///
    /// # Errors
    /// [`DistributionError`] says which number does not.
    pub fn checked(self) -> Result<Self, DistributionError> {
        let (lowest, highest) = (self.lowest, self.highest);
        if lowest.partial_cmp(&highest) != Some(Ordering::Less) {
            return Err(DistributionError::Bounds { lowest, highest });
        }
        match self.shape {
            Shape::Normal { deviation, .. } if !(deviation > 0.0 && deviation.is_finite()) => {
                Err(DistributionError::Deviation { deviation })
            }
            Shape::Normal { mean, deviation } => match self.cut(mean, deviation) {
                Some((_, [below, above])) if above - below > LEAST_PART => Ok(self),
                _ => Err(DistributionError::Empty { lowest, highest }),
            },
            Shape::Triangular { mode } if !(lowest <= mode && mode <= highest) => {
                Err(DistributionError::Mode {
                    mode,
                    lowest,
                    highest,
                })
            }
            _ => Ok(self),
        }
    }

    /// The normal distribution of a mean and a deviation, and the shares of it below the bounds.
    fn cut(&self, mean: f64, deviation: f64) -> Option<(Normal, [f64; 2])> {
        let normal = Normal::new(mean, deviation).ok()?;
        let shares = [self.lowest, self.highest].map(|bound| normal.cdf(bound));
        Some((normal, shares))
    }

    /// Value that a share of all draws, between 0 and 1, does not exceed.
    pub fn quantile(&self, share: f64) -> f64 {
        let (lowest, highest) = (self.lowest, self.highest);
        match self.shape {
            Shape::Uniform => lowest * (1.0 - share) + highest * share,
            Shape::Triangular { mode } => {
                let width = highest - lowest;
                let rising = (mode - lowest) / width;
                if share <= rising {
                    lowest + (share * width * (mode - lowest)).sqrt()
                } else {
                    highest - ((1.0 - share) * width * (highest - mode)).sqrt()
                }
            }
            Shape::Normal { mean, deviation } => {
                let cut = self.cut(mean, deviation);
                cut.map_or(f64::NAN, |(normal, [below, above])| {
                    let share = below * (1.0 - share) + above * share;
                    normal.inverse_cdf(share).clamp(lowest, highest)
                })
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_normal_quantile_is_that_of_tables() {
        let normal = Distribution {
            lowest: f64::NEG_INFINITY,
            highest: f64::INFINITY,
            shape: Shape::Normal {
                mean: 1.0,
                deviation: 2.0,
            },
        };
        assert!((normal.quantile(0.975) - (1.0 + 2.0 * 1.959_963_984_540_054)).abs() < 1e-9);
    }
}
