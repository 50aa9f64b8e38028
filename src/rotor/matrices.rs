//! The matrices of all coordinates of a structure.

use nalgebra::{DMatrix, DVector};

/// Matrices of all coordinates.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Matrices {
    /// M; nothing couples degrees of freedom with what is held.
    pub mass: DMatrix<f64>,
    /// C of all that is damped but the shaft and the contacts.
    pub damping: DMatrix<f64>,
    /// K of all that is elastic but the ball bearings; springs off the centre couple degrees of freedom with tilts that are
    /// held.
    pub stiffness: DMatrix<f64>,
    /// G: gyroscopic forces per speed and velocity.
    pub gyroscopic: DMatrix<f64>,
    /// The part of C that turns with the shaft.
    pub internal_damping: DMatrix<f64>,
    /// Forces per speed and displacement that follow from it.
    pub circulatory: DMatrix<f64>,
}

impl Matrices {
    /// Matrices of masses alone: no gyroscopic moments, stiffness or damping.
    pub fn from_masses(masses: &DVector<f64>) -> Self {
        let nothing = DMatrix::zeros(masses.len(), masses.len());
        Self {
            mass: DMatrix::from_diagonal(masses),
            damping: nothing.clone(),
            stiffness: nothing.clone(),
            gyroscopic: nothing.clone(),
            internal_damping: nothing.clone(),
            circulatory: nothing,
        }
    }

    pub fn all_mut(&mut self) -> [&mut DMatrix<f64>; 6] {
        [
            &mut self.mass,
            &mut self.damping,
            &mut self.stiffness,
            &mut self.gyroscopic,
            &mut self.internal_damping,
            &mut self.circulatory,
        ]
    }
}
