//! Pure thrust on one bearing: the axial displacement that gives a preload.

use super::{BearingError, ForceLaw, Geometry};

/// A bearing under a centred axial force: all balls alike.
///
/// `F_z = Z F_a(A sin α0 + z, A cos α0)`
///
/// Source: Harris & Kotzalas, *Rolling Bearing Analysis*, 5th ed. (2007), eqs. 7.33–7.36.
#[derive(Debug, Clone, Copy)]
pub struct Thrust<'a, L> {
    law: &'a L,
    balls: f64,
    free_axial: f64,
    free_radial: f64,
    distance: f64,
}

impl<'a, L: ForceLaw> Thrust<'a, L> {
    /// Takes the dimensions of a bearing and the law of its balls.
    pub fn new(geometry: &Geometry, law: &'a L) -> Self {
        Self {
            law,
            balls: geometry.balls() as f64,
            free_axial: geometry.free_axial(),
            free_radial: geometry.free_radial(),
            distance: geometry.groove_centre_distance(),
        }
    }

    /// Axial displacement in m under the thrust `force` in N at a shaft speed in rad/s: Newton in a
    /// bracket.
    ///
    /// # Errors
    /// [`BearingError::Preload`] where no displacement up to the distance of the groove centres
    /// gives the force.
    pub fn displacement(&self, force: f64, speed: f64) -> Result<f64, BearingError> {
        let unreachable = BearingError::Preload { preload: force };
        let (mut low, mut high) = (-self.free_axial, self.distance);
        let excess = |z: f64| {
            let (push, tangent) =
                self.law
                    .force_and_tangent(self.free_axial + z, self.free_radial, speed);
            (self.balls * push.axial - force, self.balls * tangent[0][0])
        };
        if !(force >= 0.0 && excess(high).0 >= 0.0) {
            return Err(unreachable);
        }
        let mut z = 0.1 * high;
        for _ in 0..200 {
            let (residual, slope) = excess(z);
            if residual > 0.0 {
                high = z;
            } else {
                low = z;
            }
            let newton = z - residual / slope;
            let next = if newton > low && newton < high {
                newton
            } else {
                0.5 * (low + high)
            };
            if (next - z).abs() <= f64::EPSILON * self.distance {
                return Ok(next);
            }
            z = next;
        }
        Err(unreachable)
    }
}
