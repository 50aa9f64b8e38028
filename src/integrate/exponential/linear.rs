//! The linear part of a system, and the coordinates in which it is easiest.
//!
//! What knows nothing but the number of states stands out of line: it is compiled once for all systems.

use fearless_simd::Level;

use super::columns::{Columns, apply, balanced_units, norm_in};
use super::modes::Modes;
use crate::integrate::registers::in_wide_registers;

/// The linear part of a system: `∂f/∂y` at one place.
#[derive(Debug, Clone)]
pub(super) struct LinearPart<const N: usize> {
    pub jacobian: Columns<N>,
    /// Its norm in the units that make it smallest, 1/s.
    pub norm: f64,
    /// First component that the slow part can have: in (q, q̇) it has none in q.
    pub first: usize,
    /// What the processor has.
    pub level: Level,
    /// Its modes, where they are a sound basis: the coordinates are then theirs, and else the deviation.
    pub modes: Option<Modes<N>>,
}

/// A state as its deviation from the origin, and the coordinates of that.
#[derive(Debug, Clone, Copy)]
pub(super) struct Place<const N: usize> {
    pub coordinates: [f64; N],
    pub deviation: [f64; N],
}

impl<const N: usize> LinearPart<N> {
    /// No linear part.
    pub fn none() -> Self {
        Self {
            jacobian: [[0.0; N]; N],
            norm: 0.0,
            first: 0,
            level: Level::new(),
            modes: None,
        }
    }

    /// That of a Jacobian, whose slow part begins with a component.
    #[inline(never)]
    pub fn new(jacobian: Columns<N>, first: usize, level: Level) -> Self {
        let units = balanced_units(&jacobian);
        Self {
            norm: norm_in(&units, &jacobian),
            modes: Modes::new(&jacobian, &units),
            jacobian,
            first,
            level,
        }
    }

    /// The fastest damping that a component has of itself, 1/s.
    pub fn damping(&self) -> f64 {
        let columns = self.jacobian.iter().enumerate();
        columns.fold(0.0, |most: f64, (place, column)| most.max(-column[place]))
    }

    /// The place of a deviation.
    #[inline(never)]
    pub fn place(&self, deviation: [f64; N]) -> Place<N> {
        let coordinates = match &self.modes {
            Some(modes) => modes.coordinates(&deviation, self.level),
            None => deviation,
        };
        Place {
            coordinates,
            deviation,
        }
    }

    /// The deviation of coordinates.
    #[inline(never)]
    pub fn deviation(&self, coordinates: &[f64; N]) -> [f64; N] {
        match &self.modes {
            Some(modes) => modes.deviation(coordinates, self.level),
            None => *coordinates,
        }
    }

    /// Coordinates of the slow part g = f − J y where the derivative f is known.
    #[inline(never)]
    pub fn slow(&self, rate: &[f64; N], place: &Place<N>) -> [f64; N] {
        match &self.modes {
            Some(modes) => modes.slow(rate, &place.coordinates, self.level),
            None => self.rest(rate, &place.deviation),
        }
    }

    fn rest(&self, rate: &[f64; N], deviation: &[f64; N]) -> [f64; N] {
        let moved = in_wide_registers!(self.level, {
            let mut sum = [0.0; N];
            apply(&self.jacobian, 0, deviation, &mut sum);
            sum
        });
        std::array::from_fn(|i| {
            if i < self.first {
                0.0
            } else {
                rate[i] - moved[i]
            }
        })
    }
}
