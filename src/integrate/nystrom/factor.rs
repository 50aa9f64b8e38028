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

use fearless_simd::{Simd, SimdBase};

use super::entries::{Entries, Matrix};
use super::row::{Lanes, Row};
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
    /// h² exp(B c_i h).
    back: [E; MOST],
    /// a_i,i−1 h² exp(−B (c_i − c_i−1) h): from a force straight to the place of the stage that follows it.
    onward: [E; MOST],
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
            onward: [E::ZERO; MOST],
        }
    }

    /// Largest step that the factor serves, s.
    pub fn largest_step(&self) -> f64 {
        LARGEST / self.norm
    }

    /// Prepares the exponentials for steps of a size, s.
    #[inline(always)]
    pub fn prepare<P: Pair, V: Simd>(&mut self, simd: V, size: f64) {
        if self.size == size {
            return;
        }
        self.size = size;
        let terms = self.terms(size);
        for (node, part) in const { &P::NODES }
            .iter()
            .enumerate()
            .take(P::STAGES)
            .skip(1)
        {
            self.exponentials(simd, node, part * size, terms);
        }
        self.back[0] = scaled(E::identity(), size * size);
        for (node, arguments) in const { &P::ARGUMENTS }
            .iter()
            .enumerate()
            .take(P::STAGES)
            .skip(1)
        {
            let onward = self.forth[node].product(&self.back[node - 1]);
            self.onward[node] = scaled(onward, arguments[node - 1]);
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
    fn exponentials<V: Simd>(&mut self, simd: V, node: usize, time: f64, terms: usize) {
        let (square, per_force) = (time * time, self.size * self.size);
        let pairs = self.powers[..terms].as_chunks().0;
        let forth = self.forth[node].rows_mut().iter_mut();
        let back = self.back[node].rows_mut().iter_mut();
        for (row, (forth, back)) in forth.zip(back).enumerate() {
            for register in 0..Row::<N>::REGISTERS {
                let [mut even, mut odd] = [Lanes::splat(simd, 0.0); 2];
                for [first, second] in pairs.iter().rev() {
                    even = even * square + first.rows()[row].load(simd, register);
                    odd = odd * square + second.rows()[row].load(simd, register);
                }
                let odd = odd * time;
                forth.store(register, even - odd);
                back.store(register, (even + odd) * per_force);
            }
        }
    }

    /// exp(−B c_i h) times a vector: from u to q.
    #[inline(always)]
    pub fn forth<V: Simd>(&self, simd: V, node: usize, vector: &Row<N>) -> Row<N> {
        self.forth[node].times(simd, vector)
    }

    /// h² exp(B c_i h) times a vector.
    #[inline(always)]
    pub fn back<V: Simd>(&self, simd: V, node: usize, vector: &Row<N>) -> Row<N> {
        self.back[node].times(simd, vector)
    }

    /// What the force of the stage before adds to the place of a stage.
    #[inline(always)]
    pub fn onward<V: Simd>(&self, simd: V, node: usize, vector: &Row<N>) -> Row<N> {
        self.onward[node].times(simd, vector)
    }

    /// B times a vector.
    #[inline(always)]
    pub fn half<V: Simd>(&self, simd: V, vector: &Row<N>) -> Row<N> {
        self.half.times(simd, vector)
    }

    /// A vector and B² times another.
    #[inline(always)]
    pub fn add_square<V: Simd>(&self, simd: V, vector: &Row<N>, sum: &Row<N>) -> Row<N> {
        let product = self.square.times(simd, vector);
        Row::of(|register| sum.load(simd, register) + product.load(simd, register))
    }
}

/// All entries times a number.
fn scaled<E: Entries<N>, const N: usize>(mut entries: E, factor: f64) -> E {
    for entry in entries.rows_mut().iter_mut().flat_map(|row| row.iter_mut()) {
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
