//! Distributions of what is drawn, by their quantiles.

use std::cmp::Ordering;

use statrs::distribution::{ContinuousCDF, Normal};

/// A distribution.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Distribution {
    /// Every value between two equally likely.
    Uniform {
        /// Least value.
        lowest: f64,
        /// Largest value.
        highest: f64,
    },
    /// Normal, cut off at two values.
    Normal {
        /// Mean before it is cut off.
        mean: f64,
        /// Standard deviation before it is cut off, above zero.
        deviation: f64,
        /// Least value; −∞ cuts off nothing.
        lowest: f64,
        /// Largest value; ∞ cuts off nothing.
        highest: f64,
    },
    /// Of a density that rises in a line to its mode and falls in a line from there.
    Triangular {
        /// Least value.
        lowest: f64,
        /// Most likely value.
        mode: f64,
        /// Largest value.
        highest: f64,
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
        let (lowest, highest) = self.bounds();
        if lowest.partial_cmp(&highest) != Some(Ordering::Less) {
            return Err(DistributionError::Bounds { lowest, highest });
        }
        match self {
            Self::Normal { deviation, .. } if !(deviation > 0.0 && deviation.is_finite()) => {
                Err(DistributionError::Deviation { deviation })
            }
            Self::Normal { .. } => match self.cut() {
                Some((_, [below, above])) if above - below > LEAST_PART => Ok(self),
                _ => Err(DistributionError::Empty { lowest, highest }),
            },
            Self::Triangular { mode, .. } if !(lowest <= mode && mode <= highest) => {
                Err(DistributionError::Mode {
                    mode,
                    lowest,
                    highest,
                })
            }
            _ => Ok(self),
        }
    }

    /// Least and largest value.
    pub fn bounds(&self) -> (f64, f64) {
        match *self {
            Self::Uniform { lowest, highest }
            | Self::Normal {
                lowest, highest, ..
            }
            | Self::Triangular {
                lowest, highest, ..
            } => (lowest, highest),
        }
    }

    /// The normal distribution, and the shares of it below the bounds.
    fn cut(&self) -> Option<(Normal, [f64; 2])> {
        let Self::Normal {
            mean,
            deviation,
            lowest,
            highest,
        } = *self
        else {
            return None;
        };
        let normal = Normal::new(mean, deviation).ok()?;
        Some((normal, [normal.cdf(lowest), normal.cdf(highest)]))
    }

    /// Value that a share of all draws, between 0 and 1, does not exceed.
    pub fn quantile(&self, share: f64) -> f64 {
        match *self {
            Self::Uniform { lowest, highest } => lowest * (1.0 - share) + highest * share,
            Self::Triangular {
                lowest,
                mode,
                highest,
            } => {
                let width = highest - lowest;
                let rising = (mode - lowest) / width;
                if share <= rising {
                    lowest + (share * width * (mode - lowest)).sqrt()
                } else {
                    highest - ((1.0 - share) * width * (highest - mode)).sqrt()
                }
            }
            Self::Normal {
                lowest, highest, ..
            } => self.cut().map_or(f64::NAN, |(normal, [below, above])| {
                let share = below * (1.0 - share) + above * share;
                normal.inverse_cdf(share).clamp(lowest, highest)
            }),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_normal_quantile_is_that_of_tables() {
        let infinite = (f64::NEG_INFINITY, f64::INFINITY);
        let normal = Distribution::Normal {
            mean: 1.0,
            deviation: 2.0,
            lowest: infinite.0,
            highest: infinite.1,
        };
        assert!((normal.quantile(0.975) - (1.0 + 2.0 * 1.959_963_984_540_054)).abs() < 1e-9);
    }
}
