//! Which values the numbers of a scenario take in run number i: a function of i alone.

mod axis;
mod distribution;
mod permutation;
mod sobol;

pub use axis::{Axis, AxisValues};
pub use distribution::Distribution;
pub use permutation::Permutation;
pub use sobol::{MOST_SOBOL_AXES, sobol};

use crate::rotor::load::SplitMix64;

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
    axes: Vec<Axis>,
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

    /// The axes.
    pub fn axes(&self) -> &[Axis] {
        &self.axes
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
                let part = Permutation::new(runs, random.bits(u64::MAX)).of(run);
                (part as f64 + random.uniform(run)) / runs as f64
            }
            // a shift by the same amount modulo 1 keeps the sequence even
            Sampling::Sobol(_) => (sobol(run, axis) + random.uniform(u64::MAX)).fract(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::study::plan::Axis;
    use crate::study::plan::AxisValues;

    #[test]
    fn a_grid_counts_its_last_axis_first() {
        let axis = |values: &[f64]| Axis {
            values: AxisValues::Listed(values.to_vec()),
        };
        let plan = Plan::new(
            vec![axis(&[1.0, 2.0]), axis(&[10.0, 20.0, 30.0])],
            Sampling::Grid,
            0,
        );
        assert_eq!(plan.runs(), Some(6));
        assert_eq!(plan.values(4), [2.0, 20.0]);
    }
}
