//! From a derivative to states on a time grid, with error control.
//!
//! A [`System`] is a pure function of time and state. An [`Integration`] carries its state along a
//! uniform [`Grid`] of times and hands out the states there, a block at a time, so that memory does
//! not grow with the duration.

mod chunks;
mod error;
mod explicit;
mod exponential;
mod grid;
mod integration;
mod library;
mod problem;
mod rosenbrock;
mod separated;
mod settings;
mod stepper;
mod stiffness;
mod system;
mod variation;

pub use error::IntegrateError;
pub use grid::{Grid, States};
pub use integration::Integration;
pub use separated::Separated;
pub use settings::{Counters, Method, Progress, Settings};
pub use stepper::{ChangeReason, MethodUse, Prepared};
pub use stiffness::Stiffness;
pub use system::{Scaling, Shifted, System};
pub use variation::{linear_variation, variation};
