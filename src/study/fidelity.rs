//! Fidelity levels: which law describes the bearings.

use std::fmt;

use crate::bearing::{ContactLaw, MountedBearing, Oil};
use crate::physics::RaceControl;

/// What is simulated of every contact, the cheaper first.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
#[non_exhaustive]
pub enum Fidelity {
    /// Stiffness frozen at the static equilibrium.
    Linear,
    /// Hertz contacts.
    Hertz,
    /// Hertz contacts parted by oil films.
    HertzFilm,
    /// Ball equilibrium with inertia.
    Jones,
    /// Ball equilibrium with inertia, the contacts parted by oil films.
    JonesFilm,
}

impl Fidelity {
    /// All levels, from the cheapest to the highest.
    pub(crate) const ALL: [Self; 5] = [
        Self::Linear,
        Self::Hertz,
        Self::HertzFilm,
        Self::Jones,
        Self::JonesFilm,
    ];

    /// Whether oil films part the surfaces.
    pub(crate) fn has_film(self) -> bool {
        matches!(self, Self::HertzFilm | Self::JonesFilm)
    }

    /// Whether the balls have inertia.
    pub(crate) fn has_ball_inertia(self) -> bool {
        matches!(self, Self::Jones | Self::JonesFilm)
    }

    /// The bearing at this level, its films of `oil` where the level has films. Jones's law keeps the race
    /// control that the bearing has, or takes that of the outer race.
    pub(crate) fn applied_to(self, bearing: &MountedBearing, oil: Option<Oil>) -> MountedBearing {
        let control = match bearing.law {
            ContactLaw::Jones(control) => control,
            _ => RaceControl::default(),
        };
        MountedBearing {
            law: match self {
                Self::Linear => ContactLaw::Linear,
                Self::Hertz | Self::HertzFilm => ContactLaw::Hertz,
                Self::Jones | Self::JonesFilm => ContactLaw::Jones(control),
            },
            oil: oil.filter(|_| self.has_film()),
            ..bearing.clone()
        }
    }
}

impl From<&MountedBearing> for Fidelity {
    fn from(bearing: &MountedBearing) -> Self {
        match (bearing.law, bearing.oil.is_some()) {
            (ContactLaw::Linear, _) => Self::Linear,
            (ContactLaw::Hertz, false) => Self::Hertz,
            (ContactLaw::Hertz, true) => Self::HertzFilm,
            (ContactLaw::Jones(_), false) => Self::Jones,
            (ContactLaw::Jones(_), true) => Self::JonesFilm,
        }
    }
}

impl fmt::Display for Fidelity {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(match self {
            Self::Linear => "linear",
            Self::Hertz => "hertz",
            Self::HertzFilm => "hertz + film",
            Self::Jones => "jones",
            Self::JonesFilm => "jones + film",
        })
    }
}
