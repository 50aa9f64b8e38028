//! Linear equations with many right-hand sides.

use fearless_simd::Level;
use nalgebra::DMatrix;

use super::registers::in_wide_registers;

/// Solves A X = B by Gaussian elimination with partial pivoting. Returns whether there is a solution.
///
/// `equations` has a column for each equation: its row of A and, below it, its row of B. The solution takes the place of B.
///
/// Source: Golub & Van Loan, *Matrix Computations*, 4th ed. (2013), sec. 3.4.
pub(crate) fn solve_equations(level: Level, equations: &mut DMatrix<f64>) -> bool {
    let count = equations.ncols();
    for pivot in 0..count {
        let coefficient = |equation: &usize| equations[(pivot, *equation)].abs();
        let largest = (pivot..count).max_by(|a, b| coefficient(a).total_cmp(&coefficient(b)));
        let largest = largest.unwrap_or(pivot);
        let divisor = equations[(pivot, largest)];
        if divisor == 0.0 || !divisor.is_finite() {
            return false;
        }
        equations.swap_columns(pivot, largest);
        in_wide_registers!(level, eliminate(equations, pivot, divisor));
    }
    in_wide_registers!(level, substitute_back(equations));
    true
}

/// Divides an equation by its divisor, and takes its unknown out of the later ones.
#[inline(always)]
fn eliminate(equations: &mut DMatrix<f64>, pivot: usize, divisor: f64) {
    let rows = equations.nrows();
    let (own, later) = equations.as_mut_slice()[rows * pivot..].split_at_mut(rows);
    for value in &mut own[pivot..] {
        *value /= divisor;
    }
    for equation in later.chunks_exact_mut(rows) {
        subtract(
            &own[pivot + 1..],
            equation[pivot],
            &mut equation[pivot + 1..],
        );
    }
}

/// Takes the later unknowns out of each equation, from the last one on.
#[inline(always)]
fn substitute_back(equations: &mut DMatrix<f64>) {
    let (rows, count) = equations.shape();
    for pivot in (1..count).rev() {
        let (earlier, own) = equations.as_mut_slice().split_at_mut(rows * pivot);
        for equation in earlier.chunks_exact_mut(rows) {
            subtract(&own[count..rows], equation[pivot], &mut equation[count..]);
        }
    }
}

/// Subtracts a factor times some numbers.
#[inline(always)]
fn subtract(numbers: &[f64], factor: f64, from: &mut [f64]) {
    for (from, number) in from.iter_mut().zip(numbers) {
        *from -= factor * number;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Nine equations whose first coefficient vanishes, with five right-hand sides; and a matrix that has no inverse.
    #[test]
    fn unknowns_obey_the_equations() {
        let matrix = DMatrix::from_fn(9, 9, |row, column| match (row, column) {
            (0, 0) => 0.0,
            _ => (1.0 + (7 * column + 3 * row * row + row * column) as f64).sin(),
        });
        let unknowns = DMatrix::from_fn(9, 5, |row, column| (row + 1) as f64 / (column + 2) as f64);
        let known = &matrix * &unknowns;
        let mut equations = DMatrix::zeros(14, 9);
        equations.rows_mut(0, 9).copy_from(&matrix.transpose());
        equations.rows_mut(9, 5).copy_from(&known.transpose());
        assert!(solve_equations(Level::new(), &mut equations));
        let off = (equations.rows(9, 5).transpose() - unknowns).amax();
        assert!(off < 1e-12, "{off:e}");
        assert!(!solve_equations(
            Level::new(),
            &mut DMatrix::from_element(3, 2, 1.0)
        ));
    }
}
