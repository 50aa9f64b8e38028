//! One contact of a ball at a trial position.

use nalgebra::{Matrix2, Vector2};

use super::plane::{dyads, length_and_direction};
use crate::bearing::contact_spring::ContactSpring;

/// Distance, direction and load between the ball's centre and a groove centre.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(super) struct Contact {
    /// Distance of the centres L, m.
    pub(super) length: f64,
    /// Their distance at first touch, m.
    pub(super) free_length: f64,
    /// n = (sin α, cos α), from centre to centre away from the outer groove centre.
    pub(super) normal: Vector2<f64>,
    /// Normal load Q, N.
    pub(super) load: f64,
    /// dQ/dL, N/m.
    pub(super) stiffness: f64,
}

impl Contact {
    /// Contact along a vector (axial, radial) in m; a vanishing one is taken for radial.
    #[inline(always)]
    pub(super) fn new(vector: Vector2<f64>, free_length: f64, spring: &impl ContactSpring) -> Self {
        let (length, normal) = length_and_direction(vector);
        let (load, stiffness) = spring.load_and_stiffness(length - free_length);
        Self {
            length,
            free_length,
            normal,
            load,
            stiffness,
        }
    }

    /// t = dn/dα = (cos α, −sin α).
    #[inline(always)]
    pub(super) fn tangent(&self) -> Vector2<f64> {
        Vector2::new(self.normal.y, -self.normal.x)
    }

    /// Derivative by the vector from those by its length and angle: `a nᵀ + b tᵀ/L`.
    #[inline(always)]
    pub(super) fn chain(&self, by_length: Vector2<f64>, by_angle: Vector2<f64>) -> Matrix2<f64> {
        dyads(by_length, self.normal, by_angle, self.angle_row())
    }

    /// t/L: derivative of the angle by the vector, 1/m.
    #[inline(always)]
    pub(super) fn angle_row(&self) -> Vector2<f64> {
        self.tangent() * (1.0 / self.length)
    }
}
