//! What can be integrated.

use nalgebra::DMatrix;

use super::Separated;

/// A system of first-order differential equations.
///
/// The derivative must be a pure function of time and state, or the error estimate lies. Where it
/// has no value it writes NaN; the integration then ends with an error that says when.
pub trait System {
    /// Number of states.
    fn states(&self) -> usize;

    /// Writes `d(state)/dt` at a time in s into `rate`.
    fn derivative(&self, time: f64, state: &[f64], rate: &mut [f64]);

    /// Writes `∂f/∂y`, rows by component of f: every entry. By default NaN, for a system that does not know its slopes;
    /// explicit methods do not ask for them.
    fn linearisation(&self, _time: f64, _state: &[f64], jacobian: &mut DMatrix<f64>) {
        jacobian.fill(f64::NAN);
    }

    /// Writes `∂f/∂t` at a fixed state: every entry. By default NaN, for a system that does not know it; only `rodas` asks
    /// for it.
    fn rate_by_time(&self, _time: f64, _state: &[f64], by_time: &mut [f64]) {
        by_time.fill(f64::NAN);
    }

    /// The derivative as a linear part and forces that few states decide, about a state at a time; none of a system of
    /// which this is not known, or where it saves nothing.
    fn separated(&self, _time: f64, _state: &[f64]) -> Option<Separated> {
        None
    }

    /// Writes the forces w of [`System::separated`], by the states that it says they depend on: what is in the others
    /// is of no matter, and neither is what is written for forces that never act.
    fn forces(&self, _time: f64, _state: &[f64], forces: &mut [f64]) {
        forces.fill(0.0);
    }

    /// Slopes of the forces w of [`System::separated`], of those that act by the states that they depend on.
    fn force_slopes(
        &self,
        _time: f64,
        _state: &[f64],
        seen: &[usize],
        acting: &[usize],
    ) -> DMatrix<f64> {
        DMatrix::zeros(acting.len(), seen.len())
    }

    /// The first time after `after`, in s, at which the derivative or its slope by time jumps, as
    /// where a shock begins; infinite where it is smooth from there on. No step reaches over such a
    /// time, so none can miss what begins there.
    fn next_break(&self, _after: f64) -> f64 {
        f64::INFINITY
    }

    /// Number of event surfaces: surfaces in the state space at which the derivative is not smooth.
    fn event_count(&self) -> usize {
        0
    }

    /// Writes the event functions: how far the state is past every event surface, negative before it. Each is
    /// continuous, with a simple zero at its surface. Where the derivative is separated, they depend on the states that
    /// its forces do.
    fn events(&self, _time: f64, _state: &[f64], _values: &mut [f64]) {}

    /// One of the event functions.
    fn event(&self, event: usize, time: f64, state: &[f64]) -> f64 {
        let mut values = vec![0.0; self.event_count()];
        self.events(time, state, &mut values);
        values[event]
    }

    /// Writes an upper bound of the force jump: what each component of the derivative gains at a distance past an
    /// event surface.
    fn force_jump(&self, _event: usize, _time: f64, _distance: f64, rate: &mut [f64]) {
        rate.fill(0.0);
    }

    /// Power of the distance that the force jump past an event surface grows with: 1 for a spring with a gap, 3/2 for a
    /// ball on a race. A whole power is smooth on either side of its surface, a broken one is not.
    fn event_exponent(&self, _event: usize) -> f64 {
        1.0
    }
}

/// Makes every component of a state a number of order one: `scaled = (state − origin)/scale`.
///
/// Tolerances then mean the same for a displacement of a nanometre and a speed of a metre per
/// second.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct Scaling {
    /// State that becomes zero.
    pub origin: Vec<f64>,
    /// Size of one unit of each component, positive.
    pub scale: Vec<f64>,
    /// Unit of time, s, positive.
    pub time: f64,
}

impl Scaling {
    /// The scaling of so many states that changes nothing.
    #[cfg(test)]
    pub fn identity(states: usize) -> Self {
        Self {
            origin: vec![0.0; states],
            scale: vec![1.0; states],
            time: 1.0,
        }
    }

    /// Writes the state of scaled numbers.
    pub fn write_state(&self, scaled: &[f64], state: &mut [f64]) {
        let units = self.origin.iter().zip(&self.scale);
        for ((state, scaled), (origin, scale)) in state.iter_mut().zip(scaled).zip(units) {
            *state = origin + scale * scaled;
        }
    }

    /// The state of scaled numbers.
    pub fn state(&self, scaled: &[f64]) -> Vec<f64> {
        let mut state = vec![0.0; self.scale.len()];
        self.write_state(scaled, &mut state);
        state
    }

    /// Scaled numbers of a state.
    pub fn scaled(&self, state: &[f64]) -> Vec<f64> {
        let units = self.origin.iter().zip(&self.scale);
        let scaled = |(state, (origin, scale)): (&f64, (&f64, &f64))| (state - origin) / scale;
        state.iter().zip(units).map(scaled).collect()
    }

    /// Deviation from the origin of scaled numbers.
    pub(super) fn deviation(&self, scaled: &[f64]) -> Vec<f64> {
        let units = self.scale.iter().zip(scaled);
        units.map(|(scale, scaled)| scale * scaled).collect()
    }

    /// `∂f/∂y` in scaled states, in place.
    pub fn scale_jacobian(&self, jacobian: &mut DMatrix<f64>) {
        for (column, mut entries) in jacobian.column_iter_mut().enumerate() {
            for (row, entry) in entries.iter_mut().enumerate() {
                *entry *= self.scale[column] / self.scale[row];
            }
        }
    }
}

/// A system with its time counted from `start`, s.
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

    fn linearisation(&self, time: f64, state: &[f64], jacobian: &mut DMatrix<f64>) {
        let system = self.system;
        system.linearisation(self.start + time, state, jacobian);
    }

    fn rate_by_time(&self, time: f64, state: &[f64], by_time: &mut [f64]) {
        let system = self.system;
        system.rate_by_time(self.start + time, state, by_time);
    }

    fn separated(&self, time: f64, state: &[f64]) -> Option<Separated> {
        self.system.separated(self.start + time, state)
    }

    fn forces(&self, time: f64, state: &[f64], forces: &mut [f64]) {
        self.system.forces(self.start + time, state, forces);
    }

    fn force_slopes(
        &self,
        time: f64,
        state: &[f64],
        seen: &[usize],
        acting: &[usize],
    ) -> DMatrix<f64> {
        let system = self.system;
        system.force_slopes(self.start + time, state, seen, acting)
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

    fn event(&self, event: usize, time: f64, state: &[f64]) -> f64 {
        self.system.event(event, self.start + time, state)
    }

    fn force_jump(&self, event: usize, time: f64, distance: f64, rate: &mut [f64]) {
        let system = self.system;
        system.force_jump(event, self.start + time, distance, rate);
    }

    fn event_exponent(&self, event: usize) -> f64 {
        self.system.event_exponent(event)
    }
}
