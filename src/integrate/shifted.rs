//! A system whose clock starts later.

use nalgebra::SMatrix;

use super::{Linearised, Surroundings, System};

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

    fn surroundings(&self, time: f64, state: &[f64; N]) -> Surroundings {
        self.system.surroundings(self.start + time, state)
    }

    fn past(&self, surface: u32, time: f64, state: &[f64; N]) -> f64 {
        self.system.past(surface, self.start + time, state)
    }

    fn approach(&self, times: [f64; 2], states: [&[f64; N]; 2]) -> f64 {
        let times = times.map(|time| self.start + time);
        self.system.approach(times, states)
    }

    fn clearance(&self, state: &[f64; N]) -> f64 {
        self.system.clearance(state)
    }

    fn shift(&self, states: [&[f64; N]; 2]) -> f64 {
        self.system.shift(states)
    }

    fn added(&self, surface: u32, time: f64, distance: f64) -> [f64; N] {
        self.system.added(surface, self.start + time, distance)
    }

    fn is_second_order(&self) -> bool {
        self.system.is_second_order()
    }

    fn expects_crossings(&self) -> bool {
        self.system.expects_crossings()
    }
}

impl<const N: usize, S: Linearised<N>> Linearised<N> for Shifted<'_, S> {
    fn linearisation(&self, time: f64, state: &[f64; N]) -> (SMatrix<f64, N, N>, [f64; N]) {
        self.system.linearisation(self.start + time, state)
    }
}
