//! Viscous damping of the kept freedoms.

use super::{Damping, FREEDOMS};
use crate::bearing::{Matrix5, Vector5};

/// Damping matrix C, diagonal wherever the scene allows.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum DampingMatrix {
    Diagonal(Vector5),
    Full([Vector5; FREEDOMS]),
}

impl DampingMatrix {
    /// From the way it is given, with stiffness and mass at the static equilibrium.
    pub fn new(damping: &Damping, stiffness: &Matrix5, mass: &Vector5) -> Self {
        let critical = |axis: usize| 2.0 * (stiffness[(axis, axis)].max(0.0) * mass[axis]).sqrt();
        match *damping {
            Damping::Undamped => Self::Diagonal([0.0; FREEDOMS]),
            Damping::Coefficients(coefficients) => Self::Diagonal(coefficients),
            // c = 2 ζ √(K m)
            Damping::Ratio(ratio) => {
                Self::Diagonal(std::array::from_fn(|axis| ratio * critical(axis)))
            }
            // c = τ K
            Damping::StiffnessTime(time) => Self::Full(std::array::from_fn(|row| {
                std::array::from_fn(|column| time * stiffness[(row, column)])
            })),
        }
    }

    /// One entry of C.
    pub fn entry(&self, row: usize, column: usize) -> f64 {
        match self {
            Self::Diagonal(diagonal) if row == column => diagonal[row],
            Self::Diagonal(_) => 0.0,
            Self::Full(rows) => rows[row][column],
        }
    }

    /// Takes C times the velocity of the kept freedoms off a force.
    #[inline]
    pub fn brake(&self, velocity: &[f64], force: &mut Vector5) {
        match self {
            Self::Diagonal(diagonal) => {
                for (axis, speed) in velocity.iter().enumerate() {
                    force[axis] -= diagonal[axis] * speed;
                }
            }
            Self::Full(rows) => {
                for (row, coefficients) in rows.iter().enumerate() {
                    for (column, speed) in velocity.iter().enumerate() {
                        force[row] -= coefficients[column] * speed;
                    }
                }
            }
        }
    }
}
