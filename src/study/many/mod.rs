//! Many runs of one scenario: which there are, in which order, on how many threads, and what is kept.

mod chain;
mod numbers;
mod record;
mod schedule;

pub use chain::{KeptTrace, Maker, Unmade};
pub use numbers::{NumberColumn, number_columns};
pub use record::{BearingStiffness, RunRecord, TraceSeal};
pub use schedule::{Cycles, Direction, Schedule, Shard, Sweep, Turn, work};

use crate::analysis::SectionKind;

/// What is kept of every run, beside its numbers.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Keep {
    /// Highest order up to which the amplitudes of the displacements are kept; none where `None`.
    pub highest_order: Option<f64>,
    /// Whether the stiffness of every bearing at the static equilibrium is kept.
    pub bearing_stiffness: bool,
    /// Whether the trace of every run is kept.
    pub traces: bool,
    /// The section whose points are kept, where any are.
    pub section: Option<SectionKind>,
}
