//! A mounted bearing as a restoring force on the shaft.

use std::ops::{Add, Mul, Sub};

use fearless_simd::{Level, Simd, dispatch};

use super::any_ring::AnyRing;
use super::assessment::Assessment;
use super::bearing_friction::BearingFriction;
use super::contact_damping::DampedRaces;
use super::elastic_energy::race_springs;
use super::linear_force::LinearForce;
use super::ring::{CageAngle, Matrix5, Vector5, in_registers, quarter_turn};
use super::ring_lanes::side_by_side;
use super::seat::Seat;
use super::table_ring::TableRing;
use super::{
    Around, BallContact, BearingError, BearingState, ContactBand, ContactLaw, FrictionMoment,
    Geometry, HertzLaw, HertzSpring, MountedBearing, Preload, Ring,
};
use crate::physics::{BallPass, HertzContact, ball_pass_frequencies, nominal_cage_speed};

/// A bearing at its place on the rigid shaft, ready to answer with forces.
///
/// Orientation s and position a map the shaft's displacement q to the bearing's own:
///
/// ```text
/// x + a θy,  y − a θx,  s z (+ the seat's offset),  s θx,  s θy
/// ```
///
/// and the force back by virtual work.
#[derive(Debug, Clone)]
pub struct Support {
    pub(super) ring: AnyRing,
    /// What the processor has.
    level: Level,
    /// Stands for the ring where a motion asks for forces, once compiled.
    pub(super) table: Option<Box<TableRing>>,
    /// A cheap neighbour of the ring, where there is one.
    coarse: Option<AnyRing>,
    pub(super) seat: Seat,
    /// Hertz contacts of the geometry, inner race first.
    contacts: [HertzContact; 2],
    /// Elastic contacts of the law, inner race first.
    pub(super) springs: [HertzSpring; 2],
    /// The damped contacts, where there is damping.
    pub(super) damped: Option<DampedRaces>,
    friction: BearingFriction,
    /// Speed of the cage over that of the shaft.
    cage_ratio: f64,
    /// Set once the bearing is linear.
    pub(super) frozen: Option<LinearForce>,
    pub(super) definition: MountedBearing,
    sign: f64,
}

impl Support {
    /// Builds the ring of a bearing, fastest at `speed` in rad/s, and finds the seat of its preload.
    ///
    /// A bearing of the linear law starts as Hertz, too, until [`Support::freeze`] knows where.
    ///
    /// # Errors
    /// [`BearingError`] where the contact cannot be formed or the preload cannot be reached.
    pub fn new(definition: &MountedBearing, speed: f64) -> Result<Self, BearingError> {
        let ring = AnyRing::new(definition, speed)?;
        let bearing = &definition.bearing;
        let contacts = [bearing.inner_contact()?, bearing.outer_contact()?];
        let springs = race_springs(bearing)?;
        Ok(Self {
            contacts,
            springs,
            damped: definition.contact_damping.races(springs)?,
            friction: BearingFriction::new(definition, &contacts),
            seat: Seat::new(definition, &ring)?,
            coarse: ring.coarse(definition)?,
            ring,
            level: Level::new(),
            table: None,
            cage_ratio: nominal_cage_speed(1.0, definition.bearing.geometry.gamma()),
            frozen: None,
            definition: *definition,
            sign: definition.facing.sign(),
        })
    }

    /// Largest value of a dimension among the bearings of a shaft.
    pub(crate) fn largest(supports: &[Self], dimension: fn(&Geometry) -> f64) -> f64 {
        let of = |support: &Self| dimension(&support.definition.bearing.geometry);
        supports.iter().map(of).fold(0.0, f64::max)
    }

    /// The bearing as it was defined.
    pub fn definition(&self) -> &MountedBearing {
        &self.definition
    }

    /// Axial preset of the inner ring the way its facing loads it, m.
    pub fn axial_offset(&self) -> f64 {
        self.seat.offset()
    }

    /// Whether the bearing is preset axially.
    pub fn is_preloaded(&self) -> bool {
        match self.definition.preload {
            Preload::AxialOffset(value) | Preload::Force(value) | Preload::Spring(value) => {
                value != 0.0
            }
        }
    }

    /// Axial shaft displacement at which the races of this bearing stand axially centred, m.
    pub fn centred_axial(&self) -> f64 {
        self.sign * (-self.definition.bearing.geometry.free_axial() - self.seat.offset())
    }

    /// Replaces the force by its tangent at `displacement` of the shaft where the law is linear.
    pub fn freeze(&mut self, displacement: &Vector5, speed: f64) {
        if self.definition.law == ContactLaw::Linear {
            let origin = self.imposed(displacement);
            let (force, stiffness) =
                self.local_tangent(&self.ring, &origin, CageAngle::START, speed);
            let damping = self.damping_at(&origin, speed);
            self.frozen = Some(LinearForce {
                origin,
                force,
                stiffness,
                damping,
            });
        }
    }

    /// Whether the balls go round with the cage: those of a linear bearing are frozen.
    pub fn follows_cage(&self) -> bool {
        self.frozen.is_none()
    }

    /// Friction moment under a force of the shaft onto this bearing in N at a speed in rad/s.
    pub fn friction_moment(&self, force: &Vector5, speed: f64) -> FrictionMoment {
        self.friction.moment(force, speed)
    }

