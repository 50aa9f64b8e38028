//! Multipliers on a closed curve, by coordinates in which the slopes are the same all around.
//!
//! Motions next to one of two frequencies obey v(φ + ρ) = A(φ) v(φ). In coordinates v = P(φ) w with
//!
//! ```text
//! P(φ + ρ)⁻¹ A(φ) P(φ) = Λ
//! ```
//!
//! each is multiplied by its own λ in a period, wherever on the curve it is. Coordinates in which A = Λ + R(φ) with a small R
//! become better ones by P = 1 + Q, with the Fourier coefficients
//!
//! ```text
//! Q_k,ij = R_k,ij/(λ_j exp(i k ρ) − λ_i)
//! ```
//!
//! which leave of R about its square.
//!
//! Source: À. Jorba & C. Simó, *J. Differ. Equ.* 98 (1992) 111–124.

use nalgebra::{Complex, DMatrix};

use super::Circle;
use crate::numerics::eigenvectors::modes;

/// Most changes of the coordinates: each about squares what is left.
const MOST_CHANGES: usize = 12;
/// Part of the largest multiplier that may be left of R: it changes the multipliers by about its square.
const LEFT: f64 = 1e-10;

type Complexes = DMatrix<Complex<f64>>;

/// The multipliers from the slopes at the nodes, with arguments that belong to the coordinates found; none where such
/// coordinates are not found, as where slopes differ much from node to node.
pub(super) fn multipliers(circle: &Circle, slopes: &[DMatrix<f64>]) -> Option<Vec<Complex<f64>>> {
    let weights = circle.coefficients.row(0);
    let weighted = slopes.iter().zip(weights.iter());
    let mean: DMatrix<f64> = weighted.map(|(slopes, weight)| slopes * *weight).sum();
    let basis = eigenvectors(mean)?;
    let inverse = basis.clone().try_inverse()?;
    let in_basis = |slopes: &DMatrix<f64>| &inverse * slopes.map(Complex::from) * &basis;
    let mut at_nodes: Vec<Complexes> = slopes.iter().map(in_basis).collect();
    for _ in 0..MOST_CHANGES {
        let mut remainders = fourier(circle, &at_nodes);
        let multipliers = remainders[0].1.diagonal();
        remainders[0].1.fill_diagonal(Complex::ZERO);
        let sizes = remainders.iter().flat_map(|(_, own)| own.iter());
        let most = sizes.map(|entry| entry.norm()).fold(0.0, f64::max);
        let left = LEFT * multipliers.camax();
        if most <= left {
            return Some(multipliers.iter().copied().collect());
        }
        if !most.is_finite() {
            return None;
        }
        for (harmonic, own) in &mut remainders {
            let turn = Complex::cis(*harmonic * circle.rotation);
            for ((row, column), entry) in entries(own) {
                // between multipliers that are next to nothing, as of overdamped modes, what is small enough stays
                *entry = match entry.norm() > left {
                    true => *entry / (multipliers[column] * turn - multipliers[row]),
                    false => Complex::ZERO,
                };
            }
        }
        let coordinates = |angle: f64| {
            let states = multipliers.len();
            let mut sum = Complexes::identity(states, states);
            for (harmonic, own) in &remainders {
                sum += own * Complex::cis(harmonic * angle);
            }
            sum
        };
        for (own, angle) in at_nodes.iter_mut().zip(&circle.angles) {
            let moved = &*own * coordinates(*angle);
            *own = coordinates(angle + circle.rotation).lu().solve(&moved)?;
        }
    }
    None
}

/// The eigenvectors of a real matrix as columns.
fn eigenvectors(matrix: DMatrix<f64>) -> Option<Complexes> {
    let states = matrix.nrows();
    let columns: Vec<_> = modes(matrix)?
        .into_iter()
        .flat_map(|mode| {
            let shape = nalgebra::DVector::from_vec(mode.shape.clone());
            let conjugate = mode.is_pair().then(|| shape.conjugate());
            [Some(shape), conjugate].into_iter().flatten()
        })
        .collect();
    (columns.len() == states).then(|| Complexes::from_columns(&columns))
}

/// Harmonics and Fourier coefficients of what is known at the nodes, the mean first.
fn fourier(circle: &Circle, at_nodes: &[Complexes]) -> Vec<(f64, Complexes)> {
    let row = |row: usize| -> Complexes {
        let weights = circle.coefficients.row(row);
        let weighted = at_nodes.iter().zip(weights.iter());
        weighted
            .map(|(own, weight)| own * Complex::from(*weight))
            .sum()
    };
    let mut all = vec![(0.0, row(0))];
    for harmonic in 1..=circle.harmonics() {
        // a cos kφ + b sin kφ
        let (a, b) = (row(2 * harmonic - 1), row(2 * harmonic));
        let half_turned = b * Complex::new(0.0, 0.5);
        let half = a * Complex::from(0.5);
        all.push((harmonic as f64, &half - &half_turned));
        all.push((-(harmonic as f64), half + half_turned));
    }
    all
}

