//! What steps and samples of the methods cost, s on one core of one server: by `benches/method_map`, and where
//! that tells no parts, by counts of instructions.

use crate::integrate::{Effort, Method};

/// The methods that are chosen from.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Way {
    Verner76,
    Dop853,
    Dprkn8,
    Exponential,
}

impl Way {
    /// As users know it.
    pub(super) fn method(self) -> Method {
        match self {
            Self::Verner76 => Method::Verner76,
            Self::Dop853 => Method::Dop853,
            Self::Dprkn8 => Method::Dprkn8,
            Self::Exponential => Method::Exponential,
        }
    }
}

/// All of them, in the order of their numbers.
pub(super) const WAYS: [Way; 4] = [Way::Verner76, Way::Dop853, Way::Dprkn8, Way::Exponential];

/// What an explicit pair does with each state of an evaluation: one of Nyström's has half of the sums, and its
/// integrating factor takes as long as the other half.
const EXPLICIT: f64 = 3.7e-9;
/// What the exponential method does with an evaluation, and with each entry of a matrix.
const EXPONENTIAL: [f64; 2] = [98e-9, 0.3e-9];
/// The modes of a linear part, and their functions over a step size, for each state: what is summed up beside a
/// motion costs little there.
const MODES: f64 = 6e-6;
const FUNCTIONS: f64 = 0.65e-6;
/// Step sizes that are gone through before steps have found theirs.
const FIRST_SIZES: f64 = 10.0;

/// What a step of a Nyström pair that has samples begins with for them, with each state, and what it does with
/// a sample.
const NYSTROM_SAMPLES: f64 = 33e-9;
const NYSTROM_SAMPLE: f64 = 4.5e-9;

/// Prices for a system.
#[derive(Debug, Clone, Copy)]
pub(super) struct Prices {
    /// Of an evaluation, by way.
    pub evaluation: [f64; WAYS.len()],
    /// Of a sample by the Nyström pair, and of what its step that has samples begins with for them; beyond those of
    /// the other methods, which cost about the same.
    pub nystrom_sample: f64,
    pub nystrom_first_sample: f64,
    /// Of a linear part with its modes, and of their functions over a step size.
    pub linear_part: f64,
    pub step_size: f64,
}

impl Prices {
    /// For a system of so many states.
    pub fn new(effort: Effort, states: usize) -> Self {
        let n = states as f64;
        let explicit = effort.derivative + EXPLICIT * n;
        let exponential = effort.derivative + EXPONENTIAL[0] + EXPONENTIAL[1] * n * n;
        Self {
            evaluation: [explicit, explicit, explicit, exponential],
            nystrom_sample: NYSTROM_SAMPLE * n,
            nystrom_first_sample: NYSTROM_SAMPLES * n,
            linear_part: effort.linearisation + MODES * n,
            step_size: FUNCTIONS * n,
        }
    }

    /// Of what the exponential method begins with.
    pub fn first_steps(&self) -> f64 {
        self.linear_part + FIRST_SIZES * self.step_size
    }
}
