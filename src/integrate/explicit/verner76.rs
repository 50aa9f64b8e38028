//! Verner's "most efficient" pair of orders 7 and 6: ten stages, and an interpolant of order 6 with
//! three more, the first of which is the next step's own.
//!
//! The interpolant is the only one of order 6 on these stages: its polynomials solve the order
//! conditions, which leave no choice. Its local error has the order of the error estimate and, as a norm
//! over the trees of order 7, less than a quarter of its size (1.9e-4 to 8.6e-4); the published
//! interpolant of order 7 takes three evaluations more.
//!
//! Source: J. H. Verner, "Numerically optimal Runge–Kutta pairs with interpolants", *Numerical
//! Algorithms* 53 (2010) 383–396, and the rational coefficients on the author's page, pair IIa 7(6).
//!
//! ```text
//! k_i = f(t + c_i h, y + h Σ_j a_ij k_j),   y₁ = y + h Σ_i b_i k_i
//! error = h Σ_i e_i k_i,                    y(t + θh) = y + h Σ_i b_i(θ) k_i
//! ```
//!
//! Zeros at the end of a row are left out.

use fearless_simd::{Simd, SimdBase, f64x4};

use crate::integrate::chunks::{Chunk, in_register};

/// Number of stages, those for dense output included.
pub(super) const STAGES: usize = 13;

/// The slopes of all stages of a chunk of the state.
pub(super) type Stages = [Chunk; STAGES];

/// Order of the method, and the power of the step size that the error estimate falls with.
pub(super) const ORDER: i32 = 7;

/// Product of step and eigenvalue at which the method ceases to be stable on the negative real axis, without its
/// sign.
pub(super) const STABILITY: f64 = 4.65;

/// Error of the quadrature by the weights, over a step of one, of a derivative that grows from some position on, or
/// falls to it, with a power of the distance: root mean square over all positions, within a third for powers from 1 to 2.
pub(super) fn error_over_surface(exponent: f64) -> f64 {
    9.4e-4 * 10_f64.powf(1.5 - exponent)
}

/// The stage at the end of the step, which is the first stage of the next step: the coefficients of its argument
/// are the weights b_i.
pub(super) const LAST: usize = 10;

/// c_i of all stages: first those of a trial, then the one at the end of the step, then those for dense output
/// alone.
#[rustfmt::skip]
pub(super) const NODES: [f64; STAGES] = [
    0.0, 0.005, 0.10888888888888888, 0.16333333333333333, 0.4555, 0.6095094489978381, 0.884, 0.925, 1.0, 1.0, 1.0,
    0.29, 0.125,
];

/// a_ij, a row a stage.
#[rustfmt::skip]
pub(super) const FACTORS: [&[f64]; STAGES] = [
    &[],
    &[0.005],
    &[-1.07679012345679, 1.185679012345679],
    &[0.04083333333333333, 0.0, 0.1225],
    &[0.6389139236255726, 0.0, -2.455672638223657, 2.272258714598084],
    &[-2.6615773750187572, 0.0, 10.804513886456137, -8.3539146573962, 0.820487594956657],
    &[6.067741434696771, 0.0, -24.711273635911084, 20.427517930788895, -1.9061579788166472, 1.006172249242068],
    &[12.054670076253203, 0.0, -49.75478495046899, 41.142888638604674, -4.461760149974004, 2.042334822239175,
      -0.09834843665406108],
    &[10.138146522881808, 0.0, -42.6411360317175, 35.76384003992257, -4.3480228403929075, 2.0098622683770357,
      0.3487490460338272, -0.27143900510483127],
    &[-45.030072034298676, 0.0, 187.3272437654589, -154.02882369350186, 18.56465306347536, -7.141809679295079,
      1.3088085781613785],
    &[0.04715561848627222, 0.0, 0.0, 0.25750564298434153, 0.2621665397741262, 0.15216092656738558,
      0.49399691700324844, -0.29430311714032503, 0.0813174723249511],
    &[0.0523222769159969, 0.0, 0.0, 0.22495861826705715, 0.017443709248776376, -0.007669379876829393,
      0.03435896044073285, -0.0410209723009395, 0.025651133005205617, 0.0, -0.0160443457],
    &[0.053053341257859085, 0.0, 0.0, 0.12195301011401886, 0.017746840737602496, -0.0005928372667681495,
      0.008381833970853752, -0.01293369259698612, 0.009412056815253861, 0.0, -0.005353253107275676,
      -0.06666729992455811],
];

