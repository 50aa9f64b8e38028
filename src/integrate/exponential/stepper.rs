//! Steps of the method, one after the other, and the states at samples within them.

use nalgebra::DMatrix;

use super::dense::Cursor;
use super::linear::{LinearPart, ModalState};
use super::nodes::{NODES, POINTS, Points, combined, no_points, weights};
use super::plan::Span;
use super::propagator::Propagators;
use super::slopes::StepSlopes;
use super::sweeps::{self, Outcome, Sweeps, Trial};
use crate::integrate::chunks::Padded;
use crate::integrate::problem::{Control, GROW, Problem};
use crate::integrate::stepper::{MethodStepper, Reached, Start};
use crate::integrate::{Counters, IntegrateError};
use crate::numerics::registers::in_wide_registers;

/// What the method has found out on a motion and goes on with on another one of the same system: the linear part of the
/// latest step with its operators, whether another one is due, and how long the next step may be.
#[derive(Debug, Clone)]
pub struct PreparedSteps {
    linear: LinearPart,
    propagators: Propagators,
    excess: u32,
    requested: f64,
}

/// Sweeps that cost as much as a new linear part, by their operations: some 25 n³ for its modes and 7 · 2n² and more for
/// each point of a sweep.
fn renewal_cost(states: usize) -> u32 {
    3 * states as u32
}

/// The latest step, and how to go on. States are kept as deviations from the scaling's origin.
pub(in crate::integrate) struct ExponentialStepper {
    /// Start and end of the latest step, s.
    start: f64,
    time: f64,
    /// Size that the error would allow the next step, s.
    requested: f64,
    /// Next break, s: no step reaches over it.
    limit: f64,
    /// The equal steps of which the latest is one.
    span: Span,
    /// The start and the end of the latest step.
    from: ModalState,
    to: ModalState,
    /// The nonlinear remainder at the points of the latest step, its coordinates or the few forces that make it, and that
    /// step's size; with a size of zero only its value at the end is known.
    remainder: Points,
    remainder_size: f64,
    linear: LinearPart,
    /// Whether the linear part is that of the start of the step.
    fresh: bool,
    /// Sweeps beyond the fewest since the linear part was taken: what a better one might have saved.
    excess: u32,
    control: Control,
    /// Whether a trial since the latest good step was not finite.
    fault: bool,
    counters: Counters,
    propagators: Propagators,
    /// Weights that carry the polynomial on into a step whose size is in a ratio to the latest one's.
    ahead: [[f64; POINTS]; POINTS],
    ahead_ratio: f64,
    sweeps: Sweeps,
    /// Slopes by the start, where they are asked for.
    slopes: Option<StepSlopes>,
    /// The latest sample within the step.
    cursor: Cursor,
    /// Room for the coordinates of a remainder by few forces, for a state, and for `∂f/∂y`.
    modal: Points,
    state: Padded,
    jacobian: DMatrix<f64>,
}

impl ExponentialStepper {
    /// Before the first step.
    pub fn new(problem: &Problem<'_>, start: &Start) -> Self {
        let (time, deviation) = (start.time, &start.deviation);
        let states = deviation.len();
        let linear = LinearPart::none(states);
        let mut to = ModalState::zeros(states);
        to.deviation.copy_from_slice(deviation);
        linear.to_coordinates(&mut to);
        Self {
            start: time,
            time,
            requested: 0.0,
            limit: time,
            span: Span::default(),
            from: to.clone(),
            to,
            remainder: no_points(states),
            remainder_size: 0.0,
            propagators: Propagators::new(states),
            linear,
            fresh: false,
            // the first step takes a linear part
            excess: renewal_cost(states),
            control: Control::default(),
            fault: false,
            counters: start.counters,
            ahead: [[0.0; POINTS]; POINTS],
            ahead_ratio: 0.0,
            sweeps: Sweeps::new(problem),
            slopes: None,
            cursor: Cursor::new(states),
            modal: no_points(states),
            state: Padded::zeros(states),
            jacobian: DMatrix::zeros(states, states),
        }
    }

    /// Before the first step, with the slopes of the state by that at the start found with it and kept to the same
    /// tolerance.
    pub fn with_slopes(problem: &Problem<'_>, start: &Start) -> Self {
        Self {
            slopes: Some(StepSlopes::new(&problem.scaling.scale)),
            ..Self::new(problem, start)
        }
    }

    /// Whether the latest step has taken slopes on: few forces make the remainder.
    pub fn has_slopes(&self) -> bool {
        self.slopes.is_some() && self.linear.few_forces.is_some()
    }

    /// These slopes at the end of the latest step; none where they were not asked for.
    pub fn slopes(&self, problem: &Problem<'_>) -> Option<DMatrix<f64>> {
        let slopes = self.slopes.as_ref()?;
        Some(slopes.by_states(&self.linear, &problem.scaling.scale))
    }

