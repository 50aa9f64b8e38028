//! The two contacts of a ball, dry or behind oil films, ready for a speed.

use super::film_spring::{FilmSpring, LubricatedContact};
use super::{ContactSpring, HertzSpring, RaceContacts};
use crate::bearing::{Bearing, BearingError, Oil};
use crate::physics::{FilmContact, FilmInputs, contact_modulus, entrainment_speed};

/// The contacts of a ball with both races.
pub trait Races {
    /// What a contact is at one speed.
    type Spring: ContactSpring;

    /// Springs of the inner and the outer race at a shaft speed in rad/s.
    fn at_speed(&self, speed: f64) -> [Self::Spring; 2];

    /// Elastic contacts of both races by themselves.
    fn elastic(&self) -> [HertzSpring; 2];
}

/// Hertz contacts without oil.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct DryRaces(pub(super) [HertzSpring; 2]);

impl Races for DryRaces {
    type Spring = HertzSpring;

    #[inline]
    fn at_speed(&self, _speed: f64) -> [HertzSpring; 2] {
        self.0
    }

    fn elastic(&self) -> [HertzSpring; 2] {
        self.0
    }
}

/// Hertz contacts behind oil films.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LubricatedRaces {
    contacts: [LubricatedContact; 2],
    pub(super) films: RaceFilms,
}

impl LubricatedRaces {
    /// Fastest at a shaft speed in rad/s, right at every speed.
    pub(super) fn new(springs: [HertzSpring; 2], films: RaceFilms, speed: f64) -> Self {
        let constants = films.central_constants();
        let contact = |race: usize| LubricatedContact::new(springs[race], constants[race], speed);
        Self {
            contacts: [0, 1].map(contact),
            films,
        }
    }
}

impl Races for LubricatedRaces {
    type Spring = FilmSpring;

    #[inline]
    fn at_speed(&self, speed: f64) -> [FilmSpring; 2] {
        let [inner, outer] = &self.contacts;
        [inner.at_speed(speed), outer.at_speed(speed)]
    }

    fn elastic(&self) -> [HertzSpring; 2] {
        self.contacts.each_ref().map(|contact| contact.elastic)
    }
}

/// Oil films of both races, inner first.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RaceFilms {
    contacts: [FilmContact; 2],
    entrainment_ratio: f64,
}

impl RaceFilms {
    pub(super) fn new(
        bearing: &Bearing,
        contacts: &RaceContacts,
        oil: &Oil,
    ) -> Result<Self, BearingError> {
        oil.check()?;
        let geometry = &bearing.geometry;
        let gamma = geometry.gamma();
        let film = |race: usize, curvature: f64| {
            FilmContact::new(FilmInputs {
                // R_x = D(1 ∓ γ)/2
                radius: 0.5 * geometry.ball_diameter() * (1.0 + curvature),
                modulus: 2.0 * contact_modulus(&bearing.ball_material, &bearing.ring_material),
                ellipticity: contacts.hertz[race].ellipticity(),
                viscosity: oil.viscosity,
                pressure_viscosity: oil.pressure_viscosity,
            })
        };
        Ok(Self {
            contacts: [film(0, -gamma), film(1, gamma)],
            entrainment_ratio: entrainment_speed(geometry.pitch_diameter(), gamma, 1.0),
        })
    }

    /// Constants c in m of `h = c ω^0.67 Q^(−0.067)`, inner race first.
    pub(super) fn central_constants(&self) -> [f64; 2] {
        let growth = self.entrainment_ratio.powf(FilmContact::SPEED_EXPONENT);
        self.contacts.map(|film| film.central_constant() * growth)
    }

    /// Central and minimum thickness in m at the inner and the outer race, for their loads in N
    /// at a shaft speed in rad/s.
    pub fn thickness(&self, loads: [f64; 2], speed: f64) -> [FilmThickness; 2] {
        let entrainment = self.entrainment_ratio * speed.abs();
        std::array::from_fn(|race| FilmThickness {
            central: self.contacts[race].central(entrainment, loads[race]),
            minimum: self.contacts[race].minimum(entrainment, loads[race]),
        })
    }

    /// Stiffness Q/(0.067 h) in N/m of the films at the inner and the outer race, for their loads
    /// in N at a shaft speed in rad/s; infinite at rest, zero without load.
    pub fn stiffness(&self, loads: [f64; 2], speed: f64) -> [f64; 2] {
        let entrainment = self.entrainment_ratio * speed.abs();
        // k = |dQ/dh|
        std::array::from_fn(|race| {
            let slope = self.contacts[race].central_slope(entrainment, loads[race]);
            1.0 / slope.abs()
        })
    }

    /// Energies, J, that the films of both races store under their loads in N: `∫ Q dh = (0.067/0.933) Q h`, for the
    /// thickness falls with the load as Q^(−0.067).
    pub fn stored_energies(&self, loads: [f64; 2], speed: f64) -> [f64; 2] {
        const SHARE: f64 = FilmContact::LOAD_EXPONENT / (1.0 - FilmContact::LOAD_EXPONENT);
        let thickness = self.thickness(loads, speed);
        [0, 1].map(|race| match loads[race] {
            load if load > 0.0 => SHARE * load * thickness[race].central,
            _ => 0.0,
        })
    }
}

/// Thickness of the oil film in one contact.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FilmThickness {
    /// Central thickness h_c, m.
    pub central: f64,
    /// Minimum thickness h_min, m.
    pub minimum: f64,
}
