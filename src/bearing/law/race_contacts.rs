//! The elastic contacts of balls or rollers with both races, as ratings and reports ask of them.

use super::line_contacts::LineContacts;
use super::{ContactSpring, HertzSpring};
use crate::bearing::{BallLine, Bearing, BearingError};
use crate::physics::{
    ContactEllipse, HertzContact, HertzError, contact_modulus, inner_race_curvature,
    outer_race_curvature, series_stiffness,
};

/// Elastic contacts of a ball or a roller with both races, inner first.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum RaceContacts {
    /// Of a ball.
    Point(PointContacts),
    /// Of a roller.
    Line(LineContacts),
}

/// Evaluates an expression for the contacts inside.
macro_rules! with_contacts {
    ($any:expr, $contacts:ident => $value:expr) => {
        match $any {
            RaceContacts::Point($contacts) => $value,
            RaceContacts::Line($contacts) => $value,
        }
    };
}

impl RaceContacts {
    /// Stiffness of both contacts in series at an approach in m, N/m.
    pub fn stiffness_at(&self, approach: f64) -> f64 {
        with_contacts!(self, contacts => contacts.stiffness_at(approach))
    }

    /// Load, N, of a ball without inertia whose approach to both races together is given in m; of a roller that is
    /// straight and not tilted.
    pub fn load_at(&self, approach: f64) -> f64 {
        with_contacts!(self, contacts => contacts.load_at(approach))
    }

    /// Where a ball bears on a race under a load in N; a roller on a strip that is pressed alike along its length.
    pub fn ellipse(&self, race: usize, load: f64) -> ContactEllipse {
        with_contacts!(self, contacts => contacts.ellipse(race, load))
    }

    /// Half the angle that the contact of a ball with a race takes across it under a load in N, rad; none of a roller.
    pub fn reach(&self, race: usize, load: f64) -> Option<f64> {
        match self {
            Self::Point(contacts) => Some(contacts.reach(race, load)),
            Self::Line(_) => None,
        }
    }

    /// Stiffness of the contact of the geometry with a race under a load in N, N/m.
    pub fn stiffness_under(&self, race: usize, load: f64) -> f64 {
        with_contacts!(self, contacts => contacts.stiffness_under(race, load))
    }

    /// Loads of a ball, or a roller pressed alike along its length, at both races that leave no dent, N.
    pub fn permissible_loads(&self) -> [f64; 2] {
        with_contacts!(self, contacts => contacts.permissible_loads())
    }

    /// Largest contact pressure of ISO 76 that leaves no dent, Pa.
    pub fn permissible_pressure(&self) -> f64 {
        match self {
            Self::Point(_) => PERMISSIBLE_PRESSURE,
            Self::Line(_) => LineContacts::PERMISSIBLE_PRESSURE,
        }
    }

    /// Static safety: permissible load over the largest one, at the race where that is less; none without load. Rollers
    /// are judged by the lamina that is pressed most.
    pub(in crate::bearing) fn static_safety(&self, balls: &[BallLine]) -> Option<f64> {
        let safety = match self {
            Self::Point(contacts) => {
                contacts.static_safety(balls.iter().map(|ball| [ball.inner.load, ball.outer.load]))
            }
            // the load of a lamina grows with the square of its pressure
            Self::Line(_) => {
                let contacts = balls.iter().flat_map(|ball| [&ball.inner, &ball.outer]);
                let pressure = contacts.map(|contact| contact.peak_pressure);
                (self.permissible_pressure() / pressure.fold(0.0, f64::max)).powi(2)
            }
        };
        Some(safety).filter(|safety| safety.is_finite())
    }
}

/// Elastic contacts of a ball with both races, inner first: point contacts after Hertz.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PointContacts {
    /// Contacts by the dimensions of the bearing.
    pub(super) hertz: [HertzContact; 2],
    /// K_n of both races together where it is given, N/m^1.5.
    given: Option<f64>,
    /// f D of both races, m.
    groove_radii: [f64; 2],
}

impl PointContacts {
    /// The contacts of a bearing with the curvatures of γ = D cos α/d_m.
    pub fn new(bearing: &Bearing, gamma: f64) -> Result<Self, BearingError> {
        if bearing.geometry.rollers().is_some() {
            let what = "the elliptic contact of ball and race";
            return Err(BearingError::Rollers { what });
        }
        let valid = |stiffness: &f64| *stiffness > 0.0 && stiffness.is_finite();
        if let Some(stiffness) = bearing.contact_stiffness.filter(|own| !valid(own)) {
            return Err(BearingError::ContactStiffness { stiffness });
        }
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

    /// Permissible load over the largest one, at the race where that is less; `loads` are those of every ball in N.
    fn static_safety(&self, loads: impl Iterator<Item = [f64; 2]>) -> f64 {
        let largest = loads.fold([0.0; 2], |largest: [f64; 2], load| {
            [largest[0].max(load[0]), largest[1].max(load[1])]
        });
        let permissible = self.permissible_loads();
        let [inner, outer] = [0, 1].map(|race| permissible[race] / largest[race]);
        inner.min(outer)
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
    /// [`BearingError::Contact`] where the curvatures do not meet in an ellipse, [`BearingError::Rollers`] of rollers.
    pub fn inner_contact(&self) -> Result<HertzContact, BearingError> {
        Ok(self.point_contacts()?.hertz[0])
    }

    /// Hertz contact of ball and outer race, curvature at the free contact angle.
    ///
    /// # Errors
    /// [`BearingError::Contact`] where the curvatures do not meet in an ellipse, [`BearingError::Rollers`] of rollers.
    pub fn outer_contact(&self) -> Result<HertzContact, BearingError> {
        Ok(self.point_contacts()?.hertz[1])
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
    /// [`BearingError::Contact`] where the curvatures do not meet in an ellipse, [`BearingError::ContactStiffness`] where a
    /// given one is no stiffness, [`BearingError::Rollers`] of rollers.
    pub fn load_deflection_constant(&self) -> Result<f64, BearingError> {
        Ok(self.point_contacts()?.in_series().stiffness)
    }

    /// Contacts of ball and races at the free contact angle.
    pub(crate) fn point_contacts(&self) -> Result<PointContacts, BearingError> {
        PointContacts::new(self, self.geometry.gamma())
    }

    /// Contacts of ball or roller and races at the free contact angle.
    pub(crate) fn contacts(&self) -> Result<RaceContacts, BearingError> {
        self.contacts_at(self.geometry.gamma())
    }

    /// Contacts of ball and races at the nominal contact angle, which the ratings belong to, whatever the clearance.
    pub(in crate::bearing) fn rated_contacts(&self) -> Result<RaceContacts, BearingError> {
        self.contacts_at(self.geometry.nominal_gamma())
    }

    fn contacts_at(&self, gamma: f64) -> Result<RaceContacts, BearingError> {
        Ok(match self.geometry.rollers() {
            Some(rollers) => RaceContacts::Line(LineContacts::new(self, rollers, gamma)),
            None => RaceContacts::Point(PointContacts::new(self, gamma)?),
        })
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
