//! The oil films between a ball or a roller and both races.

use super::PointContacts;
use crate::bearing::{Bearing, BearingError, Oil};
use crate::physics::{FilmContact, FilmInputs, FilmShape, contact_modulus, entrainment_speed};

/// Oil films of both races, inner first.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RaceFilms {
    contacts: [FilmContact; 2],
    entrainment_ratio: f64,
}

impl RaceFilms {
    /// Films of a bearing with an oil.
    ///
    /// # Errors
    /// [`BearingError::Oil`] where the oil is none.
    pub fn new(
        bearing: &Bearing,
        contacts: &PointContacts,
        oil: &Oil,
    ) -> Result<Self, BearingError> {
        let point = |race: usize| FilmShape::Point {
            ellipticity: contacts.hertz[race].ellipticity(),
        };
        Self::of_shapes(bearing, [0, 1].map(point), oil)
    }

    /// Films of the rollers of a bearing, of a length in m, pressed alike along it.
    ///
    /// # Errors
    /// [`BearingError::Oil`] where the oil is none.
    pub fn of_rollers(bearing: &Bearing, length: f64, oil: &Oil) -> Result<Self, BearingError> {
        Self::of_shapes(bearing, [FilmShape::Line { length }; 2], oil)
    }

    fn of_shapes(
        bearing: &Bearing,
        shapes: [FilmShape; 2],
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
                shape: shapes[race],
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

    /// Stiffness Q/(0.067 h), of rollers Q/(0.166 h), in N/m of the films at the inner and the outer race, for their loads
    /// in N at a shaft speed in rad/s; infinite at rest, zero without load.
    pub fn stiffness(&self, loads: [f64; 2], speed: f64) -> [f64; 2] {
        let entrainment = self.entrainment_ratio * speed.abs();
        // k = |dQ/dh|
        std::array::from_fn(|race| {
            let slope = self.contacts[race].central_slope(entrainment, loads[race]);
            1.0 / slope.abs()
        })
    }

    /// Energies, J, that the films of balls at both races store under their loads in N: `∫ Q dh = (0.067/0.933) Q h`, for the
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