    /// Force and moment that hold the shaft at `displacement` against this bearing.
    pub fn force(&self, displacement: &Vector5, cage: CageAngle, speed: f64) -> Vector5 {
        dispatch!(self.level, simd => self.force_by(simd, displacement, cage, speed))
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
            (None, None) => {
                in_registers(self.settled_force(in_registers(*displacement), cage, speed))
            }
        };
        self.on_shaft(&force)
    }

    /// The ring and its axial preset in m, where its balls obey the cheap law and nothing else enters.
    #[inline(always)]
    fn plain_ring(&self) -> Option<(&Ring<HertzLaw>, f64)> {
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
        match &self.table {
            Some(table) => table.force(&place, cage, speed),
            None => self.ring.force(&place, cage, speed),
        }
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
                let (force, stiffness) = match &self.table {
                    // tables have no floating ring to settle
                    Some(table) => {
                        let place = self.seat.settle(&self.ring, &imposed, cage, speed);
                        table.force_and_stiffness(&place, cage, speed)
                    }
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

    fn local_tangent(
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

    /// Displacement of the inner ring from the outer one, in the bearing's own orientation.
    pub fn ring_displacement(
        &self,
        displacement: &Vector5,
        cage: CageAngle,
        speed: f64,
    ) -> Vector5 {
        let imposed = self.imposed(displacement);
        self.seat.settle(&self.ring, &imposed, cage, speed)
    }

    /// Hands the loads and contact angles of every ball to `visit`, ball 0 first; none where the
    /// bearing is frozen: a linear law knows no balls.
    pub fn for_each_contact(
        &self,
        displacement: &Vector5,
        cage: CageAngle,
        speed: f64,
        visit: &mut dyn FnMut(BallContact),
    ) {
        if self.frozen.is_none() {
            let place = self.ring_displacement(displacement, cage, speed);
            self.ring.for_each_contact(&place, cage, speed, visit);
        }
    }

    /// Leaves the contacts of every ball in `balls`, ball 0 first, as [`Support::for_each_contact`] visits
    /// them; without `angles` the contact angles are zero.
    pub fn observe_balls(
        &self,
        displacement: &Vector5,
        cage: CageAngle,
        speed: f64,
        angles: bool,
        balls: &mut [BallContact],
    ) {
        if self.frozen.is_none() {
            let place = self.ring_displacement(displacement, cage, speed);
            self.ring.observe_balls(&place, cage, speed, angles, balls);
        }
    }

    /// Number of balls that [`Support::for_each_contact`] visits.
    pub fn known_balls(&self) -> usize {
        match self.frozen {
            Some(_) => 0,
            None => self.definition.bearing.geometry.balls(),
        }
    }

    /// Where a ball leaves and meets the inner race at a shaft speed in rad/s.
    pub fn contact_band(&self, speed: f64) -> ContactBand {
        ContactBand::new(&self.contacts[0], |load| {
            self.ring.approach_under(load, speed)
        })
    }

    /// What a ball at each of `positions` azimuths from +X on would bear with the shaft at
    /// `displacement`, or, where `None`, what every ball bears with the cage where it starts.
    pub fn around(
        &self,
        displacement: &Vector5,
        speed: f64,
        positions: Option<usize>,
    ) -> Vec<Around> {
        let place = self.ring_displacement(displacement, CageAngle::START, speed);
        self.ring.around(&place, speed, positions)
    }

    /// What is known of the bearing with the shaft at `displacement`, its cage where it starts.
    ///
    /// A linear bearing knows no balls: its state is that of the Hertz law at this displacement,
    /// force and stiffness, too.
    pub fn state(&self, displacement: &Vector5, speed: f64) -> BearingState {
        Assessment {
            definition: &self.definition,
            ring: &self.ring,
            seat: &self.seat,
            contacts: &self.contacts,
            place: self.ring_displacement(displacement, CageAngle::START, speed),
            speed,
        }
        .state()
    }

    /// Nominal speed of the cage over that of the shaft.
    #[inline]
    pub fn cage_ratio(&self) -> f64 {
        self.cage_ratio
    }

    /// Ball-pass frequencies at the nominal contact angle.
    pub fn ball_pass(&self, speed: f64) -> BallPass {
        let geometry = &self.definition.bearing.geometry;
        ball_pass_frequencies(
            speed,
            geometry.balls(),
            geometry.ball_diameter(),
            geometry.pitch_diameter(),
            geometry.gamma(),
        )
    }

    /// What the shaft's displacement imposes on the inner ring.
    #[inline(always)]
    pub(super) fn imposed<T>(&self, displacement: &[T; 5]) -> [T; 5]
    where
        T: Copy + Add<Output = T> + Sub<Output = T> + Mul<f64, Output = T>,
    {
        let [x, y, z, tilt_x, tilt_y] = *displacement;
        let (s, a) = (self.sign, self.definition.position);
        [
            x + tilt_y * a,
            y - tilt_x * a,
            z * s,
            tilt_x * s,
            tilt_y * s,
        ]
    }

    #[inline(always)]
    pub(super) fn on_shaft(&self, force: &Vector5) -> Vector5 {
        let [f_x, f_y, f_z, m_x, m_y] = *force;
        let (s, a) = (self.sign, self.definition.position);
        [f_x, f_y, s * f_z, s * m_x - a * f_y, s * m_y + a * f_x]
    }

    /// ∂(local displacement)/∂(shaft displacement).
    pub(super) fn transform(&self) -> Matrix5 {
        let (s, a) = (self.sign, self.definition.position);
        let mut transform = Matrix5::from_diagonal(&[1.0, 1.0, s, s, s].into());
        transform[(0, 4)] = a;
        transform[(1, 3)] = -a;
        transform
    }
}
