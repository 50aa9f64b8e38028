//! Sines and cosines side by side.

use fearless_simd::{Select, Simd, SimdFloat, f64x4};

/// π/2 in three parts: the products of the first two with a whole number below 2²⁶ are exact.
const HALF_PI: [f64; 3] = [
    1.570_796_310_901_641_8,
    1.589_325_471_229_585_7e-8,
    6.123_233_995_736_766e-17,
];
/// (sin x − x)/x³ by powers of x², the highest first, for |x| ≤ π/4.
const SINE: [f64; 6] = [
    1.589_623_015_765_465_7e-10,
    -2.505_074_776_285_780_7e-8,
    2.755_731_362_138_572_5e-6,
    -1.984_126_982_958_954e-4,
    8.333_333_333_322_118e-3,
    -1.666_666_666_666_663e-1,
];
/// (cos x − 1 + x²/2)/x⁴ likewise.
const COSINE: [f64; 6] = [
    -1.135_853_652_138_768_2e-11,
    2.087_570_084_197_473e-9,
    -2.755_731_417_929_674e-7,
    2.480_158_728_885_170_5e-5,
    -1.388_888_888_887_305_6e-3,
    4.166_666_666_666_66e-2,
];

/// Sines and cosines of angles in rad, right to the last digit or two up to 1e8 rad.
///
/// ```text
/// x = q π/2 + r,  |r| ≤ π/4
/// sin r ≈ r + r³ P(r²),  cos r ≈ 1 − r²/2 + r⁴ Q(r²)
/// ```
///
/// Source: S. L. Moshier, *Cephes Mathematical Library* (1989), `sin.c`; π/2 in parts after A. Fog's vector
/// class library.
#[inline(always)]
pub(crate) fn sines_and_cosines<S: Simd>(angle: f64x4<S>) -> [f64x4<S>; 2] {
    let quarters = (angle * std::f64::consts::FRAC_2_PI).round_ties_even();
    let [first, second, third] = HALF_PI;
    let rest = ((angle - quarters * first) - quarters * second) - quarters * third;
    let square = rest * rest;
    let sine = rest + rest * square * polynomial(square, &SINE);
    let cosine = 1.0 - square * 0.5 + square * square * polynomial(square, &COSINE);
    let odd = modulo(quarters, 2.0).simd_gt(0.5);
    let low = modulo(quarters, 4.0).simd_gt(1.5);
    let high = modulo(quarters + 1.0, 4.0).simd_gt(1.5);
    let (sin, cos) = (odd.select(cosine, sine), odd.select(sine, cosine));
    [low.select(-sin, sin), high.select(-cos, cos)]
}

/// By powers, the highest first.
#[inline(always)]
fn polynomial<S: Simd>(x: f64x4<S>, factors: &[f64; 6]) -> f64x4<S> {
    let [a, b, c, d, e, f] = *factors;
    // two chains: the second begins before the first is done
    let (square, fourth) = (x * x, (x * x) * (x * x));
    ((a * x + b) * fourth) + ((c * x + d) * square) + (e * x + f)
}

/// What is left of whole numbers beyond multiples of another.
#[inline(always)]
fn modulo<S: Simd>(number: f64x4<S>, of: f64) -> f64x4<S> {
    number - (number * of.recip()).floor() * of
}

#[cfg(test)]
mod tests {
    use fearless_simd::{Level, SimdBase, dispatch};

    use super::*;

    #[test]
    fn sines_side_by_side_are_those_of_the_library() {
        let level = Level::new();
        for step in 0..200_000 {
            let angle = f64::from(step) * f64::from(step) * 2.3e-3 - 1e3;
            let angles = [angle, -angle, 0.4 * angle, angle.sqrt().max(0.0)];
            let [sines, cosines] = dispatch!(level, simd => {
                sines_and_cosines(f64x4::from_slice(simd, &angles)).map(|part| *part)
            });
            for ((sine, cosine), angle) in sines.iter().zip(cosines).zip(angles) {
                assert!((sine - angle.sin()).abs() < 4e-16, "sin {angle}: {sine}");
                assert!(
                    (cosine - angle.cos()).abs() < 4e-16,
                    "cos {angle}: {cosine}"
                );
            }
        }
    }

    #[test]
    fn what_is_no_number_has_no_sine() {
        let level = Level::new();
        for angle in [f64::NAN, f64::INFINITY] {
            let parts = dispatch!(level, simd => {
                sines_and_cosines(f64x4::splat(simd, angle)).map(|part| *part)
            });
            assert!(parts.as_flattened().iter().all(|part| part.is_nan()));
        }
    }
}
