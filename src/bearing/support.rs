//! A mounted bearing as a restoring force on the shaft.

use std::f64::consts::TAU;

use super::assessment::Assessment;
use super::bearing_friction::BearingFriction;
use super::cage::Cage;
use super::law::{BallLaw, BallTable, Law, with_law};
use super::number::Number;
use super::seat::Seat;
use super::support_force::LinearForce;
use super::{
    Around, BallLoads, BearingError, BearingRotation, BearingState, CageJitter, CageMotion,
    ContactBand, ContactLaw, FrictionMoment, Geometry, Matrix5, MountedBearing, Preload, Ring,
    Vector5,
};
use crate::physics::HertzContact;

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
    pub(super) ring: Ring,
    pub(super) law: Law,
    /// Stands for the law where a motion asks for forces, once compiled.
    pub(super) table: Option<Box<BallTable>>,
    pub(super) seat: Seat,
    /// Hertz contacts of the geometry, inner race first.
    pub(super) contacts: [HertzContact; 2],
    /// The same at the nominal contact angle.
    pub(super) rated_contacts: [HertzContact; 2],
    /// Coefficients of the damping of the contacts, inner race first, s/m, where there is damping.
    pub(super) damped: Option<[f64; 2]>,
    friction: BearingFriction,
    pub(super) cage: Cage,
    pub(super) cage_jitter: Option<CageJitter>,
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
        let contacts = definition.bearing.contacts()?;
        let rated_contacts = definition.bearing.rated_contacts()?;
        let (geometry, imperfections) = (&definition.bearing.geometry, &definition.imperfections);
        imperfections.check(geometry)?;
        let law = Law::new(definition, &contacts, speed)?;
        let cage = Cage::new(
            &definition.bearing,
            geometry.gamma(),
            imperfections.cage_slip,
        );
        let mut support = Self {
            ring: Ring::new(geometry, definition.first_ball),
            contacts,
            damped: definition.contact_damping.coefficients()?,
            friction: BearingFriction::new(definition, &rated_contacts),
            rated_contacts,
            seat: Seat::new(definition, &law)?,
            law,
            table: None,
            cage,
            cage_jitter: CageJitter::new(&imperfections.cage_steps, geometry.balls()),
            frozen: None,
            definition: definition.clone(),
            sign: definition.facing.sign(),
        };
        support.turn_with(cage);
        Ok(support)
    }

    /// Largest value of a dimension among the bearings of a shaft, m; 10 mm where none has balls: it makes numbers of
    /// displacements, and any length does.
    pub(crate) fn largest(supports: &[Self], dimension: fn(&Geometry) -> f64) -> f64 {
        let of = |support: &Self| dimension(&support.definition.bearing.geometry);
        supports.iter().map(of).reduce(f64::max).unwrap_or(0.01)
    }

    /// The bearing as it was defined.
    pub(crate) fn definition(&self) -> &MountedBearing {
        &self.definition
    }

    /// Load–deflection constant K_n of a ball between both races, N/m^1.5.
    pub(crate) fn load_deflection_constant(&self) -> f64 {
        let bearing = &self.definition.bearing;
        bearing.load_deflection_constant_by(&self.contacts)
    }

    /// Whether the bearing is preset axially, apart from what fits and temperatures do.
    pub(crate) fn is_preloaded(&self) -> bool {
        let fit = self.definition.bearing.fit.and_then(|fit| fit.axial_offset);
        if let Some([before, _]) = fit {
            return before != 0.0;
        }
        match self.definition.preload {
            Preload::AxialOffset(value) | Preload::Force(value) | Preload::Spring(value) => {
                value != 0.0
            }
        }
    }

    /// Axial shaft displacement at which the races of this bearing stand axially centred, m.
    pub(crate) fn centred_axial(&self) -> f64 {
        self.sign * (-self.definition.bearing.geometry.free_axial() - self.seat.offset())
    }

    /// Replaces the force by its tangent at `displacement` of the shaft where the law is linear.
    pub(crate) fn freeze(&mut self, displacement: &Vector5, speed: f64) {
        if self.definition.law == ContactLaw::Linear {
            let (origin, rotation) = (self.imposed(displacement), BearingRotation::at_start(speed));
            let (force, stiffness) = self.local_tangent(&origin, &rotation);
            self.frozen = Some(LinearForce {
                origin,
                force,
                stiffness,
                damping: self.damping_at(&origin, &rotation),
            });
        }
    }

    /// Whether the balls go round with the cage: those of a linear bearing are frozen.
    pub(crate) fn follows_cage(&self) -> bool {
        self.frozen.is_none()
    }

    /// Friction moment under a force of the shaft onto this bearing in N at a speed in rad/s.
    pub(crate) fn friction_moment(&self, force: &Vector5, speed: f64) -> FrictionMoment {
        self.friction.moment(force, speed)
    }

    /// Displacement of the inner ring from the outer one, in the bearing's own orientation.
    pub(crate) fn ring_displacement(
        &self,
        displacement: &Vector5,
        rotation: &BearingRotation,
    ) -> Vector5 {
        self.settled(&self.imposed(displacement), rotation)
    }

    /// The same of what the shaft imposes.
    pub(super) fn settled(&self, imposed: &Vector5, rotation: &BearingRotation) -> Vector5 {
        self.seat
            .settle(imposed, |place| self.tangent(place, rotation))
    }

    /// Force of the balls and its derivative with the inner ring at `place`, in the bearing's own orientation.
    pub(super) fn tangent(
        &self,
        place: &Vector5,
        rotation: &BearingRotation,
    ) -> (Vector5, Matrix5) {
        with_law!(&self.law, law => self.ring.force_and_stiffness(law, place, rotation))
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
        let place = self.ring_displacement(displacement, rotation);
        let force = with_law!(&self.law, law => self.ring.loads(law, &place, rotation, loads));
        self.on_shaft(&force)
    }

    /// Hertz contacts of a ball with the inner and the outer race.
    pub(crate) fn contacts(&self) -> &[HertzContact; 2] {
        &self.contacts
    }

    /// Number of balls that [`Support::force_and_loads`] tells of; none where the bearing is frozen: a linear law
    /// knows no balls.
    pub(crate) fn known_balls(&self) -> usize {
        match self.frozen {
            Some(_) => 0,
            None => self.ring.balls(),
        }
    }

    /// Where a ball leaves and meets the inner race at a shaft speed in rad/s.
    pub(crate) fn contact_band(&self, speed: f64) -> ContactBand {
        with_law!(&self.law, law => {
            ContactBand::new(&self.contacts[0], |load| law.approach_under(load, speed))
        })
    }

    /// What a ball at each of `positions` azimuths from +X on would bear with the shaft at
    /// `displacement`, or, where `None`, what every ball bears with the cage where it starts.
    pub(crate) fn around(
        &self,
        displacement: &Vector5,
        speed: f64,
        positions: Option<usize>,
    ) -> Vec<Around> {
        let place = self.ring_displacement(displacement, &BearingRotation::at_start(speed));
        self.around_ring(&place, speed, positions)
    }

    /// The same with the inner ring at a displacement from the outer one.
    pub(super) fn around_ring(
        &self,
        place: &Vector5,
        speed: f64,
        positions: Option<usize>,
    ) -> Vec<Around> {
        let free = self.definition.bearing.geometry.groove_centre_distance();
        let rotation = BearingRotation::at_start(speed);
        let at = |azimuth, number| {
            let ball = self.ring.ball_at(place, azimuth, number, &rotation);
            Around {
                azimuth,
                deformation: ball.axial.hypot(ball.radial) - free,
                contact: with_law!(&self.law, law => law.contact(&ball, speed)),
            }
        };
        let balls = self.ring.azimuths.iter().enumerate();
        match positions {
            None => balls
                .map(|(number, &azimuth)| at(azimuth, Some(number)))
                .collect(),
            Some(count) => (0..count)
                .map(|index| at(TAU * index as f64 / count as f64, None))
                .collect(),
        }
    }

    /// What is known of the bearing with the shaft at `displacement`, its cage where it starts and turning as from an
    /// equilibrium there.
    ///
    /// A linear bearing knows no balls: its state is that of the Hertz law at this displacement,
    /// force and stiffness, too.
    pub(crate) fn state(
        &self,
        displacement: &Vector5,
        speed: f64,
        motion: CageMotion,
    ) -> BearingState {
        let rotation = BearingRotation::at_start(speed);
        let place = self.ring_displacement(displacement, &rotation);
        let assessment = Assessment {
            support: self,
            place,
            rotation,
            cage: self.cage_at(motion, Some(displacement), speed),
        };
        assessment.state()
    }

    /// Energy in J that the contacts store with the shaft at `displacement`: of a linear bearing that
    /// of its frozen force, zero where it was frozen; of a floating ring less the work of its spring.
    ///
    /// Its derivative by the displacement is [`Support::force`] where the law has a potential: under
    /// every law without ball inertia.
    pub(crate) fn stored_energy(&self, displacement: &Vector5, rotation: &BearingRotation) -> f64 {
        let imposed = self.imposed(displacement);
        if let Some(linear) = &self.frozen {
            return linear.energy(&imposed);
        }
        let place = self.settled(&imposed, rotation);
        let contacts = with_law!(&self.law, law => self.ring.stored_energy(law, &place, rotation));
        contacts + self.seat.stored_energy(&imposed, &place)
    }

    /// Whether the force is the derivative of [`Support::stored_energy`], the speed being steady or
    /// not.
    pub(crate) fn has_potential(&self, steady: bool) -> bool {
        self.frozen.is_some() || self.law.has_potential(steady)
    }

    /// What the shaft's displacement imposes on the inner ring.
    #[inline(always)]
    pub(super) fn imposed<T: Number>(&self, displacement: &[T; 5]) -> [T; 5] {
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
