//! Natural frequencies of the rotor linearised at its static equilibrium.

use std::f64::consts::TAU;

use nalgebra::DMatrix;

use super::{FREEDOMS, Rotor};

/// A mode of vibration of the linearised rotor.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct NaturalFrequency {
    /// Undamped natural frequency |λ|/2π, Hz.
    pub frequency: f64,
    /// Damping ratio −Re λ/|λ|.
    pub damping_ratio: f64,
}

impl Rotor {
    /// Natural frequencies, lowest first; overdamped and rigid-body modes are left out.
    ///
    /// Eigenvalues λ of `M q̈ + (C + ωG) q̇ + K q = 0`, one of each conjugate pair, with K at the
    /// static equilibrium, G the gyroscopic coupling of the tilts and ω the speed at t = 0.
    pub fn natural_frequencies(&self) -> Vec<NaturalFrequency> {
        let eigenvalues = self.state_matrix().complex_eigenvalues();
        let mut modes: Vec<NaturalFrequency> = eigenvalues
            .iter()
            .filter(|eigenvalue| eigenvalue.im > 1e-9 * eigenvalue.re.abs())
            .map(|eigenvalue| NaturalFrequency {
                frequency: eigenvalue.norm() / TAU,
                damping_ratio: -eigenvalue.re / eigenvalue.norm(),
            })
            .collect();
        modes.sort_by(|a, b| a.frequency.total_cmp(&b.frequency));
        modes
    }

    /// Matrix A of `d/dt (q, q̇) = A (q, q̇)`.
    fn state_matrix(&self) -> DMatrix<f64> {
        let kept = self.kept;
        let stiffness = &self.equilibrium.stiffness;
        let mut matrix = DMatrix::zeros(2 * kept, 2 * kept);
        for row in 0..kept {
            matrix[(row, kept + row)] = 1.0;
            for column in 0..kept {
                let inverse_mass = self.inverse_mass[row];
                matrix[(kept + row, column)] = -stiffness[(row, column)] * inverse_mass;
                matrix[(kept + row, kept + column)] =
                    -self.damping.entry(row, column) * inverse_mass;
            }
        }
        if kept == FREEDOMS {
            let coupling = self.inertia_polar * self.speed() * self.inverse_mass[3];
            matrix[(kept + 3, kept + 4)] -= coupling;
            matrix[(kept + 4, kept + 3)] += coupling;
        }
        matrix
    }
}
