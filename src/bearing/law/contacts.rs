//! The two contacts of a ball, dry or lubricated, ready for a speed.

use super::film::{FilmSpring, LubricatedContact};
use crate::bearing::number::{Function, Number};
use crate::bearing::{Bearing, BearingError, Oil};
use crate::physics::{FilmContact, FilmInputs, HertzContact, contact_modulus, entrainment_speed};

/// The contacts of a ball with both races.
pub trait Races {
    /// What a contact is at one speed.
    type Spring: ContactSpring;

    /// Springs of the inner and the outer race at a shaft speed in rad/s.
    fn at_speed(&self, speed: f64) -> [Self::Spring; 2];

    /// Elastic contacts of both races by themselves.
    fn elastic(&self) -> [HertzSpring; 2];

    /// Oil films of both races, where there are any.
    fn films(&self) -> Option<&RaceFilms>;
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

    fn films(&self) -> Option<&RaceFilms> {
        None
    }
}

/// Hertz contacts behind oil films.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LubricatedRaces {
    contacts: [LubricatedContact; 2],
    films: RaceFilms,
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

    fn films(&self) -> Option<&RaceFilms> {
        Some(&self.films)
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
        [inner, outer]: &[HertzContact; 2],
        oil: &Oil,
    ) -> Result<Self, BearingError> {
        oil.check()?;
        let geometry = &bearing.geometry;
        let gamma = geometry.gamma();
        let film = |contact: &HertzContact, curvature: f64| {
            FilmContact::new(FilmInputs {
                // R_x = D(1 ∓ γ)/2
                radius: 0.5 * geometry.ball_diameter() * (1.0 + curvature),
                modulus: 2.0 * contact_modulus(&bearing.ball_material, &bearing.ring_material),
                ellipticity: contact.ellipticity(),
                viscosity: oil.viscosity,
                pressure_viscosity: oil.pressure_viscosity,
            })
        };
        Ok(Self {
            contacts: [film(inner, -gamma), film(outer, gamma)],
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
}

/// Thickness of the oil film in one contact.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FilmThickness {
    /// Central thickness h_c, m.
    pub central: f64,
    /// Minimum thickness h_min, m.
    pub minimum: f64,
}

/// Load of one contact (or of two in series) as a function of the approach.
///
/// The load never decreases with the approach and is never negative.
pub trait ContactSpring {
    /// Load Q in N and stiffness dQ/ds in N/m at an approach `s` in m, negative when apart.
    fn load_and_stiffness(&self, approach: f64) -> (f64, f64);

    /// Approach s in m under a load in N: the inverse.
    fn approach(&self, load: f64) -> f64;

    /// Roughly by how much a film holds the surfaces apart under load, m.
    fn lift(&self) -> f64;
}

/// Dry contact: `Q = K s^(3/2)` for s > 0, nothing otherwise.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct HertzSpring {
    /// Stiffness constant K, N/m^1.5.
    pub stiffness: f64,
}

impl HertzSpring {
    /// Stiffness under a load in N, N/m.
    ///
    /// `dQ/ds = 3/2 K^(2/3) Q^(1/3)`
    pub fn stiffness_under(&self, load: f64) -> f64 {
        // 3/2 K^(2/3) Q^(1/3)
        1.5 * self.stiffness.cbrt().powi(2) * load.cbrt()
    }
}

/// Elastic contacts of both races, inner first. Where one stiffness is given for both together each
/// has half of the approach.
pub(super) fn race_springs(bearing: &Bearing, contacts: &[HertzContact; 2]) -> [HertzSpring; 2] {
    let stiffness = match bearing.contact_stiffness {
        // K_n = [2 K^(−2/3)]^(−3/2)
        Some(series) => [series * 2f64.powf(1.5); 2],
        None => contacts.each_ref().map(HertzContact::stiffness),
    };
    stiffness.map(|stiffness| HertzSpring { stiffness })
}

/// Elastic approaches of both contacts under their loads in N, m.
#[inline(always)]
pub(super) fn approaches_under<T: Number>(springs: &[HertzSpring; 2], load: [T; 2]) -> [T; 2] {
    let [inner] = T::apply(&springs[0], [load[0]]);
    let [outer] = T::apply(&springs[1], [load[1]]);
    [inner, outer]
}

/// From the load to the elastic approach.
impl Function<1, 1> for HertzSpring {
    fn with_slopes(&self, [load]: [f64; 1]) -> ([f64; 1], [[f64; 1]; 1]) {
        let stiffness = self.stiffness_under(load);
        let slope = if stiffness > 0.0 {
            1.0 / stiffness
        } else {
            0.0
        };
        ([self.approach(load)], [[slope]])
    }

    fn values(&self, [load]: [f64; 1]) -> [f64; 1] {
        [self.approach(load)]
    }
}

impl ContactSpring for HertzSpring {
    #[inline]
    fn load_and_stiffness(&self, approach: f64) -> (f64, f64) {
        let s = approach.max(0.0);
        // dQ/ds = 3/2 K √s,  Q = K s √s
        let root = self.stiffness * s.sqrt();
        (root * s, 1.5 * root)
    }

    #[inline]
    fn approach(&self, load: f64) -> f64 {
        // s = (Q/K)^(2/3)
        let root = (load / self.stiffness).cbrt();
        root * root
    }

    #[inline]
    fn lift(&self) -> f64 {
        0.0
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn springs_in_a_row_have_the_tangent_under_a_load() {
        // K = 8, Q = 27: s = (27/8)^(2/3) = 9/4 and 3/2 K √s = 18.
        let spring = HertzSpring { stiffness: 8.0 };
        assert!((spring.stiffness_under(27.0) - 18.0).abs() < 1e-14);
    }
}
