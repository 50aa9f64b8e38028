//! What defines an explicit Runge–Kutta–Nyström pair, and its sums over stages.
//!
//! ```text
//! k_i = f(t + c_i h, q + c_i h v + h² Σ_j a_ij k_j)
//! q₁ = q + h v + h² Σ_i b_i k_i,   v₁ = v + h Σ_i d_i k_i
//! ```

use fearless_simd::{Simd, SimdBase};

use super::row::{Lanes, Row};

/// Most stages of a pair.
pub(super) const MOST: usize = 17;

/// A pair of explicit Runge–Kutta–Nyström methods for q″ = f(t, q).
pub(in crate::integrate) trait Pair {
    /// Stages of a trial step, counted from 0; stage 0 is f at its start.
    const STAGES: usize;
    /// Whether the last of them is f at the end of the step.
    const ENDS_ON_STAGE: bool;
    /// Order of the method.
    const ORDER: i32;
    /// Power of the step size that the error estimate falls with.
    const ERROR_POWER: i32;
    /// Error allowed in one step, as a part of the error aimed at over the run: measured, so that
    /// the error over the run is about the tolerance.
    const LOCAL_PART: f64;
    /// Product of step and circular frequency from which on an undamped oscillation grows by more than a
    /// hundredth a step.
    const STABILITY: f64;
    /// Error of a step over a surface, over its size and what the surface adds over all of it: root mean square over
    /// where in the step it is.
    const CROSSED: f64;
    /// c_i.
    const NODES: [f64; MOST];
    /// a_ij, a row a stage.
    const ARGUMENTS: [[f64; MOST]; MOST];
    /// b_i.
    const PLACE: [f64; MOST];
    /// d_i.
    const VELOCITY: [f64; MOST];
    /// b_i less those of the other method.
    const PLACE_ERROR: [f64; MOST];
    /// d_i less those of the other method.
    const VELOCITY_ERROR: [f64; MOST];
    /// Factors of a coarser estimate of the velocity's error that tempers the first: of an order that is
    /// lower by two, as the first is of the method's.
    const COARSE_ERROR: [f64; MOST];
}

/// Σ_j factor_j k_j for each of some rows of factors. A loop and no straight-line code: that of all pairs and
/// systems takes the compiler minutes, and steps no less time.
#[inline(always)]
pub(super) fn sums<V: Simd, const N: usize, const ROWS: usize>(
    simd: V,
    factors: [&[f64]; ROWS],
    stages: &[Row<N>; MOST],
) -> [Row<N>; ROWS] {
    let mut sums = [Row::ZERO; ROWS];
    for register in 0..Row::<N>::REGISTERS {
        let mut lanes = [Lanes::splat(simd, 0.0); ROWS];
        for (index, stage) in stages.iter().enumerate().take(factors[0].len()) {
            let stage = stage.load(simd, register);
            for row in 0..ROWS {
                lanes[row] += stage * factors[row][index];
            }
        }
        for row in 0..ROWS {
            sums[row].store(register, lanes[row]);
        }
    }
    sums
}

/// Numbers followed by zeros.
pub(super) const fn padded<const GIVEN: usize>(given: [f64; GIVEN]) -> [f64; MOST] {
    let mut all = [0.0; MOST];
    let mut index = 0;
    while index < GIVEN {
        all[index] = given[index];
        index += 1;
    }
    all
}

/// Rows followed by rows of zeros.
pub(super) const fn padded_rows<const GIVEN: usize>(
    given: [[f64; MOST]; GIVEN],
) -> [[f64; MOST]; MOST] {
    let mut all = [[0.0; MOST]; MOST];
    let mut index = 0;
    while index < GIVEN {
        all[index] = given[index];
        index += 1;
    }
    all
}

/// Factors of the divided difference of some stages, times a number.
pub(super) const fn difference(nodes: &[f64; MOST], stages: &[usize], part: f64) -> [f64; MOST] {
    let mut factors = [0.0; MOST];
    let mut index = 0;
    while index < stages.len() {
        let (mut factor, mut other) = (part, 0);
        while other < stages.len() {
            if other != index {
                factor /= nodes[stages[index]] - nodes[stages[other]];
            }
            other += 1;
        }
        factors[stages[index]] = factor;
        index += 1;
    }
    factors
}
