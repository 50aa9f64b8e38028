//! How much each number of a study follows each axis.

use std::collections::BTreeMap;

use serde::Serialize;

use super::digest::Digest;

/// Fewest runs that a rank correlation is told of.
const FEWEST_RUNS: usize = 10;

/// How a number follows the axes.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub(super) struct Sensitivity {
    /// Name of the number.
    pub number: String,
    /// Rank correlation with every axis by its name.
    pub rank_correlation: BTreeMap<String, f64>,
}

/// Of every number that varies Spearman's rank correlation with every axis.
///
/// Source: C. Spearman, *The proof and measurement of association between two things*, Am. J. Psychol. 15
/// (1904) 72–101; equal values get the mean of their ranks.
pub(super) fn sensitivities(digest: &Digest) -> Vec<Sensitivity> {
    let of = |index: usize| {
        let known: Vec<_> = digest
            .rows
            .iter()
            .filter(|row| !row.numbers[index].is_nan())
            .collect();
        let column = &digest.columns[index];
        if known.len() < FEWEST_RUNS || column.lowest == column.highest {
            return None;
        }
        let numbers = ranks(known.iter().map(|row| row.numbers[index]));
        let axes = digest.axes.iter().enumerate();
        let axes = axes.map(|(axis, name)| {
            let values = ranks(known.iter().map(|row| row.values[axis]));
            (name.clone(), correlation(&values, &numbers))
        });
        Some(Sensitivity {
            number: column.name.clone(),
            rank_correlation: axes.collect(),
        })
    };
    (0..digest.columns.len()).filter_map(of).collect()
}

/// Place of every value in their order, from 0 on; equal ones share the mean of their places.
fn ranks(values: impl Iterator<Item = f64>) -> Vec<f64> {
    let values: Vec<f64> = values.collect();
    let mut order: Vec<usize> = (0..values.len()).collect();
    order.sort_by(|a, b| values[*a].total_cmp(&values[*b]));
    let mut ranks = vec![0.0; values.len()];
    let mut start = 0;
    for equal in order.chunk_by(|a, b| values[*a] == values[*b]) {
        let rank = start as f64 + 0.5 * (equal.len() - 1) as f64;
        equal.iter().for_each(|place| ranks[*place] = rank);
        start += equal.len();
    }
    ranks
}

/// Pearson's correlation; zero where one does not vary.
fn correlation(a: &[f64], b: &[f64]) -> f64 {
    let mean = |values: &[f64]| values.iter().sum::<f64>() / values.len() as f64;
    let (mean_a, mean_b) = (mean(a), mean(b));
    let product = |(a, b): (&f64, &f64)| (a - mean_a) * (b - mean_b);
    let covariance: f64 = a.iter().zip(b).map(product).sum();
    let square = |values: &[f64], mean: f64| -> f64 {
        values.iter().map(|value| (value - mean).powi(2)).sum()
    };
    let spread = (square(a, mean_a) * square(b, mean_b)).sqrt();
    if spread > 0.0 {
        covariance / spread
    } else {
        0.0
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_rank_correlation_is_that_of_scipy() {
        // scipy.stats.spearmanr([1, 2, 3, 4, 5], [5, 6, 7, 8, 7]) = 0.8207826816681233
        let a = ranks([1.0, 2.0, 3.0, 4.0, 5.0].into_iter());
        let b = ranks([5.0, 6.0, 7.0, 8.0, 7.0].into_iter());
        assert!((correlation(&a, &b) - 0.820_782_681_668_123_3).abs() < 1e-14);
    }
}
