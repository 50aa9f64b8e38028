//! Sweeps over the points of a trial step, until the nonlinear remainders are those of the states there.
//!
//! ```text
//! z_i = E_i z + Σ_j A_ij g_j,   g_i = g(t + c_i h, z_i)        i = 1 … 6
//! ```
//!
//! A sweep goes through the points once, in their order, each with the latest g of all (Gauss–Seidel). z and g are modal
//! coordinates, of the deviation y = V z from the scaling's origin and of the remainder; point 0 is the start of the step and
//! the last one its end. Where few forces make the remainder, the sweeps are those of `force_sweeps.rs`.

use super::force_operator::ForceOperator;
use super::force_sweeps::ForceSweeps;
use super::linear::{LinearPart, ModalState};
use super::nodes::{NODES, POINTS, Points, SPARE, combined, no_points};
use super::propagator::Propagator;
use super::remainder::{Evaluation, FewForces};
use crate::integrate::chunks::{Padded, add_scaled};
use crate::integrate::problem::Problem;
use crate::numerics::registers::in_wide_registers;

/// The last point, the end of the step.
const END: usize = POINTS - 1;
/// Error allowed in one step, as a part of the error aimed at over the run; found by measuring.
pub(super) const LOCAL_PART: f64 = 0.05;
/// Part of that error which the iteration may leave.
const ITERATION_PART: f64 = 0.03;
/// Fewest sweeps of a trial, which show how fast their changes fall, and most.
pub(super) const FEWEST: u32 = 2;
pub(super) const MOST: u32 = 6;

/// A step that is tried.
#[derive(Clone, Copy)]
pub(super) struct Trial<'a> {
    pub problem: &'a Problem<'a>,
    /// V, V⁻¹ and Λ.
    pub linear: &'a LinearPart,
    /// E_i and A_ij over the size of the step.
    pub operator: &'a Propagator,
    /// Time at which the step starts, and its size h, s.
    pub start: f64,
    pub size: f64,
    /// Time that no evaluation reaches, s.
    pub limit: f64,
    /// The state at the start.
    pub from: &'a ModalState,
}

/// The sweeps over a trial step.
#[derive(Debug, Clone)]
pub(super) struct Sweeps {
    /// The remainder at the points, coordinates g_j or forces u_j: known at the first, guessed at the others before the first
    /// sweep.
    pub remainder: Points,
    /// The state at the end of the step.
    pub to: ModalState,
    /// Deviations at the points after the first in the latest sweep: all of y, or the few x that the forces depend on.
    pub(super) deviations: Vec<Padded>,
    /// Δg_j of the latest sweep.
    change: Points,
    /// One over the error allowed of each component.
    inverse: Vec<f64>,
    /// Sweeps of the trial so far.
    pub count: u32,
    /// Whether event surfaces lie between the points.
    pub crossed: bool,
    pub evaluation: Evaluation,
    /// By how much the latest sweep moved the end; after the sweeps room for the parts of the error estimate.
    pub(super) shift: ModalState,
    /// For sweeps over few forces.
    pub(super) room: ForceSweeps,
    /// The event functions at the start of a step, and those at a point.
    events: [Vec<f64>; 2],
}

/// What a sweep moved.
#[derive(Debug, Clone, Copy)]
pub(super) struct Moved {
    /// Size of the change, to compare with that of the sweep before.
    pub change: f64,
    /// How far the end of the step moved, over what is allowed: from the guess, or from the start where forces are swept
    /// over first.
    pub end: f64,
}

/// How the sweeps ended.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Outcome {
    /// They converged; the error of the step over what is allowed.
    Converged(f64),
    /// They diverge, or converge too slowly.
    Slow,
    NotFinite,
}

impl Sweeps {
    /// Room for the sweeps of a problem.
    pub fn new(problem: &Problem<'_>) -> Self {
        let (states, events) = (problem.system.states(), problem.system.event_count());
        Self {
            remainder: no_points(states),
            to: ModalState::zeros(states),
            deviations: vec![Padded::zeros(states); POINTS],
            change: no_points(states),
            inverse: vec![0.0; states],
            count: 0,
            crossed: false,
            evaluation: Evaluation::new(problem),
            shift: ModalState::zeros(states),
            room: ForceSweeps::default(),
            events: [vec![0.0; events], vec![0.0; events]],
        }
    }

    /// Begins a trial with the guess in `remainder`.
    pub fn begin(&mut self, trial: &Trial<'_>) {
        self.count = 0;
        let level = trial.linear.level;
        match trial.few_forces() {
            Some((few, forces)) => {
                in_wide_registers!(level, self.begin_forces(trial, few, forces));
            }
            None => in_wide_registers!(level, self.begin_points(trial)),
        }
    }