/// Positions and entries of a matrix.
fn entries(matrix: &mut Complexes) -> impl Iterator<Item = ((usize, usize), &mut Complex<f64>)> {
    let rows = matrix.nrows();
    let positions = (0..).map(move |index| (index % rows, index / rows));
    positions.zip(matrix.iter_mut())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::shooting::multipliers::magnitudes_of_copies;

    /// The largest first.
    fn magnitudes(circle: &Circle, slopes: &[DMatrix<f64>]) -> Vec<f64> {
        let found = multipliers(circle, slopes).expect("multipliers");
        let mut magnitudes: Vec<f64> = found.iter().map(|value| value.norm()).collect();
        magnitudes.sort_by(|a, b| b.total_cmp(a));
        magnitudes
    }

    /// Slopes that turn the states and change around the curve: the magnitudes are those of the operator over the whole
    /// curve, and their product is, by Liouville's formula, the geometric mean of the determinants.
    #[test]
    fn magnitudes_are_those_of_the_whole_curve() {
        let circle =
            Circle::around(1.0, 2.0 * 3f64.sqrt(), 8).expect("an irrational part of a turn");
        let still = DMatrix::from_row_slice(3, 3, &[0.6, -0.5, 0.0, 0.5, 0.6, 0.1, 0.0, 0.2, 0.3]);
        let moving =
            DMatrix::from_row_slice(3, 3, &[0.0, 1.0, 0.5, -0.3, 0.2, 0.0, 1.0, 0.0, -0.4]);
        let at = |angle: f64| &still + &moving * (0.05 * angle.cos());
        let slopes: Vec<_> = circle.angles.iter().map(|angle| at(*angle)).collect();
        let found = magnitudes(&circle, &slopes);
        for (found, copied) in found.iter().zip(magnitudes_of_copies(&circle, &slopes)) {
            assert!((found - copied).abs() < 1e-5, "{found} {copied}");
        }
        let angles = (0..64).map(|part| f64::from(part) * std::f64::consts::TAU / 64.0);
        let logarithms = angles.map(|angle| at(angle).determinant().abs().ln());
        let mean = (logarithms.sum::<f64>() / 64.0).exp();
        let product: f64 = found.iter().product();
        assert!((product - mean).abs() < 1e-12, "{product} {mean}");
    }

    /// A turn of the neighbours of a motion changes arguments alone, and counts as an error.
    #[test]
    fn errors_count_arguments() {
        let circle =
            Circle::around(1.0, 2.0 * 3f64.sqrt(), 2).expect("an irrational part of a turn");
        let turned = |angle: f64| {
            let (sine, cosine) = angle.sin_cos();
            let still = DMatrix::from_row_slice(2, 2, &[cosine, -sine, sine, cosine]) * 0.8;
            crate::shooting::multipliers(&circle, &vec![still; circle.angles.len()])
        };
        let [before, after] = [0.7, 0.7 + 1e-6].map(turned);
        for (one, other) in before.values().iter().zip(after.values()) {
            assert!((one - other).norm() < 1e-15, "{one} {other}");
        }
        for apart in before.distances(&after, 0.0) {
            assert!((apart / 0.8e-6 - 1.0).abs() < 1e-6, "{apart:e}");
        }
    }

    /// Overdamped modes have multipliers that are next to nothing, and round-off between them is no coupling.
    #[test]
    fn multipliers_next_to_nothing_do_not_disturb_the_others() {
        let circle =
            Circle::around(1.0, 2.0 * 3f64.sqrt(), 2).expect("an irrational part of a turn");
        let slopes = circle.angles.iter().map(|angle| {
            let noise = 1e-13 * angle.sin();
            DMatrix::from_row_slice(
                4,
                4,
                &[
                    0.6, -0.5, 0.0, 0.0, 0.5, 0.6, 0.0, 0.0, 0.0, 0.0, 1e-15, noise, 0.0, 0.0,
                    -noise, 2e-15,
                ],
            )
        });
        let slopes: Vec<_> = slopes.collect();
        let found = magnitudes(&circle, &slopes);
        assert!(
            (found[0] - 0.61f64.sqrt()).abs() < 1e-15 && found[2] < 1e-12,
            "{found:?}"
        );
    }
}
