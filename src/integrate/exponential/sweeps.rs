//! Sweeps over the points of a trial step, until the nonlinear remainders are those of the states there.

use super::linear::{LinearPart, ModalState};
use super::nodes::{NODES, POINTS, Points, SPARE, combined, no_points};
use super::propagator::Propagator;
use crate::integrate::System;
use crate::integrate::chunks::{Padded, add_scaled};
use crate::integrate::problem::Problem;
use crate::numerics::registers::in_wide_registers;

/// Error allowed in one step, as a part of the error aimed at over the run: measured.
const LOCAL_PART: f64 = 0.05;
/// Part of it that may be left by the iteration.
const ITERATION_PART: f64 = 0.03;
/// Fewest sweeps of a trial, which show how fast their changes fall, and most.
pub(super) const FEWEST: u32 = 2;
pub(super) const MOST: u32 = 6;

/// A step that is tried.
#[derive(Clone, Copy)]
pub(super) struct Trial<'a> {
    pub problem: &'a Problem<'a>,
    pub linear: &'a LinearPart,
    pub operator: &'a Propagator,
    pub start: f64,
    pub size: f64,
    /// Time that no evaluation reaches, s.
    pub limit: f64,
    pub from: &'a ModalState,
}

/// The sweeps over a trial step.
#[derive(Debug, Clone)]
pub(super) struct Sweeps {
    /// Coordinates of the remainder at the points: known at the first, guessed at the others.
    pub remainder: Points,
    /// The end of the step.
    pub to: ModalState,
    /// Deviations at the points between, as the latest sweep had them.
    deviations: Vec<Padded>,
    /// Change of the remainder in the latest sweep.
    change: Points,
    /// Reciprocals of the errors allowed.
    inverse: Vec<f64>,
    /// Sweeps of the trial so far.
    pub count: u32,
    /// Whether event surfaces lie between the points.
    pub crossed: bool,
    pub evaluation: Evaluation,
    /// Coordinates and deviation of a part of the motion.
    shift: ModalState,
    /// The event functions at the start of a step, and those at a point.
    events: [Vec<f64>; 2],
}

/// An evaluation of the remainder.
#[derive(Debug, Clone)]
pub(super) struct Evaluation {
    origin: Padded,
    state: Padded,
    rate: Padded,
    /// Its coordinates.
    pub remainder: Padded,
}

/// How the sweeps ended.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Outcome {
    /// They converged; the error over what is allowed.
    Converged(f64),
    /// They diverge, or converge too slowly.
    Slow,
    NotFinite,
}

impl Evaluation {
    /// Finds the coordinates of g = f − J y with y the deviation from the origin, where it has one: the origin's part
    /// of J y is in g.
    #[inline(always)]
    pub fn evaluate(
        &mut self,
        linear: &LinearPart,
        system: &dyn System,
        time: f64,
        [coordinates, deviation]: [&Padded; 2],
    ) {
        self.find_state(deviation);
        system.derivative(time, &self.state, &mut self.rate);
        linear.find_remainder(&self.rate, coordinates, &mut self.remainder);
    }

    /// The state at a deviation.
    #[inline(always)]
    fn find_state(&mut self, deviation: &Padded) {
        let parts = self.origin.chunks().iter().zip(deviation.chunks());
        for (state, (origin, deviation)) in self.state.chunks_mut().iter_mut().zip(parts) {
            for i in 0..4 {
                state[i] = origin[i] + deviation[i];
            }
        }
    }
}

impl Sweeps {
    /// Room for those of a problem.
    pub fn new(problem: &Problem<'_>) -> Self {
        let (states, events) = (problem.system.states(), problem.system.event_count());
        let zeros = Padded::zeros(states);
        Self {
            remainder: no_points(states),
            to: ModalState::zeros(states),
            deviations: vec![zeros.clone(); POINTS],
            change: no_points(states),
            inverse: vec![0.0; states],
            count: 0,
            crossed: false,
            evaluation: Evaluation {
                origin: Padded::from_slice(&problem.scaling.origin),
                state: zeros.clone(),
                rate: zeros.clone(),
                remainder: zeros,
            },
            shift: ModalState::zeros(states),
            events: [vec![0.0; events], vec![0.0; events]],
        }
    }

