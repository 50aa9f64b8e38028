//! What lubricates a bearing.

use super::BearingError;
use crate::physics::Contamination;

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

/// The lubricant at the temperature of the bearing.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Lubrication {
    /// Kinematic viscosity of the oil, or of the base oil of a grease, m²/s.
    pub viscosity: f64,
    /// Whether it is a grease.
    pub grease: bool,
    /// How clean it is; the modified life needs it.
    pub contamination: Option<Contamination>,
}
