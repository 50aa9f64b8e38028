//! A linear part in the coordinates of its modes.
//!
//! ```text
//! y = V z,   J V = V Λ,   z′ = Λ z + V⁻¹ g
//! ```
//!
//! A real eigenvalue has one coordinate; of a conjugate pair the real and the imaginary part of the vector have
//! one each, side by side, which turn into one another.

use fearless_simd::Level;
use nalgebra::{Complex, DMatrix};

use super::basis::{Basis, balanced_units, norm_in};
use super::matrix::ChunkMatrix;
use super::remainder::FewForces;
use crate::integrate::Separated;
use crate::integrate::chunks::{Chunk, Padded, add_product, chunks_of};

/// Damping that parts modes that are nearly the same, over the norm of the Jacobian: the root of it is how far
/// apart they then are.
const PARTING: f64 = 1e-3;

/// Largest difference of V Λ V⁻¹ from the Jacobian, over the norm of the Jacobian, that round-off explains.
const EXACT: f64 = 1e-12;

/// A function of a linear part for a chunk of its modes: a factor for each coordinate, and one for what it adds to its
/// partner. Pairs lie at even positions, so that none is divided between chunks.
pub(super) type Diagonal = [Chunk; 2];

/// The linear part of a system: `∂f/∂y` in one state, or a matrix next to it whose modes are a sound basis.
#[derive(Debug, Clone)]
pub(super) struct LinearPart {
    /// Norm of the Jacobian in the units that make it smallest, 1/s.
    pub norm: f64,
    /// Vector instructions of the processor.
    pub level: Level,
    /// Eigenvalue of each coordinate, 1/s: of a pair both, the one with positive imaginary part first.
    pub eigenvalues: Vec<Complex<f64>>,
    /// −Λ.
    against: Vec<Diagonal>,
    /// V and V⁻¹.
    pub shapes: ChunkMatrix,
    pub parts: ChunkMatrix,
    /// The remainder by the few forces that make it, where the system knows them.
    pub few_forces: Option<FewForces>,
}

/// A state as its deviation from the origin, and the modal coordinates of that.
#[derive(Debug, Clone)]
pub(super) struct ModalState {
    pub coordinates: Padded,
    pub deviation: Padded,
}

impl ModalState {
    /// So many zeros.
    pub fn zeros(states: usize) -> Self {
        Self {
            coordinates: Padded::zeros(states),
            deviation: Padded::zeros(states),
        }
    }

    /// Takes the numbers of another one.
    pub fn copy_from(&mut self, other: &Self) {
        self.coordinates.copy_from(&other.coordinates);
        self.deviation.copy_from(&other.deviation);
    }
}

impl LinearPart {
    /// No linear part of so many states: every component by itself.
    pub fn none(states: usize) -> Self {
        let unity = ChunkMatrix::from_matrix(&DMatrix::identity(states, states));
        Self {
            norm: 0.0,
            level: Level::new(),
            eigenvalues: vec![Complex::ZERO; states],
            against: vec![[[0.0; 4]; 2]; chunks_of(states)],
            shapes: unity.clone(),
            parts: unity,
            few_forces: None,
        }
    }

    /// The linear part A + D K of a separated derivative, with the remainder by its forces about the scaling's origin; where
    /// its modes are no sound basis, or do not make it to round-off, that of a matrix next to it with the remainder by the
    /// whole derivative, which makes up for the difference.
    pub fn from_separated(separated: &Separated, origin: &[f64]) -> Self {
        let jacobian = separated.jacobian();
        let units = balanced_units(&jacobian);
        let norm = norm_in(&units, &jacobian);
        let basis = Basis::new(&jacobian, &units);
        let exact =
            |basis: &Basis| norm_in(&units, &(basis.restored() - &jacobian)) <= EXACT * norm;
        let basis = match basis {
            Some(basis) if !exact(&basis) => Some(basis.refined(&jacobian)).filter(exact),
            exact_or_none => exact_or_none,
        };
        let Some(basis) = basis else {
            return Self::near(&jacobian);
        };
        Self {
            norm,
            few_forces: Some(FewForces::new(separated, &basis, origin)),
            ..Self::from_basis(basis)
        }
    }

