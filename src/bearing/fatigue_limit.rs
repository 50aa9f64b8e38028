//! Fatigue load limit of a bearing.

use super::static_safety::permissible_static_load;
use super::{Bearing, Geometry};
use crate::physics::HertzContact;

impl Bearing {
    /// Fatigue load limit C_u, N: the radial load at which the contact pressure of the heaviest loaded ball reaches
    /// 1500 MPa.
    ///
    /// `C_u = 0.2288 Z Q_u cos α`, times `(100 mm/d_m)^0.5` above 100 mm; Q_u is the load of the worse race at that
    /// pressure.
    ///
    /// Source: ISO 281:2007, B.3.2.2.
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
    /// [`super::BearingError::Contact`] where ball and race form no contact.
    pub fn fatigue_load_limit(&self) -> Result<f64, super::BearingError> {
        Ok(fatigue_load_limit(&self.geometry, &self.contacts()?))
    }
}

/// As [`Bearing::fatigue_load_limit`], for contacts that are known already.
pub(super) fn fatigue_load_limit(geometry: &Geometry, contacts: &[HertzContact; 2]) -> f64 {
    // Q_u = Q(4200 MPa) (1500/4200)³
    let share = (1500.0_f64 / 4200.0).powi(3);
    let [inner, outer] = contacts.each_ref().map(permissible_static_load);
    let size = (0.1 / geometry.pitch_diameter()).sqrt().min(1.0);
    let cosine = geometry.nominal_angle().cos();
    0.2288 * geometry.balls() as f64 * share * inner.min(outer) * cosine * size
}
