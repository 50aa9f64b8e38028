//! The modes of a linear part as a basis of its states.
//!
//! States that act on no other, such as works, are quadratures: the eigenvalue of each is zero, and the modes of the
//! others go on in it as in its rate.

use nalgebra::{Complex, DMatrix};

use crate::numerics::eigenvectors::modes;

/// Product of the norms of the basis and its inverse, over the number of modes, up to which round-off in the
/// coordinates is no matter: it comes to this many times that of the state.
const WORST_CONDITION: f64 = 1e4;
/// Least size of an eigenvalue, over the largest, where there are quadratures: far slower modes pile up in
/// them.
const SLOWEST: f64 = 1e-9;

/// A basis V with J V = V Λ.
pub(super) struct Basis {
    /// Eigenvalue of each coordinate, 1/s: of a pair both, the one with positive imaginary part first.
    pub eigenvalues: Vec<Complex<f64>>,
    /// V and V⁻¹.
    pub shapes: DMatrix<f64>,
    pub parts: DMatrix<f64>,
}

impl Basis {
    /// The basis of a Jacobian with the units in which it is smallest; none where it is no sound one, as where two
    /// modes are nearly the same.
    pub fn new(jacobian: &DMatrix<f64>, units: &[f64]) -> Option<Self> {
        if !jacobian.iter().all(|entry| entry.is_finite()) {
            return None;
        }
        // states that act on others; no basis where some act on quadratures alone
        let acts = |&position: &usize| jacobian.column(position).iter().any(|entry| *entry != 0.0);
        let acting: Vec<usize> = (0..jacobian.nrows()).filter(acts).collect();
        if acting.is_empty() || !acting.iter().all(|&position| units[position].is_finite()) {
            return None;
        }
        let basis = Self::from_acting(&acting, jacobian, units)?;
        let basis = basis.with_quadratures(&acting, jacobian)?;
        let mut all = basis.shapes.iter().chain(basis.parts.iter());
        all.all(|entry| entry.is_finite()).then_some(basis)
    }

    /// V Λ V⁻¹: the Jacobian, as far as the modes were found.
    pub fn restored(&self) -> DMatrix<f64> {
        self.moved() * &self.parts
    }

    /// V Λ.
    fn moved(&self) -> DMatrix<f64> {
        let mut moved = self.shapes.clone();
        for (own, eigenvalue) in self.eigenvalues.iter().enumerate() {
            let mut column = self.shapes.column(own) * eigenvalue.re;
            // J (x + i x') = (a + i b) (x + i x') of a pair of columns x, x'
            if eigenvalue.im != 0.0 {
                let partner = if eigenvalue.im > 0.0 {
                    own + 1
                } else {
                    own - 1
                };
                column -= self.shapes.column(partner) * eigenvalue.im;
            }
            moved.set_column(own, &column);
        }
        moved
    }

    /// This basis after a step of Newton's method on J V = V Λ, which corrects the round-off of the modes: V (1 + X) and
    /// λ_j + S_jj, with S = V⁻¹ (J V − V Λ) and X_ij = S_ij/(λ_j − λ_i) where the eigenvalues differ.
    ///
    /// Source: Dongarra, Moler & Wilkinson, *SIAM J. Numer. Anal.* 20 (1983) 23–45.
    pub fn refined(mut self, jacobian: &DMatrix<f64>) -> Self {
        let residual = &self.parts * (jacobian * &self.shapes - self.moved());
        let [to_pairs, from_pairs] = conjugate_vectors(&self.eigenvalues);
        let residual = &from_pairs * residual.map(Complex::from) * &to_pairs;
        let (rows, columns) = residual.shape();
        let change = DMatrix::from_fn(rows, columns, |row, column| {
            let difference = self.eigenvalues[column] - self.eigenvalues[row];
            match difference == Complex::ZERO {
                true => Complex::ZERO,
                false => residual[(row, column)] / difference,
            }
        });
        let change = (to_pairs * change * from_pairs).map(|entry| entry.re);
        for (own, eigenvalue) in self.eigenvalues.iter_mut().enumerate() {
            *eigenvalue += residual[(own, own)];
        }
        self.shapes += &self.shapes * &change;
        self.parts -= change * &self.parts;
        self
    }