    /// The linear part of a Jacobian, or of a matrix next to it: the frozen linear part of the method may be any, and what it
    /// lacks is in the remainder. Where the modes are no sound basis, as at critical damping, every component gets a
    /// little damping of its own, which parts them, and what acts on nothing that acts back only decays; where that does
    /// not help either, there is no linear part.
    pub fn near(jacobian: &DMatrix<f64>) -> Self {
        let units = balanced_units(jacobian);
        let norm = norm_in(&units, jacobian);
        let apart = || {
            let (mut jacobian, mut units) = (jacobian.clone(), units.clone());
            let states = units.len() as f64;
            for (position, unit) in units.iter_mut().enumerate() {
                if unit.is_finite() {
                    jacobian[(position, position)] -=
                        PARTING * norm * (1.0 + position as f64 / states);
                    continue;
                }
                *unit = 1.0;
                // nothing comes back of what it acts on, and it has no time scale of its own
                if jacobian[(position, position)] == 0.0 {
                    jacobian.column_mut(position).fill(0.0);
                }
            }
            Basis::new(&jacobian, &units)
        };
        let basis = Basis::new(jacobian, &units).or_else(apart);
        let own = basis.map_or_else(|| Self::none(units.len()), Self::from_basis);
        Self { norm, ..own }
    }

    fn from_basis(basis: Basis) -> Self {
        let mut part = Self::none(basis.eigenvalues.len());
        for (coordinate, eigenvalue) in basis.eigenvalues.iter().enumerate() {
            let [own, given] = &mut part.against[coordinate / 4];
            own[coordinate % 4] = -eigenvalue.re;
            given[coordinate % 4] = eigenvalue.im;
        }
        part.shapes = ChunkMatrix::from_matrix(&basis.shapes);
        part.parts = ChunkMatrix::from_matrix(&basis.parts);
        part.eigenvalues = basis.eigenvalues;
        part
    }

    /// Numbers of the remainder at a point: of the few forces that make it, else of its modal coordinates.
    pub fn remainders(&self) -> usize {
        let few = self.few_forces.as_ref();
        few.map_or(self.eigenvalues.len(), |few| few.acting.len())
    }

    /// Finds the coordinates of a deviation.
    pub fn to_coordinates(&self, state: &mut ModalState) {
        let ModalState {
            coordinates,
            deviation,
        } = state;
        self.parts
            .multiply::<false>(deviation, coordinates.chunks_mut());
    }

    /// Finds the deviation of coordinates, within code for wide registers.
    #[inline(always)]
    pub fn find_deviation(&self, coordinates: &Padded, deviation: &mut Padded) {
        self.shapes
            .multiply::<false>(coordinates, deviation.chunks_mut());
    }

    /// V⁻¹ f − Λ z, the coordinates of the nonlinear remainder f − J y where the derivative f is known, within code for
    /// wide registers.
    #[inline(always)]
    pub fn find_remainder(&self, rate: &Padded, coordinates: &Padded, remainder: &mut Padded) {
        let chunks = coordinates.chunks().iter().zip(&self.against);
        for (remainder, (coordinates, against)) in remainder.chunks_mut().iter_mut().zip(chunks) {
            let mut sums = [[0.0; 4]; 2];
            add(against, coordinates, &mut sums);
            *remainder = joined(&sums);
        }
        self.parts.multiply::<true>(rate, remainder.chunks_mut());
    }
}

/// Adds a function of the linear part times a vector to the sums that [`joined`] puts together.
#[inline(always)]
pub(super) fn add(function: &Diagonal, vector: &Chunk, sums: &mut Diagonal) {
    for (factors, sum) in function.iter().zip(sums) {
        add_product(sum, factors, vector);
    }
}

/// What each coordinate has of its own and from its partner.
#[inline(always)]
pub(super) fn joined([own, given]: &Diagonal) -> Chunk {
    [
        own[0] + given[1],
        own[1] + given[0],
        own[2] + given[3],
        own[3] + given[2],
    ]
}

