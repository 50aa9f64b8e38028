//! The ball bearing as a nonlinear spring: geometry, ball laws, ring sum, equilibrium.

mod ball_law;
pub mod catalogue;
mod contact_spring;
mod definition;
mod film_spring;
mod geometry;
mod hertz_film_law;
mod jones;
mod oil;
mod races;

pub use ball_law::{BallContact, BallForce, BallLaw, BallTangent};
pub use contact_spring::{ContactSpring, HertzSpring};
pub use definition::{Bearing, BearingError, ContactLaw, Facing, MountedBearing, Preload};
pub use film_spring::FilmSpring;
pub use geometry::{FreePosition, Geometry, GeometryError};
pub use hertz_film_law::HertzFilmLaw;
pub use jones::{BallState, JonesFilmLaw, JonesLaw};
pub use oil::{BallLawError, Oil};
pub use races::{DryRaces, FilmThickness, LubricatedRaces, RaceFilms, Races};
