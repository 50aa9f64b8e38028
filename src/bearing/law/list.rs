//! The laws that a bearing can have: the one place that lists them.

use super::{BallLaw, DryRaces, HertzFilmLaw, HertzLaw, JonesFilmLaw, JonesLaw, LubricatedRaces};
use crate::bearing::{BearingError, ContactLaw, MountedBearing, Thrust};
use crate::physics::HertzContact;

/// The law is chosen once a call; the loop over the balls is compiled for each.
#[derive(Debug, Clone)]
pub(in crate::bearing) enum Law {
    Hertz(HertzLaw),
    HertzFilm(HertzFilmLaw),
    Jones(JonesLaw<DryRaces>),
    JonesFilm(JonesLaw<LubricatedRaces>),
}

/// Evaluates an expression for the law inside.
macro_rules! with_law {
    ($any:expr, $law:ident => $value:expr) => {
        match $any {
            $crate::bearing::law::Law::Hertz($law) => $value,
            $crate::bearing::law::Law::HertzFilm($law) => $value,
            $crate::bearing::law::Law::Jones($law) => $value,
            $crate::bearing::law::Law::JonesFilm($law) => $value,
        }
    };
}
pub(in crate::bearing) use with_law;

impl Law {
    /// The law of a mounted bearing with its [`crate::bearing::Bearing::contacts`], fastest at `speed` in rad/s. A
    /// linear bearing is one of Hertz contacts until it is frozen.
    pub fn new(
        definition: &MountedBearing,
        contacts: &[HertzContact; 2],
        speed: f64,
    ) -> Result<Self, BearingError> {
        let bearing = &definition.bearing;
        Ok(match (definition.law, definition.oil) {
            (ContactLaw::Linear | ContactLaw::Hertz, None) => {
                Self::Hertz(HertzLaw::between(bearing, contacts))
            }
            (ContactLaw::Linear | ContactLaw::Hertz, Some(oil)) => {
                Self::HertzFilm(HertzFilmLaw::new(bearing, oil, speed)?)
            }
            (ContactLaw::Jones(control), None) => Self::Jones(JonesLaw::new(bearing, control)?),
            (ContactLaw::Jones(control), Some(oil)) => {
                Self::JonesFilm(JonesFilmLaw::with_film(bearing, control, oil, speed)?)
            }
        })
    }

    /// Whether it costs so little that a table of it would gain nothing.
    pub fn is_cheap(&self) -> bool {
        matches!(self, Self::Hertz(_))
    }

    /// Whether the force of its balls is not smooth where they lift off.
    pub fn lifts_off(&self) -> bool {
        fn of<L: BallLaw>(_: &L) -> bool {
            L::LIFTS_OFF
        }
        with_law!(self, law => of(law))
    }

    /// Whether its balls have inertia: where they lift off then depends on the speed.
    pub fn has_inertia(&self) -> bool {
        fn of<L: BallLaw>(_: &L) -> bool {
            L::HAS_INERTIA
        }
        with_law!(self, law => of(law))
    }

    /// Axial displacement under a centred thrust at a speed.
    pub fn thrust_displacement(
        &self,
        definition: &MountedBearing,
        thrust: f64,
        speed: f64,
    ) -> Result<f64, BearingError> {
        let geometry = &definition.bearing.geometry;
        with_law!(self, law => Thrust::new(geometry, law).displacement(thrust, speed))
    }
}
