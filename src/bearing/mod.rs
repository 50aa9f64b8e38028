//! The ball bearing as a nonlinear spring: geometry, ball laws, ring sum.
//!
//! Data climbs from a [`Bearing`] (dimensions, materials) over a [`BallLaw`] (force of one ball) and
//! a [`Ring`] (the positions of the balls, and sums over them) to a [`Support`] (the bearing at its place on the
//! shaft).

mod assessment;
mod ball_line;
mod bearing_friction;
pub mod catalogue;
mod clearance;
mod contact_band;
mod contact_damping;
mod definition;
mod geometry;
mod law;
mod life;
mod linear_force;
pub mod number;
mod oil;
mod ring;
mod ring_contacts;
mod ring_forces;
mod rotation;
mod seat;
mod state;
mod static_safety;
mod support;
mod support_damping;
mod support_force;
mod support_lift_off;
mod support_table;
mod thrust;
mod warnings;

pub(crate) use assessment::LOADED_SHARE;
pub use clearance::{Clearance, ClearanceClass};
pub use contact_band::ContactBand;
pub use contact_damping::ContactDamping;
pub use definition::{
    Bearing, BearingError, Facing, LIMITING_SPEED_FACTOR, MountedBearing, Preload,
};
pub use geometry::{FreePosition, Geometry, GeometryError};
pub use law::{
    Ball, BallContact, BallForce, BallLaw, BallRegion, BallResponse, BallState, BallTable,
    BallTangent, ContactLaw, ContactSpring, DryRaces, FilmSpring, FilmThickness, ForceLaw,
    HertzFilmLaw, HertzLaw, HertzSpring, JonesFilmLaw, JonesLaw, LubricatedRaces, RaceFilms, Races,
    TableError, TableReport,
};
pub use life::{RatingLife, reference_rating_life};
pub use oil::Oil;
pub use ring::{Matrix5, Ring, Vector5};
pub(crate) use ring::{in_registers, quarter_turn};
pub use ring_contacts::BallLoads;
pub use rotation::{Angle, BearingRotation};
pub use state::{
    Around, BallLine, BearingState, FilmState, FrictionMoment, RaceContact, StiffnessShares,
};
pub use static_safety::{PERMISSIBLE_PRESSURE, permissible_static_load};
pub use support::Support;
