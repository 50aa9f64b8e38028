//! State-transition operator over a step of one size, in the coordinates of modes.

use fearless_simd::Level;
use nalgebra::Complex;

use super::modes::{Diagonal, Modes, add, joined};
use super::nodes::{NODES, POINTS, Points};
use super::phi::{self, HIGHEST};
use crate::registers::in_wide_registers;

/// φ_0 … φ_HIGHEST of all modes.
pub(super) type Functions<const N: usize> = [Diagonal<N>; HIGHEST + 1];

/// The functions over an interval, s.
#[inline(never)]
pub(super) fn functions<const N: usize>(
    eigenvalues: &[Complex<f64>; N],
    interval: f64,
) -> Functions<N> {
    let mut functions = [[[0.0; N]; 2]; HIGHEST + 1];
    let mut coordinate = 0;
    while coordinate < N {
        let exponent = eigenvalues[coordinate] * interval;
        let paired = exponent.im > 0.0;
        let values = if paired {
            phi::functions(exponent)
        } else {
            phi::functions(exponent.re).map(Complex::from)
        };
        for ([own, given], value) in functions.iter_mut().zip(values) {
            own[coordinate] = value.re;
            given[coordinate] = -value.im;
            if paired {
                own[coordinate + 1] = value.re;
                given[coordinate + 1] = value.im;
            }
        }
        coordinate += 1 + usize::from(paired);
    }
    functions
}

/// `z(t + c_i h) = E_i z(t) + Σ_j A_ij g(t + c_j h)`, exact where g is a polynomial of the points' degree: E_i and
/// A_ij of the points after the first.
#[derive(Debug, Clone)]
pub(super) struct Propagator<const N: usize> {
    level: Level,
    free: [Diagonal<N>; POINTS - 1],
    forced: [[Diagonal<N>; POINTS]; POINTS - 1],
}

impl<const N: usize> Propagator<N> {
    /// Over a step of a size, s.
    #[inline(never)]
    pub fn new(modes: &Modes<N>, size: f64, level: Level) -> Self {
        let mut propagator = Self {
            level,
            free: [[[0.0; N]; 2]; POINTS - 1],
            forced: [[[[0.0; N]; 2]; POINTS]; POINTS - 1],
        };
        // intervals lie symmetrically about the middle of the step
        for interval in 0..POINTS / 2 {
            let length = (NODES.part[interval + 1] - NODES.part[interval]) * size;
            let functions = functions(&modes.eigenvalues, length);
            for mirror in [interval, POINTS - 2 - interval] {
                propagator.free[mirror] = functions[0];
                in_wide_registers!(level, propagator.integrate(mirror, length, &functions));
            }
        }
        in_wide_registers!(level, propagator.go_from_point_to_point());
        propagator
    }

    /// What each of the points' polynomials adds over an interval.
    #[inline(always)]
    fn integrate(&mut self, interval: usize, length: f64, functions: &Functions<N>) {
        for (local, forced) in NODES.local[interval].iter().zip(&mut self.forced[interval]) {
            let mut sums = [[0.0; N]; 2];
            for (coefficient, function) in local.iter().zip(&functions[1..]) {
                let factor = length * coefficient;
                for (part, sum) in function.iter().zip(&mut sums) {
                    for i in 0..N {
                        sum[i] += factor * part[i];
                    }
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
                    for i in 0..N {
                        carried[i] += forced[i];
                    }
                }
                self.forced[point][of] = carried;
            }
            self.free[point] = product(&on, &self.free[point - 1]);
        }
    }

    /// Coordinates at a point after the first.
    #[inline(never)]
    pub fn coordinates(&self, point: usize, from: &[f64; N], slow: &Points<N>) -> [f64; N] {
        in_wide_registers!(self.level, {
            let mut sums = [[0.0; N]; 2];
            add(&self.free[point - 1], from, &mut sums);
            self.add_slow(point, slow, &mut sums);
            joined(&sums)
        })
    }

    /// What a slow part that vanishes at the start does to the coordinates at a point.
    #[inline(never)]
    pub fn moved(&self, point: usize, slow: &Points<N>) -> [f64; N] {
        in_wide_registers!(self.level, {
            let mut sums = [[0.0; N]; 2];
            self.add_slow(point, slow, &mut sums);
            joined(&sums)
        })
    }

    #[inline(always)]
    fn add_slow(&self, point: usize, slow: &Points<N>, sums: &mut Diagonal<N>) {
        for (forced, slow) in self.forced[point - 1].iter().zip(slow) {
            add(forced, slow, sums);
        }
    }

    /// What the slow part at one point alone does to the coordinates at another.
    #[inline(never)]
    pub fn effect(&self, point: usize, of: usize, slow: &[f64; N]) -> [f64; N] {
        let mut sums = [[0.0; N]; 2];
        add(&self.forced[point - 1][of], slow, &mut sums);
        joined(&sums)
    }
}

/// One function after the other, each as the complex numbers that its factors are the parts of.
#[inline(always)]
fn product<const N: usize>(left: &Diagonal<N>, right: &Diagonal<N>) -> Diagonal<N> {
    let mut product = [[0.0; N]; 2];
    for i in 0..N {
        product[0][i] = left[0][i] * right[0][i] - left[1][i] * right[1][i];
        product[1][i] = left[0][i] * right[1][i] + left[1][i] * right[0][i];
    }
    product
}
