//! When a new linearisation pays, and about which state it is taken.
//!
//! A linear part that is no longer that of the motion costs sweeps, and a new one costs slopes and matrices.
//! But where contacts pass by, as balls do under damping of their own, no linear part stays right over a
//! step, and a new one saves nothing: whether it did is looked at, and the next is waited for accordingly.

use super::nodes::POINTS;

/// Sweeps that a step may take without a better linear part saving any.
pub(super) const USUAL_SWEEPS: u32 = 2;
/// Evaluations that a new linear part and its propagators cost, about.
const COST: f64 = 200.0;
/// Steps over which the evaluations per time before and after a new linear part are compared, and the part
/// of them that is left where it helped.
const COMPARED: f64 = 8.0;
const HELPED: f64 = 0.8;
/// Most times of the cost that are waited for after linear parts that did not help.
const MOST_PATIENCE: f64 = 16.0;

/// Evaluations that a better linear part might have saved, and what the latest one did save.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Relinearisation {
    /// Evaluations that a better linear part might have saved since the latest one.
    waste: f64,
    /// Times of its cost that a linear part is to save.
    patience: f64,
    /// Evaluations and simulated time, s, of the latest steps, and number of steps with the linear part.
    work: f64,
    time: f64,
    steps: f64,
    /// Evaluations per time with the linear part before.
    before: f64,
}

impl Relinearisation {
    /// Without a linear part: it is to be taken.
    pub const NONE: Self = Self {
        waste: f64::INFINITY,
        patience: 1.0,
        work: 0.0,
        time: 0.0,
        steps: 0.0,
        before: f64::INFINITY,
    };

    /// Whether a new linear part pays.
    pub fn pays(&self) -> bool {
        self.waste >= self.patience * COST
    }

    /// A new linear part was taken.
    pub fn taken(&mut self) {
        self.before = if self.time > 0.0 {
            self.work / self.time
        } else {
            f64::INFINITY
        };
        (self.waste, self.work, self.time, self.steps) = (0.0, 0.0, 0.0, 0.0);
    }

    /// A trial took some sweeps and was for nothing.
    pub fn count_rejected(&mut self, sweeps: u32, waste: u32) {
        self.waste += evaluations(waste);
        self.work += evaluations(sweeps);
    }

    /// A step of a size in s took some sweeps.
    pub fn count_step(&mut self, size: f64, sweeps: u32) {
        self.waste += evaluations(sweeps.saturating_sub(USUAL_SWEEPS));
        let kept = 1.0 - 1.0 / COMPARED;
        self.work = kept * self.work + evaluations(sweeps);
        self.time = kept * self.time + size;
        self.steps += 1.0;
        if self.steps == COMPARED {
            let helped = self.work < HELPED * self.before * self.time;
            self.patience = if helped {
                1.0
            } else {
                (2.0 * self.patience).min(MOST_PATIENCE)
            };
        }
    }
}

/// Evaluations of some sweeps.
fn evaluations(sweeps: u32) -> f64 {
    f64::from(sweeps) * (POINTS - 1) as f64
}

/// Steps that the mean remembers.
const REMEMBERED: f64 = 16.0;

/// Mean of the deviations at the ends of steps: the motion of the next steps goes about it, and not about where it
/// happens to be as a new linear part is taken.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Mean {
    pub deviation: Vec<f64>,
    /// Ends of steps that it is taken over.
    pub steps: f64,
}

impl Mean {
    /// Of one deviation.
    pub fn of(deviation: &[f64]) -> Self {
        Self {
            deviation: deviation.to_vec(),
            steps: 1.0,
        }
    }

    /// Begins anew with one deviation.
    pub fn begin(&mut self, deviation: &[f64]) {
        self.deviation.copy_from_slice(deviation);
        self.steps = 1.0;
    }

    /// Takes in a further one; those of long ago fade.
    pub fn take_in(&mut self, deviation: &[f64]) {
        self.steps = (self.steps + 1.0).min(REMEMBERED);
        for (mean, value) in self.deviation.iter_mut().zip(deviation) {
            *mean += (value - *mean) / self.steps;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Steps until a new linear part pays, and then takes it.
    fn steps_to_the_next(relinearisation: &mut Relinearisation, sweeps: u32) -> u32 {
        let mut steps = 0;
        while !relinearisation.pays() {
            relinearisation.count_step(1.0, sweeps);
            steps += 1;
        }
        relinearisation.taken();
        steps
    }

    /// Linear parts that save nothing are taken ever less often; one that saves brings the next one soon.
    #[test]
    fn a_linear_part_that_does_not_help_is_not_taken_again_soon() {
        let mut relinearisation = Relinearisation::NONE;
        relinearisation.taken();
        let first = steps_to_the_next(&mut relinearisation, 4);
        let second = steps_to_the_next(&mut relinearisation, 4);
        let third = steps_to_the_next(&mut relinearisation, 4);
        assert!(
            second > 3 * first / 2 && third > 3 * second / 2,
            "{first} {second} {third}"
        );
        for _ in 0..8 {
            relinearisation.count_step(1.0, 2);
        }
        assert_eq!(relinearisation.patience, 1.0);
    }

    /// The first deviations weigh alike, and a motion about a place comes to a mean near it, wherever it began.
    #[test]
    fn a_start_fades_and_a_swing_evens_out() {
        let mut mean = Mean::of(&[3.0]);
        mean.take_in(&[6.0]);
        mean.take_in(&[0.0]);
        assert_eq!(mean.deviation, [3.0]);
        let mut mean = Mean::of(&[100.0]);
        for step in 0..200 {
            mean.take_in(&[5.0 + (1.3 * f64::from(step)).cos()]);
        }
        assert!((mean.deviation[0] - 5.0).abs() < 0.1, "{mean:?}");
    }
}
