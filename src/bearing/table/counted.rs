//! A law whose evaluations are counted.

use std::cell::Cell;

use crate::bearing::{BallForce, BallLaw};

/// The exact law, its evaluations counted.
pub(super) struct Counted<'a, L> {
    law: &'a L,
    pub(super) speed: f64,
    count: Cell<usize>,
}

impl<'a, L: BallLaw> Counted<'a, L> {
    /// A law at a shaft speed in rad/s.
    pub(super) fn new(law: &'a L, speed: f64) -> Self {
        Self {
            law,
            speed,
            count: Cell::new(0),
        }
    }

    /// Evaluations up to now.
    pub(super) fn evaluations(&self) -> usize {
        self.count.get()
    }

    pub(super) fn force(&self, axial: f64, radial: f64) -> BallForce {
        self.count.set(self.count.get() + 1);
        self.law.force(axial, radial, self.speed)
    }

    /// Load of a ball, N.
    pub(super) fn load(&self, axial: f64, radial: f64) -> f64 {
        let force = self.force(axial, radial);
        force.axial.hypot(force.radial)
    }
}