/// e_i.
#[rustfmt::skip]
pub(super) const ERROR: &[f64] = &[
    0.0025470118799310456, 0.0, 0.0, -0.00965839487279575, 0.0420647097563969, -0.0666822437469301,
    0.26500974646212816, -0.29430311714032503, 0.0813174723249511, -0.020295184663356284,
];

/// Coefficients of θ, θ², … in b_i(θ), a row a stage.
#[rustfmt::skip]
pub(super) const DENSE: [&[f64]; STAGES] = [
    &[1.0, -7.579486522562014, 24.84859042701759, -38.850677489225404, 28.756463498563733, -8.12773429530763],
    &[],
    &[],
    &[0.0, 4.551232240400548, -41.74306197989451, 125.92086146724311, -143.27243209849883, 54.800906013734014],
    &[0.0, 2.347388766837311, -21.42965001437328, 64.01102018753913, -71.54964616066292, 26.883053760433874],
    &[0.0, 0.6629628602943922, -5.9917912094851, 17.513588061514913, -18.79068837634778, 6.758089590590962],
    &[0.0, -1.8949314831970303, 17.845518911936193, -56.77440614878831, 70.55596299657564, -29.238147359523253],
    &[0.0, 1.4890772334966687, -13.95068086791359, 43.935737386438966, -53.741559805965785, 21.973122936803417],
    &[0.0, -0.5934749977615343, 5.532214575131257, -17.250578848875403, 20.76631879735288, -8.373162053522249],
    &[],
    &[0.0, 0.5229705513661462, -4.935085895387111, 15.776866594040204, -19.84035770738366, 8.475606457364421],
    &[0.0, -8.546914399459162, 71.42491845557421, -182.3743002138117, 184.6615026587374, -65.16520650104074],
    &[0.0, 9.041175750584674, -31.600972402605663, 28.091889003924496, 2.4544361976293034, -7.986528549532809],
];

/// A number of each stage, four stages side by side.
pub(super) type StageWeights = [Chunk; STAGES.div_ceil(4)];

/// Powers of θ in the weights b_i(θ).
const POWERS: usize = 6;

/// The coefficients of `DENSE`, power by power.
const DENSE_BY_POWER: [StageWeights; POWERS] = {
    let mut by_power = [[[0.0; 4]; STAGES.div_ceil(4)]; POWERS];
    let mut stage = 0;
    while stage < STAGES {
        let mut power = 0;
        while power < POWERS {
            by_power[power][stage / 4][stage % 4] = entry(DENSE[stage], power);
            power += 1;
        }
        stage += 1;
    }
    by_power
};

/// The weights b_i(θ) at a part of the step.
#[inline(always)]
pub(super) fn dense_weights<S: Simd>(simd: S, part: f64) -> StageWeights {
    let mut sums = [f64x4::splat(simd, 0.0); STAGES.div_ceil(4)];
    for coefficients in DENSE_BY_POWER.iter().rev() {
        for (sum, coefficients) in sums.iter_mut().zip(coefficients) {
            *sum = (*sum + in_register(simd, coefficients)) * part;
        }
    }
    sums.map(|sum| *sum)
}

/// Σ_i b_i(θ) k_i of a chunk by these weights.
#[inline(always)]
pub(super) fn dense_sum<S: Simd>(simd: S, weights: &StageWeights, stages: &Stages) -> f64x4<S> {
    let mut sum = f64x4::splat(simd, 0.0);
    for (weight, slope) in weights.as_flattened().iter().zip(stages) {
        sum += in_register(simd, slope) * *weight;
    }
    sum
}

/// Entry of a row, zero after its end.
pub(super) const fn entry(row: &[f64], column: usize) -> f64 {
    if column < row.len() { row[column] } else { 0.0 }
}

/// Σ_j factor_j k_j of a chunk by a constant row, as straight-line code: factors that are zero cost nothing.
macro_rules! sum_of_stages {
    ($simd:expr, $row:expr, $stages:expr) => {
        sum_of_stages!($simd, $row, $stages, 0 1 2 3 4 5 6 7 8 9 10 11 12)
    };
    ($simd:expr, $row:expr, $stages:expr, $($stage:literal)*) => {{
        let mut sum = f64x4::splat($simd, 0.0);
        $(
            if const { entry($row, $stage) != 0.0 } {
                sum += in_register($simd, &$stages[$stage]) * const { entry($row, $stage) };
            }
        )*
        sum
    }};
}
pub(super) use sum_of_stages;

#[cfg(test)]
#[path = "verner76_tests.rs"]
mod tests;
