//! The force of a linear bearing.

use super::{Matrix5, Vector5};

/// The force of a bearing frozen at a place: F = F0 + K (q − q0).
#[derive(Debug, Clone)]
pub(super) struct LinearForce {
    /// q0.
    pub origin: Vector5,
    /// F0.
    pub force: Vector5,
    /// K.
    pub stiffness: Matrix5,
    /// Damping of the contacts at the origin.
    pub damping: Matrix5,
}

impl LinearForce {
    /// Force at a displacement.
    #[inline(never)]
    pub fn force(&self, displacement: Vector5) -> Vector5 {
        let shift: Vector5 = std::array::from_fn(|axis| displacement[axis] - self.origin[axis]);
        let mut force = self.force;
        for (column, shift) in shift.into_iter().enumerate() {
            for (row, value) in force.iter_mut().enumerate() {
                *value += self.stiffness[(row, column)] * shift;
            }
        }
        force
    }

    /// Work from the origin to a displacement, J: `F0 (q − q0) + ½ (q − q0) K (q − q0)`.
    pub fn energy(&self, displacement: &Vector5) -> f64 {
        let there = self.force(*displacement);
        (0..5)
            .map(|axis| {
                0.5 * (self.force[axis] + there[axis]) * (displacement[axis] - self.origin[axis])
            })
            .sum()
    }
}
