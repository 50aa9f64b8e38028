//! A linear part in the coordinates of its modes.
//!
//! ```text
//! y = V z,   J V = V Λ,   z′ = Λ z + V⁻¹ g
//! ```
//!
//! A real eigenvalue has one coordinate; of a conjugate pair the real and the imaginary part of the vector have
//! one each, which stand side by side and turn into one another.

use fearless_simd::Level;
use nalgebra::{Complex, DMatrix};

use super::basis::Basis;
use super::columns::{Columns, apply};
use crate::integrate::registers::in_wide_registers;

/// Modes of a linear part.
#[derive(Debug, Clone)]
pub(super) struct Modes<const N: usize> {
    /// Eigenvalue of each coordinate, 1/s: of a pair both, the one with positive imaginary part first.
    pub eigenvalues: [Complex<f64>; N],
    /// −Λ.
    against: Diagonal<N>,
    /// V and V⁻¹.
    shapes: Columns<N>,
    parts: Columns<N>,
}

/// A function of a linear part in the coordinates of its modes: a factor for each coordinate, and one for what
/// it adds to its partner.
pub(super) type Diagonal<const N: usize> = [[f64; N]; 2];

impl<const N: usize> Modes<N> {
    /// Modes of a Jacobian with the units in which it is smallest; none where they are no sound basis.
    pub fn new(jacobian: &Columns<N>, units: &[f64; N]) -> Option<Self> {
        let matrix = DMatrix::from_column_slice(N, N, jacobian.as_flattened());
        let basis = Basis::new(&matrix, units)?;
        let mut modes = Self {
            eigenvalues: [Complex::ZERO; N],
            against: [[0.0; N]; 2],
            shapes: [[0.0; N]; N],
            parts: [[0.0; N]; N],
        };
        modes.eigenvalues.copy_from_slice(&basis.eigenvalues);
        let shapes = modes.shapes.as_flattened_mut();
        shapes.copy_from_slice(basis.shapes.as_slice());
        let parts = modes.parts.as_flattened_mut();
        parts.copy_from_slice(basis.parts.as_slice());
        for (coordinate, eigenvalue) in basis.eigenvalues.iter().enumerate() {
            modes.against[0][coordinate] = -eigenvalue.re;
            modes.against[1][coordinate] = eigenvalue.im;
        }
        Some(modes)
    }

    /// Coordinates of a deviation.
    pub fn coordinates(&self, deviation: &[f64; N], level: Level) -> [f64; N] {
        in_wide_registers!(level, {
            let mut sum = [0.0; N];
            apply(&self.parts, 0, deviation, &mut sum);
            sum
        })
    }

    /// The deviation of coordinates.
    pub fn deviation(&self, coordinates: &[f64; N], level: Level) -> [f64; N] {
        in_wide_registers!(level, {
            let mut sum = [0.0; N];
            apply(&self.shapes, 0, coordinates, &mut sum);
            sum
        })
    }

    /// V⁻¹ f − Λ z, the coordinates of f − J y.
    pub fn slow(&self, rate: &[f64; N], coordinates: &[f64; N], level: Level) -> [f64; N] {
        in_wide_registers!(level, {
            let mut sums = [[0.0; N]; 2];
            add(&self.against, coordinates, &mut sums);
            let mut slow = joined(&sums);
            apply(&self.parts, 0, rate, &mut slow);
            slow
        })
    }
}

/// Adds a function of the linear part times a vector to the sums that [`joined`] puts together.
#[inline(always)]
pub(super) fn add<const N: usize>(
    function: &Diagonal<N>,
    vector: &[f64; N],
    sums: &mut Diagonal<N>,
) {
    for (factors, sum) in function.iter().zip(sums) {
        for i in 0..N {
            sum[i] += factors[i] * vector[i];
        }
    }
}

/// What each coordinate has of its own and from its partner.
#[inline(always)]
pub(super) fn joined<const N: usize>([own, given]: &Diagonal<N>) -> [f64; N] {
    let mut joined = *own;
    for pair in 0..N / 2 {
        joined[2 * pair] += given[2 * pair + 1];
        joined[2 * pair + 1] += given[2 * pair];
    }
    joined
}

#[cfg(test)]
mod tests {
    use super::super::columns::balanced_units;
    use super::*;

    /// V⁻¹ f − Λ z is what f − J y is, with an oscillation among decays: J by columns, the velocities last.
    #[test]
    fn the_slow_part_is_the_rate_less_the_linear_part() {
        let jacobian = [
            [0.0, 0.0, -1e8, 2e7],
            [0.0, 0.0, 1e7, -1e8],
            [1.0, 0.0, -9e5, 300.0],
            [0.0, 1.0, -300.0, -400.0],
        ];
        let modes = Modes::new(&jacobian, &balanced_units(&jacobian)).expect("a sound basis");
        assert!(modes.eigenvalues[0].im > 0.0 && modes.eigenvalues[3].im == 0.0);
        let (deviation, level) = ([1e-6, -2e-6, 3e-3, 4e-3], Level::new());
        let rate = [3e-3, 4e-3, 70.0, -50.0];
        let coordinates = modes.coordinates(&deviation, level);
        let found = modes.deviation(&modes.slow(&rate, &coordinates, level), level);
        let mut linear = [0.0; 4];
        apply(&jacobian, 0, &deviation, &mut linear);
        for row in 0..4 {
            let error = (found[row] - (rate[row] - linear[row])).abs();
            assert!(
                error < 1e-11 * (1.0 + linear[row].abs()),
                "{row}: {error:e}"
            );
        }
    }
}
