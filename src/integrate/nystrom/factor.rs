//! The integrating factor that takes forces linear in the velocity out of the equations of motion.
//!
//! ```text
//! q″ + 2 B q′ = f(t, q),   q = exp(−B τ) u   →   u″ = exp(B τ) (f + B² q)
//! ```
//!
//! with constant B and τ the time since the start of the step: what is left has no velocity. Of damping
//! and gyroscopic terms B² remains, which is small against the stiffness wherever a motion oscillates.
//!
//! Source: the substitution is Liouville's for a number in the place of B, which commutes with its own
//! exponential as well as a number does; as a numerical method J. D. Lawson, *SIAM J. Numer. Anal.* 4
//! (1967) 372–380.

use super::entries::{Entries, Matrix};
use super::tableau::{MOST, Pair};

/// Terms of the exponential's series, an even number: enough for round-off up to a norm of one.
const TERMS: usize = 20;
/// First term of the series that may be left out.
const NOTHING: f64 = 1e-17;
/// Largest product of step size and norm of B: far above it the factor spoils what it multiplies.
const LARGEST: f64 = 1.0;

/// exp(∓B c_i h) at the nodes of a pair, and what they are made of.
#[derive(Debug, Clone)]
pub(super) struct Factor<E, const N: usize> {
    /// B.
    half: E,
    /// B².
    square: E,
    /// Norm of B, 1/s.
    norm: f64,
    /// B^k/k!.
    powers: [E; TERMS],
    /// Step size that the exponentials are of, s.
    size: f64,
    /// exp(−B c_i h).
    forth: [E; MOST],
    /// exp(B c_i h).
    back: [E; MOST],
}

impl<E: Entries<N>, const N: usize> Factor<E, N> {
    /// From ∂q″/∂q′ = −2 B, of which the first N/2 rows and columns are read.
    pub fn new(velocity_slopes: &Matrix<N>) -> Self {
        let half = scaled(E::of(velocity_slopes), -0.5);
        let mut powers = [E::identity(); TERMS];
        for order in 1..TERMS {
            powers[order] = scaled(powers[order - 1].product(&half), (order as f64).recip());
        }
        Self {
            half,
            square: half.product(&half),
            norm: 0.5 * norm(velocity_slopes),
            powers,
            size: f64::NAN,
            forth: [E::ZERO; MOST],
            back: [E::ZERO; MOST],
        }
    }

    /// Largest step that the factor serves, s.
    pub fn largest_step(&self) -> f64 {
        LARGEST / self.norm
    }

    /// Prepares the exponentials for steps of a size, s.
    pub fn prepare<P: Pair>(&mut self, size: f64) {
        if self.size == size {
            return;
        }
        self.size = size;
        let terms = self.terms(size);
        for node in 1..P::STAGES {
            self.exponentials(node, P::NODES[node] * size, terms);
        }
    }

    /// Terms after which the rest of the series is nothing, an even number.
    fn terms(&self, size: f64) -> usize {
        let (mut term, mut count) = (1.0, 1);
        while term > NOTHING && count < TERMS {
            term *= self.norm * size / count as f64;
            count += 1;
        }
        count.next_multiple_of(2)
    }

    /// Even and odd terms apart: their sum and their difference are the two exponentials.
    #[inline(always)]
    fn exponentials(&mut self, node: usize, time: f64, terms: usize) {
        let square = time * time;
        let (mut even, mut odd) = (E::ZERO, E::ZERO);
        for [first, second] in self.powers[..terms].as_chunks().0.iter().rev() {
            for (sum, term) in even.as_mut().iter_mut().zip(first.as_ref()) {
                *sum = *sum * square + term;
            }
            for (sum, term) in odd.as_mut().iter_mut().zip(second.as_ref()) {
                *sum = *sum * square + term;
            }
        }
        let both = even.as_ref().iter().zip(odd.as_ref());
        let forth = self.forth[node].as_mut().iter_mut();
        let back = self.back[node].as_mut().iter_mut();
        for ((even, odd), (forth, back)) in both.zip(forth.zip(back)) {
            *forth = even - time * odd;
            *back = even + time * odd;
        }
    }

    /// exp(−B c_i h) times a vector: from u to q.
    #[inline(always)]
    pub fn forth(&self, node: usize, vector: &[f64; N]) -> [f64; N] {
        self.forth[node].times(vector)
    }

    /// exp(B c_i h) times a vector.
    #[inline(always)]
    pub fn back(&self, node: usize, vector: &[f64; N]) -> [f64; N] {
        self.back[node].times(vector)
    }

    /// B times a vector.
    #[inline(always)]
    pub fn half(&self, vector: &[f64; N]) -> [f64; N] {
        self.half.times(vector)
    }

    /// B² times a vector, added to another.
    #[inline(always)]
    pub fn add_square(&self, vector: &[f64; N], sum: &mut [f64; N]) {
        let product = self.square.times(vector);
        for index in 0..N / 2 {
            sum[index] += product[index];
        }
    }
}

/// All entries times a number.
fn scaled<E: AsMut<[f64]>>(mut entries: E, factor: f64) -> E {
    for entry in entries.as_mut() {
        *entry *= factor;
    }
    entries
}

/// Largest sum of magnitudes in a row.
fn norm<const N: usize>(matrix: &Matrix<N>) -> f64 {
    let rows = matrix.iter().take(N / 2);
    let sums = rows.map(|row| row.iter().take(N / 2).map(|entry| entry.abs()).sum());
    sums.fold(0.0, f64::max)
}
