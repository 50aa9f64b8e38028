//! Law of a ball with inertia, after Jones.
//!
//! `inertia` gives the inertia forces for two contacts, `balance` the sum of forces at a trial
//! position with its derivatives, `start` a first guess, `solve` the place of rest, `law` what the
//! rest of the crate sees of it.

mod balance;
mod contact;
mod inertia;
mod law;
mod solve;
mod start;
mod state;

pub use law::{JonesFilmLaw, JonesLaw};
pub use state::BallState;
