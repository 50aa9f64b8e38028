//! A mounted bearing as a restoring force on the shaft.

use std::ops::{Add, Mul, Sub};

use fearless_simd::Level;

use super::any_ring::AnyRing;
use super::assessment::Assessment;
use super::bearing_friction::BearingFriction;
use super::contact_damping::DampedRaces;
use super::elastic_energy::race_springs;
use super::linear_force::LinearForce;
use super::ring::{CageAngle, Matrix5, Vector5};
use super::seat::Seat;
use super::{
    Around, BallContact, BallTable, BearingError, BearingState, ContactBand, ContactLaw,
    FrictionMoment, Geometry, HertzSpring, MountedBearing, Preload, Ring,
};
use crate::physics::{BallPass, HertzContact, nominal_cage_speed};

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
    pub(super) level: Level,
    /// Stands for the ring where a motion asks for forces, once compiled.
    pub(super) table: Option<Box<Ring<BallTable>>>,
    /// A cheap neighbour of the ring, where there is one.
    pub(super) coarse: Option<AnyRing>,
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
    pub(super) sign: f64,
}

impl Support {
    /// Builds the ring of a bearing, fastest at `speed` in rad/s, and finds the seat of its preload.
    ///
    /// A bearing of the linear law starts as Hertz, too, until [`Support::freeze`] knows where.
    ///
    /// # Errors
    /// [`BearingError`] where the contact cannot be formed or the preload cannot be reached.
    pub fn new(definition: &MountedBearing, speed: f64) -> Result<Self, BearingError> {
        let bearing = &definition.bearing;
        let contacts = bearing.contacts()?;
        let ring = AnyRing::new(definition, &contacts, speed)?;
        let springs = race_springs(bearing, &contacts);
        Ok(Self {
            contacts,
            springs,
            damped: definition.contact_damping.races(springs)?,
            friction: BearingFriction::new(definition, &contacts),
            seat: Seat::new(definition, &ring)?,
            coarse: ring.coarse(definition, &contacts)?,
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

    /// Load–deflection constant K_n of a ball between both races, N/m^1.5.
    pub(crate) fn load_deflection_constant(&self) -> f64 {
        let bearing = &self.definition.bearing;
        bearing.load_deflection_constant_by(&self.contacts)
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
        self.definition.bearing.geometry.ball_pass(speed)
    }

    /// What the shaft's displacement imposes on the inner ring.
    #[inline(always)]
    pub(super) fn imposed<T>(&self, displacement: &[T; 5]) -> [T; 5]
    where
        T: Copy + Add<Output = T> + Sub<Output = T> + Mul<f64, Output = T>,
    {
        let (s, a) = (self.sign, self.definition.position);
        let [x, y, z, tilt_x, tilt_y] = *displacement;
        [
            x + tilt_y * a,
            y - tilt_x * a,
            z * s,
            tilt_x * s,
            tilt_y * s,
        ]
    }

    /// Its force on the inner ring as one on the shaft.
    #[inline(always)]
    pub(super) fn on_shaft(&self, force: &Vector5) -> Vector5 {
        let (s, a) = (self.sign, self.definition.position);
        let [f_x, f_y, f_z, m_x, m_y] = *force;
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
