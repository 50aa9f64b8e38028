//! What defines an explicit Runge–Kutta–Nyström pair, and its sums over stages.
//!
//! ```text
//! k_i = f(t + c_i h, q + c_i h v + h² Σ_j a_ij k_j)
//! q₁ = q + h v + h² Σ_i b_i k_i,   v₁ = v + h Σ_i d_i k_i
//! ```

use std::marker::PhantomData;

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

/// Factors of a sum over stages, known when the code is compiled.
pub(super) trait Factors {
    const OF: [f64; MOST];
}

/// The factors a_ij of stage `I`.
pub(super) struct Arguments<P, const I: usize>(PhantomData<P>);
/// The factors b_i.
pub(super) struct Place<P>(PhantomData<P>);
/// The factors d_i.
pub(super) struct Velocity<P>(PhantomData<P>);
/// The differences of b_i.
pub(super) struct PlaceError<P>(PhantomData<P>);
/// The differences of d_i.
pub(super) struct VelocityError<P>(PhantomData<P>);

/// The factors of the coarser estimate.
pub(super) struct CoarseError<P>(PhantomData<P>);

impl<P: Pair> Factors for CoarseError<P> {
    const OF: [f64; MOST] = P::COARSE_ERROR;
}

impl<P: Pair, const I: usize> Factors for Arguments<P, I> {
    const OF: [f64; MOST] = P::ARGUMENTS[I];
}

impl<P: Pair> Factors for Place<P> {
    const OF: [f64; MOST] = P::PLACE;
}

impl<P: Pair> Factors for Velocity<P> {
    const OF: [f64; MOST] = P::VELOCITY;
}

impl<P: Pair> Factors for PlaceError<P> {
    const OF: [f64; MOST] = P::PLACE_ERROR;
}

impl<P: Pair> Factors for VelocityError<P> {
    const OF: [f64; MOST] = P::VELOCITY_ERROR;
}

/// Σ_j factor_j k_j of the first N/2 components as straight-line code: factors that are zero cost
/// nothing.
#[inline(always)]
pub(super) fn sum<F: Factors, const N: usize>(stages: &[[f64; N]; MOST]) -> [f64; N] {
    let mut sum = [0.0; N];
    macro_rules! add {
        ($($stage:literal)*) => {$(
            if const { F::OF[$stage] != 0.0 } {
                let factor = const { F::OF[$stage] };
                for component in 0..N / 2 {
                    sum[component] += factor * stages[$stage][component];
                }
            }
        )*};
    }
    add!(0 1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 16);
    sum
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
