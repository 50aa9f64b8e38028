//! The laws of one ball or roller: from the position of the inner groove centre to loads and forces.
//!
//! [`BallLaw`] is what a law is; each law is a file or a folder here, a variant of [`ContactLaw`] and of the one list
//! of laws below. [`RaceContacts`] is what ratings and reports ask of the contacts. Outside this folder nothing knows how
//! a contact bears.

mod ball;
mod ball_law;
mod film_spring;
mod films;
mod hertz;
mod jones;
mod laminae;
mod line_contacts;
mod ninth_root;
mod race_contacts;
mod roller;
mod roller_damping;
mod shares;
mod spring;
mod table;

pub use ball::{Ball, BallContact, BallForce, BallResponse, BallState, BallTangent, Lamina};
pub use ball_law::{BallLaw, FilmLaw, ForceLaw};
pub use films::{FilmThickness, RaceFilms};
pub use hertz::{HertzFilmLaw, HertzLaw};
pub use jones::{JonesFilmLaw, JonesLaw};
pub(super) use race_contacts::hertz_contacts;
pub use race_contacts::{
    PERMISSIBLE_PRESSURE, PointContacts, RaceContacts, permissible_static_load,
};
pub use roller::RollerLaw;
pub(super) use shares::Share;
pub use spring::{ContactSpring, HertzSpring, PreparedContact};
pub use table::{BallRegion, BallTable, TableError, TableReport};

use super::{BearingError, MountedBearing, RollerKind};
use crate::physics::{Race, RaceControl};
use line_contacts::LineContacts;

/// Force law between the rings.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ContactLaw {
    /// F = F0 + K (q − q0): the law `Hertz`, frozen at the static equilibrium.
    Linear,
    /// Hertz contact of each ball with both races in series, ball inertia neglected.
    Hertz,
    /// Jones's ball equilibrium with centrifugal force and gyroscopic moment.
    Jones(RaceControl),
}

/// The law is chosen once a call; the loop over the balls is compiled for each.
#[derive(Debug, Clone)]
pub(in crate::bearing) enum Law {
    Hertz(HertzLaw),
    HertzFilm(HertzFilmLaw),
    Jones(JonesLaw),
    JonesFilm(JonesFilmLaw),
    /// Rollers that follow the tilt of their ring.
    Roller(RollerLaw<true>),
    /// Rollers of a spherical bearing.
    Barrel(RollerLaw<false>),
}

/// Evaluates an expression for the law inside.
macro_rules! with_law {
    ($any:expr, $law:ident => $value:expr) => {
        match $any {
            $crate::bearing::law::Law::Hertz($law) => $value,
            $crate::bearing::law::Law::HertzFilm($law) => $value,
            $crate::bearing::law::Law::Jones($law) => $value,
            $crate::bearing::law::Law::JonesFilm($law) => $value,
            $crate::bearing::law::Law::Roller($law) => $value,
            $crate::bearing::law::Law::Barrel($law) => $value,
        }
    };
}
pub(in crate::bearing) use with_law;

impl Law {
    /// The law of a mounted bearing with its [`crate::bearing::Bearing::contacts`], fastest at `speed` in rad/s. A
    /// linear bearing is one of Hertz contacts until it is frozen.
    pub fn new(
        definition: &MountedBearing,
        contacts: &RaceContacts,
        speed: f64,
    ) -> Result<Self, BearingError> {
        let bearing = &definition.bearing;
        let contacts = match contacts {
            RaceContacts::Point(contacts) => contacts,
            RaceContacts::Line(contacts) => return Self::of_rollers(definition, contacts),
        };
        let has_inertia = matches!(definition.law, ContactLaw::Jones(_));
        if has_inertia && bearing.rotating_ring == Race::Outer {
            return Err(BearingError::RotatingRing);
        }
        Ok(match (definition.law, definition.oil) {
            (ContactLaw::Linear | ContactLaw::Hertz, None) => {
                Self::Hertz(HertzLaw::from_contacts(&bearing.geometry, contacts))
            }
            (ContactLaw::Linear | ContactLaw::Hertz, Some(oil)) => {
                Self::HertzFilm(HertzFilmLaw::with_film(bearing, oil, speed)?)
            }
            (ContactLaw::Jones(control), None) => Self::Jones(JonesLaw::new(bearing, control)?),
            (ContactLaw::Jones(control), Some(oil)) => {
                Self::JonesFilm(JonesFilmLaw::with_film(bearing, control, oil, speed)?)
            }
        })
    }

    /// The law of rollers with their contacts.
    fn of_rollers(
        definition: &MountedBearing,
        contacts: &LineContacts,
    ) -> Result<Self, BearingError> {
        for (known, what) in [
            (
                !matches!(definition.law, ContactLaw::Jones(_)),
                "contact = \"jones\"",
            ),
            (definition.oil.is_none(), "film = true"),
        ] {
            if !known {
                return Err(BearingError::Rollers { what });
            }
        }
        let geometry = &definition.bearing.geometry;
        Ok(match contacts.rollers.kind {
            RollerKind::Spherical => Self::Barrel(RollerLaw::new(geometry, contacts)),
            _ => Self::Roller(RollerLaw::new(geometry, contacts)),
        })
    }

    /// Whether a table of it can be faster than the law itself.
    pub fn gains_from_table(&self) -> bool {
        !matches!(self, Self::Hertz(_) | Self::Roller(_) | Self::Barrel(_))
    }

    /// Whether the force of its balls is smooth where they lift off, as behind films.
    pub fn is_smooth(&self) -> bool {
        matches!(self, Self::HertzFilm(_) | Self::JonesFilm(_))
    }

    /// Whether the force of its balls has a potential, at a steady speed or one that changes.
    pub fn has_potential(&self, steady: bool) -> bool {
        !self.has_inertia() && (steady || !self.is_smooth())
    }

    /// Whether its balls have inertia: where they lift off then depends on the speed.
    pub fn has_inertia(&self) -> bool {
        matches!(self, Self::Jones(_) | Self::JonesFilm(_))
    }
}
