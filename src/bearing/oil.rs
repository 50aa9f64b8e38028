//! The oil in the bearing, and why a law cannot be built with it.

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
    /// [`BallLawError::Oil`] where a property is not positive and finite.
    pub(super) fn check(&self) -> Result<(), BallLawError> {
        for (name, value) in [
            ("viscosity", self.viscosity),
            ("pressure–viscosity coefficient", self.pressure_viscosity),
        ] {
            if !(value > 0.0 && value.is_finite()) {
                return Err(BallLawError::Oil { name, value });
            }
        }
        Ok(())
    }
}

/// Why the law of one ball cannot be built.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum BallLawError {
    /// Ball and races do not make contacts.
    #[error(transparent)]
    Bearing(#[from] BearingError),
    /// A property of the oil is no positive number.
    #[error("the oil's {name} is {value} in SI units; it must be positive and finite")]
    Oil {
        /// Which property.
        name: &'static str,
        /// Value as given.
        value: f64,
    },
    /// The balls have no mass.
    #[error("the density of the balls is {density} kg/m³; it must be positive and finite")]
    Density {
        /// Density as given, kg/m³.
        density: f64,
    },
    /// A stiffness given for both races together cannot be told apart.
    #[error(
        "a contact stiffness of {stiffness} N/m^1.5 is given for both races together; ball inertia \
         loads them differently, so give the geometry's own contacts instead"
    )]
    SeriesStiffness {
        /// Stiffness constant K_n as given, N/m^1.5.
        stiffness: f64,
    },
}
