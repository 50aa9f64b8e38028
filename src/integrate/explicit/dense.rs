//! States between the ends of a step.

use super::pair::ExplicitPair;
use super::stepper::ExplicitStepper;
use crate::integrate::chunks::{Padded, add_scaled};
use crate::integrate::problem::Problem;

impl<P: ExplicitPair> ExplicitStepper<P> {
    /// Writes the state at a time that is neither before the start of the latest step nor after its end.
    pub(super) fn interpolate(&mut self, problem: &Problem<'_>, time: f64, state: &mut [f64]) {
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

    /// Evaluates the stages for dense output, once a step.
    pub(super) fn extend(&mut self, problem: &Problem<'_>) {
        if !self.extended {
            self.extended = true;
            self.evaluate_stages::<true>(problem);
        }
    }

    /// Finds the deviation within the step by the pair's own interpolant.
    pub(super) fn by_stages(&self, time: f64, deviation: &mut Padded) {
        let part = self.substitution.inverse((time - self.start) / self.size);
        let weights = P::dense_weights(part);
        let chunks = self.from.chunks().iter().zip(&self.stages);
        for (deviation, (from, stages)) in deviation.chunks_mut().iter_mut().zip(chunks) {
            let mut sum = [0.0; 4];
            for (weight, slope) in weights.iter().zip(stages) {
                add_scaled(&mut sum, *weight, slope);
            }
            for i in 0..4 {
                deviation[i] = from[i] + self.size * sum[i];
            }
        }
    }
}
