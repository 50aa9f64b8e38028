//! Whether a sequence is regular or chaotic, without a model of it.

use std::f64::consts::PI;

/// Frequencies that are tried.
const FREQUENCIES: u32 = 100;
/// Most values that are looked at: the last ones.
const MOST_VALUES: usize = 2000;
/// Part of the values over which the growth is followed.
const FOLLOWED: usize = 10;

/// The 0–1 test for chaos: near 0 for a regular sequence, near 1 for a chaotic one.
///
/// ```text
/// p(n) + i q(n) = Σ_{j≤n} φ_j e^{ijc},   M(m) = mean_n |p(n + m) − p(n)|² + |q(n + m) − q(n)|²
/// D(m) = M(m) − mean(φ)² (1 − cos mc)/(1 − cos c),   K_c = correlation of D with m,   m ≤ N/10
/// ```
///
/// The answer is the median of K_c over a hundred c in π/5 … 4π/5.
///
/// Source: G. A. Gottwald & I. Melbourne, *On the implementation of the 0–1 test for chaos*, SIAM
/// J. Appl. Dyn. Syst. 8 (2009) 129–145. The c of this function are evenly spread instead of random.
pub fn zero_one_test(values: &[f64]) -> f64 {
    let values = &values[values.len().saturating_sub(MOST_VALUES)..];
    if values.len() < 2 * FOLLOWED {
        return 0.0;
    }
    let mean = values.iter().sum::<f64>() / values.len() as f64;
    // evenly by the golden ratio, so that none is a simple part of a turn
    let golden = 0.5 * (5f64.sqrt() - 1.0);
    let mut found: Vec<f64> = (1..=FREQUENCIES)
        .map(|index| {
            let part = (golden * f64::from(index)).fract();
            growth(values, mean, PI * (0.2 + 0.6 * part))
        })
        .collect();
    found.sort_by(f64::total_cmp);
    found[found.len() / 2]
}

/// K_c.
fn growth(values: &[f64], mean: f64, c: f64) -> f64 {
    let mut sum = [0.0; 2];
    let walk: Vec<[f64; 2]> = values
        .iter()
        .zip(1u32..)
        .map(|(value, n)| {
            let (sin, cos) = (f64::from(n) * c).sin_cos();
            sum = [sum[0] + value * cos, sum[1] + value * sin];
            sum
        })
        .collect();
    let most = values.len() / FOLLOWED;
    let kept = values.len() - most;
    let (times, distances): (Vec<f64>, Vec<f64>) = (1..=most)
        .map(|m| {
            let pairs = walk[..kept].iter().zip(&walk[m..]);
            let squares = pairs.map(|(a, b)| (b[0] - a[0]).powi(2) + (b[1] - a[1]).powi(2));
            let time = m as f64;
            let swing = mean * mean * (1.0 - (time * c).cos()) / (1.0 - c.cos());
            (time, squares.sum::<f64>() / kept as f64 - swing)
        })
        .unzip();
    correlation(&times, &distances)
}

fn correlation(a: &[f64], b: &[f64]) -> f64 {
    let mean = |values: &[f64]| values.iter().sum::<f64>() / values.len() as f64;
    let (mean_a, mean_b) = (mean(a), mean(b));
    let pairs = || a.iter().zip(b).map(|(a, b)| (a - mean_a, b - mean_b));
    let product: f64 = pairs().map(|(a, b)| a * b).sum();
    let squares = pairs().fold([0.0; 2], |sum, (a, b)| [sum[0] + a * a, sum[1] + b * b]);
    let norm = (squares[0] * squares[1]).sqrt();
    if norm > 0.0 { product / norm } else { 0.0 }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_logistic_map_is_regular_and_chaotic() {
        let logistic = |r: f64| {
            let step = move |x: &f64| Some(r * x * (1.0 - x));
            std::iter::successors(Some(0.3), step)
                .skip(1000)
                .take(1000)
                .collect::<Vec<_>>()
        };
        assert!(zero_one_test(&logistic(3.55)) < 0.1); // a period of eight
        assert!(zero_one_test(&logistic(3.97)) > 0.9); // chaos
    }
}
