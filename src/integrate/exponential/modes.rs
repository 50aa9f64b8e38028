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
use crate::registers::in_wide_registers;

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

/// Damping that parts modes that are nearly the same, over the norm of the Jacobian: the root of it is how far
/// apart they then are.
const PARTING: f64 = 1e-3;

/// A function of a linear part in the coordinates of its modes: a factor for each coordinate, and one for what
/// it adds to its partner.
pub(super) type Diagonal<const N: usize> = [[f64; N]; 2];

impl<const N: usize> Modes<N> {
    /// Of no linear part: every component by itself.
    pub fn none() -> Self {
        let mut unity = [[0.0; N]; N];
        for (place, column) in unity.iter_mut().enumerate() {
            column[place] = 1.0;
        }
        Self {
            eigenvalues: [Complex::ZERO; N],
            against: [[0.0; N]; 2],
            shapes: unity,
            parts: unity,
        }
    }

    /// Modes of a Jacobian, with the units in which it is smallest and its norm in them, or of a matrix next to it:
    /// the frozen linear part of the method may be any, and what it lacks is in the remainder. Where the modes are
    /// no sound basis, as at critical damping, every component gets a little damping of its own, which parts them, and
    /// what acts on nothing that acts back only decays; where that does not help either, there is no linear part.
    pub fn near(jacobian: &Columns<N>, units: &[f64; N], norm: f64) -> Self {
        let apart = || {
            let (mut jacobian, mut units) = (*jacobian, *units);
            for place in 0..N {
                let column = &mut jacobian[place];
                if units[place].is_finite() {
                    column[place] -= PARTING * norm * (1.0 + place as f64 / N as f64);
                } else {
                    units[place] = 1.0;
                    // nothing comes back of what it acts on, and it has no time scale of its own
                    if column[place] == 0.0 {
                        *column = [0.0; N];
                    }
                }
            }
            Self::new(&jacobian, &units)
        };
        let own = Self::new(jacobian, units);
        own.or_else(apart).unwrap_or_else(Self::none)
    }

    /// Modes of a Jacobian with the units in which it is smallest; none where they are no sound basis.
    fn new(jacobian: &Columns<N>, units: &[f64; N]) -> Option<Self> {
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
    use super::super::columns::{balanced_units, norm_in};
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

    /// V Λ V⁻¹ is next to J: at critical damping, of a body that nothing holds, and of what hangs on it.
    #[test]
    fn where_modes_are_no_basis_those_of_a_matrix_next_to_it_are() {
        let held = [[0.0, -1e8, 0.0], [1.0, -2e4, 3e3], [0.0; 3]];
        let free = [[0.0, 0.0, 5.0], [1.0, -10.0, 3e3], [0.0; 3]];
        for jacobian in [held, free] {
            let units = balanced_units(&jacobian);
            assert!(Modes::new(&jacobian, &units).is_none());
            let norm = norm_in(&units, &jacobian);
            let modes = Modes::near(&jacobian, &units, norm);
            assert!(modes.eigenvalues.iter().any(|value| value.norm() > 0.0));
            let level = Level::new();
            for place in 0..3 {
                let mut deviation = [0.0; 3];
                deviation[place] = 1.0;
                let z = modes.coordinates(&deviation, level);
                let back = modes.deviation(&z, level);
                // −Λ z is the remainder at no rate
                let rate = modes.deviation(&modes.slow(&[0.0; 3], &z, level), level);
                for row in 0..3 {
                    let whole = f64::from(u8::from(row == place));
                    assert!((back[row] - whole).abs() < 1e-9, "{place}, {row}: {back:?}");
                    let acting = units[row].is_finite() && units[place].is_finite();
                    if row == place || acting {
                        let unit = if acting {
                            units[place] / units[row]
                        } else {
                            1.0
                        };
                        let off = (rate[row] + jacobian[place][row]) * unit;
                        assert!(off.abs() < 3.0 * PARTING * norm, "{place}, {row}: {off:e}");
                    }
                }
            }
        }
        let nothing = [[0.0; 2]; 2];
        let modes = Modes::near(&nothing, &balanced_units(&nothing), 0.0);
        assert_eq!(modes.eigenvalues, [Complex::ZERO; 2]);
        assert_eq!(modes.coordinates(&[3.0, -4.0], Level::new()), [3.0, -4.0]);
    }
}
