//! The times at which states are handed out.

/// Uniform grid of times: `t_k = k · interval`, k = 0 … count − 1.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Grid {
    /// Distance of two grid times, s, positive.
    pub interval: f64,
    /// Number of grid times.
    pub count: u64,
}

/// Distance, as a part of the grid's interval, below which a break does not divide a step.
const BREAK_SLACK: f64 = 1e-6;

impl Grid {
    /// Time of a grid point, s; free of accumulated round-off.
    pub fn time(&self, index: u64) -> f64 {
        index as f64 * self.interval
    }

    /// Breaks nearer than this to a grid time, or to another break, count as standing there, s.
    pub(super) fn slack(&self) -> f64 {
        BREAK_SLACK * self.interval
    }
}
