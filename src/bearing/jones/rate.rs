//! A number that carries its derivatives by the state of a ball.

use std::ops::{Add, Mul, Sub};

use nalgebra::Vector3;

/// Value and derivatives by (Q_i, α_i, α_o): load at the inner race, contact angles.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Rate {
    pub(super) value: f64,
    pub(super) by: Vector3<f64>,
}

impl Rate {
    pub(super) fn new(value: f64, by: [f64; 3]) -> Self {
        Self {
            value,
            by: Vector3::from(by),
        }
    }

    pub(super) fn constant(value: f64) -> Self {
        Self::new(value, [0.0; 3])
    }
}

impl Add for Rate {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        Self {
            value: self.value + other.value,
            by: self.by + other.by,
        }
    }
}

impl Sub for Rate {
    type Output = Self;

    fn sub(self, other: Self) -> Self {
        Self {
            value: self.value - other.value,
            by: self.by - other.by,
        }
    }
}

impl Mul for Rate {
    type Output = Self;

    fn mul(self, other: Self) -> Self {
        Self {
            value: self.value * other.value,
            by: self.by * other.value + other.by * self.value,
        }
    }
}

impl Mul<Rate> for f64 {
    type Output = Rate;

    fn mul(self, rate: Rate) -> Rate {
        Rate {
            value: self * rate.value,
            by: rate.by * self,
        }
    }
}
