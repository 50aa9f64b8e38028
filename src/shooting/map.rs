//! What shooting knows of a system.

use nalgebra::{DMatrix, DVector};

use super::Circle;
use crate::integrate::IntegrateError;

/// Which slopes of the map are asked for besides its image.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Slopes {
    /// None.
    None,
    /// Slopes of the first state, taken for all, and only as exact as a search needs them.
    First,
    /// Slopes of every state, only as exact as a search needs them.
    All,
    /// Slopes of every state, as exact as multipliers are asked for.
    Exact,
    /// Slopes of the first state alone, as exact.
    FirstExact,
}

/// States after a period.
#[derive(Debug, Clone, PartialEq)]
pub struct Image {
    /// The states, one after the other.
    pub end: DVector<f64>,
    /// `∂(end)/∂(start)` of the states asked for, in their order.
    pub slopes: Vec<DMatrix<f64>>,
}

/// Why the image of states is not known.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum MapError {
    /// The motion cannot be integrated over the period.
    #[error(transparent)]
    Integrate(#[from] IntegrateError),
    /// The system does not exist at a value of its parameter.
    #[error("{0}")]
    Parameter(String),
}

/// The map of states over one period. States are scaled: a unit is the size of the motion, and zero a
/// state of rest.
pub trait ReturnMap {
    /// Number of components of a state.
    fn size(&self) -> usize;

    /// The closed curve of the states; a point where there is a single one.
    fn circle(&self) -> &Circle;

    /// States after a period.
    ///
    /// # Errors
    /// [`MapError`] where that is not known.
    fn image(&mut self, states: &DVector<f64>, slopes: Slopes) -> Result<Image, MapError>;

    /// Makes the map that of a value of the parameter; the unit of the states does not depend on it.
    ///
    /// # Errors
    /// [`MapError::Parameter`] where there is none.
    fn set(&mut self, parameter: f64) -> Result<(), MapError>;

    /// The residual after half the period; `None` where the period has no half
    /// that the forcing repeats with.
    ///
    /// # Errors
    /// [`MapError`] where that is not known.
    fn half_return(&mut self, _states: &DVector<f64>) -> Result<Option<DVector<f64>>, MapError> {
        Ok(None)
    }
}

/// Residual of states that are to return: image less the shifted states.
pub(super) fn residual(
    map: &dyn ReturnMap,
    states: &DVector<f64>,
    end: &DVector<f64>,
) -> DVector<f64> {
    end - mixed(&map.circle().shift, states, map.size())
}

/// States of so many numbers each, mixed by a matrix over the nodes of a closed curve.
pub fn mixed(matrix: &DMatrix<f64>, states: &DVector<f64>, size: usize) -> DVector<f64> {
    DVector::from_fn(size * matrix.nrows(), |row, _| {
        let (node, part) = (row / size, row % size);
        (0..matrix.ncols())
            .map(|from| matrix[(node, from)] * states[size * from + part])
            .sum()
    })
}

/// Slopes of the residual: those of the states on the diagonal, less the shift.
pub(super) fn jacobian(map: &dyn ReturnMap, slopes: &[DMatrix<f64>]) -> DMatrix<f64> {
    let (size, shift) = (map.size(), &map.circle().shift);
    let count = shift.nrows();
    DMatrix::from_fn(size * count, size * count, |row, column| {
        let (node, from) = (row / size, column / size);
        let (part, by) = (row % size, column % size);
        let own = match slopes {
            [only] => only[(part, by)],
            all => all[node][(part, by)],
        };
        let own = if node == from { own } else { 0.0 };
        own - if part == by { shift[(node, from)] } else { 0.0 }
    })
}
