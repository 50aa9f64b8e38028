//! Law of a ball with inertia, after Jones.

mod balance;
mod contact;
mod inertia;
mod law;
mod plane;
mod rate;
mod solve;
mod start;

pub use law::{BallState, JonesLaw};
