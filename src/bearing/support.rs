//! A mounted bearing as a restoring force on the shaft.

use super::ring::{CageAngle, Matrix5, Ring, Vector5};
use super::{BallContact, BearingError, ContactLaw, HertzLaw, MountedBearing, Preload, Thrust};
use crate::physics::{BallPass, ball_pass_frequencies, nominal_cage_speed};

/// The force law of a bearing, chosen once; the loop over the balls is compiled for each.
#[derive(Debug, Clone)]
enum Force {
    Hertz(Ring<HertzLaw>),
    Linear(LinearForce),
}

/// F = F0 + K (q − q0).
#[derive(Debug, Clone)]
struct LinearForce {
    origin: Vector5,
    force: Vector5,
    stiffness: Matrix5,
}

impl LinearForce {
    fn force(&self, displacement: &Vector5) -> Vector5 {
        let shift: Vector5 = std::array::from_fn(|axis| displacement[axis] - self.origin[axis]);
        let mut force = self.force;
        for (column, shift) in shift.into_iter().enumerate() {
            for (row, value) in force.iter_mut().enumerate() {
                *value += self.stiffness[(row, column)] * shift;
            }
        }
        force
    }
}

/// A bearing at its place on the rigid shaft, ready to answer with forces.
///
/// Orientation s and position a map the shaft's displacement q to the bearing's own:
///
/// ```text
/// x + a θy,  y − a θx,  s z + offset,  s θx,  s θy
/// ```
///
/// and the force back by virtual work.
#[derive(Debug, Clone)]
pub struct Support {
    force: Force,
    definition: MountedBearing,
    sign: f64,
    axial_offset: f64,
}

impl Support {
    /// Builds the Hertz ring of a bearing and finds the offset of its preload.
    ///
    /// A bearing of the linear law starts as Hertz, too, until [`Support::freeze`] knows where.
    ///
    /// # Errors
    /// [`BearingError`] where the contact cannot be formed or the preload cannot be reached.
    pub fn new(definition: &MountedBearing) -> Result<Self, BearingError> {
        let bearing = &definition.bearing;
        let law = HertzLaw {
            load_deflection_constant: bearing.load_deflection_constant()?,
            distance: bearing.geometry.groove_centre_distance(),
        };
        let ring = Ring::new(&bearing.geometry, definition.first_ball, law);
        let axial_offset = match definition.preload {
            Preload::AxialOffset(offset) => offset,
            Preload::Force(preload) => Thrust::new(&bearing.geometry, law).displacement(preload)?,
        };
        Ok(Self {
            force: Force::Hertz(ring),
            definition: *definition,
            sign: definition.facing.sign(),
            axial_offset,
        })
    }

    /// The bearing as it was defined.
    pub fn definition(&self) -> &MountedBearing {
        &self.definition
    }

    /// Axial preset of the inner ring the way its facing loads it, m.
    pub fn axial_offset(&self) -> f64 {
        self.axial_offset
    }

    /// Axial shaft displacement at which the races of this bearing stand axially centred, m.
    pub fn centred_axial(&self) -> f64 {
        self.sign * (-self.definition.bearing.geometry.free_axial() - self.axial_offset)
    }

    /// Replaces the force by its tangent at `displacement` of the shaft where the law is linear.
    pub fn freeze(&mut self, displacement: &Vector5, speed: f64) {
        if self.definition.law == ContactLaw::Linear
            && let Force::Hertz(ring) = &self.force
        {
            let origin = self.local(displacement);
            let (force, stiffness) = ring.force_and_stiffness(&origin, CageAngle::START, speed);
            self.force = Force::Linear(LinearForce {
                origin,
                force,
                stiffness,
            });
        }
    }

    /// Force and moment that hold the shaft at `displacement` against this bearing.
    #[inline]
    pub fn force(&self, displacement: &Vector5, cage: CageAngle, speed: f64) -> Vector5 {
        let local = self.local(displacement);
        let force = match &self.force {
            Force::Hertz(ring) => ring.force(&local, cage, speed),
            Force::Linear(linear) => linear.force(&local),
        };
        self.on_shaft(&force)
    }

    /// Force as by [`Support::force`] and its derivative by the shaft's displacement.
    pub fn force_and_stiffness(
        &self,
        displacement: &Vector5,
        cage: CageAngle,
        speed: f64,
    ) -> (Vector5, Matrix5) {
        let local = self.local(displacement);
        let (force, stiffness) = match &self.force {
            Force::Hertz(ring) => ring.force_and_stiffness(&local, cage, speed),
            Force::Linear(linear) => (linear.force(&local), linear.stiffness),
        };
        let transform = self.transform();
        (
            self.on_shaft(&force),
            transform.transpose() * stiffness * transform,
        )
    }

    /// Loads and contact angles of every ball; none where the law knows no balls.
    pub fn contacts(
        &self,
        displacement: &Vector5,
        cage: CageAngle,
        speed: f64,
    ) -> impl Iterator<Item = BallContact> {
        let local = self.local(displacement);
        let ring = match &self.force {
            Force::Hertz(ring) => Some(ring),
            Force::Linear(_) => None,
        };
        ring.into_iter()
            .flat_map(move |ring| ring.contacts(local, cage, speed))
    }

    /// Nominal speed of the cage at a shaft speed, rad/s.
    pub fn cage_speed(&self, speed: f64) -> f64 {
        nominal_cage_speed(speed, self.definition.bearing.geometry.gamma())
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

    #[inline(always)]
    fn local(&self, displacement: &Vector5) -> Vector5 {
        let [x, y, z, tilt_x, tilt_y] = *displacement;
        let (s, a) = (self.sign, self.definition.position);
        [
            x + a * tilt_y,
            y - a * tilt_x,
            s * z + self.axial_offset,
            s * tilt_x,
            s * tilt_y,
        ]
    }

    #[inline(always)]
    fn on_shaft(&self, force: &Vector5) -> Vector5 {
        let [f_x, f_y, f_z, m_x, m_y] = *force;
        let (s, a) = (self.sign, self.definition.position);
        [f_x, f_y, s * f_z, s * m_x - a * f_y, s * m_y + a * f_x]
    }

    /// ∂(local displacement)/∂(shaft displacement).
    fn transform(&self) -> Matrix5 {
        let (s, a) = (self.sign, self.definition.position);
        let mut transform = Matrix5::from_diagonal(&[1.0, 1.0, s, s, s].into());
        transform[(0, 4)] = a;
        transform[(1, 3)] = -a;
        transform
    }
}
