//! Units in which a matrix is smallest.

use nalgebra::DMatrix;

/// Sweeps of [`balanced_units`]: each brings rows and columns nearer to each other.
const BALANCING: usize = 8;

/// The units of the components, up to a common factor, in which rows and columns of a matrix are of one size;
/// infinite of what does nothing to others, or to such alone.
///
/// Source: Osborne, *J. ACM* 7 (1960) 338–345.
pub(super) fn balanced_units(matrix: &DMatrix<f64>) -> Vec<f64> {
    let states = matrix.nrows();
    let mut unit = vec![1.0_f64; states];
    for _ in 0..BALANCING {
        for i in 0..states {
            let others = || (0..states).filter(|&j| j != i);
            let into: f64 = others().map(|j| scaled(matrix, &unit, i, j)).sum();
            let out_of: f64 = others().map(|j| scaled(matrix, &unit, j, i)).sum();
            let factor = (into / out_of).sqrt();
            if out_of == 0.0 {
                unit[i] = f64::INFINITY;
            } else if into > 0.0 && factor.is_finite() {
                unit[i] *= factor;
            }
        }
    }
    unit
}

/// Size of an entry in some units.
fn scaled(matrix: &DMatrix<f64>, unit: &[f64], row: usize, column: usize) -> f64 {
    let entry = matrix[(row, column)].abs();
    if entry == 0.0 {
        0.0
    } else {
        entry * unit[column] / unit[row]
    }
}

/// Largest sum of a column in the units of [`balanced_units`].
///
/// What a component does to others counts for nothing where nothing comes back: a work that is summed
/// up has no time scale. Powers of the matrix neither grow nor lose digits by such a choice of units.
pub(super) fn norm_in(unit: &[f64], matrix: &DMatrix<f64>) -> f64 {
    let sum = |column: usize| {
        let own = matrix[(column, column)].abs();
        let others = (0..unit.len()).filter(|&row| row != column);
        let others = others.map(|row| scaled(matrix, unit, row, column));
        own + others.filter(|entry| entry.is_finite()).sum::<f64>()
    };
    (0..unit.len()).map(sum).fold(0.0, f64::max)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// An oscillator in metres and metres per second, whose work in microjoules is summed up: its
    /// frequency alone is the size of the matrix.
    #[test]
    fn units_and_sums_do_not_count() {
        let (square, power) = (25e6, 1e9);
        let columns = [0.0, -square, 0.0, 1.0, -100.0, power, 0.0, 0.0, 0.0];
        let matrix = DMatrix::from_column_slice(3, 3, &columns);
        let norm = norm_in(&balanced_units(&matrix), &matrix);
        assert!((norm - 5100.0).abs() < 1.0, "{norm}");
    }
}