    /// The basis of what acts, pairs first, by the modes of its matrix in the units given.
    fn from_acting(acting: &[usize], jacobian: &DMatrix<f64>, units: &[f64]) -> Option<Self> {
        let (count, rows) = (acting.len(), jacobian.nrows());
        let modes = modes(DMatrix::from_fn(count, count, |row, column| {
            let (row, column) = (acting[row], acting[column]);
            jacobian[(row, column)] * (units[column] / units[row])
        }))?;
        let mut eigenvalues = vec![Complex::ZERO; rows];
        let (mut scaled, mut coordinate) = (DMatrix::zeros(count, count), 0);
        for paired in [true, false] {
            let alike = modes.iter().filter(|mode| mode.is_pair() == paired);
            for mode in alike {
                eigenvalues[coordinate] = mode.eigenvalue;
                for (row, value) in mode.shape.iter().enumerate() {
                    scaled[(row, coordinate)] = value.re;
                    if paired {
                        scaled[(row, coordinate + 1)] = value.im;
                    }
                }
                if paired {
                    eigenvalues[coordinate + 1] = mode.eigenvalue.conj();
                }
                coordinate += 1 + usize::from(paired);
            }
        }
        let inverse = scaled.clone().lu().try_inverse()?;
        let condition = scaled.norm() * inverse.norm() / count as f64;
        let [mut shapes, mut parts] = [DMatrix::zeros(rows, rows), DMatrix::zeros(rows, rows)];
        for (row, &position) in acting.iter().enumerate() {
            for coordinate in 0..count {
                shapes[(position, coordinate)] = scaled[(row, coordinate)] * units[position];
                parts[(coordinate, position)] = inverse[(coordinate, row)] / units[position];
            }
        }
        (condition <= WORST_CONDITION).then_some(Self {
            eigenvalues,
            shapes,
            parts,
        })
    }

    /// This basis with quadratures of rates R y, in which a mode X has the part H = R X Λ⁻¹:
    /// V = (X 0, H 1), V⁻¹ = (X⁻¹ 0, −H X⁻¹ 1).
    fn with_quadratures(mut self, acting: &[usize], jacobian: &DMatrix<f64>) -> Option<Self> {
        let count = acting.len();
        let sizes = self.eigenvalues[..count].iter().map(|value| value.norm());
        let [least, most] = sizes.fold([f64::INFINITY, 0.0], |[least, most], size| {
            [size.min(least), size.max(most)]
        });
        let quadratures = (0..jacobian.nrows()).filter(|row| !acting.contains(row));
        for (own, quadrature) in (count..).zip(quadratures) {
            if least < SLOWEST * most {
                return None;
            }
            for coordinate in 0..count {
                self.shapes[(quadrature, coordinate)] =
                    self.integral(acting, jacobian, quadrature, coordinate);
            }
            for &position in acting {
                let products = (0..count).map(|coordinate| {
                    self.shapes[(quadrature, coordinate)] * self.parts[(coordinate, position)]
                });
                self.parts[(own, position)] = -products.sum::<f64>();
            }
            (
                self.shapes[(quadrature, own)],
                self.parts[(own, quadrature)],
            ) = (1.0, 1.0);
        }
        Some(self)
    }

    /// The part of a coordinate's mode in a quadrature: of a pair the real or the imaginary part of R x/λ.
    fn integral(
        &self,
        acting: &[usize],
        jacobian: &DMatrix<f64>,
        quadrature: usize,
        coordinate: usize,
    ) -> f64 {
        let rate = |coordinate: usize| -> f64 {
            let rates = acting.iter().map(|&position| {
                jacobian[(quadrature, position)] * self.shapes[(position, coordinate)]
            });
            rates.sum()
        };
        let eigenvalue = self.eigenvalues[coordinate];
        if eigenvalue.im > 0.0 {
            (Complex::new(rate(coordinate), rate(coordinate + 1)) / eigenvalue).re
        } else if eigenvalue.im < 0.0 {
            (Complex::new(rate(coordinate - 1), rate(coordinate)) / eigenvalue.conj()).im
        } else {
            rate(coordinate) / eigenvalue.re
        }
    }
}

