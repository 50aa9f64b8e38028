//! What makes an explicit Runge–Kutta pair: its coefficients.

use crate::integrate::chunks::Chunk;

/// Most stages that a pair may have, those for dense output included.
pub(super) const MOST_STAGES: usize = 13;

/// The slopes of all stages of a chunk of the state.
pub(super) type Stages = [Chunk; MOST_STAGES];

/// A pair with an interpolant, by its coefficients:
///
/// ```text
/// k_i = f(t + c_i h, y + h Σ_j a_ij k_j),   y₁ = y + h Σ_i b_i k_i
/// error = h Σ_i e_i k_i,                    y(t + θh) = y + h Σ_i b_i(θ) k_i
/// ```
///
/// Zeros at the end of a row may be left out.
pub(in crate::integrate) trait ExplicitPair {
    /// Order of the method.
    const ORDER: i32;
    /// Power of the step size that the error estimate falls with.
    const ERROR_POWER: i32;
    /// Product of step and eigenvalue at which the method ceases to be stable on the negative real axis, without its
    /// sign.
    const STABILITY: f64;
    /// Error of the quadrature by the weights, over a step of one, of a derivative that grows from some place on, or
    /// falls to it, with the power 3/2 of the distance; root mean square over all places.
    const CROSSED: f64;
    /// c_i of all stages: first those of a trial, then the one at the end of the step, then those for dense output
    /// alone.
    const NODES: &[f64];
    /// a_ij, a row a stage.
    const FACTORS: &[&[f64]];
    /// The stage at the end of the step, which is the first stage of the next step: the coefficients of its argument
    /// are the weights b_i.
    const LAST: usize;
    /// e_i.
    const ERROR: &[f64];
    /// Coefficients of θ, θ², … in b_i(θ), a row a stage.
    const DENSE: &[&[f64]];

    /// The weights b_i(θ) at a part of the step.
    fn dense_weights(part: f64) -> [f64; MOST_STAGES] {
        let mut weights = [0.0; MOST_STAGES];
        for (weight, row) in weights.iter_mut().zip(Self::DENSE) {
            *weight = part * row.iter().rev().fold(0.0, |sum, term| sum * part + term);
        }
        weights
    }
}

/// Entry of a row, zero after its end.
pub(super) const fn entry(row: &[f64], column: usize) -> f64 {
    if column < row.len() { row[column] } else { 0.0 }
}

/// Row of a table, empty after its end.
pub(super) const fn row<'a>(table: &'a [&'a [f64]], index: usize) -> &'a [f64] {
    if index < table.len() {
        table[index]
    } else {
        &[]
    }
}

/// Σ_j factor_j k_j of a chunk by a constant row, as straight-line code: factors that are zero cost nothing.
macro_rules! sum_of_stages {
    ($row:expr, $stages:expr) => {
        sum_of_stages!($row, $stages, 0 1 2 3 4 5 6 7 8 9 10 11 12)
    };
    ($row:expr, $stages:expr, $($stage:literal)*) => {{
        let mut sum = [0.0; 4];
        $(
            if const { entry($row, $stage) != 0.0 } {
                add_scaled(&mut sum, const { entry($row, $stage) }, &$stages[$stage]);
            }
        )*
        sum
    }};
}
pub(super) use sum_of_stages;
