//! The force of a mounted bearing and its slopes.

use fearless_simd::Simd;

use super::law::{Law, with_law};
use super::ring::{in_registers, quarter_turn, side_by_side};
use super::seat::Seat;
use super::support::Support;
use super::{BearingRotation, Matrix5, Vector5};
use crate::registers::in_wide_registers;

impl Support {
    /// Force and moment that hold the shaft at `displacement` against this bearing.
    pub(crate) fn force(&self, displacement: &Vector5, rotation: &BearingRotation) -> Vector5 {
        in_wide_registers!(self.ring.level, simd => self.force_by(simd, displacement, rotation))
    }

    /// As [`Support::force`], for the processor's level `S`.
    #[inline(always)]
    pub(crate) fn force_by<S: Simd>(
        &self,
        simd: S,
        displacement: &Vector5,
        rotation: &BearingRotation,
    ) -> Vector5 {
        let force = match (&self.frozen, self.seat) {
            (None, Seat::Fixed { offset }) => {
                let [x, y, z, tilt_x, tilt_y] = self.imposed(&side_by_side(simd, displacement));
                let place = [x, y, z + offset, tilt_x, tilt_y];
                match (&self.law, self.table_over(displacement, offset, rotation)) {
                    (_, Some(table)) => self.ring.force_by(simd, table, &place, rotation),
                    (Law::Hertz(law), None) => self.ring.force_by(simd, law, &place, rotation),
                    _ => in_registers(self.settled_force(in_registers(*displacement), rotation)),
                }
            }
            (Some(linear), _) => in_registers(linear.force(self.imposed(displacement))),
            _ => in_registers(self.settled_force(in_registers(*displacement), rotation)),
        };
        self.on_shaft(&force)
    }

    /// The force of the balls in the bearing's own orientation, whatever their law and seat. Out of line, so
    /// that cheap laws stay in registers.
    #[inline(never)]
    fn settled_force(&self, displacement: Vector5, rotation: &BearingRotation) -> Vector5 {
        let place = self.ring_displacement(&displacement, rotation);
        with_law!(&self.law, law => self.ring.force(law, &place, rotation))
    }

    /// Force as by [`Support::force`] and its derivative by the shaft's displacement.
    pub(crate) fn force_and_stiffness(
        &self,
        displacement: &Vector5,
        rotation: &BearingRotation,
    ) -> (Vector5, Matrix5) {
        let imposed = self.imposed(displacement);
        let (force, stiffness) = match &self.frozen {
            Some(linear) => (linear.force(imposed), linear.stiffness),
            None => self.local_tangent(&imposed, rotation),
        };
        let transform = self.transform();
        (
            self.on_shaft(&force),
            transform.transpose() * stiffness * transform,
        )
    }

    /// K, and the derivative of the force by the angle of the cage.
    ///
    /// On perfect races turning the cage is turning the displacement back and the force forth:
    /// `∂F/∂ψ_c = S F − K S q` with S the generator of rotations about Z.
    pub(crate) fn slopes(
        &self,
        displacement: &Vector5,
        rotation: &BearingRotation,
    ) -> (Matrix5, Vector5) {
        let imposed = self.imposed(displacement);
        let transform = self.transform();
        let (stiffness, by_cage_angle) = match &self.frozen {
            Some(linear) => (linear.stiffness, [0.0; 5]),
            None => {
                let place = self.settled(&imposed, rotation);
                let (force, stiffness) = match self.table_at(&place, rotation.speed) {
                    Some(table) => self.ring.force_and_stiffness(table, &place, rotation),
                    None => self.condensed_tangent(&place, rotation),
                };
                let turned = stiffness * nalgebra::SVector::from(quarter_turn(&imposed));
                let force = quarter_turn(&force);
                let by_cage_angle = std::array::from_fn(|axis| force[axis] - turned[axis]);
                (stiffness, by_cage_angle)
            }
        };
        let stiffness = transform.transpose() * stiffness * transform;
        (stiffness, self.on_shaft(&by_cage_angle))
    }

    /// Force in the bearing's own orientation, and its derivative by what the shaft imposes.
    pub(super) fn local_tangent(
        &self,
        imposed: &Vector5,
        rotation: &BearingRotation,
    ) -> (Vector5, Matrix5) {
        self.condensed_tangent(&self.settled(imposed, rotation), rotation)
    }

    /// The same with the inner ring at `place`.
    fn condensed_tangent(&self, place: &Vector5, rotation: &BearingRotation) -> (Vector5, Matrix5) {
        let (force, stiffness) = self.tangent(place, rotation);
        (force, self.seat.condense(stiffness))
    }
}

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
