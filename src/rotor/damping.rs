//! Viscous damping of the shaft, and that of the contacts.

use nalgebra::DMatrix;

use super::coefficients::Mass;
use super::structure::Structure;
use super::{Damping, FREEDOMS, Rotor};
use crate::bearing::Vector5;

impl Damping {
    /// What it adds to C, with K at the static equilibrium.
    pub(super) fn matrix(&self, structure: &Structure, stiffness: &DMatrix<f64>) -> DMatrix<f64> {
        let size = structure.coordinates.len();
        let of_shaft = |coefficient: &dyn Fn(usize, usize) -> f64| {
            let mut damping = DMatrix::zeros(size, size);
            for (axis, index) in structure.shaft.coordinates.into_iter().enumerate() {
                damping[(index, index)] = coefficient(axis, index);
            }
            damping
        };
        match self {
            Self::Undamped => DMatrix::zeros(size, size),
            Self::Coefficients(coefficients) => of_shaft(&|axis, _| coefficients[axis]),
            Self::Ratio(ratio) if structure.bending.is_some() => {
                *ratio * critical(structure, stiffness)
            }
            // c = 2 ζ √(K m)
            Self::Ratio(ratio) => of_shaft(&|_, index| {
                let [stiffness, mass] =
                    [stiffness, &structure.matrices.mass].map(|matrix| matrix[(index, index)]);
                ratio * (2.0 * (stiffness.max(0.0) * mass).sqrt())
            }),
            // c = τ K
            Self::StiffnessTime(time) => *time * stiffness,
        }
    }
}

/// Critical damping of every mode of a structure without rotation, `C = Σ 2 ω_r (M φ_r)(M φ_r)ᵀ` with φ_rᵀ M φ_r = 1.
fn critical(structure: &Structure, stiffness: &DMatrix<f64>) -> DMatrix<f64> {
    let (dofs, size) = (structure.dofs, stiffness.nrows());
    let mut whole = DMatrix::zeros(size, size);
    let mass = structure
        .matrices
        .mass
        .view((0, 0), (dofs, dofs))
        .into_owned();
    let Some(mass) = Mass::new(mass) else {
        return whole;
    };
    let normalised = mass.normalised(stiffness);
    let modes = (0.5 * (&normalised + normalised.transpose())).symmetric_eigen();
    let doubled = modes.eigenvalues.map(|square| 2.0 * square.max(0.0).sqrt());
    let scaled = &modes.eigenvectors * DMatrix::from_diagonal(&doubled);
    let root = mass.root();
    let critical = &root * (scaled * modes.eigenvectors.transpose()) * root.transpose();
    whole.view_mut((0, 0), (dofs, dofs)).copy_from(&critical);
    whole
}

impl Rotor {
    /// C of all that damps the shaft but the contacts of the balls: rows and columns x, y, z, θx, θy; N s/m
    /// and what follows from it for the tilts.
    pub(crate) fn damping_matrix(&self) -> [Vector5; FREEDOMS] {
        let indices = self.structure.shaft.coordinates;
        let entries = &self.linear.damping.entries;
        indices.map(|row| indices.map(|column| entries[(row, column)]))
    }
}
