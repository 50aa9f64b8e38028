//! Functions φ_k of a matrix, which integrate polynomials exactly beside a linear system.
//!
//! ```text
//! φ_0(X) = exp X,   φ_k(X) = ∫₀¹ exp((1−σ)X) σ^(k−1)/(k−1)! dσ,   φ_k = X φ_{k+1} + 1/k!
//! φ_k(2X) = 2^−k [φ_0(X) φ_k(X) + Σ_{j=1}^{k} φ_j(X)/(k−j)!]
//! ```
//!
//! Source: Hochbruck & Ostermann, *Exponential integrators*, Acta Numerica 19 (2010) 209–286, sec. 2;
//! the doubling as in Skaflestad & Wright, *Appl. Numer. Math.* 59 (2009) 783–799.

use super::columns::{Columns, apply};
use super::linear::LinearPart;
use super::nodes::POINTS;

/// Highest k.
pub(super) const HIGHEST: usize = POINTS;
/// Norm up to which the series is summed without halving.
const SMALL: f64 = 1.0;
/// Halvings after which the matrix is out of all reason.
const MOST_HALVINGS: u32 = 60;
/// Terms of the series of the highest function: the next is below round-off at the norm above.
const TERMS: usize = 15;

/// φ_0 … φ_HIGHEST.
pub(super) type Family<const N: usize> = [Columns<N>; HIGHEST + 1];

/// The functions of a linear part over an interval, s.
#[inline(always)]
pub(super) fn over<const N: usize>(part: &LinearPart<N>, interval: f64) -> Family<N> {
    let scaled = times(interval, &part.jacobian);
    family(&scaled, interval * part.norm, part.first)
}

/// The functions of a matrix whose size by a sensible norm is known; of φ_1 and those after it only the
/// columns from `first` on are right.
#[inline(always)]
pub(super) fn family<const N: usize>(matrix: &Columns<N>, norm: f64, first: usize) -> Family<N> {
    let halvings = if norm > SMALL {
        ((norm / SMALL).log2().ceil() as u32).min(MOST_HALVINGS)
    } else {
        0
    };
    let mut family = small(&times(0.5_f64.powi(halvings as i32), matrix));
    for _ in 0..halvings {
        double(&mut family, first);
    }
    family
}

/// The functions of a matrix of small norm.
#[inline(always)]
fn small<const N: usize>(matrix: &Columns<N>) -> Family<N> {
    let mut family = [[[0.0; N]; N]; HIGHEST + 1];
    // n!/(n+k)! by Horner's rule, then the factor 1/n!
    let mut sum = diagonal(1.0);
    for term in (1..=TERMS).rev() {
        let scaled = times(1.0 / (HIGHEST + term) as f64, &sum);
        sum = diagonal(1.0);
        add_product(matrix, &scaled, &mut sum);
    }
    let mut inverse = (1..=HIGHEST).map(|k| 1.0 / k as f64).product::<f64>();
    family[HIGHEST] = times(inverse, &sum);
    for k in (0..HIGHEST).rev() {
        inverse *= (k + 1) as f64;
        let mut sum = diagonal(inverse);
        add_product(matrix, &family[k + 1], &mut sum);
        family[k] = sum;
    }
    family
}

/// From the functions of X to those of 2X.
#[inline(always)]
fn double<const N: usize>(family: &mut Family<N>, first: usize) {
    let exponential = family[0];
    for k in (0..=HIGHEST).rev() {
        let part = 0.5_f64.powi(k as i32);
        let first = if k == 0 { 0 } else { first };
        let (upto, _) = family.split_at_mut(k + 1);
        let Some((doubled, lower)) = upto.split_last_mut() else {
            continue;
        };
        for (column, doubled) in doubled.iter_mut().enumerate().skip(first) {
            let own = *doubled;
            let mut sum = [0.0; N];
            apply(&exponential, 0, &own, &mut sum);
            let mut inverse = 1.0;
            for j in (1..=k).rev() {
                let addend = if j == k { &own } else { &lower[j][column] };
                for row in 0..N {
                    sum[row] += inverse * addend[row];
                }
                inverse /= (k - j + 1) as f64;
            }
            for row in 0..N {
                doubled[row] = part * sum[row];
            }
        }
    }
}

#[inline(always)]
fn add_product<const N: usize>(left: &Columns<N>, right: &Columns<N>, sum: &mut Columns<N>) {
    for (column, sum) in right.iter().zip(sum) {
        apply(left, 0, column, sum);
    }
}

#[inline(always)]
fn diagonal<const N: usize>(value: f64) -> Columns<N> {
    let mut matrix = [[0.0; N]; N];
    for (place, column) in matrix.iter_mut().enumerate() {
        column[place] = value;
    }
    matrix
}

/// A matrix in another unit.
#[inline(always)]
fn times<const N: usize>(factor: f64, matrix: &Columns<N>) -> Columns<N> {
    let mut product = *matrix;
    for entry in product.as_flattened_mut() {
        *entry *= factor;
    }
    product
}

#[cfg(test)]
mod tests {
    use super::*;

    /// φ_1 … of a number: (φ_{k−1} − 1/(k−1)!)/x loses nothing where x is large.
    fn of_number(x: f64) -> [f64; HIGHEST + 1] {
        let mut values = [x.exp(); HIGHEST + 1];
        let mut factorial = 1.0;
        for k in 1..=HIGHEST {
            values[k] = (values[k - 1] - 1.0 / factorial) / x;
            factorial *= k as f64;
        }
        values
    }

    #[test]
    fn functions_of_a_number_are_known() {
        for x in [-1e5, -300.0, -40.0, -8.0] {
            let found = family(&[[x]], x.abs(), 0);
            for (k, expected) in of_number(x).into_iter().enumerate().skip(1) {
                let error = (found[k][0][0] - expected).abs() / expected.abs();
                assert!(error < 1e-11, "phi_{k}({x}): {error:e}");
            }
        }
    }

    /// φ_0 is a rotation, and φ_1 = (φ_0 − 1)/X keeps its chord.
    #[test]
    fn functions_of_a_rotation_are_sines_and_cosines() {
        for angle in [1e-3, 0.7, 3.0, 50.0] {
            let found = family(&[[0.0, -angle], [angle, 0.0]], angle, 0);
            let (sin, cos) = angle.sin_cos();
            let rotation = [[cos, -sin], [sin, cos]];
            let chord = [[sin, cos - 1.0], [1.0 - cos, sin]];
            for column in 0..2 {
                for row in 0..2 {
                    let turn = found[0][column][row] - rotation[column][row];
                    let mean = found[1][column][row] - chord[column][row] / angle;
                    assert!(
                        turn.abs() < 1e-13 && mean.abs() < 1e-13,
                        "{angle}: {turn:e} {mean:e}"
                    );
                }
            }
        }
    }
}
