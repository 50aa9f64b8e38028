//! Law of a ball with inertia, after Jones.
//!
//! `inertia` gives the inertia forces for two contacts, `balance` the sum of forces at a trial
//! position with its derivatives, `solve` the position of rest from a first guess, `law` what the
//! rest of the crate sees of it.

mod balance;
mod inertia;
mod law;
mod solve;

pub use law::{JonesFilmLaw, JonesLaw};
