//! What carries a state over a step or an interval of samples, in whichever coordinates.
//!
//! What knows nothing but the number of states stands out of line: it is compiled once for all systems.

use super::linear::LinearPart;
use super::mode_propagator::{self, Functions, ModePropagator};
use super::nodes::Points;
use super::phi::{self, Family};
use super::propagator::Propagator;
use crate::integrate::registers::in_wide_registers;

/// `y(t + c_i h) = E_i y(t) + Σ_j A_ij g(t + c_j h)`, exact where g is a polynomial of the points' degree.
#[derive(Debug, Clone)]
pub(super) enum Operator<const N: usize> {
    Modes(ModePropagator<N>),
    Dense(Box<Propagator<N>>),
}

impl<const N: usize> Operator<N> {
    /// That of a linear part over a step of a size, s.
    #[inline(never)]
    pub fn new(part: &LinearPart<N>, size: f64) -> Self {
        match &part.modes {
            Some(modes) => Self::Modes(ModePropagator::new(modes, size, part.level)),
            None => Self::Dense(Propagator::new(part, size)),
        }
    }

    /// Coordinates at a point after the first, from those at the start.
    #[inline(never)]
    pub fn coordinates(&self, point: usize, from: &[f64; N], slow: &Points<N>) -> [f64; N] {
        match self {
            Self::Modes(over) => over.coordinates(point, from, slow),
            Self::Dense(over) => over.state(point, from, slow),
        }
    }

    /// What a slow part that vanishes at the start does to the coordinates at a point.
    #[inline(never)]
    pub fn moved(&self, point: usize, slow: &Points<N>) -> [f64; N] {
        match self {
            Self::Modes(over) => over.moved(point, slow),
            Self::Dense(over) => over.moved(point, slow),
        }
    }

    /// What the slow part at one point alone does to the coordinates at another.
    #[inline(never)]
    pub fn effect(&self, point: usize, of: usize, slow: &[f64; N]) -> [f64; N] {
        match self {
            Self::Modes(over) => over.effect(point, of, slow),
            Self::Dense(over) => over.effect(point, of, slow),
        }
    }
}

/// The functions φ of a linear part over an interval.
#[derive(Debug, Clone)]
pub(super) enum Phi<const N: usize> {
    Modes(Functions<N>),
    Dense(Box<Family<N>>),
}

impl<const N: usize> Phi<N> {
    /// Over an interval, s.
    #[inline(never)]
    pub fn new(part: &LinearPart<N>, interval: f64) -> Self {
        match &part.modes {
            Some(modes) => Self::Modes(mode_propagator::functions(&modes.eigenvalues, interval)),
            None => Self::Dense(Box::new(in_wide_registers!(
                part.level,
                phi::over(part, interval)
            ))),
        }
    }
}

#[cfg(test)]
mod tests {
    use fearless_simd::Level;

    use super::super::nodes::POINTS;
    use super::*;

    /// Two displacements and their velocities: strong damping of one, an oscillation of the other, coupled.
    const JACOBIAN: [[f64; 4]; 4] = [
        [0.0, 0.0, -1e8, 2e7],
        [0.0, 0.0, 1e7, -1e8],
        [1.0, 0.0, -9e5, 300.0],
        [0.0, 1.0, -300.0, -400.0],
    ];

    fn part() -> LinearPart<4> {
        let part = LinearPart::new(JACOBIAN, 2, Level::new());
        assert!(part.modes.is_some());
        part
    }

    /// A slow part that pushes velocities alone, at the points.
    fn pushes() -> Points<4> {
        std::array::from_fn(|point| {
            let part = point as f64;
            [0.0, 0.0, 1e3 * part.cos(), 2e3 * (0.5 * part).sin()]
        })
    }

    /// In the coordinates of modes a step comes to what it comes to by matrices, however long it is.
    #[test]
    fn modes_carry_a_state_as_matrices_do() {
        let by_modes = part();
        let by_matrices = LinearPart {
            modes: None,
            ..by_modes.clone()
        };
        let (from, slow) = ([1e-6, -2e-6, 1e-3, 2e-3], pushes());
        for size in [1e-9, 1e-6, 1e-4, 1e-2] {
            let modes = Operator::new(&by_modes, size);
            let matrices = Operator::new(&by_matrices, size);
            let inner = slow.map(|slow| by_modes.place(slow).coordinates);
            for point in 1..POINTS {
                let at = modes.coordinates(point, &by_modes.place(from).coordinates, &inner);
                let pairs = [
                    (at, matrices.coordinates(point, &from, &slow)),
                    (modes.moved(point, &inner), matrices.moved(point, &slow)),
                    (
                        modes.effect(point, 3, &inner[3]),
                        matrices.effect(point, 3, &slow[3]),
                    ),
                ];
                for (found, expected) in pairs {
                    let found = by_modes.deviation(&found);
                    for (row, scale) in [1e-6, 1e-6, 1e-2, 1e-2].into_iter().enumerate() {
                        let error = (found[row] - expected[row]).abs() / scale;
                        assert!(
                            error < 1e-11,
                            "{size:e}, point {point}, row {row}: {error:e}"
                        );
                    }
                }
            }
        }
    }

    #[test]
    fn every_width_of_registers_gives_the_same_bytes() {
        let best = part();
        let mut levels = vec![Level::baseline()];
        #[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
        levels.extend(best.level.as_sse4_2().map(Level::Sse4_2));
        let bytes = |part: &LinearPart<4>| {
            let place = part.place([1e-6, -2e-6, 1e-3, 2e-3]);
            let slow = pushes().map(|slow| part.slow(&slow, &place));
            let operator = Operator::new(part, 1e-4);
            let end = operator.coordinates(POINTS - 1, &place.coordinates, &slow);
            let all = [end, operator.moved(3, &slow), part.deviation(&end)];
            all.map(|vector| vector.map(f64::to_bits))
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
