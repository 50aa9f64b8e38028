//! State-transition operators over steps of some sizes, in the coordinates of modes.

use nalgebra::Complex;

use super::linear::{Diagonal, LinearPart, add, joined};
use super::nodes::{NODES, POINTS, Points};
use super::phi::{self, HIGHEST};
use crate::integrate::chunks::{Padded, add_scaled, chunks_of};
use crate::registers::in_wide_registers;

/// Step sizes whose operators are kept.
const KEPT: usize = 12;

/// φ_0 … φ_HIGHEST of a chunk of modes.
pub(super) type Functions = [Diagonal; HIGHEST + 1];

const NO_FUNCTIONS: Functions = [[[0.0; 4]; 2]; HIGHEST + 1];

/// Finds the functions of all modes over an interval, s.
fn find_functions(eigenvalues: &[Complex<f64>], interval: f64, functions: &mut [Functions]) {
    functions.fill(NO_FUNCTIONS);
    let mut coordinate = 0;
    while coordinate < eigenvalues.len() {
        let exponent = eigenvalues[coordinate] * interval;
        let paired = exponent.im > 0.0;
        let values = if paired {
            phi::functions(exponent)
        } else {
            phi::functions(exponent.re).map(Complex::from)
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
#[derive(Debug, Clone)]
struct ChunkPropagator {
    free: [Diagonal; POINTS - 1],
    forced: [[Diagonal; POINTS]; POINTS - 1],
}

impl ChunkPropagator {
    const NONE: Self = Self {
        free: [[[0.0; 4]; 2]; POINTS - 1],
        forced: [[[[0.0; 4]; 2]; POINTS]; POINTS - 1],
    };

    /// What each of the points' polynomials adds over an interval between two points.
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

    /// What came before a point is carried on.
    #[inline(always)]
    fn go_from_point_to_point(&mut self) {
        for point in 1..POINTS - 1 {
            let on = self.free[point];
            for of in 0..POINTS {
                let mut carried = product(&on, &self.forced[point - 1][of]);
                for (carried, forced) in carried.iter_mut().zip(&self.forced[point][of]) {
                    add_scaled(carried, 1.0, forced);
                }
                self.forced[point][of] = carried;
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
#[derive(Debug, Clone, Copy)]
pub(super) struct Propagator<'a> {
    chunks: &'a [ChunkPropagator],
}

impl Propagator<'_> {
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
    pub fn find_effect(&self, point: usize, of: usize, remainder: &Padded, effect: &mut Padded) {
        let chunks = self.chunks.iter().zip(remainder.chunks());
        for (effect, (chunk, remainder)) in effect.chunks_mut().iter_mut().zip(chunks) {
            let mut sums = [[0.0; 4]; 2];
            add(&chunk.forced[point - 1][of], remainder, &mut sums);
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

/// The operator over a step of a size, s.
#[derive(Debug, Clone)]
struct Kept {
    /// Zero where there is none.
    size: f64,
    chunks: Vec<ChunkPropagator>,
}

/// Operators of one linear part over steps of the sizes of late, and the functions over a sample interval.
#[derive(Debug, Clone)]
pub(super) struct Propagators {
    /// The one that was asked for last first.
    kept: Vec<Kept>,
    samples: Vec<Functions>,
    are_samples_known: bool,
    /// Room for the functions over an interval.
    functions: Vec<Functions>,
}

impl Propagators {
    /// Room for those of so many states.
    pub fn new(states: usize) -> Self {
        let chunks = chunks_of(states);
        let none = Kept {
            size: 0.0,
            chunks: vec![ChunkPropagator::NONE; chunks],
        };
        Self {
            kept: vec![none; KEPT],
            samples: vec![NO_FUNCTIONS; chunks],
            are_samples_known: false,
            functions: vec![NO_FUNCTIONS; chunks],
        }
    }

    /// Forgets all: the linear part is another.
    pub fn clear(&mut self) {
        for kept in &mut self.kept {
            kept.size = 0.0;
        }
        self.are_samples_known = false;
    }

    /// The operator over a step.
    pub fn of(&mut self, linear: &LinearPart, size: f64) -> Propagator<'_> {
        let known = self.kept.iter().position(|kept| kept.size == size);
        // the one that was not asked for longest gives its place
        let place = known.unwrap_or(KEPT - 1);
        self.kept[..=place].rotate_right(1);
        let Kept { size: kept, chunks } = &mut self.kept[0];
        if known.is_none() {
            *kept = size;
            find_propagator(linear, size, &mut self.functions, chunks);
        }
        Propagator { chunks }
    }

    /// The functions over an interval of samples.
    pub fn samples(&mut self, linear: &LinearPart, interval: f64) -> &[Functions] {
        if !self.are_samples_known {
            find_functions(&linear.eigenvalues, interval, &mut self.samples);
            self.are_samples_known = true;
        }
        &self.samples
    }
}