    /// Finds the end of the step that the guess leads to, and what error of each component is allowed.
    #[inline(always)]
    fn begin_points(&mut self, trial: &Trial<'_>) {
        // y₁ = V (E z + Σ_j A_j g_j)
        let (to, start) = (&mut self.to, &trial.from.coordinates);
        let (operator, remainder) = (trial.operator, &self.remainder);
        operator.find_coordinates(POINTS - 1, start, remainder, &mut to.coordinates);
        trial
            .linear
            .find_deviation(&to.coordinates, &mut to.deviation);
        self.allow(trial);
    }

    /// Finds what error of each component is allowed.
    #[inline(always)]
    pub(super) fn allow(&mut self, trial: &Trial<'_>) {
        let problem = trial.problem;
        let allowed = LOCAL_PART * problem.settings.tolerance;
        let ends = trial.from.deviation.iter().zip(self.to.deviation.iter());
        let parts = ends.zip(&problem.scaling.scale);
        for (inverse, ((from, to), scale)) in self.inverse.iter_mut().zip(parts) {
            let most = from.abs().max(to.abs());
            *inverse = (allowed * (scale + most)).recip();
        }
    }

    /// How far the latest sweep moved the end, over what is allowed.
    #[inline(always)]
    pub(super) fn end_shift(&self) -> f64 {
        norm(&self.shift.deviation, &self.inverse)
    }

    /// Sweeps until what further ones would change is small.
    ///
    /// Changes Δ that fall by the factor θ from sweep to sweep leave Δ (θ + θ² + …) = Δ θ/(1 − θ). The factor of one sweep
    /// may be small by chance, and then does not last: from the third sweep on θ is the geometric mean of it and the θ
    /// before.
    ///
    /// Source: Hairer & Wanner, *Solving Ordinary Differential Equations II*, 2nd ed. (1996), sec. IV.8, and the code RADAU.
    pub fn run(&mut self, trial: &Trial<'_>) -> Outcome {
        let (mut before, mut theta) = (f64::NAN, f64::NAN);
        while self.count < MOST {
            let Moved { change, end } = self.sweep(trial);
            if !(change.is_finite() && end.is_finite()) {
                return Outcome::NotFinite;
            }
            if self.count >= FEWEST {
                let fall = if change > 0.0 { change / before } else { 0.0 };
                theta = if theta.is_nan() {
                    fall
                } else {
                    (theta * fall).sqrt()
                };
                if theta >= 1.0 {
                    return Outcome::Slow;
                }
                let left = end * theta / (1.0 - theta);
                if left <= ITERATION_PART {
                    return Outcome::Converged(left + self.error(trial));
                }
            }
            before = change;
        }
        Outcome::Slow
    }

    /// Evaluates the remainder point by point, each with the latest values at all others; what that moves.
    pub fn sweep(&mut self, trial: &Trial<'_>) -> Moved {
        self.count += 1;
        let level = trial.linear.level;
        match trial.few_forces() {
            Some((few, forces)) => {
                in_wide_registers!(level, self.sweep_forces(trial, few, forces))
            }
            None => {
                in_wide_registers!(level, self.sweep_points(trial));
                let end = self.end_shift();
                Moved { change: end, end }
            }
        }
    }

