//! The times at which states are handed out, and those states.

/// Uniform grid of times: `t_k = k · interval`, k = 0 … count − 1.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Grid {
    /// Distance of two grid times, s, positive.
    pub interval: f64,
    /// Number of grid times.
    pub count: u64,
}

impl Grid {
    /// Time of a grid point, s; free of accumulated round-off.
    pub fn time(&self, index: u64) -> f64 {
        index as f64 * self.interval
    }
}

/// A list of states of the same number of components.
#[derive(Debug, Clone, PartialEq)]
pub struct States {
    width: usize,
    values: Vec<f64>,
}

impl States {
    /// No states yet, each to be of `width` components, at least one.
    pub fn new(width: usize) -> Self {
        Self::with_capacity(width, 0)
    }

    /// As [`States::new`], with room for so many states.
    pub fn with_capacity(width: usize, states: usize) -> Self {
        Self {
            width,
            values: Vec::with_capacity(width * states),
        }
    }

    /// Appends a state.
    pub fn push(&mut self, state: &[f64]) {
        debug_assert_eq!(state.len(), self.width);
        self.values.extend_from_slice(state);
    }

    /// Number of states.
    pub fn len(&self) -> usize {
        self.values.len() / self.width
    }

    /// Removes all states.
    pub fn clear(&mut self) {
        self.values.clear();
    }

    /// The states in their order.
    pub fn iter(&self) -> std::slice::ChunksExact<'_, f64> {
        self.values.chunks_exact(self.width)
    }

    /// One of them.
    pub fn get(&self, index: usize) -> Option<&[f64]> {
        self.iter().nth(index)
    }

    /// The last of them.
    pub fn last(&self) -> Option<&[f64]> {
        self.iter().next_back()
    }

    /// All numbers, state by state.
    pub fn as_slice(&self) -> &[f64] {
        &self.values
    }
}