    /// Begins with a guess of the remainder.
    pub fn begin(&mut self, trial: &Trial<'_>) {
        self.count = 0;
        let (linear, from) = (trial.linear, trial.from);
        let (to, remainder) = (&mut self.to, &self.remainder);
        in_wide_registers!(linear.level, {
            let (point, start) = (POINTS - 1, &from.coordinates);
            trial
                .operator
                .find_coordinates(point, start, remainder, &mut to.coordinates);
            linear.find_deviation(&to.coordinates, &mut to.deviation);
        });
        let problem = trial.problem;
        let allowed = LOCAL_PART * problem.settings.tolerance;
        for (i, inverse) in self.inverse.iter_mut().enumerate() {
            let most = from.deviation[i].abs().max(self.to.deviation[i].abs());
            *inverse = (allowed * (problem.scaling.scale[i] + most)).recip();
        }
    }

    /// Sweeps until what further ones would change is small.
    ///
    /// Changes Δ that fall by the factor θ from sweep to sweep leave Δ θ/(1 − θ). A fall that is much faster than that
    /// before it does not last: θ is the geometric mean of both.
    ///
    /// Source: Hairer & Wanner, *Solving Ordinary Differential Equations II*, 2nd ed. (1996), sec. IV.8, and the code RADAU.
    pub fn run(&mut self, trial: &Trial<'_>) -> Outcome {
        let (mut before, mut rate) = (f64::NAN, f64::NAN);
        while self.count < MOST {
            let change = self.sweep(trial);
            if !change.is_finite() {
                return Outcome::NotFinite;
            }
            if self.count >= FEWEST {
                let fall = if change > 0.0 { change / before } else { 0.0 };
                rate = if rate.is_nan() {
                    fall
                } else {
                    (rate * fall).sqrt()
                };
                if rate >= 1.0 {
                    return Outcome::Slow;
                }
                let rest = change * rate / (1.0 - rate);
                if rest <= ITERATION_PART {
                    return Outcome::Converged(rest + self.error(trial));
                }
            }
            before = change;
        }
        Outcome::Slow
    }

    /// Evaluates the remainder point by point, each with what is known by then; the size of what that
    /// changes at the end.
    pub fn sweep(&mut self, trial: &Trial<'_>) -> f64 {
        self.count += 1;
        in_wide_registers!(trial.linear.level, self.swept(trial));
        norm(&self.shift.deviation, &self.inverse)
    }

    #[inline(always)]
    fn swept(&mut self, trial: &Trial<'_>) {
        let (linear, operator) = (trial.linear, trial.operator);
        let coordinates = &mut self.shift.coordinates;
        let evaluation = &mut self.evaluation;
        for point in 1..POINTS {
            // y_i = V (E_i z + Σ_j A_ij g_j), the latest g_j
            let (from, deviation) = (&trial.from.coordinates, &mut self.deviations[point]);
            operator.find_coordinates(point, from, &self.remainder, coordinates);
            linear.find_deviation(coordinates, deviation);
            // g_i = V⁻¹ f(t + c_i h, y_i) − Λ z_i
            let time = trial.time_of(point);
            evaluation.evaluate(linear, trial.problem.system, time, [coordinates, deviation]);
            let points = self.remainder.iter_mut().zip(&mut self.change);
            for ((known, change), found) in points.zip(evaluation.remainder.chunks()) {
                let before = known[point];
                for i in 0..4 {
                    change[point][i] = found[i] - before[i];
                }
                known[point] = *found;
            }
        }
        // y₁ moves by V Σ_j A_j Δg_j
        operator.find_shift(&self.change, coordinates);
        linear.find_deviation(coordinates, &mut self.shift.deviation);
        for (to, by) in [
            (&mut self.to.coordinates, &self.shift.coordinates),
            (&mut self.to.deviation, &self.shift.deviation),
        ] {
            for (to, by) in to.chunks_mut().iter_mut().zip(by.chunks()) {
                add_scaled(to, 1.0, by);
            }
        }
    }

