//! What an integration needs to go on another time.

use serde::{Deserialize, Serialize};

use super::{Counters, MethodUse, Stiffness};

/// Samples of a segment: at the end of each the method begins afresh, so that one that goes on from there is the same
/// by construction.
pub const SEGMENT: u64 = 4096;

/// Where an integration stands at the end of a segment of its grid: another integration of the same system, scaling,
/// grid and settings goes on from it to the very same states.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Checkpoint {
    /// Number of the grid time.
    pub next: u64,
    /// Scaled state there.
    pub scaled: Vec<f64>,
    /// Size of the step to go on with, s.
    pub step: f64,
    /// Work done so far.
    pub counters: Counters,
    /// Stiffness, where it was seen.
    pub stiffness: Option<Stiffness>,
    /// Which method carried the run, where the choice is left open.
    pub method_use: Option<MethodUse>,
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
    /// Number of its grid time.
    pub next: u64,
    /// States of the integration.
    pub expected: usize,
    /// Grid times of the integration.
    pub count: u64,
}
