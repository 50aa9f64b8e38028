//! The ball bearing as a nonlinear spring: geometry, ball laws, ring sum, equilibrium.

mod ball_law;
pub mod catalogue;
mod definition;
mod geometry;

pub use ball_law::{BallContact, BallForce, BallLaw, BallTangent};
pub use definition::{Bearing, BearingError, ContactLaw, Facing, MountedBearing, Preload};
pub use geometry::{FreePosition, Geometry, GeometryError};
