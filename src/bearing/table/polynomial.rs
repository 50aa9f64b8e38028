//! Interpolation by polynomials of low degree on nodes that include both ends.

use std::f64::consts::PI;

/// Chebyshev–Lobatto node `index` of `count` on −1 … 1, rising.
pub(super) fn lobatto(index: usize, count: usize) -> f64 {
    // symmetric to the bit, both ends exact
    let angle = PI * (2 * index as i64 + 1 - count as i64) as f64 / (2 * (count - 1)) as f64;
    angle.sin()
}

/// Weights by which values at Lobatto nodes make the interpolant at `x`.
///
/// Source: J.-P. Berrut & L. N. Trefethen, *SIAM Review* 46 (2004) 501–517, eq. 5.4.
pub(super) fn weights_at(x: f64, count: usize) -> Vec<f64> {
    let mut weights = vec![0.0; count];
    let mut sum = 0.0;
    for index in 0..count {
        let distance = x - lobatto(index, count);
        if distance == 0.0 {
            weights.fill(0.0);
            weights[index] = 1.0;
            return weights;
        }
        let half = if index == 0 || index == count - 1 {
            0.5
        } else {
            1.0
        };
        let sign = if index % 2 == 0 { half } else { -half };
        weights[index] = sign / distance;
        sum += weights[index];
    }
    weights.iter_mut().for_each(|weight| *weight /= sum);
    weights
}

/// Weights by which values at the Lobatto nodes make the coefficients of the powers of `x`: row k
/// for x^k.
pub(super) fn power_weights<const N: usize>() -> [[f64; N]; N] {
    let nodes: [f64; N] = std::array::from_fn(|index| lobatto(index, N));
    let mut rows = [[0.0; N]; N];
    for node in 0..N {
        // Lagrange's polynomial of the node, factor by factor
        let mut powers = [0.0; N];
        powers[0] = 1.0;
        for (degree, &other) in (0..N).filter(|&other| other != node).zip_nodes(&nodes) {
            let scale = 1.0 / (nodes[node] - other);
            for power in (0..=degree + 1).rev() {
                let below = if power > 0 { powers[power - 1] } else { 0.0 };
                powers[power] = (below - other * powers[power]) * scale;
            }
        }
        for power in 0..N {
            rows[power][node] = powers[power];
        }
    }
    rows
}

/// Numbers the factors of Lagrange's polynomial.
trait ZipNodes: Iterator<Item = usize> + Sized {
    fn zip_nodes(self, nodes: &[f64]) -> impl Iterator<Item = (usize, &f64)> {
        self.map(|index| &nodes[index]).enumerate()
    }
}

impl<I: Iterator<Item = usize>> ZipNodes for I {}

/// Chebyshev coefficients c_0 … of the interpolant through values at the Lobatto nodes.
pub(super) fn chebyshev_coefficients(values: &[f64]) -> Vec<f64> {
    let last = values.len() - 1;
    let ends = |index: usize| {
        if index == 0 || index == last {
            0.5
        } else {
            1.0
        }
    };
    (0..=last)
        .map(|order| {
            let sum: f64 = values
                .iter()
                .enumerate()
                .map(|(index, value)| {
                    // the nodes rise from −1: cos(π (last − index)/last)
                    let turn = PI * (order * (last - index)) as f64 / last as f64;
                    ends(index) * value * turn.cos()
                })
                .sum();
            2.0 * ends(order) * sum / last as f64
        })
        .collect()
}

/// Coefficients of the powers of x from the first `N` Chebyshev coefficients.
pub(super) fn powers_of_chebyshev<const N: usize>(coefficients: &[f64]) -> [f64; N] {
    let mut powers = [0.0; N];
    // T_0 = 1, T_1 = x, T_k+1 = 2 x T_k − T_k−1
    let (mut before, mut present) = ([0.0; N], [0.0; N]);
    present[0] = 1.0;
    for (order, coefficient) in coefficients.iter().take(N).enumerate() {
        for power in 0..N {
            powers[power] += coefficient * present[power];
        }
        let factor = if order == 0 { 1.0 } else { 2.0 };
        let next = std::array::from_fn(|power| {
            let raised = if power > 0 { present[power - 1] } else { 0.0 };
            factor * raised - before[power]
        });
        (before, present) = (present, next);
    }
    powers
}

#[cfg(test)]
mod tests {
    use super::*;

    fn cubic(x: f64) -> f64 {
        ((0.3 * x - 1.2) * x + 0.7) * x - 2.0
    }

    #[test]
    fn powers_weights_and_chebyshev_terms_give_back_a_cubic() {
        let values: [f64; 4] = std::array::from_fn(|index| cubic(lobatto(index, 4)));
        let powers = power_weights::<4>()
            .map(|row| row.iter().zip(&values).map(|(a, b)| a * b).sum::<f64>());
        let by_chebyshev = powers_of_chebyshev::<4>(&chebyshev_coefficients(&values));
        for (power, expected) in [-2.0, 0.7, -1.2, 0.3].into_iter().enumerate() {
            assert!((powers[power] - expected).abs() < 1e-15);
            assert!((by_chebyshev[power] - expected).abs() < 1e-15);
        }
        for x in [-1.0, -0.37, 0.5, 0.99] {
            let weights = weights_at(x, 4);
            let value: f64 = weights.iter().zip(&values).map(|(a, b)| a * b).sum();
            assert!((value - cubic(x)).abs() < 1e-15);
        }
    }
}