#[cfg(test)]
mod tests {
    use super::*;

    fn coordinates(part: &LinearPart, deviation: &[f64]) -> Padded {
        let mut state = ModalState::zeros(deviation.len());
        state.deviation.copy_from_slice(deviation);
        part.to_coordinates(&mut state);
        state.coordinates
    }

    fn deviation(part: &LinearPart, coordinates: &Padded) -> Padded {
        let mut deviation = coordinates.clone();
        part.find_deviation(coordinates, &mut deviation);
        deviation
    }

    /// f − J y at a rate and a deviation.
    fn remainder(part: &LinearPart, rate: &[f64], at: &[f64]) -> Padded {
        let (rate, coordinates) = (Padded::from_slice(rate), coordinates(part, at));
        let mut remainder = rate.clone();
        part.find_remainder(&rate, &coordinates, &mut remainder);
        deviation(part, &remainder)
    }

    /// V⁻¹ f − Λ z is what f − J y is, with an oscillation among decays: the velocities last.
    #[test]
    fn the_remainder_is_the_rate_less_the_linear_part() {
        let columns = [
            [0.0, 0.0, -1e8, 2e7],
            [0.0, 0.0, 1e7, -1e8],
            [1.0, 0.0, -9e5, 300.0],
            [0.0, 1.0, -300.0, -400.0],
        ];
        let jacobian = DMatrix::from_column_slice(4, 4, columns.as_flattened());
        let part = LinearPart::near(&jacobian);
        assert!(part.eigenvalues[0].im > 0.0 && part.eigenvalues[3].im == 0.0);
        let (deviation, rate) = ([1e-6, -2e-6, 3e-3, 4e-3], [3e-3, 4e-3, 70.0, -50.0]);
        let found = remainder(&part, &rate, &deviation);
        let linear = jacobian * DMatrix::from_column_slice(4, 1, &deviation);
        for row in 0..4 {
            let error = (found[row] - (rate[row] - linear[row])).abs();
            assert!(
                error < 1e-11 * (1.0 + linear[row].abs()),
                "{row}: {error:e}"
            );
        }
    }

    /// V Λ V⁻¹ is next to J: at critical damping, of a body that nothing holds, and of its quadratures.
    #[test]
    fn where_modes_are_no_basis_those_of_a_matrix_next_to_it_are() {
        let held = [[0.0, -1e8, 0.0], [1.0, -2e4, 3e3], [0.0; 3]];
        let free = [[0.0, 0.0, 5.0], [1.0, -10.0, 3e3], [0.0; 3]];
        for columns in [held, free] {
            let jacobian = DMatrix::from_column_slice(3, 3, columns.as_flattened());
            let units = balanced_units(&jacobian);
            assert!(Basis::new(&jacobian, &units).is_none());
            let part = LinearPart::near(&jacobian);
            assert!(part.eigenvalues.iter().any(|value| value.norm() > 0.0));
            for position in 0..3 {
                let mut one = [0.0; 3];
                one[position] = 1.0;
                let back = deviation(&part, &coordinates(&part, &one));
                // −Λ z is the remainder at no rate
                let rate = remainder(&part, &[0.0; 3], &one);
                for row in 0..3 {
                    assert!((back[row] - one[row]).abs() < 1e-9, "{position}, {row}");
                    let acting = units[row].is_finite() && units[position].is_finite();
                    if row == position || acting {
                        let unit = if acting {
                            units[position] / units[row]
                        } else {
                            1.0
                        };
                        let off = (rate[row] + jacobian[(row, position)]) * unit;
                        assert!(
                            off.abs() < 3.0 * PARTING * part.norm,
                            "{position}, {row}: {off:e}"
                        );
                    }
                }
            }
        }
        let part = LinearPart::near(&DMatrix::zeros(2, 2));
        assert_eq!(part.eigenvalues, [Complex::ZERO; 2]);
        assert_eq!(coordinates(&part, &[3.0, -4.0])[..], [3.0, -4.0]);
    }
}
