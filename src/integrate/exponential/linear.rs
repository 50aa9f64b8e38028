//! The linear part of a system, and the coordinates in which it is easiest: those of its modes.
//!
//! What knows nothing but the number of states stands out of line: it is compiled once for all systems.

use fearless_simd::Level;

use super::columns::{Columns, balanced_units, norm_in};
use super::modes::Modes;

/// The linear part of a system: `∂f/∂y` at one place, or a matrix next to it whose modes are a sound basis.
#[derive(Debug, Clone)]
pub(super) struct LinearPart<const N: usize> {
    /// Its norm in the units that make it smallest, 1/s.
    pub norm: f64,
    /// The fastest damping that a component has of itself, 1/s.
    pub damping: f64,
    /// What the processor has.
    pub level: Level,
    pub modes: Modes<N>,
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
            norm: 0.0,
            damping: 0.0,
            level: Level::new(),
            modes: Modes::none(),
        }
    }

    /// That of a Jacobian.
    #[inline(never)]
    pub fn new(jacobian: Columns<N>, level: Level) -> Self {
        let units = balanced_units(&jacobian);
        let norm = norm_in(&units, &jacobian);
        let columns = jacobian.iter().enumerate();
        Self {
            norm,
            damping: columns.fold(0.0, |most: f64, (place, column)| most.max(-column[place])),
            level,
            modes: Modes::near(&jacobian, &units, norm),
        }
    }

    /// The place of a deviation.
    #[inline(never)]
    pub fn place(&self, deviation: [f64; N]) -> Place<N> {
        Place {
            coordinates: self.modes.coordinates(&deviation, self.level),
            deviation,
        }
    }

    /// The deviation of coordinates.
    #[inline(never)]
    pub fn deviation(&self, coordinates: &[f64; N]) -> [f64; N] {
        self.modes.deviation(coordinates, self.level)
    }

    /// Coordinates of the nonlinear remainder g = f − J y where the derivative f is known.
    #[inline(never)]
    pub fn slow(&self, rate: &[f64; N], place: &Place<N>) -> [f64; N] {
        self.modes.slow(rate, &place.coordinates, self.level)
    }
}
