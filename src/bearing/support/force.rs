//! The force of a mounted bearing, its slopes, and the energy that it is the derivative of.
//!
//! Five entries: [`Support::force`] with [`Support::force_by`] for motions, [`Support::tangent`] for slopes,
//! [`Support::force_and_loads`] for what the balls bear, and [`Support::damped_force`] with the damping of the contacts.

use fearless_simd::Simd;

use super::{ContactLaw, LinearForce, Matrix5, Seat, Support, Vector5};
use crate::bearing::law::{Law, with_law};
use crate::bearing::ring::{in_registers, quarter_turn, side_by_side};
use crate::bearing::{BallLoads, BearingRotation};
use crate::numerics::registers::in_wide_registers;

/// The force of a bearing at a displacement and its slopes.
#[derive(Debug, Clone, PartialEq)]
pub struct Tangent {
    /// Force and moment that hold the inner ring, N and N m.
    pub force: Vector5,
    /// K = ∂F/∂q.
    pub stiffness: Matrix5,
    /// Derivative of the force by the angle of the cage on perfect races.
    pub by_cage_angle: Vector5,
}

impl Support {
    /// Force and moment that hold the inner ring at a displacement.
    pub(crate) fn force(&self, displacement: &Vector5, rotation: &BearingRotation) -> Vector5 {
        in_wide_registers!(self.ring.level, simd => self.force_by(simd, displacement, rotation))
    }

    /// Force as by [`Support::force`], for the processor's level `S`.
    #[inline(always)]
    pub(crate) fn force_by<S: Simd>(
        &self,
        simd: S,
        displacement: &Vector5,
        rotation: &BearingRotation,
    ) -> Vector5 {
        match (&self.frozen, self.seat) {
            (None, Seat::Fixed { offset }) => {
                let [x, y, z, tilt_x, tilt_y] = *displacement;
                let place = [x, y, z + offset, tilt_x, tilt_y];
                let table = self.table_at(&place, rotation.speed);
                let place = side_by_side(simd, &place);
                match (&self.law, table) {
                    (_, Some(table)) => self.ring.force_by(simd, table, &place, rotation),
                    (Law::Hertz(law), None) => self.ring.force_by(simd, law, &place, rotation),
                    _ => in_registers(self.settled_force(in_registers(*displacement), rotation)),
                }
            }
            (Some(linear), _) => in_registers(linear.force(*displacement)),
            _ => in_registers(self.settled_force(in_registers(*displacement), rotation)),
        }
    }

    /// The force of the balls, whatever their law and seat. Out of line, so that cheap laws stay in registers.
    #[inline(never)]
    fn settled_force(&self, displacement: Vector5, rotation: &BearingRotation) -> Vector5 {
        let place = self.settled(&displacement, rotation);
        with_law!(&self.law, law => self.ring.force(law, &place, rotation))
    }

    /// Force as by [`Support::force`] and its slopes.
    ///
    /// On perfect races turning the cage is turning the displacement back and the force forth:
    /// `∂F/∂ψ_c = S F − K S q` with S the generator of rotations about Z.
    pub(crate) fn tangent(&self, displacement: &Vector5, rotation: &BearingRotation) -> Tangent {
        let (force, stiffness, by_cage_angle) = match &self.frozen {
            Some(linear) => (linear.force(*displacement), linear.stiffness, [0.0; 5]),
            None => {
                let place = self.settled(displacement, rotation);
                let (force, stiffness) = match self.table_at(&place, rotation.speed) {
                    Some(table) => self.ring.force_and_stiffness(table, &place, rotation),
                    None => self.ring_tangent(&place, rotation),
                };
                let stiffness = self.seat.condense(stiffness);
                // S F − K S q
                let turned = stiffness * nalgebra::SVector::from(quarter_turn(displacement));
                let turning = quarter_turn(&force);
                let by_cage_angle = std::array::from_fn(|axis| turning[axis] - turned[axis]);
                (force, stiffness, by_cage_angle)
            }
        };
        Tangent {
            force,
            stiffness,
            by_cage_angle,
        }
    }

    /// Force as by [`Support::force`]; leaves the loads of every ball in `loads`, which must have room for
    /// [`Support::known_balls`]. The exact law answers, whether there is a table of it or not.
    pub(crate) fn force_and_loads(
        &self,
        displacement: &Vector5,
        rotation: &BearingRotation,
        loads: &mut BallLoads,
    ) -> Vector5 {
        if self.frozen.is_some() {
            return self.force(displacement, rotation);
        }
        let place = self.settled(displacement, rotation);
        with_law!(&self.law, law => self.ring.loads(law, &place, rotation, loads))
    }

    /// Energy in J that the contacts store at a displacement: of a linear bearing that
    /// of its frozen force, zero where it was frozen; of a floating ring less the work of its spring.
    ///
    /// Its derivative by the displacement is [`Support::force`] where the law has a potential: under
    /// every law without ball inertia.
    pub(crate) fn stored_energy(&self, displacement: &Vector5, rotation: &BearingRotation) -> f64 {
        if let Some(linear) = &self.frozen {
            return linear.energy(displacement);
        }
        let (place, films) = (self.settled(displacement, rotation), self.films.as_ref());
        let contacts =
            with_law!(&self.law, law => self.ring.stored_energy(law, films, &place, rotation));
        contacts + self.seat.stored_energy(displacement, &place)
    }

    /// Whether the force is the derivative of [`Support::stored_energy`], the speed being steady or
    /// not.
    pub(crate) fn has_potential(&self, steady: bool) -> bool {
        self.frozen.is_some() || self.law.has_potential(steady)
    }

    /// Replaces the force by its tangent at a displacement where the law is linear.
    pub(crate) fn freeze(&mut self, displacement: &Vector5, speed: f64) {
        if self.definition.law == ContactLaw::Linear {
            let rotation = BearingRotation::at_start(speed);
            let place = self.settled(displacement, &rotation);
            let (force, stiffness) = self.ring_tangent(&place, &rotation);
            self.frozen = Some(LinearForce {
                origin: *displacement,
                force,
                stiffness: self.seat.condense(stiffness),
                damping: self.damping_at(displacement, &rotation),
            });
        }
    }

    /// Displacement of the inner ring from the outer one where the seat has put this by the imposed displacement.
    pub(in crate::bearing) fn settled(
        &self,
        displacement: &Vector5,
        rotation: &BearingRotation,
    ) -> Vector5 {
        self.seat
            .settle(displacement, |place| self.ring_tangent(place, rotation))
    }

    /// Force of the balls under the exact law and its derivative with the inner ring at `place`.
    pub(super) fn ring_tangent(
        &self,
        place: &Vector5,
        rotation: &BearingRotation,
    ) -> (Vector5, Matrix5) {
        with_law!(&self.law, law => self.ring.force_and_stiffness(law, place, rotation))
    }
}
