//! State-transition operators over steps of some sizes, in the coordinates of modes.

use nalgebra::{Complex, ComplexField};

use super::force_operator::ForceOperator;
use super::linear::{Diagonal, LinearPart, add, joined};
use super::nodes::{NODES, POINTS, Points};
use crate::integrate::chunks::{Padded, add_scaled, chunks_of};
use crate::numerics::registers::in_wide_registers;

/// Step sizes whose operators are kept: those from an interval of samples down to a thousandth of it.
pub(super) const KEPT: usize = 48;

/// φ_0 … φ_7, up to the number of points, of a chunk of modes.
pub(super) type Functions = [Diagonal; POINTS + 1];

/// Finds the functions of all modes over an interval, s.
fn find_functions(eigenvalues: &[Complex<f64>], interval: f64, functions: &mut [Functions]) {
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

/// `z(t + c_i h) = E_i z(t) + Σ_j A_ij g(t + c_j h)`, exact where g is a polynomial of the points' degree: E_i and
/// A_ij of the points after the first, for a chunk of modes.
#[derive(Debug, Clone, Default)]
struct ChunkPropagator {
    free: [Diagonal; POINTS - 1],
    forced: [[Diagonal; POINTS]; POINTS - 1],
}

impl ChunkPropagator {
    /// E and A of an interval between two points: φ_0, and `h Σ_m p⁽ᵐ⁾ φ_{m+1}` of each of the points' polynomials p.
    #[inline(always)]
    fn integrate(&mut self, interval: usize, length: f64, functions: &Functions) {
        self.free[interval] = functions[0];
        for (local, forced) in NODES.local[interval].iter().zip(&mut self.forced[interval]) {
            let mut sums = [[0.0; 4]; 2];
            for (coefficient, function) in local.iter().zip(&functions[1..]) {
                let factor = length * coefficient;
                for (part, sum) in function.iter().zip(&mut sums) {
                    add_scaled(sum, factor, part);
                }
            }
            *forced = sums;
        }
    }

    /// From intervals to the whole step up to each point: E_i = E E_{i−1}, A_ij = E A_{i−1,j} + A of the interval.
    #[inline(always)]
    fn go_from_point_to_point(&mut self) {
        for point in 1..POINTS - 1 {
            let on = self.free[point];
            for node in 0..POINTS {
                let mut carried = product(&on, &self.forced[point - 1][node]);
                for (carried, forced) in carried.iter_mut().zip(&self.forced[point][node]) {
                    add_scaled(carried, 1.0, forced);
                }
                self.forced[point][node] = carried;
            }
            self.free[point] = product(&on, &self.free[point - 1]);
        }
    }
}

/// Finds the operator over a step of a size, s; `functions` is room for those of its intervals.
fn find_propagator(
    linear: &LinearPart,
    size: f64,
    functions: &mut [Functions],
    chunks: &mut [ChunkPropagator],
) {
    // intervals lie symmetrically about the middle of the step
    for interval in 0..POINTS / 2 {
        let length = (NODES.part[interval + 1] - NODES.part[interval]) * size;
        find_functions(&linear.eigenvalues, length, functions);
        in_wide_registers!(linear.level, {
            for (chunk, functions) in chunks.iter_mut().zip(&*functions) {
                for mirror in [interval, POINTS - 2 - interval] {
                    chunk.integrate(mirror, length, functions);
                }
            }
        });
    }
    in_wide_registers!(linear.level, {
        for chunk in chunks {
            chunk.go_from_point_to_point();
        }
    });
}

/// State-transition operator over a step.
#[derive(Debug, Clone)]
pub(super) struct Propagator {
    /// Size of the step, s; zero where none is known yet.
    size: f64,
    chunks: Vec<ChunkPropagator>,
    /// What few forces do over the step, where they make the remainder.
    pub forces: Option<ForceOperator>,
}

impl Propagator {
    /// Finds the coordinates at a point after the first, within code for wide registers.
    #[inline(always)]
    pub fn find_coordinates(
        &self,
        point: usize,
        from: &Padded,
        remainder: &Points,
        to: &mut Padded,
    ) {
        let chunks = self.chunks.iter().zip(from.chunks()).zip(remainder);
        for (to, ((chunk, from), remainder)) in to.chunks_mut().iter_mut().zip(chunks) {
            let mut sums = [[0.0; 4]; 2];
            add(&chunk.free[point - 1], from, &mut sums);
            for (forced, remainder) in chunk.forced[point - 1].iter().zip(remainder) {
                add(forced, remainder, &mut sums);
            }
            *to = joined(&sums);
        }
    }

    /// Finds the numbers of A_ij: the real and the imaginary part for each of the pairs, the first coordinates, and the real
    /// one for each of the others.
    #[inline(always)]
    pub fn find_function(&self, point: usize, source: usize, pairs: usize, numbers: &mut Padded) {
        let mut first = 0;
        for (numbers, chunk) in numbers.chunks_mut().iter_mut().zip(&self.chunks) {
            let [own, given] = &chunk.forced[point - 1][source];
            *numbers = *own;
            for partner in [1, 3] {
                if first + partner < 2 * pairs {
                    numbers[partner] = given[partner];
                }
            }
            first += 4;
        }
    }

    /// Finds what the coordinates at the start come to by themselves, within code for wide registers.
    #[inline(always)]
    pub fn find_free(&self, point: usize, from: &Padded, to: &mut Padded) {
        let chunks = self.chunks.iter().zip(from.chunks());
        for (to, (chunk, from)) in to.chunks_mut().iter_mut().zip(chunks) {
            let mut sums = [[0.0; 4]; 2];
            add(&chunk.free[point - 1], from, &mut sums);
            *to = joined(&sums);
        }
    }

    /// Finds what a remainder that vanishes at the start does to the coordinates at the end.
    #[inline(always)]
    pub fn find_shift(&self, remainder: &Points, shift: &mut Padded) {
        let chunks = self.chunks.iter().zip(remainder);
        for (shift, (chunk, remainder)) in shift.chunks_mut().iter_mut().zip(chunks) {
            let mut sums = [[0.0; 4]; 2];
            for (forced, remainder) in chunk.forced[POINTS - 2].iter().zip(remainder) {
                add(forced, remainder, &mut sums);
            }
            *shift = joined(&sums);
        }
    }

    /// Finds what the remainder at one point alone does to the coordinates at another.
    #[inline(always)]
    pub fn find_effect(
        &self,
        point: usize,
        source: usize,
        remainder: &Padded,
        effect: &mut Padded,
    ) {
        let chunks = self.chunks.iter().zip(remainder.chunks());
        for (effect, (chunk, remainder)) in effect.chunks_mut().iter_mut().zip(chunks) {
            let mut sums = [[0.0; 4]; 2];
            add(&chunk.forced[point - 1][source], remainder, &mut sums);
            *effect = joined(&sums);
        }
    }
}

/// One function after the other, each as the complex numbers that its factors are the parts of.
#[inline(always)]
fn product(left: &Diagonal, right: &Diagonal) -> Diagonal {
    let mut product = [[0.0; 4]; 2];
    for i in 0..4 {
        product[0][i] = left[0][i] * right[0][i] - left[1][i] * right[1][i];
        product[1][i] = left[0][i] * right[1][i] + left[1][i] * right[0][i];
    }
    product
}

/// Operators of one linear part over steps of the sizes of late, and the functions over a sample interval.
#[derive(Debug, Clone)]
pub(super) struct Propagators {
    /// The one that was asked for last first.
    kept: Vec<Propagator>,
    samples: Vec<Functions>,
    /// The interval of samples that these belong to, s; zero where none is known yet.
    samples_interval: f64,
    /// Room for the functions over an interval.
    functions: Vec<Functions>,
}

impl Propagators {
    /// Room for those of so many states.
    pub fn new(states: usize) -> Self {
        let chunks = chunks_of(states);
        Self {
            kept: Vec::new(),
            samples: vec![Functions::default(); chunks],
            samples_interval: 0.0,
            functions: vec![Functions::default(); chunks],
        }
    }

    /// Forgets all: the linear part is another.
    pub fn clear(&mut self) {
        for kept in &mut self.kept {
            kept.size = 0.0;
        }
        self.samples_interval = 0.0;
    }

    /// The operator over a step of a size, s.
    pub fn over_step(&mut self, linear: &LinearPart, size: f64) -> &Propagator {
        let known = self.kept.iter().position(|kept| kept.size == size);
        let position = known.unwrap_or_else(|| self.place_of_another());
        self.kept[..=position].rotate_right(1);
        let found = &mut self.kept[0];
        if known.is_none() {
            found.size = size;
            find_propagator(linear, size, &mut self.functions, &mut found.chunks);
            let few = linear.few_forces.as_ref();
            let level = linear.level;
            found.forces = few.map(|few| in_wide_registers!(level, ForceOperator::new(few, found)));
        }
        found
    }

    /// Where an operator over a step of another size goes: to a free place, or to that of the one that was not asked for
    /// longest.
    fn place_of_another(&mut self) -> usize {
        let free = self.kept.iter().position(|kept| kept.size == 0.0);
        if free.is_none() && self.kept.len() < KEPT {
            self.kept.push(Propagator {
                size: 0.0,
                chunks: vec![ChunkPropagator::default(); self.functions.len()],
                forces: None,
            });
        }
        free.unwrap_or(self.kept.len() - 1)
    }

    /// The functions over an interval of samples.
    pub fn samples(&mut self, linear: &LinearPart, interval: f64) -> &[Functions] {
        if self.samples_interval != interval {
            find_functions(&linear.eigenvalues, interval, &mut self.samples);
            self.samples_interval = interval;
        }
        &self.samples
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
