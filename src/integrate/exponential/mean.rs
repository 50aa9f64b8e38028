//! The mean of the states of late: the motion of the next steps goes about it, and not about where it happens to
//! be as a new linear part is taken.

/// Steps that are remembered.
const STEPS: f64 = 16.0;

/// Mean of the deviations at the ends of steps.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Mean<const N: usize> {
    pub deviation: [f64; N],
    /// Ends of steps that it is taken over.
    pub steps: f64,
}

impl<const N: usize> Mean<N> {
    /// Of one deviation.
    pub fn of(deviation: [f64; N]) -> Self {
        Self {
            deviation,
            steps: 1.0,
        }
    }

    /// Takes in a further one; those of long ago fade.
    pub fn take_in(&mut self, deviation: &[f64; N]) {
        self.steps = (self.steps + 1.0).min(STEPS);
        for (mean, value) in self.deviation.iter_mut().zip(deviation) {
            *mean += (value - *mean) / self.steps;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The first deviations weigh alike, and a motion about a place comes to a mean near it, wherever it began.
    #[test]
    fn a_start_fades_and_a_swing_evens_out() {
        let mut mean = Mean::of([3.0]);
        mean.take_in(&[6.0]);
        mean.take_in(&[0.0]);
        assert_eq!(mean.deviation, [3.0]);
        let mut mean = Mean::of([100.0]);
        for step in 0..200 {
            mean.take_in(&[5.0 + (1.3 * f64::from(step)).cos()]);
        }
        assert!((mean.deviation[0] - 5.0).abs() < 0.1, "{mean:?}");
    }
}
