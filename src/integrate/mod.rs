//! From a derivative to states on a time grid, with error control.
//!
//! A [`System`] is a pure function of time and state. An [`Integration`] carries its state along a
//! uniform [`Grid`] of times and hands out the states there, a block at a time, so that memory does
//! not grow with the duration.

mod adapter;
mod auto;
mod block;
mod checkpoint;
mod control;
mod course;
mod error;
mod explicit;
mod exponential;
mod integration;
mod look;

mod rosenbrock;
mod settings;
mod shifted;
mod stepper;
mod stiffness;
mod stride;
mod system;
mod variation;

pub use auto::{ChangeReason, MethodUse};
pub use checkpoint::{Checkpoint, CheckpointMismatch, SEGMENT};
pub use error::IntegrateError;
pub use integration::{Grid, Integration};

pub use settings::{Counters, Method, Settings};
pub use shifted::Shifted;
pub use stiffness::Stiffness;
pub use system::{Linearised, Scaling, Sides, Square, Surroundings, System};
pub use variation::{Variation, variation};
