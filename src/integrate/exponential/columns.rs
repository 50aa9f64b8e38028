//! Small square matrices as arrays of columns, whose products are straight-line code.
//!
//! What is worked out in place here (`#[inline(always)]`) is compiled for the width of registers that its
//! caller has dispatched to. Products and sums are the same and in the same order whatever the width, and
//! so are the bytes.

/// A matrix by its columns.
pub(super) type Columns<const N: usize> = [[f64; N]; N];

/// Adds the product of a matrix, from a column on, and a vector.
#[inline(always)]
pub(super) fn apply<const N: usize>(
    columns: &Columns<N>,
    first: usize,
    vector: &[f64; N],
    sum: &mut [f64; N],
) {
    for (column, value) in columns[first..].iter().zip(&vector[first..]) {
        for row in 0..N {
            sum[row] += column[row] * value;
        }
    }
}

/// Sweeps of [`balanced_units`]: each brings rows and columns nearer to each other.
const BALANCING: usize = 8;

/// The units of the components, up to a common factor, in which rows and columns of a matrix are of one size;
/// infinite of what does nothing to others, or to such alone.
///
/// Source: Osborne, *J. ACM* 7 (1960) 338–345.
pub(super) fn balanced_units<const N: usize>(columns: &Columns<N>) -> [f64; N] {
    let mut unit = [1.0_f64; N];
    for _ in 0..BALANCING {
        for i in 0..N {
            let others = || (0..N).filter(|&j| j != i);
            let into: f64 = others().map(|j| scaled(columns, &unit, i, j)).sum();
            let out_of: f64 = others().map(|j| scaled(columns, &unit, j, i)).sum();
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
fn scaled<const N: usize>(columns: &Columns<N>, unit: &[f64; N], row: usize, column: usize) -> f64 {
    let entry = columns[column][row].abs();
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
pub(super) fn norm_in<const N: usize>(unit: &[f64; N], columns: &Columns<N>) -> f64 {
    let sum = |column: usize| {
        let own = columns[column][column].abs();
        let others = (0..N).filter(|&row| row != column);
        let others = others.map(|row| scaled(columns, unit, row, column));
        own + others.filter(|entry| entry.is_finite()).sum::<f64>()
    };
    (0..N).map(sum).fold(0.0, f64::max)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// An oscillator in metres and metres per second, whose work in microjoules is summed up: its
    /// frequency alone is the size of the matrix.
    #[test]
    fn units_and_sums_do_not_count() {
        let (square, power) = (25e6, 1e9);
        let columns = [[0.0, -square, 0.0], [1.0, -100.0, power], [0.0, 0.0, 0.0]];
        let norm = norm_in(&balanced_units(&columns), &columns);
        assert!((norm - 5100.0).abs() < 1.0, "{norm}");
    }
}