    /// What the highest power of the polynomial does at the end and in the middle of the step, over
    /// what is allowed, as far as it is not better than that.
    fn error(&mut self, trial: &Trial<'_>) -> f64 {
        in_wide_registers!(trial.linear.level, self.estimated(trial))
    }

    #[inline(always)]
    fn estimated(&mut self, trial: &Trial<'_>) -> f64 {
        let smoothness = self.smoothness(trial);
        self.combine(&NODES.spare);
        let spare = &mut self.evaluation.remainder;
        spare.copy_from(&self.shift.coordinates);
        let ModalState {
            coordinates,
            deviation,
        } = &mut self.shift;
        let mut sizes = [0.0; 2];
        for (size, point) in sizes.iter_mut().zip([POINTS - 1, SPARE + 1]) {
            trial.operator.find_effect(point, SPARE, spare, coordinates);
            trial.linear.find_deviation(coordinates, deviation);
            *size = norm(deviation, &self.inverse);
        }
        smoothness * sizes[0].max(sizes[1])
    }

    /// Finds a weighted sum of the remainders at the points.
    #[inline(always)]
    fn combine(&mut self, weights: &[f64; POINTS]) {
        let to = self.shift.coordinates.chunks_mut();
        for (to, points) in to.iter_mut().zip(&self.remainder) {
            *to = combined(weights, points);
        }
    }

    /// Factor of the error estimate, which is that of the polynomial without its highest power.
    ///
    /// Where the remainder is smooth its Legendre coefficients fall by about the same factor from one to
    /// the next, and what the polynomial leaves out is smaller than what the estimate sees by two of
    /// them. Where an event surface is crossed they fall slowly, and no faster than seen. A part that is nearly
    /// odd about the middle of the step has next to no even coefficients: there the fall is not seen.
    #[inline(always)]
    fn smoothness(&mut self, trial: &Trial<'_>) -> f64 {
        let mut sizes = [0.0; 3];
        for (size, mode) in sizes.iter_mut().zip(&NODES.modes) {
            self.combine(mode);
            let shift = &mut self.shift;
            trial
                .linear
                .find_deviation(&shift.coordinates, &mut shift.deviation);
            *size = norm(&shift.deviation, &self.inverse);
        }
        let [before, middle, highest] = sizes;
        let square = middle * middle;
        let fall = (square + highest * highest) / (before * before + square);
        // with a factor of two for how even the fall is
        let factor = 2.0 * fall.max(highest / before.max(middle));
        // no number where the remainder is constant
        self.crossed = self.crosses(trial);
        if factor < 1.0 && !self.crossed {
            factor
        } else {
            1.0
        }
    }

    /// Whether event surfaces lie between the points of the step.
    fn crosses(&mut self, trial: &Trial<'_>) -> bool {
        let [at_start, later] = &mut self.events;
        if at_start.is_empty() {
            return false;
        }
        let (problem, system) = (trial.problem, trial.problem.system);
        let evaluation = &mut self.evaluation;
        problem.write_state(&trial.from.deviation, &mut evaluation.state);
        system.events(trial.start, &evaluation.state, at_start);
        (1..POINTS).any(|point| {
            evaluation.find_state(match point + 1 {
                POINTS => &self.to.deviation,
                _ => &self.deviations[point],
            });
            system.events(trial.time_of(point), &evaluation.state, later);
            let mut sides = at_start.iter().zip(&*later);
            sides.any(|(start, later)| start.is_sign_positive() != later.is_sign_positive())
        })
    }
}

