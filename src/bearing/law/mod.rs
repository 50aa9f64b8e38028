//! The laws of one ball: from the position of the inner groove centre to loads and forces.
//!
//! [`BallLaw`] is what a law is; each law is a file or a folder here and a line in `list`. Outside this folder
//! nothing knows how a contact bears.

mod film_shares;
mod film_spring;
mod hertz;
mod hertz_film;
mod jones;
mod law;
mod list;
mod races;
mod spring;
mod table;

pub(super) use film_shares::Share;
pub use film_spring::FilmSpring;
pub use hertz::HertzLaw;
pub use hertz_film::HertzFilmLaw;
pub use jones::{BallState, JonesFilmLaw, JonesLaw};
pub use law::{Ball, BallContact, BallForce, BallLaw, BallResponse, BallTangent, ForceLaw};
pub(super) use list::{Law, with_law};
pub use races::{DryRaces, FilmThickness, LubricatedRaces, RaceFilms, Races};
pub use spring::{ContactSpring, HertzSpring};
pub use table::{BallRegion, BallTable, TableError, TableReport};
