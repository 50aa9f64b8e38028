//! A block of the time grid, the unit that every method integrates over.

use std::sync::atomic::AtomicBool;

use super::{Counters, IntegrateError, Scaling, Settings};

/// Error allowed in one step, as a part of the error aimed at over the run: local errors add up.
const LOCAL_PART: f64 = 0.25;
/// A block of the grid to integrate over.
pub(super) struct Block<'a, S, const N: usize> {
    pub system: &'a S,
    pub scaling: &'a Scaling<N>,
    pub settings: &'a Settings,
    pub stop: &'a AtomicBool,
    /// Time at the start of the block, s.
    pub start: f64,
    /// Distance of the grid points, s.
    pub interval: f64,
    /// Number of intervals in the block.
    pub intervals: usize,
    /// Step size to start with in s; zero lets the method choose.
    pub first_step: f64,
    /// Steps that are left of the limit.
    pub steps_left: u64,
    /// Time at which the whole integration ends, s.
    pub run_end: f64,
}

/// What came of a block.
pub(super) struct Outcome<const N: usize> {
    /// Scaled states at the grid points, the first at the block's start, the end left out.
    pub states: Vec<[f64; N]>,
    /// Scaled state at the end of the block.
    pub end: [f64; N],
    /// A good step size to go on with, s.
    pub last_step: f64,
    pub counters: Counters,
    pub error: Option<IntegrateError>,
}

impl<S, const N: usize> Block<'_, S, N> {
    /// Error allowed in one step, relative to one plus the scaled state.
    pub fn local_tolerance(&self) -> f64 {
        LOCAL_PART * self.settings.tolerance
    }
}
