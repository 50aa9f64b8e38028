//! Static ratings of balls in grooves, and the grooves that a rating asks for.

use super::{Candidate, CatalogueLine, EstimateError};
use crate::bearing::law::{hertz_contacts, permissible_static_load};
use crate::bearing::static_rating::static_rating_of_loads;
use crate::numerics::root::bisection;
use crate::physics::{Material, contact_modulus, dynamic_rating, open_groove_factor};

/// Reference grooves of ISO/TS 16281, inner race first: taken where the groove is not known.
pub(crate) const REFERENCE_GROOVES: [f64; 2] = [0.52, 0.53];

/// Range in which the groove factor of both races is looked for.
pub(super) const GROOVES: [f64; 2] = [0.502, 0.6];

impl CatalogueLine {
    /// C_0 = Z Q cos α/5 with Q the load of 4200 MPa at the worse race; zero where no contact can be formed.
    pub(super) fn static_rating_of(
        &self,
        balls: usize,
        ball_diameter: f64,
        pitch: f64,
        grooves: [f64; 2],
    ) -> f64 {
        let steel = Material::BEARING_STEEL;
        let cosine = self.contact_angle.cos();
        let gamma = ball_diameter * cosine / pitch;
        let modulus = contact_modulus(&steel, &steel);
        let contacts = hertz_contacts(ball_diameter, grooves, gamma, modulus);
        let loads = contacts
            .map(|contact| contact.map_or(0.0, |contact| permissible_static_load(&contact)));
        static_rating_of_loads(balls, loads, cosine)
    }

    /// C of ISO 281 of balls in grooves, N.
    pub(super) fn dynamic_rating_of(
        &self,
        balls: usize,
        ball_diameter: f64,
        pitch: f64,
        grooves: [f64; 2],
    ) -> f64 {
        let gamma = ball_diameter * self.contact_angle.cos() / pitch;
        open_groove_factor(gamma, grooves)
            * dynamic_rating(balls, ball_diameter, pitch, self.contact_angle)
    }

    /// f0 = C_0/(Z D² cos α), N/mm².
    pub(super) fn static_factor_of(&self, balls: usize, ball_diameter: f64) -> Option<f64> {
        let area = 1e6 * ball_diameter * ball_diameter * self.contact_angle.cos();
        Some(self.static_rating? / (balls as f64 * area))
    }

    /// The factor of both grooves at which the balls have the printed static rating.
    pub(super) fn groove_of_static_rating(
        &self,
        candidate: &Candidate,
        pitch: f64,
    ) -> Result<f64, EstimateError> {
        let statical = self.static_rating.ok_or(EstimateError::NoStaticRating)?;
        let (balls, ball_diameter) = (candidate.balls, candidate.ball_diameter);
        let rating = |groove| self.static_rating_of(balls, ball_diameter, pitch, [groove; 2]);
        let [narrow, wide] = GROOVES;
        let (least, largest) = (rating(wide), rating(narrow));
        if !(least..=largest).contains(&statical) {
            return Err(EstimateError::Groove {
                statical,
                balls,
                ball_diameter,
                least,
                largest,
            });
        }
        // the wider the groove, the smaller the contact and the rating
        let is_wide = |groove| rating(groove) <= statical;
        Ok(bisection(is_wide, GROOVES, 0.0))
    }
}
