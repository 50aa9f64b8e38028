//! The method that is chosen on the way: each of a few carries the motion on for a while, and the one that
//! costs least per simulated time goes on with it.
//!
//! Nothing is tried beside the run: a stretch on trial is a stretch of the run, to the same error as any
//! other. What counts as cost are evaluations, linear parts and step sizes at prices that are part of the
//! code, so that the same scene takes the same steps on every machine.

mod beforehand;
mod blows;
mod choice;
mod cost;
mod numbers;
mod promises;
mod rest;
mod selector;
mod usage;
mod walk;

pub use usage::{MethodChange, MethodUse, Stretch};
pub(super) use walk::AutoWalk;
