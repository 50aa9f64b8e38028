//! A ring under whichever ball law its bearing asks for.

use super::contact_damping::DampedRaces;
use super::contact_spring::ContactSpring;
use super::ring_lift_off::LiftOffs;
use super::{
    Around, BallContact, BearingError, CageAngle, ContactLaw, HertzFilmLaw, HertzLaw, HertzSpring,
    JonesFilmLaw, JonesLaw, Matrix5, MountedBearing, Ring, Thrust, Vector5,
};
use crate::physics::HertzContact;

/// The law is chosen once a call; the loop over the balls is compiled for each.
#[derive(Debug, Clone)]
pub(super) enum AnyRing {
    Hertz(Ring<HertzLaw>),
    HertzFilm(Ring<HertzFilmLaw>),
    Jones(Ring<JonesLaw>),
    JonesFilm(Ring<JonesFilmLaw>),
}

/// Evaluates an expression for the ring inside, whatever its law.
macro_rules! with_ring {
    ($any:expr, $ring:ident => $value:expr) => {
        match $any {
            AnyRing::Hertz($ring) => $value,
            AnyRing::HertzFilm($ring) => $value,
            AnyRing::Jones($ring) => $value,
            AnyRing::JonesFilm($ring) => $value,
        }
    };
}

impl AnyRing {
    /// The ring of a mounted bearing with its [`super::Bearing::contacts`], fastest at `speed` in rad/s. A linear
    /// bearing is a Hertz ring until it is frozen.
    pub fn new(
        definition: &MountedBearing,
        contacts: &[HertzContact; 2],
        speed: f64,
    ) -> Result<Self, BearingError> {
        let (bearing, first) = (&definition.bearing, definition.first_ball);
        let geometry = &bearing.geometry;
        Ok(match (definition.law, definition.oil) {
            (ContactLaw::Linear | ContactLaw::Hertz, None) => {
                let law = HertzLaw {
                    load_deflection_constant: bearing.load_deflection_constant_by(contacts),
                    distance: geometry.groove_centre_distance(),
                };
                Self::Hertz(Ring::new(geometry, first, law))
            }
            (ContactLaw::Linear | ContactLaw::Hertz, Some(oil)) => Self::HertzFilm(Ring::new(
                geometry,
                first,
                HertzFilmLaw::new(bearing, oil, speed)?,
            )),
            (ContactLaw::Jones(control), None) => {
                Self::Jones(Ring::new(geometry, first, JonesLaw::new(bearing, control)?))
            }
            (ContactLaw::Jones(control), Some(oil)) => {
                let law = JonesFilmLaw::with_film(bearing, control, oil, speed)?;
                Self::JonesFilm(Ring::new(geometry, first, law))
            }
        })
    }

    /// The same ring of plain Hertz contacts: a cheap neighbour of the costly laws.
    pub fn coarse(
        &self,
        definition: &MountedBearing,
        contacts: &[HertzContact; 2],
    ) -> Result<Option<Self>, BearingError> {
        if matches!(self, Self::Hertz(_)) {
            return Ok(None);
        }
        let dry = MountedBearing {
            law: ContactLaw::Hertz,
            oil: None,
            ..*definition
        };
        Self::new(&dry, contacts, 0.0).map(Some)
    }

    /// The ring, where its law is the cheap one.
    #[inline(always)]
    pub fn hertz(&self) -> Option<&Ring<HertzLaw>> {
        match self {
            Self::Hertz(ring) => Some(ring),
            _ => None,
        }
    }

    pub fn force(&self, displacement: &Vector5, cage: CageAngle, speed: f64) -> Vector5 {
        with_ring!(self, ring => ring.force(displacement, cage, speed))
    }

    pub fn force_and_stiffness(
        &self,
        displacement: &Vector5,
        cage: CageAngle,
        speed: f64,
    ) -> (Vector5, Matrix5) {
        with_ring!(self, ring => ring.force_and_stiffness(displacement, cage, speed))
    }

    /// Force that moves the ring at `rate`, seen from the cage, against the damping of its contacts.
    pub fn damping_force(
        &self,
        displacement: &Vector5,
        rate: &Vector5,
        cage: CageAngle,
        speed: f64,
        races: &DampedRaces,
    ) -> Vector5 {
        if let Self::Hertz(ring) = self {
            return ring.series_damping(displacement, rate, cage, races);
        }
        with_ring!(self, ring => ring.damping_force(displacement, rate, cage, speed, races))
    }

    /// Hands the contacts of every ball to `visit`, ball 0 first.
    pub fn for_each_contact(
        &self,
        displacement: &Vector5,
        cage: CageAngle,
        speed: f64,
        visit: &mut dyn FnMut(BallContact),
    ) {
        with_ring!(self, ring => ring.contacts(*displacement, cage, speed).for_each(visit));
    }

    /// Whether the force of its balls is not smooth where they lift off.
    pub fn lifts_off(&self) -> bool {
        matches!(self, Self::Hertz(_) | Self::Jones(_))
    }

    /// The balls about their lift-off.
    pub fn lift_offs(&self, displacement: &Vector5, cage: CageAngle, speed: f64) -> LiftOffs {
        if let Self::Hertz(ring) = self {
            return ring.series_lift_offs(displacement, cage);
        }
        with_ring!(self, ring => ring.lift_offs(displacement, cage, speed))
    }

    /// Radius of the circle of inner groove centres, m.
    pub fn arm(&self) -> f64 {
        with_ring!(self, ring => ring.arm)
    }

    /// Approach that no ball has less of, wherever the cage stands, m; none where that is not known.
    #[allow(dead_code)]
    pub fn least_approach(&self, place: &Vector5) -> Option<f64> {
        match self {
            Self::Hertz(ring) => Some(ring.least_approach(place)),
            _ => None,
        }
    }

    /// How far a ball is pressed past its lift-off, m.
    pub fn past_lift_off(
        &self,
        ball: usize,
        displacement: &Vector5,
        cage: CageAngle,
        speed: f64,
    ) -> f64 {
        with_ring!(self, ring => ring.past_lift_off(ball, displacement, cage, speed))
    }

    /// Largest load of a ball so far past its lift-off, N; of dry contacts only.
    pub fn load_past_lift_off(&self, distance: f64, speed: f64) -> f64 {
        let spring = match self {
            Self::Hertz(ring) => HertzSpring {
                stiffness: ring.law().load_deflection_constant,
            },
            Self::Jones(ring) => ring.law().inner_spring(speed),
            Self::HertzFilm(_) | Self::JonesFilm(_) => return 0.0,
        };
        spring.load_and_stiffness(distance).0
    }

    /// What a ball at each of `positions` azimuths would bear; the balls' own where `None`.
    pub fn around(
        &self,
        displacement: &Vector5,
        speed: f64,
        positions: Option<usize>,
    ) -> Vec<Around> {
        with_ring!(self, ring => ring.around(displacement, speed, positions))
    }

    /// Axial displacement under a centred thrust at a speed.
    pub fn thrust_displacement(
        &self,
        definition: &MountedBearing,
        thrust: f64,
        speed: f64,
    ) -> Result<f64, BearingError> {
        let geometry = &definition.bearing.geometry;
        with_ring!(self, ring => Thrust::new(geometry, ring.law()).displacement(thrust, speed))
    }
}
