//! The ball bearing as a nonlinear spring: geometry, ball laws, ring sum, equilibrium.
//!
//! Data climbs from a [`Bearing`] (dimensions, materials) over a [`BallLaw`] (force of one ball) and
//! a [`Ring`] (sum over the balls) to a [`Support`] (the bearing at its place on the shaft) and the
//! [`equilibrium`] of any number of them under a load.

mod ball_law;
pub mod catalogue;
mod definition;
pub mod equilibrium;
mod geometry;
mod hertz_law;
mod ring;
mod support;
mod thrust;

pub use ball_law::{BallContact, BallForce, BallLaw, BallTangent};
pub use definition::{Bearing, BearingError, ContactLaw, Facing, MountedBearing, Preload};
pub use geometry::{FreePosition, Geometry, GeometryError};
pub use hertz_law::HertzLaw;
pub use ring::{CageAngle, Matrix5, Ring, Vector5};
pub use support::Support;
pub use thrust::Thrust;
