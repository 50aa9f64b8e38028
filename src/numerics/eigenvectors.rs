//! Eigenvalues and eigenvectors of small real matrices, by their real Schur form `A = Q T Qᵀ`.

use nalgebra::linalg::Schur;
use nalgebra::{Complex, DMatrix, Dyn};

/// Sweeps of the QR iteration for each row: three are usual.
const SWEEPS: usize = 30;

/// The real Schur form; none where the iteration does not come to an end.
fn schur(matrix: DMatrix<f64>) -> Option<Schur<f64, Dyn>> {
    let sweeps = SWEEPS * matrix.nrows();
    Schur::try_new(matrix, f64::EPSILON, sweeps)
}

/// Magnitude of the largest eigenvalue; none where the iteration does not come to an end.
pub(crate) fn largest_eigenvalue(matrix: DMatrix<f64>) -> Option<f64> {
    let eigenvalues = schur(matrix)?.complex_eigenvalues();
    let sizes = eigenvalues.iter().map(|value| value.norm());
    sizes.reduce(f64::max)
}

/// An eigenvalue with its eigenvector of unit length; of a conjugate pair the one with positive imaginary part.
pub(crate) struct Mode {
    pub eigenvalue: Complex<f64>,
    pub shape: Vec<Complex<f64>>,
}

impl Mode {
    /// Whether it is one of a conjugate pair.
    pub fn is_pair(&self) -> bool {
        self.eigenvalue.im > 0.0
    }
}

/// The modes of a small real matrix by back substitution in its Schur form; none where the iteration does not come to an
/// end. A matrix without a full set of eigenvectors has some that are nearly the same.
///
/// Source: Golub & Van Loan, *Matrix Computations*, 4th ed. (2013), sec. 7.6.4.
pub(crate) fn modes(matrix: DMatrix<f64>) -> Option<Vec<Mode>> {
    let rows = matrix.nrows();
    let (basis, form) = schur(matrix)?.unpack();
    let least = f64::EPSILON * form.amax();
    let (mut modes, mut row) = (Vec::with_capacity(rows), 0);
    while row < rows {
        let paired = is_pair(&form, row);
        let last = row + usize::from(paired);
        let eigenvalue = if paired {
            eigenvalue_of_pair(&form, row)?
        } else {
            Complex::from(form[(row, row)])
        };
        let inner = eigenvector(&form, last, eigenvalue, least);
        modes.push(Mode {
            eigenvalue,
            shape: of_unit_length(&basis, &inner),
        });
        row = last + 1;
    }
    Some(modes)
}

/// Whether a row and the next form a block of two on the diagonal.
fn is_pair(form: &DMatrix<f64>, row: usize) -> bool {
    row + 1 < form.nrows() && form[(row + 1, row)] != 0.0
}

/// The eigenvalue with positive imaginary part of a block of two; none where both are real.
fn eigenvalue_of_pair(form: &DMatrix<f64>, row: usize) -> Option<Complex<f64>> {
    let [first, second] = [form[(row, row)], form[(row + 1, row + 1)]];
    let half = 0.5 * (first - second);
    let square = half * half + form[(row, row + 1)] * form[(row + 1, row)];
    (square < 0.0).then(|| Complex::new(0.5 * (first + second), (-square).sqrt()))
}

/// The eigenvector of the Schur form whose last entry that is not zero is that of row `last`. Divisors that
/// vanish, as they do where eigenvalues are the same, are taken as `least`.
fn eigenvector(
    form: &DMatrix<f64>,
    last: usize,
    eigenvalue: Complex<f64>,
    least: f64,
) -> Vec<Complex<f64>> {
    let mut vector = vec![Complex::ZERO; form.nrows()];
    vector[last] = Complex::ONE;
    let mut found = last;
    if last > 0 && is_pair(form, last - 1) {
        found -= 1;
        vector[found] = (eigenvalue - form[(last, last)]) / form[(last, found)];
    }
    while found > 0 {
        let low = found - 1;
        let rest = |row: usize| -> Complex<f64> {
            (found..=last)
                .map(|column| vector[column] * form[(row, column)])
                .sum()
        };
        let own = |row: usize| form[(row, row)] - eigenvalue;
        if low > 0 && is_pair(form, low - 1) {
            let up = low - 1;
            let [above, below] = [form[(up, low)], form[(low, up)]];
            let determinant = own(up) * own(low) - above * below;
            let divisor = at_least(determinant, least * least);
            let pair = [
                rest(low) * above - own(low) * rest(up),
                rest(up) * below - own(up) * rest(low),
            ];
            [vector[up], vector[low]] = pair.map(|entry| entry / divisor);
            found = up;
        } else {
            vector[low] = -rest(low) / at_least(own(low), least);
            found = low;
        }
    }
    vector
}

fn at_least(divisor: Complex<f64>, least: f64) -> Complex<f64> {
    if divisor.norm() < least {
        Complex::from(least)
    } else {
        divisor
    }
}

/// A vector of the Schur basis as one of the matrix, of unit length. Sums in their own order: products of
/// matrices may be fused on some processors.
fn of_unit_length(basis: &DMatrix<f64>, inner: &[Complex<f64>]) -> Vec<Complex<f64>> {
    let mut shape = vec![Complex::ZERO; inner.len()];
    for (column, value) in inner.iter().enumerate() {
        for (row, entry) in shape.iter_mut().enumerate() {
            *entry += value * basis[(row, column)];
        }
    }
    let length = shape.iter().map(Complex::norm_sqr).sum::<f64>().sqrt();
    for entry in &mut shape {
        *entry /= length;
    }
    shape
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Largest entry of `A x − λ x` over all modes.
    fn residual(matrix: &DMatrix<f64>) -> f64 {
        let modes = modes(matrix.clone()).expect("modes");
        let coordinates = modes.iter().map(|mode| 1 + usize::from(mode.is_pair()));
        assert_eq!(coordinates.sum::<usize>(), matrix.nrows());
        let entry = |mode: &Mode, row: usize| {
            let products = mode.shape.iter().enumerate();
            let product: Complex<f64> = products
                .map(|(column, value)| value * matrix[(row, column)])
                .sum();
            (product - mode.eigenvalue * mode.shape[row]).norm()
        };
        modes
            .iter()
            .flat_map(|mode| (0..matrix.nrows()).map(move |row| entry(mode, row)))
            .fold(0.0, f64::max)
    }

    /// Real eigenvalues and conjugate pairs in any order, and one that occurs three times.
    #[test]
    fn vectors_belong_to_their_eigenvalues() {
        let mixed = DMatrix::from_fn(10, 10, |row, column| {
            (1.0 + (7 * column + 3 * row) as f64).sin()
        });
        let found = residual(&mixed);
        assert!(found < 1e-13, "{found:e}");
        let repeated = DMatrix::from_fn(5, 5, |row, column| {
            f64::from(u8::from(row == column)) * if row < 3 { -2.0 } else { 1.0 }
        });
        assert!(residual(&repeated) < 1e-15);
    }

    /// Both vectors of a matrix that has but one are nearly the same.
    #[test]
    fn a_missing_vector_shows() {
        let found = modes(DMatrix::from_row_slice(2, 2, &[-1.0, 1.0, 0.0, -1.0])).expect("modes");
        assert_eq!(found.len(), 2);
        let along: Complex<f64> = found[0]
            .shape
            .iter()
            .zip(&found[1].shape)
            .map(|(a, b)| a.conj() * b)
            .sum();
        assert!(along.norm() > 1.0 - 1e-12);
    }
}
