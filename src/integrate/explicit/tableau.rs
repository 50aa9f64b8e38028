//! What defines an explicit Runge–Kutta pair, and its sums over stages.
//!
//! ```text
//! k_i = f(t + c_i h, y + h Σ_j a_ij k_j),   y₁ = y + h Σ_i b_i k_i
//! error = h Σ_i e_i k_i,                    y(t + θh) = y + h Σ_i b_i(θ) k_i
//! ```

use std::marker::PhantomData;

/// Most stages of a pair, those of its dense output among them.
pub(in crate::integrate) const MOST: usize = 13;
/// Highest degree of a dense output.
pub(in crate::integrate) const DEGREE: usize = 6;

/// A pair of explicit Runge–Kutta methods with dense output.
///
/// Stages count from 0. The first [`Pair::TRIAL`] of them make a trial step, stage [`Pair::LAST`] is
/// the derivative at its end, which is the first stage of the next step, and those after it serve
/// dense output alone.
pub(in crate::integrate) trait Pair {
    /// Stages of a trial step.
    const TRIAL: usize;
    /// The stage at the end of the step; its arguments' coefficients are the weights b_i.
    const LAST: usize;
    /// All stages.
    const STAGES: usize;
    /// Order of the method.
    const ORDER: i32;
    /// Power of the step size that the error estimate falls with.
    const ERROR_POWER: i32;
    /// Error allowed in one step, as a part of the error aimed at over the run: measured, so that
    /// the error over the run is about the tolerance.
    const LOCAL_PART: f64;
    /// Product of step and eigenvalue at which the method ceases to be stable on the negative real
    /// axis, without its sign.
    const STABILITY: f64;
    /// Error of the quadrature by the weights, over a step of one, of a derivative that grows from some
    /// place on, or falls to it, with the power 3/2 of the distance; root mean square over all places.
    const CROSSED: f64;
    /// c_i.
    const NODES: [f64; MOST];
    /// a_ij, a row a stage.
    const ARGUMENTS: [[f64; MOST]; MOST];
    /// e_i.
    const ERROR: [f64; MOST];
    /// Coefficients of θ, θ², … in b_i(θ), a row a stage.
    const DENSE: [[f64; DEGREE]; MOST];
}

/// Factors of a sum over stages, known when the code is compiled.
pub(super) trait Factors {
    const OF: [f64; MOST];
}

/// The factors a_ij of stage `I`.
pub(super) struct Arguments<P, const I: usize>(PhantomData<P>);
/// The weights b_i.
pub(super) struct Weights<P>(PhantomData<P>);
/// The factors e_i.
pub(super) struct Error<P>(PhantomData<P>);

impl<P: Pair, const I: usize> Factors for Arguments<P, I> {
    const OF: [f64; MOST] = P::ARGUMENTS[I];
}

impl<P: Pair> Factors for Weights<P> {
    const OF: [f64; MOST] = P::ARGUMENTS[P::LAST];
}

impl<P: Pair> Factors for Error<P> {
    const OF: [f64; MOST] = P::ERROR;
}

/// Σ_j factor_j k_j as straight-line code: factors that are zero cost nothing.
#[inline(always)]
pub(super) fn sum<F: Factors, const N: usize>(stages: &[[f64; N]; MOST]) -> [f64; N] {
    let mut sum = [0.0; N];
    macro_rules! add {
        ($($stage:literal)*) => {$(
            if const { F::OF[$stage] != 0.0 } {
                let factor = const { F::OF[$stage] };
                for component in 0..N {
                    sum[component] += factor * stages[$stage][component];
                }
            }
        )*};
    }
    add!(0 1 2 3 4 5 6 7 8 9 10 11 12);
    sum
}

/// Numbers followed by zeros.
pub(super) const fn padded<const GIVEN: usize, const ALL: usize>(
    given: [f64; GIVEN],
) -> [f64; ALL] {
    let mut all = [0.0; ALL];
    let mut index = 0;
    while index < GIVEN {
        all[index] = given[index];
        index += 1;
    }
    all
}

/// Rows followed by rows of zeros.
pub(super) const fn padded_rows<const GIVEN: usize, const WIDTH: usize>(
    given: [[f64; WIDTH]; GIVEN],
) -> [[f64; WIDTH]; MOST] {
    let mut all = [[0.0; WIDTH]; MOST];
    let mut index = 0;
    while index < GIVEN {
        all[index] = given[index];
        index += 1;
    }
    all
}
