//! The ninth root, by which the load of a lamina follows from its approach.

use fearless_simd::{Bytes, ExtractToken, Simd, SimdBase, u32x8};

use crate::bearing::number::Lanes;

/// Least number whose root is taken, far below any approach in m.
const LEAST: f64 = 1e-30;
/// Upper half of the bits of 2^0 times 10/9, less half of what the line through a mantissa is off by at most.
const FIRST: u32 = 1_191_831_055;
/// Coefficients of ε, ε² … of (1 − ε)^(−1/9).
const SERIES: [f64; 5] = series();

const fn series() -> [f64; 5] {
    let mut coefficients = [1.0 / 9.0; 5];
    let mut power = 1;
    while power < 5 {
        // c_k = c_(k−1) (9k − 8)/(9k)
        let k = (power + 1) as f64;
        coefficients[power] = coefficients[power - 1] * (9.0 * k - 8.0) / (9.0 * k);
        power += 1;
    }
    coefficients
}

/// Ninth roots of numbers that are not negative, to some units of the last digit; of zero, next to nothing.
///
/// The inverse root z = x^(−1/9) is found first, which takes no division: from the bits of x to 3.4 %, then twice by
/// `z (1 − ε)^(−1/9)` with `ε = 1 − x z⁹`.
#[inline(always)]
pub(super) fn ninth_root<S: Simd>(number: Lanes<S>) -> Lanes<S> {
    let simd = number.token();
    let x = number.max(Lanes::splat(simd, LEAST));
    // log₂ z = −log₂ x/9, by the exponents with the mantissas as their fractions: 1/9 = 1/8 − 1/64 + 1/512 …
    let bits = x.bitcast::<u32x8<S>>();
    let ninth = ((bits >> 3) - (bits >> 6)) + ((bits >> 9) - (bits >> 12)) + (bits >> 15);
    let first = u32x8::splat(simd, FIRST) - ninth;
    let mut z = first.bitcast::<Lanes<S>>();
    z = z + z * correction::<S, 4>(x, z);
    z = z + z * correction::<S, 5>(x, z);
    // x^(1/9) = x z⁸
    let square = z * z;
    let fourth = square * square;
    x * (fourth * fourth)
}

/// `(1 − ε)^(−1/9) − 1` by so many terms, with `ε = 1 − x z⁹`.
#[inline(always)]
fn correction<S: Simd, const TERMS: usize>(x: Lanes<S>, z: Lanes<S>) -> Lanes<S> {
    let square = z * z;
    let fourth = square * square;
    let ninth = (fourth * fourth) * z;
    let off = Lanes::splat(z.token(), 1.0) - x * ninth;
    let mut sum = Lanes::splat(z.token(), SERIES[TERMS - 1]);
    for term in (0..TERMS - 1).rev() {
        sum = sum * off + SERIES[term];
    }
    sum * off
}

#[cfg(test)]
mod tests {
    use fearless_simd::{Level, dispatch};

    use super::*;

    #[test]
    fn ninth_roots_are_right_to_round_off() {
        dispatch!(Level::new(), simd => {
            for step in 0..4000 {
                let number = 1e-29 * 1e31_f64.powf(f64::from(step) / 4000.0);
                let root = ninth_root(Lanes::splat(simd, number))[0];
                let expected = number.powf(1.0 / 9.0);
                assert!((root / expected - 1.0).abs() < 4e-15, "{number:e}: {root}, {expected}");
            }
            assert!(ninth_root(Lanes::splat(simd, 0.0))[0] < 1e-3);
        });
    }
}
