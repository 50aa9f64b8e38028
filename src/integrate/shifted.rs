//! A system whose clock starts later.

use nalgebra::SMatrix;

use super::{Linearised, System};

/// The same system with its time counted from `start`, s.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Shifted<'a, S> {
    /// The system.
    pub system: &'a S,
    /// Its time where the shifted one is zero, s.
    pub start: f64,
}

impl<const N: usize, S: System<N>> System<N> for Shifted<'_, S> {
    #[inline]
    fn derivative(&self, time: f64, state: &[f64; N], rate: &mut [f64; N]) {
        self.system.derivative(self.start + time, state, rate);
    }

    fn next_break(&self, after: f64) -> f64 {
        self.system.next_break(self.start + after) - self.start
    }

    fn is_second_order(&self) -> bool {
        self.system.is_second_order()
    }
}

impl<const N: usize, S: Linearised<N>> Linearised<N> for Shifted<'_, S> {
    fn linearisation(&self, time: f64, state: &[f64; N]) -> (SMatrix<f64, N, N>, [f64; N]) {
        self.system.linearisation(self.start + time, state)
    }
}
