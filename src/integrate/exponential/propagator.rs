//! The matrices that carry a state over a step of one size, and those that were used of late.

use fearless_simd::{Level, dispatch};

use super::columns::{Columns, apply, product};
use super::nodes::{NODES, POINTS, Points};
use super::phi::{self, Family};

/// Sizes that are kept.
const KEPT: usize = 12;
/// Numbers of [`Propagators::numbers`].
pub(super) const NUMBERS: usize = 2 + 2 * KEPT;

/// The linear part of a system: `∂f/∂y` at one place.
#[derive(Debug, Clone, Copy)]
pub(super) struct LinearPart<const N: usize> {
    pub jacobian: Columns<N>,
    /// Its norm in the units that make it smallest, 1/s.
    pub norm: f64,
    /// First component that the slow part can have: in (q, q̇) it has none in q.
    pub first: usize,
    /// What the processor has.
    pub level: Level,
}

impl<const N: usize> LinearPart<N> {
    /// No linear part.
    pub fn none() -> Self {
        Self {
            jacobian: [[0.0; N]; N],
            norm: 0.0,
            first: 0,
            level: Level::new(),
        }
    }

    /// The product of it and a vector.
    pub fn applied(&self, vector: &[f64; N]) -> [f64; N] {
        dispatch!(self.level, _ => {
            let mut sum = [0.0; N];
            apply(&self.jacobian, 0, vector, &mut sum);
            sum
        })
    }

    /// The functions φ of it over an interval, s.
    #[inline(always)]
    fn family(&self, interval: f64) -> Family<N> {
        let scaled = phi::times(interval, &self.jacobian);
        phi::family(&scaled, interval * self.norm, self.first)
    }
}

/// `y(t + c_i h) = E_i y(t) + Σ_j A_ij g(t + c_j h)`, exact where g is a polynomial of the points'
/// degree.
#[derive(Debug, Clone)]
pub(super) struct Propagator<const N: usize> {
    size: f64,
    first: usize,
    level: Level,
    /// E_i and A_ij of the points after the first.
    free: [Columns<N>; POINTS - 1],
    forced: [[Columns<N>; POINTS]; POINTS - 1],
}

impl<const N: usize> Propagator<N> {
    fn new() -> Self {
        Self {
            size: 0.0,
            first: 0,
            level: Level::baseline(),
            free: [[[0.0; N]; N]; POINTS - 1],
            forced: [[[[0.0; N]; N]; POINTS]; POINTS - 1],
        }
    }

    /// State at a point after the first.
    pub fn state(&self, point: usize, from: &[f64; N], slow: &Points<N>) -> [f64; N] {
        dispatch!(self.level, _ => {
            let mut state = [0.0; N];
            apply(&self.free[point - 1], 0, from, &mut state);
            self.add(point, slow, &mut state);
            state
        })
    }

    /// What a slow part that vanishes at the start does to the state at a point.
    pub fn moved(&self, point: usize, slow: &Points<N>) -> [f64; N] {
        dispatch!(self.level, _ => {
            let mut moved = [0.0; N];
            self.add(point, slow, &mut moved);
            moved
        })
    }

    /// Adds what a slow part does to the state at a point.
    #[inline(always)]
    fn add(&self, point: usize, slow: &Points<N>, state: &mut [f64; N]) {
        for (forced, slow) in self.forced[point - 1].iter().zip(slow) {
            apply(forced, self.first, slow, state);
        }
    }

    /// What the slow part at one point alone does to the state at another.
    #[inline(always)]
    pub fn effect(&self, point: usize, of: usize, slow: &[f64; N]) -> [f64; N] {
        let mut state = [0.0; N];
        apply(&self.forced[point - 1][of], self.first, slow, &mut state);
        state
    }

    /// Makes it that of a size.
    fn build(&mut self, part: &LinearPart<N>, size: f64) {
        (self.size, self.first, self.level) = (size, part.first, part.level);
        dispatch!(part.level, _ => self.go_from_point_to_point(part, size));
    }

    /// What came before a point is carried on, and what the interval adds is added.
    #[inline(always)]
    fn go_from_point_to_point(&mut self, part: &LinearPart<N>, size: f64) {
        // intervals lie symmetrically about the middle of the step
        for interval in 0..POINTS / 2 {
            let length = NODES.part[interval + 1] - NODES.part[interval];
            let family = part.family(length * size);
            for mirror in [interval, POINTS - 2 - interval] {
                self.free[mirror] = family[0];
                for (j, forced) in self.forced[mirror].iter_mut().enumerate() {
                    integrals(
                        &family,
                        &NODES.local[mirror][j],
                        length * size,
                        part.first,
                        forced,
                    );
                }
            }
        }
        for point in 1..POINTS - 1 {
            let ([.., free_before], [free, ..]) = self.free.split_at_mut(point) else {
                return;
            };
            let ([.., forced_before], [forced, ..]) = self.forced.split_at_mut(point) else {
                return;
            };
            for (before, forced) in forced_before.iter().zip(forced) {
                for column in part.first..N {
                    apply(free, 0, &before[column], &mut forced[column]);
                }
            }
            *free = product(free, free_before);
        }
    }
}

