//! Why a bearing cannot be built or mounted.

use super::surface::ImperfectionError;
use super::{EstimateError, GeometryError};
use crate::physics::HertzError;

/// Why a bearing cannot be built or mounted.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum BearingError {
    /// The dimensions do not make a bearing.
    #[error(transparent)]
    Geometry(#[from] GeometryError),
    /// No internal geometry follows from the catalogue line.
    #[error(transparent)]
    Estimate(#[from] Box<EstimateError>),
    /// Ball and race do not form a Hertz contact.
    #[error("the contact of ball and {race} race: {source}")]
    Contact {
        /// Which race.
        race: &'static str,
        /// What is wrong with it.
        source: HertzError,
    },
    /// A property of the oil is no positive number.
    #[error("the oil's {name} is {value} in SI units; it must be positive and finite")]
    Oil {
        /// Which property.
        name: &'static str,
        /// Value as given.
        value: f64,
    },
    /// The stiffness of a ball between both races is no positive number.
    #[error("the contact stiffness is {stiffness} N/m^1.5; it must be positive and finite")]
    ContactStiffness {
        /// Stiffness constant K_n as given, N/m^1.5.
        stiffness: f64,
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
    /// The inertia of balls under an outer ring that turns.
    #[error(
        "contact = \"jones\" knows the inertia of balls under a turning inner ring only: with rotating_ring = \"outer\" \
         set contact = \"hertz\""
    )]
    RotatingRing,
    /// What is known of balls only, asked of rollers.
    #[error("{what} is not known of roller bearings")]
    Rollers {
        /// What it is.
        what: &'static str,
    },
    /// A coefficient of the contact damping is no number that damps.
    #[error("the contact damping is {value} s/m; it must be zero or positive, finite")]
    ContactDamping {
        /// Coefficient as given, s/m.
        value: f64,
    },
    /// A defect, a wave or a ball does not fit the bearing.
    #[error(transparent)]
    Imperfection(#[from] ImperfectionError),
    /// A bearing's preload has no axial position that gives it.
    #[error(
        "no axial position of the inner ring gives a preload of {preload} N; give a smaller \
         preload or an axial_offset"
    )]
    Preload {
        /// Preload as given, N.
        preload: f64,
    },
}
