//! Loads that the contact pressure permits: static load rating and safety of ISO 76, fatigue load limit of ISO 281.

use super::{Bearing, BearingError, Geometry, RaceContacts};
use crate::physics::roller_static_rating;

impl Bearing {
    /// Basic static radial load rating C_0 from the bearing's own contacts at the nominal contact angle, N.
    ///
    /// `C_0 = Z Q cos α/5`
    ///
    /// Q is the permissible load of the weaker contact, [`super::permissible_static_load`], in N, α the
    /// nominal contact angle; 5 is Stribeck's ratio of the largest ball load to the mean under
    /// radial load. Of a roller bearing, [`crate::physics::roller_static_rating`].
    ///
    /// Source: ISO 76:2006 with ISO/TR 10657:1991 (derivation); R. Stribeck (1901).
    ///
    /// ```
    /// use jeffcott::bearing::Bearing;
    /// // 7205C: ISO 76 prints C_0 = f_0 Z D² cos α = 10 225 N with f_0 = 14.0. Its f_0 is
    /// // tabulated in steps of γ at E = 207 GPa: agreement to 1 % is all that can be asked.
    /// let rating = Bearing::catalogue("7205C")?.static_rating()?;
    /// assert!((rating / 10_225.0 - 1.0).abs() < 0.01, "{rating}");
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// [`BearingError::Contact`] where ball and race form no contact.
    pub fn static_rating(&self) -> Result<f64, BearingError> {
        Ok(static_rating(&self.geometry, &self.rated_contacts()?))
    }

    /// Fatigue load limit C_u, N: the radial load at which the contact pressure of the heaviest loaded ball reaches
    /// 1500 MPa.
    ///
    /// `C_u = 0.2288 Z Q_u cos α`, times `(100 mm/d_m)^0.5` above 100 mm; Q_u is the load of the worse race at that
    /// pressure. Of a roller bearing `C_u = C_0/8.2`, times `(100 mm/d_m)^0.3` above 100 mm.
    ///
    /// Source: ISO 281:2007, B.3.2.2 and B.3.3.3.
    ///
    /// ```
    /// use jeffcott::bearing::Bearing;
    /// // 7205C: 531.9 N by an independent implementation
    /// let limit = Bearing::catalogue("7205C")?.fatigue_load_limit()?;
    /// assert!((limit - 531.9).abs() < 0.5, "{limit}");
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// [`BearingError::Contact`] where ball and race form no contact.
    pub fn fatigue_load_limit(&self) -> Result<f64, BearingError> {
        Ok(fatigue_load_limit(&self.geometry, &self.rated_contacts()?))
    }
}

/// C_0 by [`Bearing::static_rating`] from [`Bearing::rated_contacts`], which take long to find.
pub(super) fn static_rating(geometry: &Geometry, contacts: &RaceContacts) -> f64 {
    if let Some(rollers) = geometry.rollers() {
        return roller_static_rating(
            geometry.all_balls(),
            geometry.ball_diameter(),
            rollers.length,
            geometry.pitch_diameter(),
            geometry.nominal_angle(),
        );
    }
    let loads = contacts.permissible_loads();
    static_rating_of_loads(geometry.balls(), loads, geometry.nominal_angle().cos())
}

/// C_0 = Z Q cos α/5 of balls with permissible loads at both races.
pub(super) fn static_rating_of_loads(balls: usize, [inner, outer]: [f64; 2], cosine: f64) -> f64 {
    balls as f64 * inner.min(outer) * cosine / 5.0
}

/// C_u by [`Bearing::fatigue_load_limit`] from [`Bearing::rated_contacts`].
pub(super) fn fatigue_load_limit(geometry: &Geometry, contacts: &RaceContacts) -> f64 {
    let oversize = (0.1 / geometry.pitch_diameter()).min(1.0);
    if geometry.rollers().is_some() {
        return static_rating(geometry, contacts) / 8.2 * oversize.powf(0.3);
    }
    // Q_u = Q(4200 MPa) (1500/4200)³
    let share = (1500.0_f64 / 4200.0).powi(3);
    let [inner, outer] = contacts.permissible_loads();
    let size = oversize.sqrt();
    let cosine = geometry.nominal_angle().cos();
    0.2288 * geometry.balls() as f64 * share * inner.min(outer) * cosine * size
}
