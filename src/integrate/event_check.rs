//! Where a state lies between the event surfaces, and the error of a step over one.

use super::System;
use super::chunks::Padded;
use super::problem::Problem;

/// Part of the distance of the nearest event surface within which no further check is made: within a step
/// the state moves farther than between its ends.
const SAFE: f64 = 0.7;
/// Error of a step over its size and the force jump over a short part at its end, over that part:
/// ∫ x^(3/2), for none of it need be seen.
const CROSSED_AT_END: f64 = 0.4;

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

/// A step over event surfaces, or to one.
pub(super) struct EventStep<'a> {
    pub problem: &'a Problem<'a>,
    /// Deviation at its start.
    pub from: &'a [f64],
    /// Its end and its size, s.
    pub end: f64,
    pub size: f64,
    /// Event functions at its start and at its end.
    pub ends: [&'a [f64]; 2],
}

impl EventStep<'_> {
    /// How far both ends are past a surface.
    pub fn ends_past(&self, event: usize) -> [f64; 2] {
        self.ends.map(|values| values[event])
    }

    /// Error of crossing a surface somewhere, over the tolerance, by a method whose error is a part `crossed` of its
    /// size and the force jump over all of it.
    pub fn error_over(&self, event: usize, crossed: f64, rate: &mut [f64]) -> f64 {
        let [from, to] = self.ends_past(event);
        let (past, apart) = (from.max(to), (from - to).abs());
        let anywhere = crossed * self.weight(event, apart, rate);
        let at_end = CROSSED_AT_END * past / apart * self.weight(event, past, rate);
        anywhere.min(at_end)
    }

    /// Error of a step that was to end on a surface, over the tolerance.
    pub fn error_beside(&self, event: usize, rate: &mut [f64]) -> f64 {
        let [from, to] = self.ends_past(event);
        let part = to.abs() / (from - to).abs();
        CROSSED_AT_END * part * self.weight(event, to.abs(), rate)
    }

    /// Change of the state over the step by the force jump at a distance, over the tolerance.
    fn weight(&self, event: usize, distance: f64, rate: &mut [f64]) -> f64 {
        let system = self.problem.system;
        system.force_jump(event, self.end, distance, rate);
        self.problem.norm(self.from, rate) * self.size
    }
}
