//! Where a state lies between the event surfaces.

use super::System;
use super::chunks::Padded;

/// Part of the distance of the nearest event surface within which no further check is made: within a step
/// the state moves farther than between its ends.
const SAFE: f64 = 0.7;
/// The event functions in a state.
#[derive(Debug, Clone)]
pub(super) struct EventCheck {
    time: f64,
    pub state: Padded,
    /// How far the state is past each surface.
    pub values: Vec<f64>,
    /// Least distance of a surface; zero where nothing is known.
    pub nearest: f64,
}

impl EventCheck {
    /// Nothing known yet.
    pub fn none(system: &dyn System) -> Self {
        let events = system.event_count();
        Self {
            time: 0.0,
            state: Padded::zeros(system.states()),
            values: vec![0.0; events],
            nearest: if events == 0 { f64::INFINITY } else { 0.0 },
        }
    }

    /// Evaluates the event functions in a state at a time, s.
    pub fn evaluate(&mut self, system: &dyn System, time: f64, state: &[f64]) {
        if self.values.is_empty() {
            return;
        }
        self.time = time;
        self.state.copy_from_slice(state);
        system.events(time, state, &mut self.values);
        let distances = self.values.iter().map(|value| value.abs());
        self.nearest = distances.fold(f64::INFINITY, f64::min);
    }

    /// Whether it is certain that no surface lies between the state of the check and another one.
    pub fn is_clear(&self, system: &dyn System, time: f64, state: &[f64]) -> bool {
        if self.nearest == f64::INFINITY {
            return true;
        }
        if self.nearest <= 0.0 {
            return false;
        }
        system.event_change([self.time, time], [&self.state, state]) < SAFE * self.nearest
    }

    /// Whether the state is past a surface.
    pub fn is_past(&self, event: usize) -> bool {
        self.values[event].is_sign_positive()
    }

    /// Whether any surface lies between two states.
    pub fn differs_from(&self, other: &Self) -> bool {
        (0..self.values.len()).any(|event| self.is_past(event) != other.is_past(event))
    }
}
