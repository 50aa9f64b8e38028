//! The matrices that carry a deviation over a step of one size, where the modes of the linear part are no
//! sound basis.

use fearless_simd::Level;

use super::columns::{Columns, apply, product};
use super::linear::LinearPart;
use super::nodes::{NODES, POINTS, Points};
use super::phi::{self, Family};
use crate::integrate::registers::in_wide_registers;

/// `y(t + c_i h) = E_i y(t) + Σ_j A_ij g(t + c_j h)`, exact where g is a polynomial of the points'
/// degree.
#[derive(Debug, Clone)]
pub(super) struct Propagator<const N: usize> {
    first: usize,
    level: Level,
    /// E_i and A_ij of the points after the first.
    free: [Columns<N>; POINTS - 1],
    forced: [[Columns<N>; POINTS]; POINTS - 1],
}

impl<const N: usize> Propagator<N> {
    /// Over a step of a size, s.
    pub fn new(part: &LinearPart<N>, size: f64) -> Box<Self> {
        let mut propagator = Box::new(Self {
            first: part.first,
            level: part.level,
            free: [[[0.0; N]; N]; POINTS - 1],
            forced: [[[[0.0; N]; N]; POINTS]; POINTS - 1],
        });
        in_wide_registers!(part.level, propagator.go_from_point_to_point(part, size));
        propagator
    }

    /// State at a point after the first.
    pub fn state(&self, point: usize, from: &[f64; N], slow: &Points<N>) -> [f64; N] {
        in_wide_registers!(self.level, {
            let mut state = [0.0; N];
            apply(&self.free[point - 1], 0, from, &mut state);
            self.add(point, slow, &mut state);
            state
        })
    }

    /// What a slow part that vanishes at the start does to the state at a point.
    pub fn moved(&self, point: usize, slow: &Points<N>) -> [f64; N] {
        in_wide_registers!(self.level, {
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
    pub fn effect(&self, point: usize, of: usize, slow: &[f64; N]) -> [f64; N] {
        let mut state = [0.0; N];
        apply(&self.forced[point - 1][of], self.first, slow, &mut state);
        state
    }

    /// What came before a point is carried on, and what the interval adds is added.
    #[inline(always)]
    fn go_from_point_to_point(&mut self, part: &LinearPart<N>, size: f64) {
        // intervals lie symmetrically about the middle of the step
        for interval in 0..POINTS / 2 {
            let length = NODES.part[interval + 1] - NODES.part[interval];
            let family = phi::over(part, length * size);
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

#[cfg(test)]
mod tests {
    use super::*;

    /// Ten states, two of them far faster than the others, at all widths of registers.
    #[test]
    fn every_width_of_registers_gives_the_same_bytes() {
        let mut jacobian = [[0.0; 10]; 10];
        for (column, entries) in jacobian.iter_mut().enumerate() {
            for (row, entry) in entries.iter_mut().enumerate() {
                *entry = (1.0 + (7 * column + 3 * row) as f64).sin();
            }
            entries[column] -= if column < 2 { 1e3 } else { 3.0 };
        }
        let best = LinearPart {
            modes: None,
            ..LinearPart::new(jacobian, 5, Level::new())
        };
        let mut levels = vec![Level::baseline()];
        #[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
        levels.extend(best.level.as_sse4_2().map(Level::Sse4_2));
        let from = std::array::from_fn(|i| (i as f64).cos());
        let slow = std::array::from_fn(|j| from.map(|value: f64| (value + j as f64).sin()));
        let bytes = |part: &LinearPart<10>| {
            let propagator = Propagator::new(part, 0.3);
            let state = propagator.state(POINTS - 1, &from, &slow);
            assert!(state.iter().all(|value| value.abs() < 10.0), "{state:?}");
            let rest = part.slow(&from, &part.place(from));
            [state, propagator.moved(3, &slow), rest].map(|vector| vector.map(f64::to_bits))
        };
        for level in levels {
            let other = LinearPart {
                level,
                ..best.clone()
            };
            assert_eq!(bytes(&best), bytes(&other));
        }
    }
}
