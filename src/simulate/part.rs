//! A run in parts: where it stopped, what was kept, and how it goes on.

use std::io;

use serde::{Deserialize, Serialize};

use super::SimulateError;
use super::passes::Passes;
use crate::integrate::{Checkpoint, Counters, Pace, States};
use crate::rotor::MotionScale;

/// Keeps the states of a run, from which another part goes on.
pub trait StateKeeper {
    /// Takes the states of further samples, one after the other.
    ///
    /// # Errors
    /// Whatever keeps it from taking them; the run ends there.
    fn keep(&mut self, states: &[f64]) -> io::Result<()>;
}

/// Gives the states of an earlier part back in their order.
pub trait StateSource {
    /// Fills `states` with the next numbers that were kept.
    ///
    /// # Errors
    /// Whatever keeps it from giving them, as a file that ends too early.
    fn fill(&mut self, states: &mut [f64]) -> io::Result<()>;
}

/// Where a run stands after whole blocks of samples: what it takes to go on.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Standing {
    /// Time of the next sample, s.
    pub time: f64,
    /// What the tolerance is relative to.
    pub scale: MotionScale,
    /// The integration.
    pub main: Checkpoint,
    /// The second pass, where the run has one.
    pub reference: Option<ReferenceStanding>,
    /// The pass with more modes of a shaft that bends, where the run has one.
    #[serde(default)]
    pub finer: Option<ReferenceStanding>,
}

/// Where the second pass stands, and how far the first has been from it.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct ReferenceStanding {
    /// The integration.
    pub pass: Checkpoint,
    /// Largest difference of a displacement so far, m.
    pub difference: f64,
    /// Why the pass cannot go on, where it cannot.
    pub failure: Option<String>,
}

/// An earlier part of the same run.
pub struct Earlier<'a> {
    /// Where it stopped.
    pub standing: Standing,
    /// The states of all samples before.
    pub states: &'a mut dyn StateSource,
}

/// One part of a run: where it begins and stops, and how far it came.
///
/// The samples of the earlier part are made anew from their states, so that every taker of samples
/// sees the whole run; what comes of a run in parts is bit by bit what comes of it in one go.
pub struct Part<'a> {
    /// The part before; `None`: the run begins.
    pub earlier: Option<Earlier<'a>>,
    /// The run stops at the first end of a block of samples at or after this time, s.
    pub stop_at: f64,
    /// Takes the states, where another part is to follow.
    pub keeper: Option<&'a mut dyn StateKeeper>,
    /// Where the two passes note how they get on, for who watches them.
    pub paces: [Option<&'a Pace>; 2],
    /// Where the run stood at its latest end of a block: set by the run.
    pub standing: Option<Standing>,
    /// Work done, also in the block that failed: set by the run.
    pub counters: Counters,
}

impl Default for Part<'_> {
    /// The whole run.
    fn default() -> Self {
        Self {
            earlier: None,
            stop_at: f64::INFINITY,
            keeper: None,
            paces: [None; 2],
            standing: None,
            counters: Counters::default(),
        }
    }
}

impl Part<'_> {
    /// The states of the earlier part from sample `from` on, `most` at most, and none after its last
    /// one; they are kept for the part that follows this.
    pub(super) fn replay(
        &mut self,
        from: u64,
        most: usize,
        states: &mut States,
    ) -> Result<(), SimulateError> {
        states.clear();
        if let Some(earlier) = &mut self.earlier {
            let left = earlier.standing.main.next - from;
            let count = usize::try_from(left).unwrap_or(usize::MAX).min(most);
            let filled = earlier.states.fill(states.resized(count));
            filled.map_err(SimulateError::Replay)?;
        }
        self.keep(states)
    }

    /// Keeps the states of a whole block.
    pub(super) fn keep(&mut self, states: &States) -> Result<(), SimulateError> {
        match &mut self.keeper {
            Some(keeper) => keeper.keep(states.as_slice()).map_err(SimulateError::Keep),
            None => Ok(()),
        }
    }

    /// Takes note of the end of a block, and stops there where the part ends.
    pub(super) fn stand(&mut self, passes: &Passes<'_>) -> Result<(), SimulateError> {
        let standing = self.standing.insert(passes.standing());
        match standing.time {
            time if time >= self.stop_at => Err(SimulateError::Stopped { time }),
            _ => Ok(()),
        }
    }
}