impl Trial<'_> {
    /// Time of a point, s.
    fn time_of(&self, point: usize) -> f64 {
        (self.start + NODES.part[point] * self.size).min(self.limit)
    }
}

/// Root mean square over what is allowed.
#[inline(always)]
fn norm(vector: &[f64], inverse: &[f64]) -> f64 {
    let mut sum = 0.0;
    for (value, inverse) in vector.iter().zip(inverse) {
        let part = value * inverse;
        sum += part * part;
    }
    (sum / vector.len() as f64).sqrt()
}

#[cfg(test)]
mod tests {
    use std::sync::atomic::AtomicBool;

    use nalgebra::DMatrix;

    use super::super::propagator::Propagators;
    use super::*;
    use crate::integrate::{Method, Scaling, Settings};

    const NATURAL: f64 = 200.0;

    /// q″ = −ω² [q − cos t + 0.01 q³ (2 + sin 2t)]: time enters, and it is not linear.
    struct Hardening;

    impl System for Hardening {
        fn states(&self) -> usize {
            2
        }

        fn derivative(&self, time: f64, state: &[f64], rate: &mut [f64]) {
            let position = state[0];
            let hard = 0.01 * position.powi(3) * (2.0 + (2.0 * time).sin());
            rate[0] = state[1];
            rate[1] = -NATURAL * NATURAL * (position - time.cos() + hard);
        }
    }

    /// State at a time from one that follows the drive, after so many equal steps.
    fn stepped(steps: u32, time: f64) -> [f64; 2] {
        let stop = AtomicBool::new(false);
        let settings = Settings {
            method: Method::Exponential,
            tolerance: 1.0,
            step_limit: u64::MAX,
        };
        let problem = Problem {
            system: &Hardening,
            scaling: Scaling::identity(2),
            settings,
            stop: &stop,
            progress: None,
            end: 100.0,
            interval: 1.0,
        };
        let square = -1.06 * NATURAL * NATURAL;
        let linear = LinearPart::near(&DMatrix::from_row_slice(2, 2, &[0.0, 1.0, square, 0.0]));
        let mut propagators = Propagators::new(2);
        let mut from = ModalState::zeros(2);
        from.deviation.copy_from_slice(&[0.98, 0.0]);
        linear.to_coordinates(&mut from);
        let size = time / f64::from(steps);
        let operator = propagators.over_step(&linear, size);
        let mut sweeps = Sweeps::new(&problem);
        for step in 0..steps {
            let start = f64::from(step) * size;
            sweeps.evaluation.evaluate(
                &linear,
                &Hardening,
                start,
                [&from.coordinates, &from.deviation],
            );
            for (points, guess) in sweeps
                .remainder
                .iter_mut()
                .zip(sweeps.evaluation.remainder.chunks())
            {
                *points = [*guess; POINTS];
            }
            let trial = Trial {
                problem: &problem,
                linear: &linear,
                operator,
                start,
                size,
                limit: f64::INFINITY,
                from: &from,
            };
            sweeps.begin(&trial);
            for _ in 0..40 {
                sweeps.sweep(&trial);
            }
            from.copy_from(&sweeps.to);
        }
        [from.deviation[0], from.deviation[1]]
    }

    /// A free oscillation goes on beside the drive, and the cube of both is in the remainder: at 4 and at
    /// 2 rad of it a step the error falls with order seven at least.
    #[test]
    fn steps_of_the_order_of_the_natural_period_have_order_seven() {
        let truth = stepped(1600, 2.0);
        let error = |steps| (stepped(steps, 2.0)[0] - truth[0]).abs();
        for steps in [100, 140] {
            let order = (error(steps) / error(2 * steps)).log2();
            println!("{:e} {:e} {order}", error(steps), error(2 * steps));
            assert!(order > 6.5, "{steps} steps: {order}");
        }
    }
}
