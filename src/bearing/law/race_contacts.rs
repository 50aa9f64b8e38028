//! The elastic contacts of balls with both races, as ratings and reports ask of them: point contacts after Hertz.

use super::{ContactSpring, HertzSpring};
use crate::bearing::static_rating::permissible_static_load;
use crate::bearing::{Bearing, BearingError, PERMISSIBLE_PRESSURE};
use crate::physics::{ContactEllipse, HertzContact, series_stiffness};

/// Elastic contacts of a ball with both races, inner first.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RaceContacts {
    /// Those of the geometry.
    pub(super) hertz: [HertzContact; 2],
    /// K_n of both races together where it is given, N/m^1.5.
    given: Option<f64>,
    /// f D of both races, m.
    groove_radii: [f64; 2],
}

impl RaceContacts {
    /// Largest contact pressure that leaves no dent, Pa.
    pub const PERMISSIBLE_PRESSURE: f64 = PERMISSIBLE_PRESSURE;

    /// The contacts of a bearing with the curvatures of γ = D cos α/d_m.
    pub fn new(bearing: &Bearing, gamma: f64) -> Result<Self, BearingError> {
        let geometry = &bearing.geometry;
        let grooves = geometry.groove_factors();
        Ok(Self {
            hertz: [
                bearing.contact("inner", gamma)?,
                bearing.contact("outer", gamma)?,
            ],
            given: bearing.contact_stiffness,
            groove_radii: grooves.map(|factor| factor * geometry.ball_diameter()),
        })
    }

    /// Each contact by itself. Where one stiffness is given for both together each has half of the approach.
    pub fn springs(&self) -> [HertzSpring; 2] {
        let own = |contact: &HertzContact| HertzSpring {
            stiffness: contact.stiffness(),
        };
        self.given
            .map_or_else(|| self.hertz.each_ref().map(own), HertzSpring::halves)
    }

    /// Both contacts in series under one load.
    pub fn in_series(&self) -> HertzSpring {
        let stiffness = self.given.unwrap_or_else(|| {
            let [inner, outer] = &self.hertz;
            series_stiffness(inner.stiffness(), outer.stiffness())
        });
        HertzSpring { stiffness }
    }

    /// Stiffness of both contacts in series at an approach in m, N/m.
    pub fn stiffness_at(&self, approach: f64) -> f64 {
        // dQ/dδ = 3/2 K_n √δ
        1.5 * self.in_series().stiffness * approach.sqrt()
    }

    /// Load, N, of a ball without inertia whose approach to both races together is given in m.
    pub fn load_at(&self, approach: f64) -> f64 {
        self.in_series().load_and_stiffness(approach).0
    }

    /// Where a ball bears on a race under a load in N.
    pub fn ellipse(&self, race: usize, load: f64) -> ContactEllipse {
        self.hertz[race].ellipse(load)
    }

    /// Half the angle that the contact with a race takes across it under a load in N, rad: `asin(a/(f D))`.
    pub fn reach(&self, race: usize, load: f64) -> f64 {
        let semi_major = self.ellipse(race, load).semi_major;
        (semi_major / self.groove_radii[race]).min(1.0).asin()
    }

    /// Stiffness of the contact of the geometry with a race under a load in N, N/m.
    pub fn stiffness_under(&self, race: usize, load: f64) -> f64 {
        let stiffness = self.hertz[race].stiffness();
        HertzSpring { stiffness }.stiffness_under(load)
    }

    /// Loads of a ball at both races that leave no dent, N.
    pub fn permissible_loads(&self) -> [f64; 2] {
        self.hertz.each_ref().map(permissible_static_load)
    }

    /// Static safety: permissible load over the largest one, at the race where that is less; none without load.
    /// `loads` are those of every ball in N.
    pub fn static_safety(&self, loads: impl Iterator<Item = [f64; 2]>) -> Option<f64> {
        let largest = loads.fold([0.0; 2], |largest: [f64; 2], load| {
            [largest[0].max(load[0]), largest[1].max(load[1])]
        });
        let permissible = self.permissible_loads();
        let [inner, outer] = [0, 1].map(|race| permissible[race] / largest[race]);
        Some(inner.min(outer)).filter(|safety| safety.is_finite())
    }
}
