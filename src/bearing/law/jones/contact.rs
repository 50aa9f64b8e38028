//! One contact of a ball at a trial position.

use crate::bearing::law::ContactSpring;
use crate::bearing::number::{Dual, Number};

/// A single number, plain or with slopes.
pub(super) trait Scalar: Number {
    /// The number without its slopes.
    fn value(self) -> f64;

    /// A function of it with this value and slope.
    fn chained(self, value: f64, slope: f64) -> Self;
}

impl Scalar for f64 {
    #[inline(always)]
    fn value(self) -> f64 {
        self
    }

    #[inline(always)]
    fn chained(self, value: f64, _slope: f64) -> Self {
        value
    }
}

impl<const D: usize> Scalar for Dual<f64, D> {
    #[inline(always)]
    fn value(self) -> f64 {
        self.value
    }

    #[inline(always)]
    fn chained(self, value: f64, slope: f64) -> Self {
        Self {
            value,
            slopes: self.slopes.map(|part| slope * part),
        }
    }
}

/// Axial and radial component.
pub(super) type Plane<T> = [T; 2];

/// Distance, direction and load between the ball's centre and a groove centre.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Contact<T> {
    /// Distance of the centres L, m.
    pub(super) length: T,
    /// Approach: L less the distance of the centres at first touch, m.
    pub(super) approach: T,
    /// sin α and cos α: from centre to centre away from the outer groove centre.
    pub(super) sin: T,
    pub(super) cos: T,
    /// Normal load Q, N.
    pub(super) load: T,
    /// dQ/dL, N/m.
    pub(super) stiffness: f64,
}

impl<T: Copy> Contact<T> {
    /// The same with another kind of number.
    #[inline(always)]
    pub(super) fn map<U>(&self, to: impl Fn(T) -> U) -> Contact<U> {
        Contact {
            length: to(self.length),
            approach: to(self.approach),
            sin: to(self.sin),
            cos: to(self.cos),
            load: to(self.load),
            stiffness: self.stiffness,
        }
    }
}

impl<T: Scalar> Contact<T> {
    /// Contact along a vector in m, the centres at first touch at a distance of `free` in m; a vanishing vector is
    /// taken for radial.
    #[inline(always)]
    pub(super) fn new([axial, radial]: Plane<T>, free: T, spring: &impl ContactSpring) -> Self {
        let square = axial * axial + radial * radial;
        let (length, sin, cos) = if square.value() > 0.0 {
            // L and 1/L by one division
            let value = square.value().sqrt();
            let inverse = 1.0 / value;
            let length = square.chained(value, 0.5 * inverse);
            let inverse = square.chained(inverse, -0.5 * inverse * inverse * inverse);
            (length, axial * inverse, radial * inverse)
        } else {
            let constant = |value| axial.constant(value);
            (constant(f64::MIN_POSITIVE), constant(0.0), constant(1.0))
        };
        let approach = length - free;
        let (load, stiffness) = spring.load_and_stiffness(approach.value());
        Self {
            length,
            approach,
            sin,
            cos,
            load: approach.chained(load, stiffness),
            stiffness,
        }
    }

    /// The same load with another stiffness in N/m.
    pub(super) fn with_stiffness(self, stiffness: f64) -> Self {
        Self {
            load: self.approach.chained(self.load.value(), stiffness),
            ..self
        }
    }
}
