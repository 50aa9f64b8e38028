//! The motion between the ends of a step, sample by sample.
//!
//! ```text
//! y(t + δ) = exp(δJ) y(t) + Σ_m δ^(m+1) φ_{m+1}(δJ) p⁽ᵐ⁾(t)
//! ```
//!
//! with p the polynomial of the slow part: exact as the step itself, whatever the linear part does
//! between two samples. The sum is a polynomial of the sample's number, found once a step.

use fearless_simd::{Level, dispatch};

use super::columns::apply;
use super::nodes::{NODES, POINTS, Points, combined};
use super::phi::Family;
use super::propagator::LinearPart;

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
        linear: &LinearPart<N>,
    ) -> Self {
        dispatch!(linear.level, _ => {
            let push = pushes(slow, [interval, intervals], family, linear.first);
            Self { index: 0.0, state: from, push }
        })
    }

    /// Number of samples after the step's start.
    pub fn index(&self) -> f64 {
        self.index
    }

    /// Goes to a sample that is not behind; its deviation.
    pub fn go_to(&mut self, index: f64, family: &Family<N>, level: Level) -> [f64; N] {
        dispatch!(level, _ => {
            while self.index < index {
                self.go_on(family);
            }
        });
        self.state
    }

    /// Goes to the next sample.
    #[inline(always)]
    fn go_on(&mut self, family: &Family<N>) {
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
}

/// Coefficients of the powers of a sample's number in what the slow part adds up to it.
#[inline(always)]
fn pushes<const N: usize>(
    slow: &Points<N>,
    [interval, intervals]: [f64; 2],
    family: &Family<N>,
    first: usize,
) -> Points<N> {
    let mut derivatives = [[0.0; N]; POINTS];
    let mut factor = 1.0;
    for (power, derivative) in derivatives.iter_mut().enumerate() {
        let mut weights = [0.0; POINTS];
        for (weight, row) in weights.iter_mut().zip(&NODES.power) {
            *weight = factor * row[power];
        }
        *derivative = combined(&weights, slow);
        factor *= (power + 1) as f64 / intervals;
    }
    let mut pushes = [[0.0; N]; POINTS];
    let mut factor = interval;
    for (power, push) in pushes.iter_mut().enumerate() {
        for (function, derivative) in family[1..].iter().zip(&derivatives[power..]) {
            apply(function, first, derivative, push);
        }
        for entry in push {
            *entry *= factor;
        }
        factor /= (power + 1) as f64;
    }
    pushes
}
