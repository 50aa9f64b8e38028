//! What an integration needs to go on another time.

use super::{Counters, Stiffness};

/// Where an integration stands between two blocks of its grid: plain numbers, from which another
/// integration of the same system, scaling, grid and settings goes on to the very same states.
#[derive(Debug, Clone, PartialEq)]
pub struct Checkpoint {
    /// Scaled state at the next grid time.
    pub scaled: Vec<f64>,
    /// Number of grid times handed out.
    pub next: u64,
    /// Step size to go on with, s.
    pub step: f64,
    /// The latest step of an explicit pair of this crate or of the exponential method, number by number:
    /// it may reach beyond the grid time. Zeros with every other method.
    pub latest_step: Vec<f64>,
    /// Work done so far.
    pub counters: Counters,
    /// Stiffness, where it was seen.
    pub stiffness: Option<Stiffness>,
}

/// A checkpoint of another integration.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
#[error(
    "a checkpoint of {states} states at grid time {next} belongs to another integration: this one \
     has {expected} states and {count} grid times"
)]
pub struct CheckpointMismatch {
    /// States of the checkpoint.
    pub states: usize,
    /// Grid times that were handed out before it.
    pub next: u64,
    /// States of the integration.
    pub expected: usize,
    /// Grid times of the integration.
    pub count: u64,
}
