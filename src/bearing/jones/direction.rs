//! Length and direction from one groove centre to the next.

use nalgebra::{Matrix2, Vector2};

use super::rate::Rate;

/// A vector (axial, radial) as length and contact angle.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Direction {
    /// Length, m.
    pub(super) length: f64,
    /// (sin α, cos α): from groove centre to groove centre.
    pub(super) normal: Vector2<f64>,
}

impl Direction {
    /// A vanishing vector points nowhere; it is given the radial length of the smallest number.
    #[inline]
    pub(super) fn new(vector: Vector2<f64>) -> Self {
        let length = vector.norm();
        if length > 0.0 {
            Self {
                length,
                normal: vector / length,
            }
        } else {
            Self {
                length: f64::MIN_POSITIVE,
                normal: Vector2::y(),
            }
        }
    }

    /// (cos α, −sin α): the derivative of the normal by the angle.
    #[inline]
    pub(super) fn tangent(&self) -> Vector2<f64> {
        Vector2::new(self.normal.y, -self.normal.x)
    }

    /// sin α and cos α, α being number `index` of the variables of a [`Rate`].
    #[inline]
    pub(super) fn sine_and_cosine(&self, index: usize) -> (Rate, Rate) {
        let (sin, cos) = (self.normal.x, self.normal.y);
        let (mut by_sin, mut by_cos) = ([0.0; 3], [0.0; 3]);
        by_sin[index] = cos;
        by_cos[index] = -sin;
        (Rate::new(sin, by_sin), Rate::new(cos, by_cos))
    }

    /// Chain rule from (length, angle) to the vector: `a nᵀ + b tᵀ/L`.
    #[inline]
    pub(super) fn chain(&self, by_length: Vector2<f64>, by_angle: Vector2<f64>) -> Matrix2<f64> {
        by_length * self.normal.transpose()
            + by_angle * (self.tangent() / self.length).transpose()
    }
}
