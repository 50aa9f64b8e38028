//! States between the ends of a step.

use super::quintic::{self, Quintic};
use super::stepper::ExplicitStepper;
use super::verner76::dense_weights;
use crate::integrate::chunks::{Padded, add_scaled};
use crate::integrate::problem::Problem;

/// Part of the local error that the interpolation without evaluations may be estimated to have.
const QUINTIC_PART: f64 = 0.1;

impl ExplicitStepper {
    /// Writes the state at a time that is not before the start of the latest step; takes steps as far as needed.
    ///
    /// # Errors
    /// Why the run ends before that time.
    pub fn state_at(
        &mut self,
        problem: &Problem<'_>,
        time: f64,
        state: &mut [f64],
    ) -> Result<(), crate::integrate::IntegrateError> {
        while self.time < time {
            self.step(problem)?;
        }
        self.state_within(problem, time, state);
        Ok(())
    }

    /// Writes the state at a time that is neither before the start of the latest step nor after its end.
    pub fn state_within(&mut self, problem: &Problem<'_>, time: f64, state: &mut [f64]) {
        if time >= self.time {
            problem.write_state(&self.to, state);
            return;
        }
        let mut deviation = std::mem::take(&mut self.argument);
        if self.quintic {
            self.by_quintic(time, &mut deviation);
        } else {
            self.argument = deviation;
            self.extend(problem);
            deviation = std::mem::take(&mut self.argument);
            self.by_stages(time, &mut deviation);
        }
        problem.write_state(&deviation, state);
        self.argument = deviation;
    }

    /// Evaluates the stages for dense output, once a step.
    pub(super) fn extend(&mut self, problem: &Problem<'_>) {
        if !self.extended {
            self.extended = true;
            self.stage::<11>(problem);
            self.stage::<12>(problem);
        }
    }

    /// Deviation within the step by the pair's own interpolant.
    pub(super) fn by_stages(&self, time: f64, deviation: &mut Padded) {
        let part = self.substitution.inverse((time - self.start) / self.size);
        let weights = dense_weights(part);
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

    /// Deviation within the step by the motion at both ends.
    pub(super) fn by_quintic(&self, time: f64, deviation: &mut [f64]) {
        let part = (time - self.start) / self.size;
        let dofs = self.from.len() / 2;
        for dof in 0..dofs {
            let [start, end] = self.ends(dof);
            let quintic = Quintic::new(self.size, start, end);
            [deviation[dof], deviation[dofs + dof]] = quintic.at(part, self.size, start);
        }
    }

    /// Motion of a degree of freedom at both ends of the step.
    #[inline(always)]
    pub(super) fn ends(&self, dof: usize) -> [quintic::Motion; 2] {
        let velocity = self.from.len() / 2 + dof;
        [
            [
                self.from[dof],
                self.from[velocity],
                self.start_rate[velocity],
            ],
            [self.to[dof], self.to[velocity], self.end_rate[velocity]],
        ]
    }

    /// Whether the quintic's error is small beside what the step may have.
    pub(super) fn is_quintic_exact(&mut self, problem: &Problem<'_>) -> bool {
        let (size, before) = (self.size, self.size_before);
        let scale = &problem.scaling.scale;
        let allowed = QUINTIC_PART * problem.settings.tolerance;
        let dofs = self.jerk.len();
        let mut good = true;
        for dof in 0..dofs {
            let [start, end] = self.ends(dof);
            let [first, last] = Quintic::new(size, start, end).jerks();
            let jump = first / size.powi(3) - self.jerk[dof];
            self.jerk[dof] = last / size.powi(3);
            let [place, velocity] = quintic::errors(jump, size, before);
            // not so where the jump is no number
            good &= place <= allowed * (scale[dof] + start[0].abs())
                && velocity <= allowed * (scale[dofs + dof] + start[1].abs());
        }
        good
    }
}
