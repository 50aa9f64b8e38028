//! A system whose clock starts later.

use nalgebra::DMatrix;

use super::System;

/// The same system with its time counted from `start`, s.
#[derive(Clone, Copy)]
pub struct Shifted<'a> {
    /// The system.
    pub system: &'a dyn System,
    /// Its time where the shifted one is zero, s.
    pub start: f64,
}

impl System for Shifted<'_> {
    fn states(&self) -> usize {
        self.system.states()
    }

    fn derivative(&self, time: f64, state: &[f64], rate: &mut [f64]) {
        self.system.derivative(self.start + time, state, rate);
    }

    fn linearisation(
        &self,
        time: f64,
        state: &[f64],
        jacobian: &mut DMatrix<f64>,
        by_time: &mut [f64],
    ) {
        let system = self.system;
        system.linearisation(self.start + time, state, jacobian, by_time);
    }

    fn next_break(&self, after: f64) -> f64 {
        self.system.next_break(self.start + after) - self.start
    }

    fn event_count(&self) -> usize {
        self.system.event_count()
    }

    fn events(&self, time: f64, state: &[f64], values: &mut [f64]) {
        self.system.events(self.start + time, state, values);
    }

    fn event_change(&self, times: [f64; 2], states: [&[f64]; 2]) -> f64 {
        let times = times.map(|time| self.start + time);
        self.system.event_change(times, states)
    }

    fn force_jump(&self, event: usize, time: f64, distance: f64, rate: &mut [f64]) {
        let system = self.system;
        system.force_jump(event, self.start + time, distance, rate);
    }

    fn expects_crossings(&self) -> bool {
        self.system.expects_crossings()
    }
}
