//! The force of a mounted bearing, its slopes, and the energy that it is the derivative of.
//!
//! Five entries: [`Support::force`] with [`Support::force_by`] for motions, [`Support::tangent`] for slopes,
//! [`Support::force_and_loads`] for what the balls bear, and [`Support::damped_force`] with the damping of the contacts.
//!
//! Each takes the displacement q that shaft and housing impose. [`Support::settled`] gives the one that the ring of balls
//! sees, its `place`: the preload shifts it, and a spring-pressed outer ring follows axially. A linear bearing is frozen
//! and asks neither seat nor balls.

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
    /// ∂F/∂ψ_c, by the angle of the cage, as on perfect races.
    pub by_cage_angle: Vector5,
}

impl Support {
    /// Force and moment that hold the inner ring at a displacement.
    pub(crate) fn force(&self, displacement: &Vector5, rotation: &BearingRotation) -> Vector5 {
        in_wide_registers!(self.ring.level, simd => self.force_by(simd, displacement, rotation))
    }

    /// Force as by [`Support::force`], compiled into callers that run on the vector instructions `S`.
    ///
    /// A fixed seat with a table or the Hertz law is answered in place; all others out of line.
    #[inline(always)]
    pub(crate) fn force_by<S: Simd>(
        &self,
        simd: S,
        displacement: &Vector5,
        rotation: &BearingRotation,
    ) -> Vector5 {
        match (&self.frozen, self.seat) {
            (None, Seat::Fixed { offset }) => {
                // as `settled`, without a search
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

    /// The force of the balls under the exact law, whatever law and seat. Out of line, so that cheap laws stay in registers.
    #[inline(never)]
    fn settled_force(&self, displacement: Vector5, rotation: &BearingRotation) -> Vector5 {
        let place = self.settled(&displacement, rotation);
        with_law!(&self.law, law => self.ring.force(law, &place, rotation))
    }

    /// Force as by [`Support::force`] and its slopes.
    ///
    /// On perfect races a cage turned by ψ_c sees the displacement turned back, and its force is turned forth by the rotation
    /// R about Z: `F(q, ψ_c) = R F(R⁻¹ q, 0)`. With S = dR/dψ_c at 0 that gives `∂F/∂ψ_c = S F − K S q`.
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
                let force_turned = quarter_turn(&force);
                let by_turning_back =
                    stiffness * nalgebra::SVector::from(quarter_turn(displacement));
                let by_cage_angle =
                    std::array::from_fn(|axis| force_turned[axis] - by_turning_back[axis]);
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

    /// Energy in J that the contacts, and the spring of a floating outer ring, store at a displacement. A linear bearing has
    /// that of its frozen force instead, counted from the displacement at which it was frozen.
    ///
    /// Its derivative by the displacement is [`Support::force`] where [`Support::has_potential`].
    pub(crate) fn stored_energy(&self, displacement: &Vector5, rotation: &BearingRotation) -> f64 {
        if let Some(linear) = &self.frozen {
            return linear.energy(displacement);
        }
        let place = self.settled(displacement, rotation);
        let films = self.films.as_ref().filter(|_| self.law.is_smooth());
        let contacts =
            with_law!(&self.law, law => self.ring.stored_energy(law, films, &place, rotation));
        contacts + self.seat.stored_energy(displacement, &place)
    }

    /// Whether the force is the derivative of [`Support::stored_energy`], at a steady speed or at one that changes.
    pub(crate) fn has_potential(&self, steady: bool) -> bool {
        self.frozen.is_some() || self.law.has_potential(steady)
    }

    /// Replaces the force of a bearing of the linear law by its tangent at a displacement and a speed; other laws stay.
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

    /// Displacement of the inner ring from the outer one, as the balls see it, under the displacement that shaft and housing
    /// impose: with the preset of a fixed seat, or with z such that a floating outer ring carries the force of its spring.
    pub(in crate::bearing) fn settled(
        &self,
        displacement: &Vector5,
        rotation: &BearingRotation,
    ) -> Vector5 {
        self.seat
            .settle(displacement, |place| self.ring_tangent(place, rotation))
    }

    /// Force of the balls under the exact law, and its derivative by `place`, where the seat has put the inner ring.
    pub(super) fn ring_tangent(
        &self,
        place: &Vector5,
        rotation: &BearingRotation,
    ) -> (Vector5, Matrix5) {
        with_law!(&self.law, law => self.ring.force_and_stiffness(law, place, rotation))
    }
}