/// P and P⁻¹, which make of the real and the imaginary part of each vector the vector and its conjugate.
fn conjugate_vectors(eigenvalues: &[Complex<f64>]) -> [DMatrix<Complex<f64>>; 2] {
    let unity = DMatrix::identity(eigenvalues.len(), eigenvalues.len());
    let [mut to_pairs, mut from_pairs] = [unity.clone(), unity];
    let is_first = |own: &usize| eigenvalues[*own].im > 0.0;
    for own in (0..eigenvalues.len()).filter(is_first) {
        let (one, turn) = (Complex::ONE, Complex::<f64>::I);
        let mut block = to_pairs.view_mut((own, own), (2, 2));
        block.copy_from_slice(&[one, turn, one, -turn]);
        let mut block = from_pairs.view_mut((own, own), (2, 2));
        block.copy_from_slice(&[one * 0.5, one * 0.5, -turn * 0.5, turn * 0.5]);
    }
    [to_pairs, from_pairs]
}

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

    fn basis<const N: usize>(columns: &[[f64; N]; N]) -> Option<Basis> {
        let jacobian = DMatrix::from_column_slice(N, N, columns.as_flattened());
        Basis::new(&jacobian, &balanced_units(&jacobian))
    }

    /// Displacements and velocities under stiff damping that couples them, with two works and a state that
    /// never changes compared with them, in units far apart.
    fn with_works() -> [[f64; 7]; 7] {
        let mut jacobian = [[0.0; 7]; 7];
        (jacobian[2][0], jacobian[3][1]) = (1.0, 1.0);
        let forces = [[-4e8, 3e8, -1e6, 2e3], [-3e8, -4e8, -3e3, -9e5]];
        for (row, entries) in forces.iter().enumerate() {
            for (column, entry) in entries.iter().enumerate() {
                jacobian[column][2 + row] = *entry;
            }
        }
        for (column, entries) in jacobian.iter_mut().take(4).enumerate() {
            (entries[4], entries[5]) = (1e3 + column as f64, -2e7);
        }
        jacobian
    }

    /// V⁻¹ V = 1 and J V = V Λ, with the eigenvalues of a pair as they turn its two coordinates.
    #[test]
    fn modes_and_their_eigenvalues_make_the_jacobian() {
        let columns = with_works();
        let basis = basis(&columns).expect("a sound basis");
        let unity = &basis.parts * &basis.shapes;
        assert!((unity - DMatrix::identity(7, 7)).amax() < 1e-11);
        let jacobian = DMatrix::from_fn(7, 7, |row, column| columns[column][row]);
        let mut turning = DMatrix::zeros(7, 7);
        for (coordinate, eigenvalue) in basis.eigenvalues.iter().enumerate() {
            turning[(coordinate, coordinate)] = eigenvalue.re;
            if eigenvalue.im != 0.0 {
                let partner = if eigenvalue.im > 0.0 {
                    coordinate + 1
                } else {
                    coordinate - 1
                };
                turning[(coordinate, partner)] = eigenvalue.im;
            }
        }
        assert!(basis.eigenvalues[0].im > 0.0 && basis.eigenvalues[6] == Complex::ZERO);
        let [left, right] = [jacobian * &basis.shapes, &basis.shapes * turning];
        for (left, right) in left.row_iter().zip(right.row_iter()) {
            assert!(
                (left - right).amax() < 1e-11 * left.amax().max(1e-30),
                "{left} {right}"
            );
        }
    }

    /// Modes that are off by 1e-6 come right to the square of it.
    #[test]
    fn newtons_step_corrects_modes() {
        let columns = with_works();
        let jacobian = DMatrix::from_column_slice(7, 7, columns.as_flattened());
        let units = balanced_units(&jacobian);
        let mut basis = basis(&columns).expect("a sound basis");
        for (column, mut shape) in basis.shapes.column_iter_mut().take(4).enumerate() {
            shape[column] *= 1.0 + 1e-6;
        }
        for eigenvalue in &mut basis.eigenvalues {
            *eigenvalue *= 1.0 + 1e-6;
        }
        basis.parts = basis.shapes.clone().try_inverse().expect("an inverse");
        let off = |basis: &Basis| {
            let off = basis.restored() - &jacobian;
            norm_in(&units, &off) / norm_in(&units, &jacobian)
        };
        let before = off(&basis);
        let after = off(&basis.refined(&jacobian));
        assert!(before > 1e-7 && after < 1e-11, "{before:e}, {after:e}");
    }

    /// An oscillator at critical damping has one vector only, and one that hardly misses it two that are nearly
    /// the same. What is not finite, or nothing at all, has none.
    #[test]
    fn a_basis_that_is_not_sound_is_none() {
        let oscillator = |ratio: f64| [[0.0, -1e8], [1.0, -2e4 * ratio]];
        for ratio in [0.0, 0.02, 0.999, 1.001, 50.0] {
            assert!(basis(&oscillator(ratio)).is_some(), "{ratio}");
        }
        for ratio in [1.0, 1.0 - 1e-10, 1.0 + 1e-10, f64::NAN, f64::INFINITY] {
            assert!(basis(&oscillator(ratio)).is_none(), "{ratio}");
        }
        assert!(basis(&[[0.0; 3]; 3]).is_none());
    }

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
