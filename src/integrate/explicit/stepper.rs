//! Steps of the explicit pair, one after the other.

use fearless_simd::{Level, Simd, SimdBase, f64x4};

use super::crossing::Crossings;
use super::plan::Substitution;
use super::verner76::{
    ERROR, FACTORS, LAST, NODES, ORDER, STABILITY, STAGES, Stages, dense_sum, dense_weights, entry,
    sum_of_stages,
};
use crate::integrate::chunks::{Padded, chunks_of, in_register};
use crate::integrate::problem::{Control, Problem};
use crate::integrate::stepper::{MethodStepper, Reached, Start};
use crate::integrate::{Counters, IntegrateError};
use crate::numerics::registers::in_wide_registers;

/// Times that a step looks for a better position to land on.
const MOST_SEARCHES: u32 = 5;

/// The latest step, and how to go on. States are kept as deviations from the scaling's origin: sums
/// of them lose less to round-off.
pub(in crate::integrate) struct ExplicitStepper {
    /// Vector instructions of the processor.
    pub(super) level: Level,
    /// Start and end of the latest step, s.
    pub(super) start: f64,
    pub(super) time: f64,
    /// Size of the latest step and of the next one, s.
    pub(super) size: f64,
    pub(super) next_size: f64,
    /// Time that the next step must not reach over, s.
    pub(super) limit: f64,
    origin: Padded,
    scale: Padded,
    /// Deviations at the start and at the end of the latest step.
    pub(super) from: Padded,
    pub(super) to: Padded,
    /// The state that the derivative is evaluated in, and that derivative.
    pub(super) argument: Padded,
    pub(super) rate: Padded,
    /// Derivatives at the start and at the end of the latest step.
    pub(super) start_rate: Padded,
    pub(super) end_rate: Padded,
    /// Slopes by the variable of the step, chunk by chunk of the state.
    pub(super) stages: Vec<Stages>,
    pub(super) substitution: Substitution,
    pub(super) crossing: Crossings,
    /// Whether the derivative at the end of the trial is known.
    pub(super) ended: bool,
    /// Whether the stages for dense output are known.
    pub(super) extended: bool,
    pub(super) control: Control,
    /// Whether a trial since the latest good step was not finite.
    pub(super) fault: bool,
    pub(super) counters: Counters,
}

impl ExplicitStepper {
    /// Before the first step.
    pub fn new(problem: &Problem<'_>, start: &Start) -> Self {
        let (time, deviation) = (start.time, &start.deviation);
        let states = deviation.len();
        let zeros = || Padded::zeros(states);
        Self {
            level: Level::new(),
            start: time,
            time,
            size: 0.0,
            next_size: 0.0,
            limit: time,
            origin: Padded::from_slice(&problem.scaling.origin),
            // what is zero has no error
            scale: Padded::padded_with(&problem.scaling.scale, 1.0),
            from: Padded::from_slice(deviation),
            to: Padded::from_slice(deviation),
            argument: zeros(),
            rate: zeros(),
            start_rate: zeros(),
            end_rate: zeros(),
            stages: vec![[[0.0; 4]; STAGES]; chunks_of(states)],
            substitution: Substitution::default(),
            crossing: Crossings::new(problem, start),
            ended: false,
            extended: false,
            control: Control::default(),
            fault: false,
            counters: start.counters,
        }
    }

    /// Makes the end of the latest step the start of the next.
    pub(super) fn begin(&mut self, problem: &Problem<'_>) {
        self.start = self.time;
        self.from.copy_from(&self.to);
        std::mem::swap(&mut self.start_rate, &mut self.end_rate);
        if self.time >= self.limit {
            problem.write_state(&self.from, &mut self.argument);
            self.crossing.plan_none();
            self.limit = problem.limit_after(self.time);
            // the derivative after a break, or the very first
            let rate = &mut self.start_rate;
            problem.system.derivative(self.time, &self.argument, rate);
            self.counters.evaluations += 1;
        }
        if self.next_size <= 0.0 {
            self.counters.evaluations += 1;
            let span = [self.start, self.limit];
            self.next_size = problem.first_size(span, &self.from, &self.start_rate, ORDER);
        }
    }

    /// Evaluates the derivative in the argument as a stage.
    #[inline(always)]
    fn evaluate<S: Simd>(&mut self, simd: S, problem: &Problem<'_>, stage: usize) {
        // dy/ds = h φ′(s) f(t₀ + h φ(s), y), here without h
        let [part, slope] = self.substitution.at(NODES[stage]);
        // what begins at a break is no part of a step that ends there
        let time = (self.start + part * self.size).min(self.limit.next_down());
        let rate = if stage == LAST {
            &mut self.end_rate
        } else {
            &mut self.rate
        };
        problem.system.derivative(time, &self.argument, rate);
        self.counters.evaluations += 1;
        for (stages, rate) in self.stages.iter_mut().zip(rate.chunks()) {
            stages[stage] = *(in_register(simd, rate) * slope);
        }
    }

    #[inline(always)]
    fn stage<S: Simd, const STAGE: usize>(&mut self, simd: S, problem: &Problem<'_>) {
        let size = self.size;
        let chunks = self.origin.chunks().iter().zip(self.from.chunks());
        let chunks = chunks.zip(&self.stages);
        for (argument, ((origin, from), stages)) in
            self.argument.chunks_mut().iter_mut().zip(chunks)
        {
            // y + h Σ_j a_ij k_j
            let sum = sum_of_stages!(simd, FACTORS[STAGE], stages);
            let deviation = in_register(simd, from) + sum * size;
            *argument = *(in_register(simd, origin) + deviation);
        }
        self.evaluate(simd, problem, STAGE);
    }

