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
                let (force, stiffness) = self
                    .table_tangent(displacement, rotation)
                    .unwrap_or_else(|| self.local_tangent(&imposed, rotation));
                let turned = stiffness * nalgebra::SVector::from(quarter_turn(&imposed));
                let force = quarter_turn(&force);
                (
                    stiffness,
                    std::array::from_fn(|axis| force[axis] - turned[axis]),
                )
            }
        };
        let stiffness = transform.transpose() * stiffness * transform;
        (stiffness, self.on_shaft(&by_cage_angle))
    }

    /// Force and stiffness by the table, in the bearing's own orientation, where it covers the displacement.
    fn table_tangent(
        &self,
        displacement: &Vector5,
        rotation: &BearingRotation,
    ) -> Option<(Vector5, Matrix5)> {
        let offset = self.seat.offset();
        let table = self.table_over(displacement, offset, rotation)?;
        let [x, y, z, tilt_x, tilt_y] = self.imposed(displacement);
        let place = [x, y, z + offset, tilt_x, tilt_y];
        Some(self.ring.force_and_stiffness(table, &place, rotation))
    }

    pub(super) fn local_tangent(
        &self,
        imposed: &Vector5,
        rotation: &BearingRotation,
    ) -> (Vector5, Matrix5) {
        let place = self.settled(imposed, rotation);
        let (force, stiffness) =
            with_law!(&self.law, law => self.ring.force_and_stiffness(law, &place, rotation));
        (force, self.seat.condense(stiffness))
    }
}
