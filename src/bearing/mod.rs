//! The ball bearing as a nonlinear spring: geometry, ball laws, ring sum, equilibrium.

pub mod catalogue;
mod definition;
mod geometry;

pub use definition::{Bearing, BearingError, ContactLaw, Facing, MountedBearing, Preload};
pub use geometry::{FreePosition, Geometry, GeometryError};
