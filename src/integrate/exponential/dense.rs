//! The motion between the ends of a step, sample by sample.
//!
//! ```text
//! y(t + δ) = exp(δJ) y(t) + Σ_m δ^(m+1) φ_{m+1}(δJ) p⁽ᵐ⁾(t)
//! ```
//!
//! with p the polynomial of the slow part: exact as the step itself, whatever the linear part does
//! between two samples. The sum is a polynomial of the sample's number, found once a step.

use super::linear::LinearPart;
use super::modes::{add, joined};
use super::nodes::{NODES, POINTS, Points, combined};
use super::propagator::Functions;
use crate::registers::in_wide_registers;

/// A sample within a step, and how to come to the next.
#[derive(Debug, Clone, Copy)]
pub(super) struct Cursor<const N: usize> {
    /// Samples after the step's start.
    index: f64,
    coordinates: [f64; N],
    /// Coefficients of the powers of the index in the sum.
    push: Points<N>,
}

impl<const N: usize> Cursor<N> {
    /// Stands at the start of a step of so many intervals of samples, s.
    #[inline(never)]
    pub fn new(
        from: [f64; N],
        slow: &Points<N>,
        [interval, intervals]: [f64; 2],
        phi: &Functions<N>,
        linear: &LinearPart<N>,
    ) -> Self {
        let push = in_wide_registers!(linear.level, {
            let derivatives = derivatives(slow, intervals);
            pushes(&derivatives, interval, phi)
        });
        Self {
            index: 0.0,
            coordinates: from,
            push,
        }
    }

    /// Number of samples after the step's start.
    pub fn index(&self) -> f64 {
        self.index
    }

    /// Goes to a sample that is not behind; its deviation.
    #[inline(never)]
    pub fn go_to(&mut self, index: f64, phi: &Functions<N>, linear: &LinearPart<N>) -> [f64; N] {
        in_wide_registers!(linear.level, {
            while self.index < index {
                self.go_on(phi);
            }
        });
        linear.deviation(&self.coordinates)
    }

    /// Goes to the next sample.
    #[inline(always)]
    fn go_on(&mut self, phi: &Functions<N>) {
        let mut next = [0.0; N];
        for push in self.push.iter().rev() {
            for i in 0..N {
                next[i] = next[i] * self.index + push[i];
            }
        }
        let mut sums = [next, [0.0; N]];
        add(&phi[0], &self.coordinates, &mut sums);
        self.coordinates = joined(&sums);
        self.index += 1.0;
    }
}

/// Derivatives of the slow part at the start by the number of the sample.
#[inline(always)]
fn derivatives<const N: usize>(slow: &Points<N>, intervals: f64) -> Points<N> {
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
    derivatives
}

/// Coefficients of the powers of a sample's number in what the slow part adds up to it.
#[inline(always)]
fn pushes<const N: usize>(
    derivatives: &Points<N>,
    interval: f64,
    functions: &Functions<N>,
) -> Points<N> {
    let mut pushes = [[0.0; N]; POINTS];
    for (power, push) in pushes.iter_mut().enumerate() {
        let mut sums = [[0.0; N]; 2];
        for (function, derivative) in functions[1..].iter().zip(&derivatives[power..]) {
            add(function, derivative, &mut sums);
        }
        *push = joined(&sums);
    }
    divided(pushes, interval)
}

/// Sums of derivatives over an interval, divided by the factorials of their powers.
#[inline(always)]
fn divided<const N: usize>(mut pushes: Points<N>, interval: f64) -> Points<N> {
    let mut factor = interval;
    for (power, push) in pushes.iter_mut().enumerate() {
        for entry in push {
            *entry *= factor;
        }
        factor /= (power + 1) as f64;
    }
    pushes
}
