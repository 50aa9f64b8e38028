//! What is known of a column of a study: its range, mean and quantiles.

use std::collections::BTreeMap;

use serde::Serialize;

use crate::table::Column;

/// What changes by less than this part of it does not change.
const CONSTANT: f64 = 1e-9;

/// Quantiles that are reported.
pub(super) const QUANTILES: [f64; 5] = [0.05, 0.25, 0.5, 0.75, 0.95];

/// One number over all runs.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub(super) struct ColumnDigest {
    #[serde(skip)]
    pub column: Column,
    /// Runs that have it.
    pub known: u64,
    pub mean: f64,
    /// Of one run of a population of which these are a sample; none of a single run.
    pub standard_deviation: Option<f64>,
    /// Sum of the squares of the differences from the mean.
    #[serde(skip)]
    squares: f64,
    pub lowest: f64,
    /// The run that has the lowest value.
    pub lowest_in_run: u64,
    pub highest: f64,
    pub highest_in_run: u64,
    /// Quantiles by their shares, where the runs were drawn.
    pub quantiles: Option<BTreeMap<String, f64>>,
}

impl ColumnDigest {
    pub fn new(column: Column) -> Self {
        Self {
            column,
            known: 0,
            mean: 0.0,
            standard_deviation: None,
            squares: 0.0,
            lowest: f64::INFINITY,
            lowest_in_run: 0,
            highest: f64::NEG_INFINITY,
            highest_in_run: 0,
            quantiles: None,
        }
    }

    /// Largest absolute value of its ends, as far as they are finite.
    pub(super) fn size(&self) -> f64 {
        let ends = [self.lowest, self.highest].map(f64::abs);
        let finite = ends.into_iter().filter(|end| end.is_finite());
        finite.fold(0.0, f64::max)
    }

    /// Whether it varies by more than what is round-off compared with a value of its kind.
    pub(super) fn varies_beside(&self, size: f64) -> bool {
        self.known > 1 && self.highest - self.lowest > CONSTANT * size
    }

    pub fn add(&mut self, run: u64, value: f64) {
        if value.is_nan() {
            return;
        }
        self.known += 1;
        // B. P. Welford, Technometrics 4 (1962) 419–420
        let from_mean = value - self.mean;
        self.mean += from_mean / self.known as f64;
        self.squares += from_mean * (value - self.mean);
        let freedoms = self.known - 1;
        self.standard_deviation = (freedoms > 0).then(|| (self.squares / freedoms as f64).sqrt());
        if value < self.lowest {
            (self.lowest, self.lowest_in_run) = (value, run);
        }
        if value > self.highest {
            (self.highest, self.highest_in_run) = (value, run);
        }
    }
}

/// Quantiles by linear interpolation between the order statistics, type 7 of Hyndman & Fan (1996).
pub(super) fn quantiles(values: impl Iterator<Item = f64>) -> Option<[f64; QUANTILES.len()]> {
    let mut sorted: Vec<f64> = values.filter(|value| !value.is_nan()).collect();
    sorted.sort_by(f64::total_cmp);
    let last = sorted.len().checked_sub(1)?;
    Some(QUANTILES.map(|share| {
        let place = share * last as f64;
        let below = place as usize;
        let above = (below + 1).min(last);
        match place - below as f64 {
            // compared with an infinite life
            0.0 => sorted[below],
            part => sorted[below] * (1.0 - part) + sorted[above] * part,
        }
    }))
}
