//! Interpolation by polynomials on nodes that include both ends of an interval.

use std::f64::consts::PI;

/// Chebyshev–Lobatto nodes on −1 … 1, rising; symmetric to the bit, both ends exact.
pub(super) fn lobatto<const N: usize>() -> [f64; N] {
    std::array::from_fn(|index| {
        let steps = 2 * index as i64 + 1 - N as i64;
        (PI * steps as f64 / (2 * (N - 1)) as f64).sin()
    })
}

/// Weights by which values at `nodes` make the coefficients of the powers of x: row k for x^k.
pub(super) fn power_weights<const N: usize>(nodes: &[f64; N]) -> [[f64; N]; N] {
    let mut rows = [[0.0; N]; N];
    for node in 0..N {
        // Lagrange's polynomial of the node, factor by factor: Π (x − x_j)/(x_i − x_j)
        let mut powers = [0.0; N];
        powers[0] = 1.0;
        for other in (0..N).filter(|&other| other != node) {
            let scale = 1.0 / (nodes[node] - nodes[other]);
            for power in (0..N).rev() {
                let below = if power > 0 { powers[power - 1] } else { 0.0 };
                powers[power] = (below - nodes[other] * powers[power]) * scale;
            }
        }
        for power in 0..N {
            rows[power][node] = powers[power];
        }
    }
    rows
}

/// Sum of values by weights.
pub(super) fn weighted<const N: usize, const M: usize>(
    weights: &[f64; N],
    values: impl Fn(usize) -> [f64; M],
) -> [f64; M] {
    let mut sum = [0.0; M];
    for (index, weight) in weights.iter().enumerate() {
        for (sum, value) in sum.iter_mut().zip(values(index)) {
            *sum += weight * value;
        }
    }
    sum
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn values_at_the_nodes_give_back_the_powers_of_a_polynomial() {
        let expected = [-2.0, 0.7, -1.2, 0.3, 0.9, -0.4];
        let nodes = lobatto::<6>().map(|node| 0.5 * node);
        let value = |x: f64| expected.iter().rev().fold(0.0, |sum, c| sum * x + c);
        for (weights, expected) in power_weights(&nodes).iter().zip(expected) {
            let [power] = weighted(weights, |node| [value(nodes[node])]);
            assert!((power - expected).abs() < 1e-13, "{power}, {expected}");
        }
    }

    #[test]
    fn nodes_are_symmetric_and_reach_both_ends() {
        let nodes = lobatto::<5>();
        assert_eq!([nodes[0], nodes[2], nodes[4]], [-1.0, 0.0, 1.0]);
        assert_eq!(nodes[1], -nodes[3]);
    }
}
