//! The response of the rotor linearised at its static equilibrium: to a harmonic force at a point, and to its unbalances.

use std::f64::consts::TAU;

use nalgebra::{Complex, DMatrix, DVector};

use super::point::Attachment;
use super::{FREEDOMS, Rotor};

/// A point of the shaft, and a direction.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Pickup {
    /// Position along the shaft, m.
    pub position: f64,
    /// 0 … 4: along x, y, z, about X, about Y.
    pub axis: usize,
}

/// How far a motion takes the shaft from the middle of an element with a clearance.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Excursion {
    /// Number of the element in the scene, from 1.
    pub element: usize,
    /// Largest distance, m.
    pub distance: f64,
    /// The clearance, m.
    pub clearance: f64,
}

/// Angles of the shaft at which an excursion is looked at: its largest is met within 1 − cos(π/180) of the motion.
const ANGLES: usize = 180;

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
        self.motions(self.speed, &self.unbalance(), at)
    }

    fn unbalance(&self) -> DVector<Complex<f64>> {
        let excitation = &self.rotor.excitation;
        excitation.unbalance_phasor(self.speed, self.rotor.dofs())
    }

    /// How far the unbalances take the shaft from the middle of every element with a clearance, about the place of its static
    /// equilibrium; nothing at an undamped resonance.
    pub fn excursions(&self) -> Vec<Excursion> {
        let rotor = self.rotor;
        let mut gaps = rotor.elements.clearances().peekable();
        if gaps.peek().is_none() {
            return Vec::new();
        }
        let Some(parts) = self.moved(self.speed, &self.unbalance()) else {
            return Vec::new();
        };
        let rest = &rotor.start.rest;
        let excursion = |(element, attachment, clearance): (usize, &Attachment, f64)| {
            let middle = attachment.displacement(rest, rest);
            let [real, imaginary] = parts.each_ref().map(|own| attachment.rate(own));
            let distance = |index: usize| {
                let (sin, cos) = (TAU * index as f64 / ANGLES as f64).sin_cos();
                let [x, y] =
                    [0, 1].map(|axis| middle[axis] + cos * real[axis] - sin * imaginary[axis]);
                x.hypot(y)
            };
            Excursion {
                element,
                distance: (0..ANGLES).map(distance).fold(0.0, f64::max),
                clearance,
            }
        };
        gaps.map(excursion).collect()
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
        let [real, imaginary] = self.moved(omega, force)?;
        let motion = |pickup: &Pickup| {
            let row = self.row(*pickup);
            let sum = |all: &[f64]| row.iter().zip(all).map(|(part, own)| part * own).sum();
            Complex::new(sum(&real), sum(&imaginary))
        };
        let found: Vec<_> = at.iter().map(motion).collect();
        found.iter().all(|own| own.is_finite()).then_some(found)
    }

    /// Real and imaginary part of the motion of all coordinates under a force of an angular frequency.
    fn moved(&self, omega: f64, force: &DVector<Complex<f64>>) -> Option<[Vec<f64>; 2]> {
        let rotor = self.rotor;
        let dynamic = rotor.linear.dynamic_stiffness(&self.matrices, omega);
        let moved = dynamic.lu().solve(force)?;
        let parts = [moved.map(|own| own.re), moved.map(|own| own.im)];
        Some(parts.map(|own| rotor.rate_of_all(own.as_slice()).into_owned()))
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
