//! The φ functions, which sum up what acts on a mode while it decays and turns.

use nalgebra::{Complex, ComplexField};

use super::linear::Diagonal;
use super::nodes::POINTS;

/// φ_0 … φ_7, up to the number of points, of a chunk of modes.
pub(super) type Functions = [Diagonal; POINTS + 1];

/// Finds the functions of all modes over an interval, s.
pub(super) fn find_functions(
    eigenvalues: &[Complex<f64>],
    interval: f64,
    functions: &mut [Functions],
) {
    functions.fill(Functions::default());
    let mut coordinate = 0;
    while coordinate < eigenvalues.len() {
        let exponent = eigenvalues[coordinate] * interval;
        let paired = exponent.im > 0.0;
        let values = if paired {
            phi_functions(exponent)
        } else {
            phi_functions(exponent.re).map(Complex::from)
        };
        let (chunk, lane) = (coordinate / 4, coordinate % 4);
        for ([own, given], value) in functions[chunk].iter_mut().zip(values) {
            own[lane] = value.re;
            given[lane] = -value.im;
            if paired {
                own[lane + 1] = value.re;
                given[lane + 1] = value.im;
            }
        }
        coordinate += 1 + usize::from(paired);
    }
}

/// 1/k!.
const INVERSE_FACTORIALS: [f64; POINTS + 1] = {
    let mut inverse = [1.0; POINTS + 1];
    let (mut k, mut factorial) = (1, 1.0);
    while k <= POINTS {
        factorial *= k as f64;
        inverse[k] = 1.0 / factorial;
        k += 1;
    }
    inverse
};

/// φ_0 … φ_7 of a number, real or complex, as accurate where it is small as where it is large.
///
/// ```text
/// φ_0(x) = exp x,   φ_k = (φ_{k−1} − 1/(k−1)!)/x,   φ_k(x) = Σ_n x^n/(n+k)!
/// ```
///
/// The recursion loses digits upwards where k is above |x|, and downwards where it is below: it goes up from
/// the exponential and down from the series of the highest function, and both meet at |x|.
///
/// Source: Hochbruck & Ostermann, *Exponential integrators*, Acta Numerica 19 (2010) 209–286, sec. 2.
fn phi_functions<T: ComplexField<RealField = f64> + Copy>(x: T) -> [T; POINTS + 1] {
    let mut values = [x.exp(); POINTS + 1];
    let size = x.modulus();
    let meeting = size.min(POINTS as f64) as usize;
    let inverse = x.recip();
    for k in 1..=meeting {
        values[k] = (values[k - 1] - T::from_real(INVERSE_FACTORIALS[k - 1])) * inverse;
    }
    if meeting < POINTS {
        values[POINTS] = highest(x, size);
        for k in (meeting + 1..POINTS).rev() {
            values[k] = x * values[k + 1] + T::from_real(INVERSE_FACTORIALS[k]);
        }
    }
    values
}

/// The highest function by its series.
fn highest<T: ComplexField<RealField = f64> + Copy>(x: T, size: f64) -> T {
    let (mut term, mut sum) = (T::one(), T::one());
    let (mut divisor, mut part) = (POINTS as f64, 1.0);
    while part > 0.01 * f64::EPSILON {
        divisor += 1.0;
        term *= x.unscale(divisor);
        part *= size / divisor;
        sum += term;
    }
    sum.scale(INVERSE_FACTORIALS[POINTS])
}

#[cfg(test)]
mod tests {
    use nalgebra::Complex;

    use super::*;

    /// φ_1 … of decays: (φ_{k−1} − 1/(k−1)!)/x loses nothing where x is large.
    #[test]
    fn functions_of_fast_decays_are_known() {
        for x in [-1e5, -300.0, -40.0, -8.0_f64] {
            let (mut expected, mut factorial) = (x.exp(), 1.0);
            for (k, found) in phi_functions(x).into_iter().enumerate().skip(1) {
                expected = (expected - 1.0 / factorial) / x;
                factorial *= k as f64;
                let error = (found - expected).abs() / expected.abs();
                assert!(error < 1e-11, "phi_{k}({x}): {error:e}");
            }
        }
    }

    /// φ_0 of a turn is a rotation, and φ_1 = (φ_0 − 1)/x its chord.
    #[test]
    fn functions_of_a_turn_are_sines_and_cosines() {
        for angle in [1e-6, 1e-3, 0.7, 3.0, 50.0_f64] {
            let found = phi_functions(Complex::new(0.0, angle));
            let (sin, cos) = angle.sin_cos();
            let half = (0.5 * angle).sin();
            let chord = Complex::new(sin, 2.0 * half * half) / angle;
            assert!(
                (found[0] - Complex::new(cos, sin)).norm() < 1e-14,
                "{angle}"
            );
            assert!((found[1] - chord).norm() < 1e-14, "{angle}");
        }
    }

    /// φ_k = x φ_{k+1} + 1/k!, also where the way up from the exponential meets that down from the series.
    #[test]
    fn functions_follow_from_each_other() {
        for size in [0.0, 1e-6, 0.3, 0.99, 1.01, 2.5, 4.99, 5.01, 6.9, 7.1, 30.0] {
            for angle in [0.0_f64, 0.4, 0.8, 1.2, std::f64::consts::FRAC_PI_2] {
                let x = Complex::new(-size * angle.cos(), size * angle.sin());
                let found = phi_functions(x);
                for k in 0..POINTS {
                    let off = found[k] - (x * found[k + 1] + INVERSE_FACTORIALS[k]);
                    let error = off.norm() / INVERSE_FACTORIALS[k];
                    assert!(error < 1e-14 * size.max(10.0), "phi_{k}({x}): {error:e}");
                }
            }
        }
    }

    /// φ_1 … φ_7 by sums of exact fractions.
    #[test]
    fn functions_of_some_numbers_are_those_of_exact_sums() {
        let decay = [
            0.198_652_410_600_182_9,
            0.160_269_517_879_963_4,
            0.067_946_096_424_007_31,
            0.019_744_114_048_531_87,
            0.004_384_510_523_626_959,
            0.000_789_764_561_941_274_9,
            0.000_119_824_865_389_522_81,
        ];
        let turn = [
            [0.117_876_523_544_840_03, 0.169_728_357_251_408_67],
            [0.133_011_354_334_844_6, 0.120_772_353_362_656_56],
            [0.063_362_214_017_843_7, 0.044_225_500_902_906_08],
            [0.019_472_614_462_323_73, 0.011_221_652_315_462_946],
            [0.004_458_750_634_995_224, 0.002_204_450_074_839_316_8],
            [0.000_817_661_935_774_863_8, 0.000_355_399_222_753_379_55],
            [0.000_125_411_110_014_223_75, 4.874_840_576_783_846_6e-5],
        ];
        let of = [
            (Complex::from(-5.0), decay.map(Complex::from)),
            (
                Complex::new(-3.0, 4.0),
                turn.map(|[re, im]| Complex::new(re, im)),
            ),
        ];
        for (x, expected) in of {
            for (found, expected) in phi_functions(x)[1..].iter().zip(expected) {
                let error = (found - expected).norm() / expected.norm();
                assert!(error < 4.0 * f64::EPSILON, "{x}: {found} {error:e}");
            }
        }
    }
}