/// What one of the points' polynomials adds over an interval.
#[inline(always)]
fn integrals<const N: usize>(
    family: &Family<N>,
    local: &[f64; POINTS],
    interval: f64,
    first: usize,
    sum: &mut Columns<N>,
) {
    for column in first..N {
        let mut entries = [0.0; N];
        for (coefficient, function) in local.iter().zip(&family[1..]) {
            let factor = interval * coefficient;
            for row in 0..N {
                entries[row] += factor * function[column][row];
            }
        }
        sum[column] = entries;
    }
}

/// Propagators of one linear part by their sizes, and the functions over a sample interval.
#[derive(Debug, Clone)]
pub(super) struct Propagators<const N: usize> {
    kept: Vec<Propagator<N>>,
    /// Number of those that belong to the linear part.
    valid: usize,
    /// When each was asked for, to forget the one that has not been for longest.
    used: [u64; KEPT],
    clock: u64,
    /// Number built so far.
    pub built: u64,
    samples: Box<Family<N>>,
    samples_valid: bool,
}

impl<const N: usize> Propagators<N> {
    pub fn new() -> Self {
        Self {
            kept: Vec::with_capacity(KEPT),
            valid: 0,
            used: [0; KEPT],
            clock: 0,
            built: 0,
            samples: Box::new([[[0.0; N]; N]; phi::HIGHEST + 1]),
            samples_valid: false,
        }
    }

    /// Forgets all: the linear part is another.
    pub fn clear(&mut self) {
        self.valid = 0;
        self.samples_valid = false;
    }

    /// The propagator over a step.
    pub fn of(&mut self, part: &LinearPart<N>, size: f64) -> &Propagator<N> {
        self.clock += 1;
        let mut known = self.kept[..self.valid].iter();
        let index = match known.position(|known| known.size == size) {
            Some(index) => index,
            None => self.build(part, size),
        };
        self.used[index] = self.clock;
        &self.kept[index]
    }

    /// Builds a propagator in place of none or of the one that was not used for longest.
    fn build(&mut self, part: &LinearPart<N>, size: f64) -> usize {
        let index = if self.valid < KEPT {
            self.valid += 1;
            self.valid - 1
        } else {
            (0..KEPT).min_by_key(|&index| self.used[index]).unwrap_or(0)
        };
        self.put(index, part, size);
        self.built += 1;
        index
    }

    fn put(&mut self, index: usize, part: &LinearPart<N>, size: f64) {
        if index == self.kept.len() {
            self.kept.push(Propagator::new());
        }
        self.kept[index].build(part, size);
    }

    /// What [`Propagators::restore`] takes: of every place its size and when it was asked for.
    pub fn numbers(&self) -> [f64; NUMBERS] {
        let mut numbers = [0.0; NUMBERS];
        numbers[0] = self.clock as f64;
        numbers[1] = self.built as f64;
        for index in 0..self.valid {
            numbers[2 + 2 * index] = self.kept[index].size;
            numbers[3 + 2 * index] = self.used[index] as f64;
        }
        numbers
    }

    /// Finds the matrices again that were kept: what is built from here on is what would have been.
    pub fn restore(&mut self, part: &LinearPart<N>, numbers: &[f64; NUMBERS]) {
        let [clock, built, places @ ..] = numbers;
        (self.clock, self.built) = (*clock as u64, *built as u64);
        let (places, _) = places.as_chunks::<2>();
        let known = places.iter().take_while(|[size, _]| *size > 0.0);
        for (index, [size, used]) in known.enumerate() {
            self.put(index, part, *size);
            (self.valid, self.used[index]) = (index + 1, *used as u64);
        }
    }

    /// The functions over an interval of samples.
    pub fn samples(&mut self, part: &LinearPart<N>, interval: f64) -> &Family<N> {
        if !self.samples_valid {
            *self.samples = dispatch!(part.level, _ => part.family(interval));
            self.samples_valid = true;
        }
        &self.samples
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Ten states, two of them far faster than the others, at all widths of registers.
    #[test]
    fn every_width_of_registers_gives_the_same_bytes() {
        let mut best = LinearPart::<10>::none();
        for (column, entries) in best.jacobian.iter_mut().enumerate() {
            for (row, entry) in entries.iter_mut().enumerate() {
                *entry = (1.0 + (7 * column + 3 * row) as f64).sin();
            }
            entries[column] -= if column < 2 { 1e3 } else { 3.0 };
        }
        (best.norm, best.first) = (1.1e3, 5);
        let mut levels = vec![Level::baseline()];
        #[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
        levels.extend(best.level.as_sse4_2().map(Level::Sse4_2));
        let from = std::array::from_fn(|i| (i as f64).cos());
        let slow = std::array::from_fn(|j| from.map(|value: f64| (value + j as f64).sin()));
        let bytes = |part: &LinearPart<10>| {
            let mut propagators = Propagators::new();
            let propagator = propagators.of(part, 0.3);
            let state = propagator.state(POINTS - 1, &from, &slow);
            assert!(state.iter().all(|value| value.abs() < 10.0), "{state:?}");
            let all = [state, propagator.moved(3, &slow), part.applied(&from)];
            all.map(|vector| vector.map(f64::to_bits))
        };
        for level in levels {
            assert_eq!(bytes(&best), bytes(&LinearPart { level, ..best }));
        }
    }
}
