//! A linear part in the coordinates of its modes.
//!
//! ```text
//! y = V z,   J V = V Λ,   z′ = Λ z + V⁻¹ g
//! ```
//!
//! A real eigenvalue has one coordinate; of a conjugate pair the real and the imaginary part of the vector have
//! one each, which stand side by side and turn into one another. What a state adds up without acting back, such
//! as works, hangs on the modes of the others: its own eigenvalue is zero, and it follows them as its rate does.

use fearless_simd::Level;
use nalgebra::{Complex, DMatrix};

use super::columns::{Columns, apply};
use super::spectrum::{self, Mode};
use crate::integrate::registers::in_wide_registers;

/// Product of the norms of V and V⁻¹, over the number of modes, up to which round-off in the coordinates is no
/// matter: it comes to this many times that of the state.
const WORST_CONDITION: f64 = 1e4;
/// Least size of an eigenvalue, over the largest, where anything hangs on the modes: far slower ones pile up
/// in what they add to.
const SLOWEST: f64 = 1e-9;

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
    /// Modes of a Jacobian with the units in which it is smallest; none where they are no sound basis, as where
    /// two of them are nearly the same.
    pub fn new(jacobian: &Columns<N>, units: [f64; N]) -> Option<Self> {
        if !jacobian
            .as_flattened()
            .iter()
            .all(|entry| entry.is_finite())
        {
            return None;
        }
        let acting = Acting::of(jacobian, units)?;
        let found = spectrum::modes(acting.matrix(jacobian))?;
        let mut modes = Self {
            eigenvalues: [Complex::ZERO; N],
            against: [[0.0; N]; 2],
            shapes: [[0.0; N]; N],
            parts: [[0.0; N]; N],
        };
        let scaled = modes.take(&acting, jacobian, &found)?;
        let inverse = scaled.clone().lu().try_inverse()?;
        let condition = scaled.norm() * inverse.norm() / acting.places.len() as f64;
        if condition > WORST_CONDITION {
            return None;
        }
        modes.invert(&acting, &inverse);
        modes.against = [0, 1].map(|part| {
            let entry = |eigenvalue: Complex<f64>| {
                if part == 0 {
                    -eigenvalue.re
                } else {
                    eigenvalue.im
                }
            };
            modes.eigenvalues.map(entry)
        });
        let all = modes
            .shapes
            .as_flattened()
            .iter()
            .chain(modes.parts.as_flattened());
        all.copied().all(f64::is_finite).then_some(modes)
    }

    /// Puts the modes in their places, pairs first; the shapes of what acts, by coordinates, in the units that
    /// make the Jacobian smallest.
    fn take(
        &mut self,
        acting: &Acting<N>,
        jacobian: &Columns<N>,
        found: &[Mode],
    ) -> Option<DMatrix<f64>> {
        let fastest = found
            .iter()
            .map(|mode| mode.eigenvalue.norm())
            .fold(0.0, f64::max);
        let (pairs, single): (Vec<&Mode>, Vec<&Mode>) =
            found.iter().partition(|mode| mode.eigenvalue.im > 0.0);
        let mut scaled = DMatrix::zeros(acting.places.len(), acting.places.len());
        let mut coordinate = 0;
        for mode in pairs.into_iter().chain(single) {
            let slow = mode.eigenvalue.norm() < SLOWEST * fastest;
            if acting.places.len() < N && slow {
                return None;
            }
            let shape = acting.whole(jacobian, mode);
            let count = if mode.eigenvalue.im > 0.0 { 2 } else { 1 };
            for part in 0..count {
                let of = |value: &Complex<f64>| if part == 0 { value.re } else { value.im };
                for (row, value) in mode.shape.iter().enumerate() {
                    scaled[(row, coordinate)] = of(value);
                }
                self.shapes[coordinate] = std::array::from_fn(|row| of(&shape[row]));
                self.eigenvalues[coordinate] = if part == 0 {
                    mode.eigenvalue
                } else {
                    mode.eigenvalue.conj()
                };
                coordinate += 1;
            }
        }
        Some(scaled)
    }

    /// Fills in V⁻¹ from that of what acts, and what hangs on it: V = (X 0, H 1), V⁻¹ = (X⁻¹ 0, −H X⁻¹ 1).
    fn invert(&mut self, acting: &Acting<N>, inverse: &DMatrix<f64>) {
        for (column, &place) in acting.places.iter().enumerate() {
            for row in 0..acting.places.len() {
                self.parts[place][row] = inverse[(row, column)] / acting.units[place];
            }
        }
        let hanging = (0..N).filter(|&row| !acting.acts(row));
        for (coordinate, hanging) in (acting.places.len()..).zip(hanging) {
            self.shapes[coordinate][hanging] = 1.0;
            for &place in &acting.places {
                let products = (0..acting.places.len())
                    .map(|mode| self.shapes[mode][hanging] * self.parts[place][mode]);
                self.parts[place][coordinate] = -products.sum::<f64>();
            }
            self.parts[hanging][coordinate] = 1.0;
        }
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
        in_wide_registers!(level, self.put_together(coordinates))
    }

    #[inline(always)]
    pub fn put_together(&self, coordinates: &[f64; N]) -> [f64; N] {
        let mut sum = [0.0; N];
        apply(&self.shapes, 0, coordinates, &mut sum);
        sum
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

/// The components that act on any, and the units in which their matrix is smallest.
struct Acting<const N: usize> {
    places: Vec<usize>,
    units: [f64; N],
}

impl<const N: usize> Acting<N> {
    /// Those of a Jacobian; none where there are none, or where some act on what hangs on them alone.
    fn of(jacobian: &Columns<N>, units: [f64; N]) -> Option<Self> {
        let acts = |&place: &usize| jacobian[place].iter().any(|entry| *entry != 0.0);
        let places: Vec<usize> = (0..N).filter(acts).collect();
        let known = places.iter().all(|&place| units[place].is_finite());
        (known && !places.is_empty()).then_some(Self { places, units })
    }

    fn acts(&self, place: usize) -> bool {
        self.places.contains(&place)
    }

    /// Their matrix in these units.
    fn matrix(&self, jacobian: &Columns<N>) -> DMatrix<f64> {
        DMatrix::from_fn(self.places.len(), self.places.len(), |row, column| {
            let (row, column) = (self.places[row], self.places[column]);
            jacobian[column][row] * (self.units[column] / self.units[row])
        })
    }

    /// The shape of a mode in all components: in those that hang on it what they add up, H = R X/λ.
    fn whole(&self, jacobian: &Columns<N>, mode: &Mode) -> [Complex<f64>; N] {
        let mut shape = [Complex::ZERO; N];
        for (&place, value) in self.places.iter().zip(&mode.shape) {
            shape[place] = value * self.units[place];
        }
        for hanging in (0..N).filter(|&row| !self.acts(row)) {
            let rates = self
                .places
                .iter()
                .map(|&place| shape[place] * jacobian[place][hanging]);
            shape[hanging] = rates.sum::<Complex<f64>>() / mode.eigenvalue;
        }
        shape
    }
}

#[cfg(test)]
mod tests {
    use super::super::columns::balanced_units;
    use super::*;

    fn modes<const N: usize>(jacobian: &Columns<N>) -> Option<Modes<N>> {
        Modes::new(jacobian, balanced_units(jacobian))
    }

    /// A product of two matrices by columns.
    fn product<const N: usize>(left: &Columns<N>, right: &Columns<N>) -> Columns<N> {
        right.map(|column| {
            let mut sum = [0.0; N];
            apply(left, 0, &column, &mut sum);
            sum
        })
    }

    /// Displacements and velocities under stiff damping that couples them, with two works and a state that
    /// never changes beside them, in units far apart.
    fn accounted() -> Columns<7> {
        let mut jacobian = [[0.0; 7]; 7];
        (jacobian[2][0], jacobian[3][1]) = (1.0, 1.0);
        for (row, entries) in [[-4e8, 3e8, -1e6, 2e3], [-3e8, -4e8, -3e3, -9e5]]
            .iter()
            .enumerate()
        {
            for (column, entry) in entries.iter().enumerate() {
                jacobian[column][2 + row] = *entry;
            }
        }
        for (column, entries) in jacobian.iter_mut().take(4).enumerate() {
            (entries[4], entries[5]) = (1e3 + column as f64, -2e7);
        }
        jacobian
    }

    #[test]
    fn modes_and_their_eigenvalues_make_the_jacobian() {
        let jacobian = accounted();
        let modes = modes(&jacobian).expect("a sound basis");
        let unity = product(&modes.parts, &modes.shapes);
        for (column, entries) in unity.iter().enumerate() {
            for (row, entry) in entries.iter().enumerate() {
                let expected = f64::from(u8::from(row == column));
                assert!((entry - expected).abs() < 1e-11, "{row} {column}: {entry}");
            }
        }
        let scales = [1e-5, 1e-5, 0.1, 0.1, 1.0, 1.0, 1.0];
        for place in 0..7 {
            let mut unit = [0.0; 7];
            unit[place] = scales[place];
            // f = 0: what is left is −V⁻¹ J y
            let slow = modes.slow(
                &[0.0; 7],
                &modes.coordinates(&unit, Level::new()),
                Level::new(),
            );
            let rate = modes.deviation(&slow, Level::new());
            for row in 0..7 {
                let expected = -jacobian[place][row] * scales[place];
                let error = (rate[row] - expected).abs();
                assert!(
                    error < 1e-10 * expected.abs().max(1e5 * scales[row]),
                    "{row} {place}: {error:e}"
                );
            }
        }
    }

    /// An oscillator at critical damping has one vector only, and one that hardly misses it two that are nearly
    /// the same. What is not finite, or nothing at all, has none.
    #[test]
    fn a_basis_that_is_not_sound_is_none() {
        let oscillator = |ratio: f64| [[0.0, -1e8], [1.0, -2e4 * ratio]];
        for ratio in [0.0, 0.02, 0.999, 1.001, 50.0] {
            assert!(modes(&oscillator(ratio)).is_some(), "{ratio}");
        }
        for ratio in [1.0, 1.0 - 1e-10, 1.0 + 1e-10, f64::NAN, f64::INFINITY] {
            assert!(modes(&oscillator(ratio)).is_none(), "{ratio}");
        }
        assert!(modes(&[[0.0; 3]; 3]).is_none());
    }
}