    /// Makes the end of the latest step the start of the next.
    fn begin(&mut self, problem: &Problem<'_>) {
        self.start = self.time;
        self.from.copy_from(&self.to);
        self.cursor.index = f64::INFINITY;
        let behind_break = self.time >= self.limit;
        if behind_break {
            self.limit = problem.system.next_break(self.time + problem.slack());
        }
        if self.is_renewal_due() {
            self.linearise(problem);
        } else if behind_break {
            self.forget(problem);
        }
        if self.requested <= 0.0 {
            // a moment that changes its sign as the shaft starts is over at once: nothing is missed
            self.requested = problem.scaling.time.min(1.0 / self.linear.norm);
        }
    }

    /// Whether a new linear part might save what it costs.
    fn is_renewal_due(&self) -> bool {
        self.excess >= renewal_cost(self.jacobian.nrows())
    }

    /// Takes the linear part anew.
    fn linearise(&mut self, problem: &Problem<'_>) {
        problem.write_state(&self.from.deviation, &mut self.state);
        let (system, time) = (problem.system, self.start);
        let linear = match system.separated(time, &self.state) {
            Some(separated) => LinearPart::from_separated(&separated, &problem.scaling.origin),
            None => {
                system.linearisation(time, &self.state, &mut self.jacobian);
                LinearPart::near(&self.jacobian)
            }
        };
        self.take_linear(linear, problem);
        self.linear.to_coordinates(&mut self.from);
        (self.fresh, self.excess) = (true, 0);
        self.propagators.clear();
        self.forget(problem);
    }

    /// Takes another linear part, in whose coordinates nothing is known yet but the slopes.
    fn take_linear(&mut self, linear: LinearPart, problem: &Problem<'_>) {
        if let Some(slopes) = &mut self.slopes {
            slopes.change(&self.linear, &linear, &problem.scaling.scale);
        }
        self.remainder = no_points(linear.remainders());
        self.sweeps.remainder.clone_from(&self.remainder);
        self.linear = linear;
    }

    /// Forgets the remainder before the start, which is no guess of what follows.
    fn forget(&mut self, problem: &Problem<'_>) {
        self.remainder_size = 0.0;
        let (evaluation, from) = (&mut self.sweeps.evaluation, &self.from.coordinates);
        let (linear, time, room) = (&self.linear, self.start, &mut self.state);
        in_wide_registers!(linear.level, {
            if let Some(few) = &linear.few_forces {
                few.shapes.multiply::<false>(from, room.chunks_mut());
                evaluation.evaluate_forces(few, problem.system, time, room);
            } else {
                evaluation.evaluate(linear, problem.system, time, from, room);
            }
        });
        for (points, now) in self.remainder.iter_mut().zip(evaluation.remainder.chunks()) {
            points[POINTS - 1] = *now;
        }
        self.counters.evaluations += 1;
    }

    /// Chooses the size of the step to come.
    fn plan(&mut self, interval: f64) {
        self.span = if self.span.left == 0.0 || self.span.intervals > 0.0 {
            Span::new(self.start, self.requested, interval, self.limit)
        } else {
            self.span.adapted(self.requested)
        };
    }

    /// Tries a step; how its sweeps ended.
    fn trial(&mut self, problem: &Problem<'_>) -> Outcome {
        self.guess();
        let trial = Trial {
            problem,
            linear: &self.linear,
            operator: self.propagators.over_step(&self.linear, self.span.size),
            start: self.start,
            size: self.span.size,
            limit: self.limit.next_down(),
            from: &self.from,
        };
        self.sweeps.begin(&trial);
        let outcome = self.sweeps.run(&trial);
        self.counters.evaluations += u64::from(self.sweeps.count) * (POINTS as u64 - 1);
        match (outcome, &mut self.slopes) {
            (Outcome::Converged(error), Some(slopes)) if error <= 1.0 => {
                self.counters.evaluations += POINTS as u64;
                Outcome::Converged(error.max(slopes.step(&trial, &mut self.sweeps)))
            }
            _ => outcome,
        }
    }

    /// Guesses the remainder at the points of the step to come by the polynomial of the latest one; where steps grow faster
    /// than by [`GROW`], as behind one that was cut, that is round-off, and it is taken as it is at the start.
    fn guess(&mut self) {
        let ratio = self.span.size / self.remainder_size;
        let is_known = self.remainder_size > 0.0 && ratio <= GROW;
        if is_known && ratio != self.ahead_ratio {
            self.ahead_ratio = ratio;
            self.ahead = NODES.part.map(|part| weights(1.0 + ratio * part));
        }
        for (guess, known) in self.sweeps.remainder.iter_mut().zip(&self.remainder) {
            *guess = [known[POINTS - 1]; POINTS];
            if is_known {
                for (guess, ahead) in guess.iter_mut().zip(&self.ahead).skip(1) {
                    *guess = combined(ahead, known);
                }
            }
        }
    }