    #[inline(always)]
    fn sweep_points(&mut self, trial: &Trial<'_>) {
        let (linear, operator) = (trial.linear, trial.operator);
        let coordinates = &mut self.shift.coordinates;
        let evaluation = &mut self.evaluation;
        for point in 1..POINTS {
            // z_i = E_i z + Σ_j A_ij g_j, the latest g_j
            let (from, deviation) = (&trial.from.coordinates, &mut self.deviations[point]);
            operator.find_coordinates(point, from, &self.remainder, coordinates);
            // g_i of z_i at t + c_i h
            let (system, time) = (trial.problem.system, trial.time_of(point));
            evaluation.evaluate(linear, system, time, coordinates, deviation);
            // Δg_i, and g_i in place of the one before
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

    /// Error of the polynomial, over what is allowed: what its highest power does to the states at the end and in the middle
    /// of the step, reduced where that power is seen to be much larger than what the polynomial lacks.
    fn error(&mut self, trial: &Trial<'_>) -> f64 {
        in_wide_registers!(trial.linear.level, self.estimate_error(trial))
    }

    #[inline(always)]
    fn estimate_error(&mut self, trial: &Trial<'_>) -> f64 {
        if let Some((few, _)) = trial.few_forces() {
            self.take_forces(few);
        }
        let factor = self.error_factor(trial);
        // the remainder at the spare point less the polynomial through all others, which has one power less
        self.combine(&NODES.spare);
        let ModalState {
            coordinates,
            deviation,
        } = &mut self.shift;
        let spare = &mut self.evaluation.remainder;
        match &trial.linear.few_forces {
            Some(few) => few.parts.multiply::<false>(coordinates, spare.chunks_mut()),
            None => spare.copy_from(coordinates),
        }
        // what that difference, acting at the spare point alone, does at the end and at the first point past the middle
        let mut sizes = [0.0; 2];
        for (size, point) in sizes.iter_mut().zip([POINTS - 1, SPARE + 1]) {
            trial.operator.find_effect(point, SPARE, spare, coordinates);
            trial.linear.find_deviation(coordinates, deviation);
            *size = norm(deviation, &self.inverse);
        }
        factor * sizes[0].max(sizes[1])
    }

    /// Finds a weighted sum of the remainders at the points, into the first coordinates of `shift`.
    #[inline(always)]
    fn combine(&mut self, weights: &[f64; POINTS]) {
        let to = self.shift.coordinates.chunks_mut();
        for (to, points) in to.iter_mut().zip(&self.remainder) {
            *to = combined(weights, points);
        }
    }

    /// Factor, at most 1, from the error of the polynomial without its highest power to that of the polynomial itself.
    ///
    /// The Legendre coefficients of a smooth remainder fall by about the same factor θ from each degree to the next, and
    /// what the polynomial leaves out is smaller by θ² than what the estimate sees: θ² is the ratio of the squares of the
    /// two highest coefficients to those of the two before. Of a remainder that is nearly odd about the middle of the step
    /// this is 1, and nothing is gained; of one that is nearly even it would be θ⁴, so that the factor is no less than the
    /// highest coefficient over the larger of both before it. Where an event surface is crossed, coefficients fall slowly,
    /// and the factor is 1.
    #[inline(always)]
    fn error_factor(&mut self, trial: &Trial<'_>) -> f64 {
        let mut sizes = [0.0; 3];
        for (size, mode) in sizes.iter_mut().zip(&NODES.modes) {
            self.combine(mode);
            let ModalState {
                coordinates,
                deviation,
            } = &mut self.shift;
            match trial.few_forces() {
                Some((few, _)) => few
                    .inputs
                    .multiply::<false>(coordinates, deviation.chunks_mut()),
                None => trial.linear.find_deviation(coordinates, deviation),
            }
            *size = norm(deviation, &self.inverse);
        }
        self.crossed = self.crosses(trial);
        if self.crossed {
            1.0
        } else {
            error_factor(sizes)
        }
    }

    /// Whether a point of the step is on another side of an event surface than its start.
    fn crosses(&mut self, trial: &Trial<'_>) -> bool {
        if self.events[0].is_empty() {
            return false;
        }
        let system = trial.problem.system;
        let [mut at_start, mut later] = self.events.each_mut().map(std::mem::take);
        system.events(trial.start, self.state_at(trial, 0), &mut at_start);
        let crosses = (1..POINTS).any(|point| {
            system.events(
                trial.time_of(point),
                self.state_at(trial, point),
                &mut later,
            );
            let mut sides = at_start.iter().zip(&later);
            sides.any(|(start, later)| start.is_sign_positive() != later.is_sign_positive())
        });
        self.events = [at_start, later];
        crosses
    }

    /// The state at a point after the sweeps, as far as forces and event functions depend on it.
    pub fn state_at(&mut self, trial: &Trial<'_>, point: usize) -> &[f64] {
        let (problem, evaluation) = (trial.problem, &mut self.evaluation);
        match point {
            0 => problem.write_state(&trial.from.deviation, &mut evaluation.state),
            // the end has moved since the latest sweep evaluated there
            END => problem.write_state(&self.to.deviation, &mut evaluation.state),
            _ => evaluation.find_state(trial.linear, problem, &self.deviations[point]),
        }
        &evaluation.state
    }
}

/// Factor from the error of the polynomial without its highest power to that of the polynomial itself, by the sizes of the
/// Legendre coefficients of the degrees 4, 5 and 6.
pub(super) fn error_factor([before, middle, highest]: [f64; 3]) -> f64 {
    let square = middle * middle;
    let fall = (square + highest * highest) / (before * before + square);
    // coefficients fall unevenly: twice as much
    let factor = 2.0 * fall.max(highest / before.max(middle));
    // a constant remainder gives 0/0, and so 1
    if factor < 1.0 { factor } else { 1.0 }
}

impl<'a> Trial<'a> {
    /// The few forces that make the remainder, and what they do over the step.
    #[inline(always)]
    pub fn few_forces(&self) -> Option<(&'a FewForces, &'a ForceOperator)> {
        let few = self.linear.few_forces.as_ref();
        few.zip(self.operator.forces.as_ref())
    }

    /// Time of a point, s.
    pub fn time_of(&self, point: usize) -> f64 {
        (self.start + NODES.part[point] * self.size).min(self.limit)
    }
}

/// Root mean square of a vector's components over what is allowed of each.
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
    use crate::integrate::{Method, Scaling, Settings, System};

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
        let (mut from, mut seen) = (ModalState::zeros(2), Padded::zeros(2));
        from.deviation.copy_from_slice(&[0.98, 0.0]);
        linear.to_coordinates(&mut from);
        let size = time / f64::from(steps);
        let operator = propagators.over_step(&linear, size);
        let mut sweeps = Sweeps::new(&problem);
        for step in 0..steps {
            let start = f64::from(step) * size;
            let evaluation = &mut sweeps.evaluation;
            evaluation.evaluate(&linear, &Hardening, start, &from.coordinates, &mut seen);
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