    /// Tries a step; its error over what is allowed, or no number.
    pub(super) fn trial(&mut self, problem: &Problem<'_>) -> f64 {
        let error = in_wide_registers!(self.level, simd => self.tried(simd, problem));
        error * self.size * self.error_factor() / problem.settings.tolerance
    }

    /// Tries a step; the error per time, relative to one unit and the deviation.
    #[inline(always)]
    fn tried<S: Simd>(&mut self, simd: S, problem: &Problem<'_>) -> f64 {
        (self.ended, self.extended, self.crossing.is_end_known) = (false, false, false);
        self.stage::<_, 1>(simd, problem);
        self.stage::<_, 2>(simd, problem);
        self.stage::<_, 3>(simd, problem);
        self.stage::<_, 4>(simd, problem);
        self.stage::<_, 5>(simd, problem);
        self.stage::<_, 6>(simd, problem);
        self.stage::<_, 7>(simd, problem);
        self.stage::<_, 8>(simd, problem);
        self.stage::<_, 9>(simd, problem);
        let size = self.size;
        let chunks = self.scale.chunks().iter().zip(self.from.chunks());
        let chunks = chunks.zip(self.to.chunks_mut().iter_mut().zip(&self.stages));
        let mut squares = 0.0;
        for ((scale, from), (to, stages)) in chunks {
            // y₁ = y + h Σ_i b_i k_i
            let from = in_register(simd, from);
            let end = from + sum_of_stages!(simd, FACTORS[LAST], stages) * size;
            *to = *end;
            // Σ_i e_i k_i over the unit and the deviation of each component
            let unit = in_register(simd, scale) + from.abs().max(end.abs());
            let inverse = f64x4::splat(simd, 1.0) / unit;
            for part in *(sum_of_stages!(simd, ERROR, stages) * inverse) {
                squares += part * part;
            }
        }
        (squares / self.from.len() as f64).sqrt()
    }

    /// Evaluates the derivative at the end of the step, where the trial did not.
    pub(super) fn evaluate_end(&mut self, problem: &Problem<'_>) {
        if !self.ended {
            self.ended = true;
            problem.write_state(&self.to, &mut self.argument);
            in_wide_registers!(self.level, simd => self.evaluate(simd, problem, LAST));
        }
    }

    /// Completes a good step.
    pub(super) fn finish(&mut self, problem: &Problem<'_>) {
        self.evaluate_end(problem);
        self.counters.steps += 1;
        self.fault = false;
    }

    /// Evaluates the stages for dense output, once a step.
    pub(super) fn extend(&mut self, problem: &Problem<'_>) {
        if !self.extended {
            self.extended = true;
            in_wide_registers!(self.level, simd => {
                self.stage::<_, 11>(simd, problem);
                self.stage::<_, 12>(simd, problem);
            });
        }
    }

    /// Finds the deviation within the step by the pair's own interpolant.
    pub(super) fn by_stages(&self, time: f64, deviation: &mut Padded) {
        let part = self.substitution.inverse((time - self.start) / self.size);
        in_wide_registers!(self.level, simd => {
            let weights = dense_weights(simd, part);
            let chunks = self.from.chunks().iter().zip(&self.stages);
            for (deviation, (from, stages)) in deviation.chunks_mut().iter_mut().zip(chunks) {
                *deviation = *(in_register(simd, from) + dense_sum(simd, &weights, stages) * self.size);
            }
        });
    }
}

impl MethodStepper for ExplicitStepper {
    fn step(&mut self, problem: &Problem<'_>) -> Result<(), IntegrateError> {
        self.begin(problem);
        let mut searches = 0;
        loop {
            let size = self.next_size.min(self.crossing.sizes[0]);
            problem.check(self.start, size, &self.counters, self.fault)?;
            let plan = self.plan(self.crossing.next_landing());
            problem.check_progress([self.start, plan.end], plan.size, self.fault)?;
            self.size = plan.size;
            self.substitute(&plan);
            let error = self.trial(problem);
            if searches < MOST_SEARCHES && self.is_spoiled(problem, &plan, error) {
                self.counters.rejected += 1;
                searches += 1;
            } else if error <= 1.0 {
                self.accept(&plan, error);
                self.finish(problem);
                self.arrive(problem, &plan);
                return Ok(());
            } else {
                self.reject(error);
            }
        }
    }

    fn state_within(&mut self, problem: &Problem<'_>, time: f64, state: &mut [f64]) {
        if time >= self.time {
            problem.write_state(&self.to, state);
            return;
        }
        self.extend(problem);
        let mut deviation = std::mem::take(&mut self.argument);
        self.by_stages(time, &mut deviation);
        problem.write_state(&deviation, state);
        self.argument = deviation;
    }

    fn reached(&self) -> Reached<'_> {
        Reached {
            time: self.time,
            deviation: &self.to,
            // where a break or the end cut the latest step, that to come
            step: if self.time >= self.limit {
                self.next_size
            } else {
                self.size
            },
            counters: self.counters,
        }
    }

    fn stability_limit(&self) -> Option<f64> {
        Some(STABILITY)
    }
}

#[cfg(test)]
#[path = "stepper_tests.rs"]
mod tests;
