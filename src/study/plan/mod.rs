//! Which values the numbers of a scenario take in run number i: a function of i alone.

mod distribution;
mod sequences;

use serde::{Deserialize, Serialize};

use crate::rotor::load::SplitMix64;

pub use distribution::{Distribution, Shape};
use sequences::Permutation;
pub use sequences::{MOST_SOBOL_AXES, sobol};

/// Most runs of a study.
pub const MOST_RUNS: u64 = 1_000_000_000;

/// How the values of the axes are combined.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Sampling {
    /// Every value of every axis with every value of the others; the last axis varies fastest.
    Grid,
    /// So many runs; every axis is cut into as many parts of equal probability, and each part is met
    /// once.
    LatinHypercube(u64),
    /// So many runs at the points of Sobol's sequence, shifted at random.
    Sobol(u64),
    /// So many runs drawn independently.
    MonteCarlo(u64),
}

/// The values of every run.
#[derive(Debug, Clone, PartialEq)]
pub struct Plan {
    /// The axes.
    pub axes: Vec<Axis>,
    sampling: Sampling,
    seed: u64,
}

impl Plan {
    /// A plan over some axes; the seed decides all that is drawn.
    pub fn new(axes: Vec<Axis>, sampling: Sampling, seed: u64) -> Self {
        Self {
            axes,
            sampling,
            seed,
        }
    }

    /// Whether values are drawn instead of being those of a grid.
    pub fn is_drawn(&self) -> bool {
        self.sampling != Sampling::Grid
    }

    /// Number of runs; `None` where it is beyond 64 bits.
    pub fn runs(&self) -> Option<u64> {
        match self.sampling {
            Sampling::Grid => {
                let mut lengths = self.axes.iter().map(Axis::length);
                lengths.try_fold(1, u64::checked_mul)
            }
            Sampling::LatinHypercube(runs) | Sampling::Sobol(runs) | Sampling::MonteCarlo(runs) => {
                Some(runs)
            }
        }
    }

    /// The values of all axes in a run, SI units.
    pub fn values(&self, run: u64) -> Vec<f64> {
        if self.sampling == Sampling::Grid {
            return self.grid_values(run);
        }
        let axes = self.axes.iter().enumerate();
        axes.map(|(index, axis)| axis.quantile(self.share(run, index)))
            .collect()
    }

    fn grid_values(&self, run: u64) -> Vec<f64> {
        let mut rest = run;
        let mut values = vec![0.0; self.axes.len()];
        for (value, axis) in values.iter_mut().zip(&self.axes).rev() {
            let length = axis.length().max(1);
            *value = axis.value(rest % length);
            rest /= length;
        }
        values
    }

    /// Probability, between 0 and 1, at which an axis is met in a run.
    fn share(&self, run: u64, axis: usize) -> f64 {
        let random = SplitMix64::new(self.seed).stream(axis as u64);
        match self.sampling {
            Sampling::Grid | Sampling::MonteCarlo(_) => random.uniform(run),
            Sampling::LatinHypercube(runs) => {
                let part = Permutation::new(runs, random.bits(u64::MAX)).position(run);
                (part as f64 + random.uniform(run)) / runs as f64
            }
            // a shift by the same amount modulo 1 keeps the sequence even
            Sampling::Sobol(_) => (sobol(run, axis) + random.uniform(u64::MAX)).fract(),
        }
    }
}

/// The number that varies.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Variable {
    /// Path of its key in the scenario, for instance `load[1].constant.z`.
    pub key: String,
    /// Its SI unit; empty for a plain number.
    pub unit: String,
    /// The unit that it was written in; empty for a plain number.
    pub shown_unit: String,
    /// That unit in SI units.
    pub shown_size: f64,
    /// Of a key of words: those that it takes; a value is the place of one of them.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub words: Vec<String>,
}

impl Variable {
    /// A value of SI unit in the unit that it was written in.
    pub fn shown(&self, value: f64) -> f64 {
        value / self.shown_size
    }

    /// The word that a value stands for; none of a number.
    pub fn word(&self, value: f64) -> Option<&str> {
        self.words.get(value as usize).map(String::as_str)
    }
}

/// The values that one number of a scenario takes.
#[derive(Debug, Clone, PartialEq)]
pub enum Axis {
    /// A list, SI units.
    Listed(Vec<f64>),
    /// Evenly spaced.
    Spaced {
        /// First value, SI units.
        from: f64,
        /// Last value, SI units.
        to: f64,
        /// How many.
        count: u64,
        /// Whether by equal ratios instead of equal differences.
        logarithmic: bool,
    },
    /// Drawn.
    Drawn(Distribution),
}

impl Axis {
    /// Number of values on a grid; zero where they are drawn.
    pub fn length(&self) -> u64 {
        match self {
            Self::Listed(values) => values.len() as u64,
            Self::Spaced { count, .. } => *count,
            Self::Drawn(_) => 0,
        }
    }

    /// Value number `index` of a grid; NaN where there is none.
    pub fn value(&self, index: u64) -> f64 {
        match self {
            Self::Listed(values) => values.get(index as usize).map_or(f64::NAN, |value| *value),
            Self::Spaced {
                from,
                to,
                count,
                logarithmic,
            } => match (index, count.saturating_sub(1)) {
                // exact at both ends
                (0, _) => *from,
                (_, last) if index >= last => *to,
                (_, last) => part_way(*from, *to, *logarithmic, index as f64 / last as f64),
            },
            Self::Drawn(_) => f64::NAN,
        }
    }

    /// Value that a share of all draws does not exceed: a list is drawn from evenly, spaced values are a
    /// uniform distribution from the first to the last (of the logarithm, where spaced by ratios).
    pub fn quantile(&self, share: f64) -> f64 {
        match self {
            Self::Listed(values) => {
                let index = (share * values.len() as f64) as usize;
                let last = values.len().saturating_sub(1);
                values.get(index.min(last)).map_or(f64::NAN, |value| *value)
            }
            Self::Spaced {
                from,
                to,
                logarithmic,
                ..
            } => part_way(*from, *to, *logarithmic, share),
            Self::Drawn(distribution) => distribution.quantile(share),
        }
    }
}

fn part_way(from: f64, to: f64, logarithmic: bool, part: f64) -> f64 {
    if logarithmic {
        return (from.ln() * (1.0 - part) + to.ln() * part).exp();
    }
    from * (1.0 - part) + to * part
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_grid_counts_its_last_axis_first() {
        let axis = |values: &[f64]| Axis::Listed(values.to_vec());
        let plan = Plan::new(
            vec![axis(&[1.0, 2.0]), axis(&[10.0, 20.0, 30.0])],
            Sampling::Grid,
            0,
        );
        assert_eq!(plan.runs(), Some(6));
        assert_eq!(plan.values(4), [2.0, 20.0]);
    }
}
