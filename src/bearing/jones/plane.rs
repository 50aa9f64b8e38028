//! Products of 2×2 matrices, written out: they are the cost of a solve.

use nalgebra::{Matrix2, Vector2};

/// `a xᵀ + b yᵀ`
#[inline(always)]
pub(super) fn dyads(
    a: Vector2<f64>,
    x: Vector2<f64>,
    b: Vector2<f64>,
    y: Vector2<f64>,
) -> Matrix2<f64> {
    Matrix2::new(
        a.x * x.x + b.x * y.x,
        a.x * x.y + b.x * y.y,
        a.y * x.x + b.y * y.x,
        a.y * x.y + b.y * y.y,
    )
}

/// `A B`
#[inline(always)]
pub(super) fn product(a: &Matrix2<f64>, b: &Matrix2<f64>) -> Matrix2<f64> {
    Matrix2::new(
        a.m11 * b.m11 + a.m12 * b.m21,
        a.m11 * b.m12 + a.m12 * b.m22,
        a.m21 * b.m11 + a.m22 * b.m21,
        a.m21 * b.m12 + a.m22 * b.m22,
    )
}

/// `A x`
#[inline(always)]
pub(super) fn apply(a: &Matrix2<f64>, x: Vector2<f64>) -> Vector2<f64> {
    Vector2::new(a.m11 * x.x + a.m12 * x.y, a.m21 * x.x + a.m22 * x.y)
}

/// `A⁻¹`; nothing for a singular matrix.
#[inline(always)]
pub(super) fn inverse(a: &Matrix2<f64>) -> Option<Matrix2<f64>> {
    let scale = 1.0 / (a.m11 * a.m22 - a.m12 * a.m21);
    scale
        .is_finite()
        .then(|| Matrix2::new(a.m22 * scale, -a.m12 * scale, -a.m21 * scale, a.m11 * scale))
}

/// `|x|²`
#[inline(always)]
pub(super) fn square(x: Vector2<f64>) -> f64 {
    x.x * x.x + x.y * x.y
}

/// Length and unit vector; a vanishing vector is taken for a radial one.
#[inline(always)]
pub(super) fn length_and_direction(x: Vector2<f64>) -> (f64, Vector2<f64>) {
    let length = square(x).sqrt();
    if length > 0.0 {
        let inverse = 1.0 / length;
        (length, Vector2::new(x.x * inverse, x.y * inverse))
    } else {
        (f64::MIN_POSITIVE, Vector2::new(0.0, 1.0))
    }
}
