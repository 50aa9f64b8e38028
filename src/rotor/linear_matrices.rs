//! The matrices of the rotor linearised at its static equilibrium, with the names of its coordinates.

use nalgebra::DMatrix;

use super::Rotor;
use super::coordinate::{Coordinate, CoordinateKind};

/// `M q̈ + (C + ω G) q̇ + K q = f` of the degrees of freedom q about the static equilibrium, at a speed ω.
#[derive(Debug, Clone, PartialEq)]
pub struct LinearMatrices {
    /// ω, rad/s.
    pub speed: f64,
    /// Names and units of the degrees of freedom. A share of a mode of bending, which has the modal mass one, is in √kg m.
    pub coordinates: Vec<(String, &'static str)>,
    /// M.
    pub mass: DMatrix<f64>,
    /// C of the shaft, of damping and elements, and of films at rest; without that of the contacts of balls.
    pub damping: DMatrix<f64>,
    /// G: gyroscopic forces per velocity and rad/s.
    pub gyroscopic: DMatrix<f64>,
    /// K of all that holds the shaft at this speed. What has no potential, of films and of damping inside the shaft, makes it
    /// unsymmetric.
    pub stiffness: DMatrix<f64>,
    /// Frequency in Hz up to which natural frequencies are those of a shaft that bends, and not of its reduction.
    pub natural_up_to: Option<f64>,
    /// A of `d/dt (q, q̇) = A (q, q̇)`.
    pub state: DMatrix<f64>,
}

impl Rotor {
    /// The matrices of [`super::receptance::Linearised`], at the speed of the start.
    pub(crate) fn linear_matrices(&self) -> LinearMatrices {
        let (dofs, speed) = (self.dofs(), self.speed());
        let own = |matrix: &DMatrix<f64>| matrix.view((0, 0), (dofs, dofs)).into_owned();
        let slopes = self.linearised(speed);
        let mut state = DMatrix::zeros(2 * dofs, 2 * dofs);
        self.linear.write_state_matrix(&slopes, &mut state);
        let coordinates = self.structure.coordinates[..dofs].iter();
        LinearMatrices {
            speed,
            coordinates: coordinates.map(Coordinate::name_and_unit).collect(),
            mass: self.linear.mass.entries.clone(),
            damping: own(&(&self.linear.damping.entries + &self.start.law_damping)),
            gyroscopic: own(&self.linear.gyroscopic.entries),
            stiffness: own(&slopes[0]),
            natural_up_to: self.natural_up_to(),
            state,
        }
    }
}

impl Coordinate {
    fn name_and_unit(&self) -> (String, &'static str) {
        let unit = match self.kind {
            CoordinateKind::Displacement => "m",
            CoordinateKind::Tilt => "rad",
            CoordinateKind::Mode(_) => "sqrt(kg) m",
        };
        (self.name.clone(), unit)
    }
}
