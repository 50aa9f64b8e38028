//! How the shaft's acceleration depends on its velocity, where it does so by constant numbers.

use super::{FREEDOMS, Rotor};
use crate::integrate::VelocityDependence;

impl Rotor {
    /// ∂q̈/∂q̇ = −M⁻¹ (C + G ω) of the first N/2 freedoms.
    ///
    /// # Errors
    /// [`VelocityDependence`] where it changes with place or time.
    pub(super) fn constant_velocity_slopes<const N: usize>(
        &self,
    ) -> Result<[[f64; N]; N], VelocityDependence> {
        let kept = N / 2;
        let gyroscopic = kept == FREEDOMS && self.inertia_polar != 0.0;
        let depends = |because| Err(VelocityDependence { because });
        if self.contacts_damped {
            return depends("the damping of the contacts changes with the place of the shaft");
        }
        if gyroscopic && !self.speed.is_constant() {
            return depends("gyroscopic moments change with the speed of the shaft");
        }
        let mut slopes = [[0.0; N]; N];
        for (row, slopes) in slopes.iter_mut().enumerate().take(kept) {
            for (column, slope) in slopes.iter_mut().enumerate().take(kept) {
                *slope = -self.damping.entry(row, column) * self.inverse_mass[row];
            }
        }
        if gyroscopic {
            let coupling = self.inertia_polar * self.inverse_mass[3] * self.speed();
            slopes[3][4] -= coupling;
            slopes[4][3] += coupling;
        }
        Ok(slopes)
    }
}
