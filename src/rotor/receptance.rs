//! The response of the rotor linearised at its static equilibrium: to a harmonic force at a point, and to its unbalances.

use nalgebra::{Complex, DMatrix, DVector};

use super::{FREEDOMS, Rotor};

/// A point of the shaft, and a direction.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Pickup {
    /// Position along the shaft, m.
    pub position: f64,
    /// 0 … 4: along x, y, z, about X, about Y.
    pub axis: usize,
}

/// `M q̈ + B q̇ + A q = f` at a speed.
#[derive(Debug, Clone)]
pub(crate) struct Linearised<'a> {
    rotor: &'a Rotor,
    speed: f64,
    /// A and B.
    matrices: [DMatrix<f64>; 2],
}

impl Rotor {
    /// The rotor linearised at its static equilibrium, at the speed of its start.
    pub(crate) fn linear_model(&self) -> Linearised<'_> {
        let speed = self.speed();
        let matrices = self.linearised(speed);
        Linearised {
            rotor: self,
            speed,
            matrices,
        }
    }
}

impl Linearised<'_> {
    /// Motions at some pickups under the unbalances, as complex amplitudes, m and rad: `Re u e^(iωt)` with the shaft's angle ωt;
    /// none at an undamped resonance.
    pub fn to_unbalance(&self, at: &[Pickup]) -> Option<Vec<Complex<f64>>> {
        let force = self
            .rotor
            .excitation
            .unbalance_phasor(self.speed, self.rotor.dofs());
        self.motions(self.speed, &force, at)
    }

    /// Motions at some pickups by a force or moment of one at another, of an angular frequency in rad/s.
    pub fn to_force(&self, omega: f64, by: Pickup, at: &[Pickup]) -> Option<Vec<Complex<f64>>> {
        let dofs = self.rotor.dofs();
        let along = self.row(by);
        let mut force = DVector::zeros(dofs);
        force.copy_from_slice(&along[..dofs]);
        // what acts on coordinates without mass acts through those that they follow
        let followers = &self.rotor.structure.followers;
        let first = along.len() - followers.nrows();
        let followed = followers.transpose() * DVector::from_column_slice(&along[first..]);
        let force = if followers.is_empty() {
            force
        } else {
            force + followed
        };
        self.motions(omega, &force.map(Complex::from), at)
    }

    /// Whether a force at a pickup acts on a mass: what has none yields by itself, too.
    pub fn has_mass(&self, at: Pickup) -> bool {
        let along = self.row(at);
        let first = along.len() - self.rotor.structure.followers.nrows();
        along[first..].iter().all(|part| *part == 0.0)
    }

    fn motions(
        &self,
        omega: f64,
        force: &DVector<Complex<f64>>,
        at: &[Pickup],
    ) -> Option<Vec<Complex<f64>>> {
        let rotor = self.rotor;
        let dynamic = rotor.linear.dynamic_stiffness(&self.matrices, omega);
        let moved = dynamic.lu().solve(force)?;
        let parts = [moved.map(|own| own.re), moved.map(|own| own.im)];
        let [real, imaginary] = parts.map(|own| rotor.rate_of_all(own.as_slice()).into_owned());
        let motion = |pickup: &Pickup| {
            let row = self.row(*pickup);
            let sum = |all: &[f64]| row.iter().zip(all).map(|(part, own)| part * own).sum();
            Complex::new(sum(&real), sum(&imaginary))
        };
        let found: Vec<_> = at.iter().map(motion).collect();
        found.iter().all(|own| own.is_finite()).then_some(found)
    }

    /// What each coordinate adds to the motion at a pickup.
    fn row(&self, at: Pickup) -> Vec<f64> {
        let mut row = vec![0.0; self.rotor.start.rest.len()];
        let unit: [f64; FREEDOMS] =
            std::array::from_fn(|axis| f64::from(u8::from(axis == at.axis)));
        self.rotor
            .structure
            .place_at(at.position)
            .add_force(1.0, &unit, &mut row);
        row
    }
}
