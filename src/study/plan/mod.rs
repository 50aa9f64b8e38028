//! Which values the numbers of a scenario take in run number i: a function of i alone.

mod distribution;

use serde::{Deserialize, Serialize};

use crate::rotor::load::SplitMix64;

pub use distribution::{Distribution, Shape};

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

    /// Whether values are drawn instead of standing on a grid.
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
                let part = Permutation::new(runs, random.bits(u64::MAX)).of(run);
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
}

impl Variable {
    /// A value of SI unit in the unit that it was written in.
    pub fn shown(&self, value: f64) -> f64 {
        value / self.shown_size
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

/// Rounds of the network: the least that leave no visible pattern of Luby and Rackoff's four, and two more.
const ROUNDS: u64 = 6;

/// A permutation of 0 … n − 1 that a key decides.
///
/// A Feistel network permutes the next power of four; what falls outside n is sent through again.
///
/// Source: J. Black & P. Rogaway, *Ciphers with arbitrary finite domains*, CT-RSA 2002, cycle walking.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Permutation {
    length: u64,
    random: SplitMix64,
    /// Bits of one half of a number.
    half: u32,
}

impl Permutation {
    /// A permutation of `length` numbers; at most 2⁶² of them.
    pub fn new(length: u64, key: u64) -> Self {
        let bits = u64::BITS - length.saturating_sub(1).leading_zeros();
        Self {
            length,
            random: SplitMix64::new(key),
            half: bits.div_ceil(2).max(1),
        }
    }

    /// Position of a number below `length`.
    pub fn of(&self, number: u64) -> u64 {
        let mut position = self.network(number);
        while position >= self.length {
            position = self.network(position);
        }
        position
    }

    fn network(&self, number: u64) -> u64 {
        let mask = (1_u64 << self.half) - 1;
        let (mut left, mut right) = (number >> self.half, number & mask);
        for round in 0..ROUNDS {
            let mixed = left ^ (self.random.stream(round).bits(right) & mask);
            (left, right) = (right, mixed);
        }
        left << self.half | right
    }
}

/// Most axes of Sobol's sequence.
pub const MOST_SOBOL_AXES: usize = 16;

/// Bits of a coordinate.
const BITS: usize = 32;

/// Degree and coefficients of a primitive polynomial, and the first direction numbers.
struct Direction(usize, u32, &'static [u32]);

/// Axes from the second on.
const DIRECTIONS: [Direction; MOST_SOBOL_AXES - 1] = [
    Direction(1, 0, &[1]),
    Direction(2, 1, &[1, 3]),
    Direction(3, 1, &[1, 3, 1]),
    Direction(3, 2, &[1, 1, 1]),
    Direction(4, 1, &[1, 1, 3, 3]),
    Direction(4, 4, &[1, 3, 5, 13]),
    Direction(5, 2, &[1, 1, 5, 5, 17]),
    Direction(5, 4, &[1, 1, 5, 5, 5]),
    Direction(5, 7, &[1, 1, 7, 11, 19]),
    Direction(5, 11, &[1, 1, 5, 1, 1]),
    Direction(5, 13, &[1, 1, 1, 3, 11]),
    Direction(5, 14, &[1, 3, 5, 5, 31]),
    Direction(6, 1, &[1, 3, 3, 9, 7, 49]),
    Direction(6, 13, &[1, 1, 1, 15, 21, 21]),
    Direction(6, 16, &[1, 3, 1, 13, 27, 49]),
];

/// Coordinate, from 0 on and below 1, of point `index` along `axis`; the first 2³² points, and the first
/// [`MOST_SOBOL_AXES`] axes, differ.
///
/// ```text
/// x = ⊕ over the set bits k of the Gray code of index of v_k,
/// v_k = a_1 v_(k−1) ⊕ … ⊕ a_(s−1) v_(k−s+1) ⊕ v_(k−s) ⊕ (v_(k−s) >> s)
/// ```
///
/// Source: S. Joe & F. Y. Kuo, SIAM J. Sci. Comput. 30 (2008) 2635–2654, the table new-joe-kuo-6.
pub fn sobol(index: u64, axis: usize) -> f64 {
    let numbers = direction_numbers(axis % MOST_SOBOL_AXES);
    let gray = index ^ (index >> 1);
    let bits = numbers.iter().enumerate();
    let set = bits.filter(|(bit, _)| gray >> bit & 1 == 1);
    let coordinate = set.fold(0, |sum: u32, (_, number)| sum ^ number);
    f64::from(coordinate) / 2f64.powi(BITS as i32)
}

fn direction_numbers(axis: usize) -> [u32; BITS] {
    let mut numbers: [u32; BITS] = std::array::from_fn(|bit| 1 << (BITS - 1 - bit));
    let Some(Direction(degree, polynomial, first)) = axis.checked_sub(1).map(|k| &DIRECTIONS[k])
    else {
        return numbers;
    };
    for bit in 0..BITS {
        numbers[bit] = match first.get(bit) {
            Some(start) => start << (BITS - 1 - bit),
            None => {
                let last = numbers[bit - degree];
                let terms = 1..*degree;
                let chosen = terms.filter(|term| polynomial >> (degree - 1 - term) & 1 == 1);
                let sum = chosen.fold(0, |sum, term| sum ^ numbers[bit - term]);
                sum ^ last ^ (last >> degree)
            }
        };
    }
    numbers
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

    #[test]
    fn every_position_is_taken_once() {
        let order = Permutation::new(5, 7);
        let mut positions: Vec<u64> = (0..5).map(|i| order.of(i)).collect();
        positions.sort();
        assert_eq!(positions, [0, 1, 2, 3, 4]);
    }
}
