//! Forces that a table interpolates, and their interpolants.

use super::cells::{AXIAL_TERMS, ROOT_TERMS};
use super::polynomial::weights_at;

/// Forces over the factor f that their polynomials are multiplied by: F_a/f, F_r/f, couple/f.
pub(super) type Reduced = [f64; 3];

/// Place in −1 … 1 of x in −1 … 1 of one of equal parts.
pub(super) fn part_place(part: usize, parts: usize, x: f64) -> f64 {
    (2.0 * part as f64 + 1.0 + x) / parts as f64 - 1.0
}

/// Weights that take a polynomial of high degree, `exact`, from that of low degree through its values
/// at `nodes`.
pub(super) fn difference(own: &[f64], nodes: &[Vec<f64>], exact: &[f64]) -> Vec<f64> {
    let of_node = |index: usize| {
        own.iter()
            .zip(nodes)
            .map(move |(own, node)| own * node[index])
    };
    exact
        .iter()
        .enumerate()
        .map(|(index, exact)| of_node(index).sum::<f64>() - exact)
        .collect()
}

/// Rows at x in −1 … 1 of the strip that they span.
pub(super) fn between(rows: &[Vec<Reduced>], x: f64) -> Vec<Reduced> {
    let weights = weights_at(x, rows.len());
    (0..rows[0].len())
        .map(|column| weighted(rows.iter().map(|row| row[column]), &weights))
        .collect()
}

pub(super) fn weighted(values: impl Iterator<Item = Reduced>, weights: &[f64]) -> Reduced {
    let mut sum = [0.0; 3];
    for (value, weight) in values.zip(weights) {
        for output in 0..3 {
            sum[output] += weight * value[output];
        }
    }
    sum
}

/// Coefficients of x^k t^l from those of t^l at the nodes of x.
pub(super) fn powers_along_root(
    rows: &[[Reduced; AXIAL_TERMS]; ROOT_TERMS],
    by_root: &[[f64; ROOT_TERMS]; ROOT_TERMS],
) -> [[Reduced; AXIAL_TERMS]; ROOT_TERMS] {
    by_root
        .map(|weights| std::array::from_fn(|l| weighted(rows.iter().map(|row| row[l]), &weights)))
}
