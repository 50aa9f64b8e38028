//! A look around at the surfaces about a state.

use super::{Sides, System};

/// Part of the distance of the nearest surface that may be walked without another look: within a step
/// the way is longer than between its ends.
const SAFE: f64 = 0.7;

/// What was seen from a state.
#[derive(Debug, Clone, Copy)]
pub(super) struct Look<const N: usize> {
    pub sides: Sides,
    time: f64,
    state: [f64; N],
    /// Distance of the nearest surface.
    pub nearest: f64,
    /// The same wherever surfaces are by the time, where that is known.
    clearance: f64,
}

impl<const N: usize> Look<N> {
    /// From where nothing is known.
    pub const NONE: Self = Self {
        sides: 0,
        time: 0.0,
        state: [0.0; N],
        nearest: 0.0,
        clearance: 0.0,
    };

    /// From a state at a time, s.
    pub fn around<S: System<N>>(system: &S, time: f64, state: [f64; N]) -> Self {
        let seen = system.surroundings(time, &state);
        Self {
            sides: seen.sides,
            time,
            state,
            nearest: seen.nearest,
            clearance: system.clearance(&state),
        }
    }

    /// Whether another state is nearer than any surface was.
    pub fn is_clear<S: System<N>>(&self, system: &S, time: f64, state: &[f64; N]) -> bool {
        if self.nearest == f64::INFINITY {
            return true;
        }
        // a look that was never taken is near to everything
        if self.nearest <= 0.0 {
            return false;
        }
        if self.clearance > 0.0 && system.shift([&self.state, state]) < SAFE * self.clearance {
            return true;
        }
        let walked = system.approach([self.time, time], [&self.state, state]);
        walked < SAFE * self.nearest
    }
}
