//! The ball or roller bearing as a nonlinear spring: geometry, ball laws, ring sum.
//!
//! What rolls is called a ball throughout, and is a roller where the law of its contacts is that of one. Data climbs from
//! a [`Bearing`] (dimensions, materials) over the law of one ball and the ring (the positions of the balls, and sums over them)
//! to the bearing at its place on the shaft.

mod bearing_friction;
mod cage;
pub(crate) mod catalogue;
mod clearance;
pub(crate) mod definition;
mod dual;
mod error;
mod estimate;
mod fit;
mod free_position;
mod geometry;
mod geometry_error;
pub(crate) mod law;
mod life;
pub(crate) mod number;
pub(crate) mod ring;
mod ring_contacts;
mod ring_forces;
mod rollers;
pub(crate) mod rotation;
mod seat;
mod state;
mod static_rating;
pub(crate) mod support;
pub(crate) mod surface;
mod warnings;

pub(crate) use cage::CageMotion;
pub use catalogue::{CATALOGUE, Catalogue, CatalogueEntry, RollerEntry, UnknownBearing};
pub use clearance::{Clearance, ClearanceClass};
pub use definition::{Bearing, Oil};
pub(crate) use definition::{
    ContactDamping, Facing, Housing, Lubrication, MountedBearing, Preload, Resonator,
};
pub use error::BearingError;
pub(crate) use estimate::REFERENCE_GROOVES;
pub use estimate::{
    Candidate, CatalogueLine, Estimate, EstimateError, RollerCandidate, RollerEstimate, RollerLine,
};
pub use fit::Fit;
pub use free_position::FreePosition;
pub use geometry::Geometry;
pub use geometry_error::GeometryError;
pub(crate) use law::{
    Ball, BallForce, BallLaw, ContactLaw, ForceLaw, RaceContacts, RaceFilms, TableError,
    TableReport,
};
pub use law::{BallContact, Lamina, PERMISSIBLE_PRESSURE, permissible_static_load};
#[cfg(test)]
pub(crate) use law::{
    BallRegion, BallState, BallTable, HertzFilmLaw, HertzLaw, JonesFilmLaw, JonesLaw,
};
pub(crate) use life::RatingLife;
pub use life::{ModifiedLife, RatingLives, reference_rating_life};
pub use ring::{Matrix5, Vector5};
pub(crate) use ring::{Ring, quarter_turn};
pub use ring_contacts::BallLoads;
pub use rollers::{Profile, ProfilePoints, RollerKind, Rollers, Slice};
pub(crate) use rotation::{Angle, BearingRotation};
pub(crate) use state::{Around, FitState, GeometryState, StiffnessShares};
pub use state::{
    BallLine, BearingState, Elements, FilmState, FrictionMoment, InternalGeometry, LaminaLine,
    RaceContact, RollerGeometry, SkfMoment,
};
pub(crate) use support::{ContactBand, LOADED_SHARE, Support};
pub use surface::Surface;
pub(crate) use surface::{CageJitter, Defect, Imperfections, Passing, RaceSpall, SideView, Wave};
pub(crate) use surface::{DefectProfile, ImperfectionError, check_ball};
