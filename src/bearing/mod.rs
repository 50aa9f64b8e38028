//! The ball bearing as a nonlinear spring: geometry, ball laws, ring sum, equilibrium.
//!
//! Data climbs from a [`Bearing`] (dimensions, materials) over a [`BallLaw`] (force of one ball) and
//! a [`Ring`] (sum over the balls) to a [`Support`] (the bearing at its place on the shaft) and the
//! [`equilibrium`] of any number of them under a load.

mod any_ring;
mod assessment;
mod ball_law;
mod ball_line;
mod ball_reading;
mod bearing_friction;
pub mod catalogue;
mod contact_band;
mod contact_damping;
mod contact_spring;
mod definition;
mod elastic_energy;
pub mod equilibrium;
mod film_shares;
mod film_spring;
mod geometry;
mod hertz_film_law;
mod hertz_law;
mod jones;
mod life;
mod linear_force;
mod oil;
mod races;
mod ring;
mod ring_lanes;
mod ring_lift_off;
mod ring_loads;
mod ring_table;
mod seat;
mod series_damping;
mod state;
mod static_safety;
mod support;
mod support_damping;
mod support_force;
mod support_lift_off;
mod support_table;
mod table;
mod thrust;
mod warnings;

pub(crate) use assessment::LOADED_SHARE;
pub use ball_law::{
    BallContact, BallForce, BallLaw, BallTangent, LANES, LaneForces, Lanes, LoadSlope,
};
pub use contact_band::ContactBand;
pub use contact_damping::ContactDamping;
pub use contact_spring::{ContactSpring, HertzSpring};
pub use definition::{
    Bearing, BearingError, ContactLaw, Facing, LIMITING_SPEED_FACTOR, MountedBearing, Preload,
};
pub use film_spring::FilmSpring;
pub use geometry::{FreePosition, Geometry, GeometryError};
pub use hertz_film_law::HertzFilmLaw;
pub use hertz_law::HertzLaw;
pub use jones::{BallState, JonesFilmLaw, JonesLaw};
pub use life::{RatingLife, reference_rating_life};
pub use oil::Oil;
pub use races::{DryRaces, FilmThickness, LubricatedRaces, RaceFilms, Races};
pub use ring::{Around, CageAngle, Matrix5, Ring, Vector5};
pub(crate) use ring::{in_registers, quarter_turn};
pub use state::{BallLine, BearingState, FilmState, FrictionMoment, RaceContact, StiffnessShares};
pub use static_safety::{PERMISSIBLE_PRESSURE, permissible_static_load};
pub use support::Support;
pub use table::{BallRegion, BallTable, TableError, TableReport};
pub use thrust::Thrust;
