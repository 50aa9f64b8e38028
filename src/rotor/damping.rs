//! Viscous damping of the kept freedoms, and that of the contacts.

use super::{Damping, FREEDOMS, Rotation, Rotor};
use crate::bearing::{Matrix5, Vector5, in_registers};

/// Damping matrix C, diagonal wherever the scene allows.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum DampingMatrix {
    Diagonal(Vector5),
    Full([Vector5; FREEDOMS]),
}

impl Rotor {
    /// C of all that damps the shaft but the contacts of the balls: rows and columns x, y, z, θx, θy; N s/m
    /// and what follows from it for the tilts.
    pub fn damping_matrix(&self) -> [Vector5; FREEDOMS] {
        let row = |row| std::array::from_fn(|column| self.damping.entry(row, column));
        std::array::from_fn(row)
    }

    /// Entry of C + ωG at a speed in rad/s: what resists, and the gyroscopic coupling of the tilts.
    pub(super) fn rate_entry(&self, row: usize, column: usize, speed: f64) -> f64 {
        let gyroscopic = match (row, column) {
            (3, 4) => self.inertia_polar * speed,
            (4, 3) => -self.inertia_polar * speed,
            _ => 0.0,
        };
        self.damping.entry(row, column) + gyroscopic
    }

    /// Force of the shaft against the damping of all contacts, N and N m.
    pub(super) fn contact_damping(
        &self,
        displacement: &Vector5,
        velocity: &Vector5,
        rotation: &Rotation,
    ) -> Vector5 {
        let mut total = [0.0; FREEDOMS];
        self.for_each_support(rotation, &self.phases(rotation), |support, rotation| {
            let [_, force] = support.damped_force(displacement, velocity, rotation);
            for axis in 0..FREEDOMS {
                total[axis] += force[axis];
            }
        });
        total
    }
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

    /// C times the velocity of the kept freedoms.
    #[inline(always)]
    pub fn force(&self, velocity: &[f64]) -> Vector5 {
        match self {
            Self::Diagonal(diagonal) => {
                let mut force = [0.0; FREEDOMS];
                for (axis, speed) in velocity.iter().enumerate() {
                    force[axis] = diagonal[axis] * speed;
                }
                force
            }
            Self::Full(rows) => in_registers(full_force(rows, velocity)),
        }
    }
}

/// Out of line: most dampings are diagonal.
#[inline(never)]
fn full_force(rows: &[Vector5; FREEDOMS], velocity: &[f64]) -> Vector5 {
    rows.map(|coefficients| {
        let products = coefficients.iter().zip(velocity);
        products
            .map(|(coefficient, speed)| coefficient * speed)
            .sum()
    })
}