    fn accept(&mut self, error: f64) {
        std::mem::swap(&mut self.to, &mut self.sweeps.to);
        std::mem::swap(&mut self.remainder, &mut self.sweeps.remainder);
        if let Some(slopes) = &mut self.slopes {
            std::mem::swap(&mut slopes.from, &mut slopes.to);
        }
        self.remainder_size = self.span.size;
        // the error falls with the power of the number of points
        let growth = self.control.accepted(error, POINTS as i32);
        // sweeps that hardly converged would not over a longer step
        let proposed = match self.sweeps.count {
            count if count > sweeps::FEWEST + 1 => self.span.size * growth.min(1.0),
            _ => self.span.size * growth,
        };
        // the error of a step that was cut by a break or a sample does not bound the next one
        self.requested = if self.span.size < 0.5 * self.requested {
            proposed.max(self.requested)
        } else {
            proposed
        };
        self.excess += self.sweeps.count - sweeps::FEWEST;
        (self.fault, self.fresh) = (false, false);
        self.counters.steps += 1;
        self.span.left -= 1.0;
        self.time = if self.span.left == 0.0 {
            self.span.end
        } else {
            self.start + self.span.size
        };
    }

    fn reject(&mut self, error: f64) {
        self.counters.rejected += 1;
        self.requested = self.span.size * self.control.rejected(error, POINTS as i32);
    }

    /// After sweeps that did not converge: a new linear part once it pays, else a shorter step.
    fn renew_or_shorten(&mut self, problem: &Problem<'_>) {
        self.counters.rejected += 1;
        self.control.rejected = true;
        if self.fresh || !self.is_renewal_due() {
            self.requested = 0.5 * self.span.size;
        } else {
            self.linearise(problem);
        }
    }
}

impl MethodStepper for ExponentialStepper {
    fn step(&mut self, problem: &Problem<'_>) -> Result<(), IntegrateError> {
        self.begin(problem);
        loop {
            problem.check(self.start, self.requested, &self.counters, self.fault)?;
            self.plan(problem.interval);
            let ends = [self.start, self.start + self.span.size];
            problem.check_progress(ends, self.span.size, self.fault)?;
            let outcome = self.trial(problem);
            match outcome {
                Outcome::Converged(error) if error <= 1.0 => {
                    self.accept(error);
                    return Ok(());
                }
                Outcome::Converged(error) => {
                    self.excess += 1;
                    self.reject(error);
                }
                Outcome::Slow => {
                    self.excess += sweeps::MOST;
                    self.renew_or_shorten(problem);
                }
                Outcome::NotFinite => {
                    self.excess += 1;
                    self.fault = true;
                    self.reject(f64::INFINITY);
                }
            }
        }
    }

    fn state_within(&mut self, problem: &Problem<'_>, time: f64, state: &mut [f64]) {
        if time >= self.time {
            problem.write_state(&self.to.deviation, state);
            return;
        }
        let interval = problem.interval;
        let index = ((time - self.start) / interval).round();
        let phi = self.propagators.samples(&self.linear, interval);
        let (cursor, linear) = (&mut self.cursor, &self.linear);
        if cursor.index > index {
            let (from, intervals) = (&self.from.coordinates, [interval, self.span.intervals]);
            let remainder = match &linear.few_forces {
                Some(few) => {
                    let modal = &mut self.modal;
                    in_wide_registers!(linear.level, few.find_modal(&self.remainder, modal));
                    &self.modal
                }
                None => &self.remainder,
            };
            cursor.begin(from, remainder, intervals, phi, linear);
        }
        cursor.go_to(index, phi, linear, &mut self.state);
        problem.write_state(&self.state, state);
    }

    fn reached(&self) -> Reached<'_> {
        Reached {
            time: self.time,
            deviation: &self.to.deviation,
            step: self.requested,
            counters: self.counters,
        }
    }

    fn crossed(&self) -> bool {
        self.sweeps.crossed
    }

    fn take_over(&mut self, prepared: PreparedSteps, problem: &Problem<'_>) {
        self.take_linear(prepared.linear, problem);
        self.linear.to_coordinates(&mut self.to);
        self.propagators = prepared.propagators;
        (self.excess, self.requested) = (prepared.excess, prepared.requested);
    }

    fn into_prepared(self: Box<Self>) -> Option<PreparedSteps> {
        Some(PreparedSteps {
            linear: self.linear,
            propagators: self.propagators,
            excess: self.excess,
            requested: self.requested,
        })
    }

    fn largest_eigenvalue(&self) -> f64 {
        let eigenvalues = self.linear.eigenvalues.iter();
        eigenvalues.map(|value| value.norm()).fold(0.0, f64::max)
    }
}

#[cfg(test)]
#[path = "stepper_tests.rs"]
mod tests;
