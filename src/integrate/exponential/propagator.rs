//! State-transition operators over steps of some sizes, in the coordinates of modes.

use super::force_operator::ForceOperator;
use super::functions::{Functions, find_functions};
use super::linear::{Diagonal, LinearPart, add, joined};
use super::nodes::{NODES, POINTS, Points};
use crate::integrate::chunks::{Padded, add_scaled, chunks_of};
use crate::numerics::registers::in_wide_registers;

/// Step sizes whose operators are kept: those from an interval of samples down to a thousandth of it.
pub(super) const KEPT: usize = 48;

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
