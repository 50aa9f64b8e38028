//! The motion between the ends of a step, sample by sample.
//!
//! ```text
//! y(t + δ) = exp(δJ) y(t) + Σ_m δ^(m+1) φ_{m+1}(δJ) p⁽ᵐ⁾(t)
//! ```
//!
//! with p the polynomial of the nonlinear remainder: exact as the step itself, whatever the linear part does
//! between two samples. The sum is a polynomial of the sample's number, found once a step.

use super::functions::Functions;
use super::linear::{LinearPart, add, joined};
use super::nodes::{NODES, POINTS, Points, PointsOfChunk, combined, no_points};
use crate::integrate::chunks::Padded;
use crate::numerics::registers::in_wide_registers;

/// A sample within a step, and how to come to the next.
#[derive(Debug, Clone)]
pub(super) struct Cursor {
    /// Samples after the step's start; infinite where it is in no step.
    pub index: f64,
    coordinates: Padded,
    /// Coefficients of the powers of the index in the sum.
    forcing: Points,
}

impl Cursor {
    /// Of so many states, in no step.
    pub fn new(states: usize) -> Self {
        Self {
            index: f64::INFINITY,
            coordinates: Padded::zeros(states),
            forcing: no_points(states),
        }
    }

    /// Goes to the start of a step of so many intervals of samples, s.
    #[inline(never)]
    pub fn begin(
        &mut self,
        from: &Padded,
        remainder: &Points,
        [interval, intervals]: [f64; 2],
        phi: &[Functions],
        linear: &LinearPart,
    ) {
        self.index = 0.0;
        self.coordinates.copy_from(from);
        in_wide_registers!(linear.level, {
            for (forcing, (remainder, phi)) in
                self.forcing.iter_mut().zip(remainder.iter().zip(phi))
            {
                *forcing = forcing_of(&derivatives(remainder, intervals), interval, phi);
            }
        });
    }

    /// Goes to a sample that is not behind and finds its deviation.
    #[inline(never)]
    pub fn go_to(
        &mut self,
        index: f64,
        phi: &[Functions],
        linear: &LinearPart,
        deviation: &mut Padded,
    ) {
        in_wide_registers!(linear.level, {
            while self.index < index {
                self.go_on(phi);
            }
            linear.find_deviation(&self.coordinates, deviation);
        });
    }

    /// Goes to the next sample.
    #[inline(always)]
    fn go_on(&mut self, phi: &[Functions]) {
        let index = self.index;
        let chunks = self.forcing.iter().zip(phi);
        for (coordinates, (forcing, phi)) in self.coordinates.chunks_mut().iter_mut().zip(chunks) {
            let mut next = [0.0; 4];
            for coefficient in forcing.iter().rev() {
                for i in 0..4 {
                    next[i] = next[i] * index + coefficient[i];
                }
            }
            let mut sums = [next, [0.0; 4]];
            add(&phi[0], coordinates, &mut sums);
            *coordinates = joined(&sums);
        }
        self.index += 1.0;
    }
}

/// Derivatives of the remainder at the start by the number of the sample.
#[inline(always)]
fn derivatives(remainder: &PointsOfChunk, intervals: f64) -> PointsOfChunk {
    let mut derivatives = [[0.0; 4]; POINTS];
    let mut factor = 1.0;
    for (power, derivative) in derivatives.iter_mut().enumerate() {
        let mut weights = [0.0; POINTS];
        for (weight, row) in weights.iter_mut().zip(&NODES.power) {
            *weight = factor * row[power];
        }
        *derivative = combined(&weights, remainder);
        factor *= (power + 1) as f64 / intervals;
    }
    derivatives
}

/// Coefficients of the powers of a sample's number in what the remainder adds up to it.
#[inline(always)]
fn forcing_of(derivatives: &PointsOfChunk, interval: f64, phi: &Functions) -> PointsOfChunk {
    let mut forcing = [[0.0; 4]; POINTS];
    // over an interval, divided by the factorials of the powers
    let mut factor = interval;
    for (power, coefficient) in forcing.iter_mut().enumerate() {
        let mut sums = [[0.0; 4]; 2];
        for (function, derivative) in phi[1..].iter().zip(&derivatives[power..]) {
            add(function, derivative, &mut sums);
        }
        *coefficient = joined(&sums).map(|entry| entry * factor);
        factor /= (power + 1) as f64;
    }
    forcing
}
