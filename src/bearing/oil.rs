//! The oil in the bearing.

use super::BearingError;

/// Lubricating oil at the bearing's temperature.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Oil {
    /// Viscosity at ambient pressure η0, Pa s.
    pub viscosity: f64,
    /// Pressure–viscosity coefficient α_p, 1/Pa.
    pub pressure_viscosity: f64,
}

impl Oil {
    /// # Errors
    /// [`BearingError::Oil`] where a property is not positive and finite.
    pub(super) fn check(&self) -> Result<(), BearingError> {
        for (name, value) in [
            ("viscosity", self.viscosity),
            ("pressure–viscosity coefficient", self.pressure_viscosity),
        ] {
            if !(value > 0.0 && value.is_finite()) {
                return Err(BearingError::Oil { name, value });
            }
        }
        Ok(())
    }
}
