//! The force of a mounted bearing and its slopes.

use fearless_simd::{Simd, dispatch};

use super::any_ring::AnyRing;
use super::ring::{CageAngle, Matrix5, Vector5, in_registers, quarter_turn};
use super::ring_lanes::side_by_side;
use super::seat::Seat;
use super::support::Support;
use super::{BallContact, HertzLaw, Ring};

impl Support {
    /// Force and moment that hold the shaft at `displacement` against this bearing.
    pub fn force(&self, displacement: &Vector5, cage: CageAngle, speed: f64) -> Vector5 {
        dispatch!(self.level, simd => self.force_by(simd, displacement, cage, speed))
    }

    /// Force as by [`Support::force`]; leaves the contacts of every ball in `balls`, ball 0 first, as
    /// [`Support::for_each_contact`] visits them; without `angles` the contact angles may be zero.
    pub(crate) fn force_and_balls(
        &self,
        displacement: &Vector5,
        cage: CageAngle,
        speed: f64,
        angles: bool,
        balls: &mut [BallContact],
    ) -> Vector5 {
        if let (None, Some((ring, offset)), false) = (&self.frozen, self.plain_ring(), angles) {
            let [x, y, z, tilt_x, tilt_y] = self.imposed(displacement);
            let place = [x, y, z + offset, tilt_x, tilt_y];
            return self.on_shaft(&ring.force_and_loads(&place, cage, balls));
        }
        let mut balls = balls.iter_mut();
        self.for_each_contact(displacement, cage, speed, &mut |contact| {
            if let Some(ball) = balls.next() {
                *ball = contact;
            }
        });
        self.force(displacement, cage, speed)
    }

    /// As [`Support::force`], for the processor's level `S`.
    #[inline(always)]
    pub(crate) fn force_by<S: Simd>(
        &self,
        simd: S,
        displacement: &Vector5,
        cage: CageAngle,
        speed: f64,
    ) -> Vector5 {
        let force = match (&self.frozen, self.plain_ring()) {
            (Some(linear), _) => in_registers(linear.force(self.imposed(displacement))),
            (None, Some((ring, offset))) => {
                let [x, y, z, tilt_x, tilt_y] = self.imposed(&side_by_side(simd, displacement));
                let place = [x, y, z + offset, tilt_x, tilt_y];
                ring.force_by(simd, &place, cage, speed)
            }
            (None, None) => match self.table_force(simd, displacement, cage, speed) {
                Some(force) => force,
                None => in_registers(self.settled_force(in_registers(*displacement), cage, speed)),
            },
        };
        self.on_shaft(&force)
    }

    /// The force of the balls in the bearing's own orientation where all of them are inside a table.
    #[inline(always)]
    fn table_force<S: Simd>(
        &self,
        simd: S,
        displacement: &Vector5,
        cage: CageAngle,
        speed: f64,
    ) -> Option<Vector5> {
        let Seat::Fixed { offset } = self.seat else {
            return None;
        };
        let [x, y, z, tilt_x, tilt_y] = self.imposed(displacement);
        let table = self.table_at(&[x, y, z + offset, tilt_x, tilt_y], speed)?;
        let [x, y, z, tilt_x, tilt_y] = self.imposed(&side_by_side(simd, displacement));
        Some(table.table_force(simd, &[x, y, z + offset, tilt_x, tilt_y], cage))
    }

    /// The ring and its axial preset in m, where its balls obey the cheap law and nothing else enters.
    #[inline(always)]
    pub(super) fn plain_ring(&self) -> Option<(&Ring<HertzLaw>, f64)> {
        match (&self.table, &self.seat) {
            (None, Seat::Fixed { offset }) => Some((self.ring.hertz()?, *offset)),
            _ => None,
        }
    }

    /// The force of the balls in the bearing's own orientation, whatever their law and seat. Out of line, so
    /// that the plain ring stays small.
    #[inline(never)]
    fn settled_force(&self, displacement: Vector5, cage: CageAngle, speed: f64) -> Vector5 {
        let imposed = self.imposed(&displacement);
        let place = self.seat.settle(&self.ring, &imposed, cage, speed);
        self.ring.force(&place, cage, speed)
    }

    /// Force as by [`Support::force`] and its derivative by the shaft's displacement.
    pub fn force_and_stiffness(
        &self,
        displacement: &Vector5,
        cage: CageAngle,
        speed: f64,
    ) -> (Vector5, Matrix5) {
        self.tangent_on_shaft(&self.ring, displacement, cage, speed)
    }

    /// K, and the derivative of the force by the angle of the cage.
    ///
    /// Turning the cage is turning the displacement back and the force forth:
    /// `∂F/∂ψ_c = S F − K S q` with S the generator of rotations about Z.
    pub fn slopes(
        &self,
        displacement: &Vector5,
        cage: CageAngle,
        speed: f64,
    ) -> (Matrix5, Vector5) {
        let imposed = self.imposed(displacement);
        let transform = self.transform();
        let (stiffness, by_cage_angle) = match &self.frozen {
            Some(linear) => (linear.stiffness, [0.0; 5]),
            None => {
                // tables have no floating ring to settle
                let place = self
                    .table
                    .is_some()
                    .then(|| self.seat.settle(&self.ring, &imposed, cage, speed));
                let table = place.and_then(|place| Some((self.table_at(&place, speed)?, place)));
                let (force, stiffness) = match table {
                    Some((table, place)) => table.table_stiffness(&place, cage),
                    None => self.local_tangent(&self.ring, &imposed, cage, speed),
                };
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

    /// Whether [`Support::coarse_force_and_stiffness`] is cheaper than the exact one.
    pub(super) fn has_coarse_ring(&self) -> bool {
        self.coarse.is_some()
    }

    /// As [`Support::force_and_stiffness`], of plain Hertz contacts.
    pub(super) fn coarse_force_and_stiffness(
        &self,
        displacement: &Vector5,
        cage: CageAngle,
        speed: f64,
    ) -> (Vector5, Matrix5) {
        let ring = self.coarse.as_ref().unwrap_or(&self.ring);
        self.tangent_on_shaft(ring, displacement, cage, speed)
    }

    fn tangent_on_shaft(
        &self,
        ring: &AnyRing,
        displacement: &Vector5,
        cage: CageAngle,
        speed: f64,
    ) -> (Vector5, Matrix5) {
        let imposed = self.imposed(displacement);
        let (force, stiffness) = match &self.frozen {
            Some(linear) => (linear.force(imposed), linear.stiffness),
            None => self.local_tangent(ring, &imposed, cage, speed),
        };
        let transform = self.transform();
        (
            self.on_shaft(&force),
            transform.transpose() * stiffness * transform,
        )
    }

    pub(super) fn local_tangent(
        &self,
        ring: &AnyRing,
        imposed: &Vector5,
        cage: CageAngle,
        speed: f64,
    ) -> (Vector5, Matrix5) {
        let place = self.seat.settle(ring, imposed, cage, speed);
        let (force, stiffness) = ring.force_and_stiffness(&place, cage, speed);
        (force, self.seat.condense(stiffness))
    }
}
