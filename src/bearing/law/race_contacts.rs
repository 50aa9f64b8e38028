//! The elastic contacts of balls with both races, as ratings and reports ask of them: point contacts after Hertz.

use super::{ContactSpring, HertzSpring};
use crate::bearing::{Bearing, BearingError};
use crate::physics::{
    ContactEllipse, HertzContact, HertzError, contact_modulus, inner_race_curvature,
    outer_race_curvature, series_stiffness,
};

/// Elastic contacts of a ball with both races, inner first.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RaceContacts {
    /// Contacts by the dimensions of the bearing.
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
        let (diameter, grooves) = (
            bearing.geometry.ball_diameter(),
            bearing.geometry.groove_factors(),
        );
        let modulus = contact_modulus(&bearing.ball_material, &bearing.ring_material);
        let [inner, outer] = hertz_contacts(diameter, grooves, gamma, modulus);
        let wrong = |race| move |source| BearingError::Contact { race, source };
        Ok(Self {
            hertz: [
                inner.map_err(wrong("inner"))?,
                outer.map_err(wrong("outer"))?,
            ],
            given: bearing.contact_stiffness,
            groove_radii: grooves.map(|factor| factor * diameter),
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

/// Hertz contacts of a ball of a diameter in m with races of groove factors, by γ = D cos α/d_m and the modulus in Pa.
pub(in crate::bearing) fn hertz_contacts(
    ball_diameter: f64,
    [inner, outer]: [f64; 2],
    gamma: f64,
    modulus: f64,
) -> [Result<HertzContact, HertzError>; 2] {
    let curvatures = [
        inner_race_curvature(ball_diameter, inner, gamma),
        outer_race_curvature(ball_diameter, outer, gamma),
    ];
    curvatures.map(|curvature| HertzContact::new(curvature, modulus))
}

impl Bearing {
    /// Hertz contact of ball and inner race, curvature at the free contact angle.
    ///
    /// # Errors
    /// [`BearingError::Contact`] where the curvatures do not meet in an ellipse.
    pub fn inner_contact(&self) -> Result<HertzContact, BearingError> {
        Ok(self.contacts()?.hertz[0])
    }

    /// Hertz contact of ball and outer race, curvature at the free contact angle.
    ///
    /// # Errors
    /// [`BearingError::Contact`] where the curvatures do not meet in an ellipse.
    pub fn outer_contact(&self) -> Result<HertzContact, BearingError> {
        Ok(self.contacts()?.hertz[1])
    }

    /// Load–deflection constant K_n of a ball between both races, N/m^1.5.
    ///
    /// ```
    /// use jeffcott::bearing::Bearing;
    /// // 7205C, E = 207 GPa, ν = 0.3: K_n = 273 580.37 N/mm^1.5 (independent implementations).
    /// let bearing = Bearing::catalogue("7205C")?;
    /// assert!((bearing.load_deflection_constant()? / 10f64.powf(4.5) - 273_580.37).abs() < 0.01);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// [`BearingError::Contact`] where the curvatures do not meet in an ellipse.
    pub fn load_deflection_constant(&self) -> Result<f64, BearingError> {
        match self.contact_stiffness {
            Some(given) => Ok(given),
            None => Ok(self.contacts()?.in_series().stiffness),
        }
    }

    /// Contacts of ball and races at the free contact angle.
    pub(crate) fn contacts(&self) -> Result<RaceContacts, BearingError> {
        RaceContacts::new(self, self.geometry.gamma())
    }

    /// Contacts of ball and races at the nominal contact angle, which the ratings belong to, whatever the clearance.
    pub(in crate::bearing) fn rated_contacts(&self) -> Result<RaceContacts, BearingError> {
        RaceContacts::new(self, self.geometry.nominal_gamma())
    }
}

/// Contact pressure of ISO 76 at which balls and races keep a dent of about 1e-4 of the ball
/// diameter, Pa.
pub const PERMISSIBLE_PRESSURE: f64 = 4.2e9;

/// Permissible static load of one contact, N: the one whose largest pressure is 4200 MPa.
///
/// `Q = (p/p_1)³`, with p_1 the largest pressure in Pa under 1 N, for `p = 3Q/(2πab)` grows as
/// Q^(1/3).
///
/// Source: ISO 76:2006, definition of the basic static load rating of ball bearings.
///
/// ```
/// use jeffcott::bearing::{Bearing, permissible_static_load};
/// let contact = Bearing::catalogue("7205C")?.inner_contact()?;
/// let load = permissible_static_load(&contact);
/// assert!((contact.ellipse(load).peak_pressure / 4.2e9 - 1.0).abs() < 1e-14);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn permissible_static_load(contact: &HertzContact) -> f64 {
    // Q = (p/p_1)³
    (PERMISSIBLE_PRESSURE / contact.ellipse(1.0).peak_pressure).powi(3)
}
