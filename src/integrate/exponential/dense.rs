//! The motion between the ends of a step, sample by sample.
//!
//! ```text
//! y(t + δ) = exp(δJ) y(t) + Σ_m δ^(m+1) φ_{m+1}(δJ) p⁽ᵐ⁾(t)
//! ```
//!
//! with p the polynomial of the slow part: exact as the step itself, whatever the linear part does
//! between two samples. The sum is a polynomial of the sample's number, found once a step.

use super::columns::apply;
use super::nodes::{NODES, POINTS, Points, combined};
use super::phi::Family;

/// A sample within a step, and how to come to the next.
#[derive(Debug, Clone, Copy)]
pub(super) struct Cursor<const N: usize> {
    /// Samples after the step's start.
    index: f64,
    state: [f64; N],
    /// Coefficients of the powers of the index in the sum.
    push: Points<N>,
}

impl<const N: usize> Cursor<N> {
    /// Stands at the start of a step of so many intervals of samples, s.
    pub fn new(
        from: [f64; N],
        slow: &Points<N>,
        [interval, intervals]: [f64; 2],
        family: &Family<N>,
        first: usize,
    ) -> Self {
        let part = 1.0 / intervals;
        let mut factor = 1.0;
        let derivatives: Points<N> = std::array::from_fn(|power| {
            let weights: [f64; POINTS] = std::array::from_fn(|j| factor * NODES.power[j][power]);
            factor *= part * (power + 1) as f64;
            combined(&weights, slow)
        });
        let mut factor = interval;
        let push = std::array::from_fn(|power| {
            let mut sum = [0.0; N];
            for (function, derivative) in family[1..].iter().zip(&derivatives[power..]) {
                apply(function, first, derivative, &mut sum);
            }
            let push = sum.map(|value| factor * value);
            factor /= (power + 1) as f64;
            push
        });
        Self {
            index: 0.0,
            state: from,
            push,
        }
    }

    /// Number of samples after the step's start.
    pub fn index(&self) -> f64 {
        self.index
    }

    /// Goes to a sample that is not behind; its deviation.
    pub fn go_to(&mut self, index: f64, family: &Family<N>) -> [f64; N] {
        while self.index < index {
            let mut next = [0.0; N];
            for push in self.push.iter().rev() {
                for i in 0..N {
                    next[i] = next[i] * self.index + push[i];
                }
            }
            apply(&family[0], 0, &self.state, &mut next);
            self.state = next;
            self.index += 1.0;
        }
        self.state
    }
}
