//! The points of a step at which the nonlinear remainder is known, and what a polynomial through them yields.

use std::sync::LazyLock;

use crate::integrate::chunks::{Chunk, add_scaled, chunks_of};

/// Points of a step, its start and its end among them.
pub(super) const POINTS: usize = 7;
/// The point whose omission gives the polynomial of next lower degree.
pub(super) const SPARE: usize = POINTS / 2;

/// A vector at every point, chunk by chunk.
pub(super) type Points = Vec<PointsOfChunk>;

/// A chunk of a vector at every point.
pub(super) type PointsOfChunk = [Chunk; POINTS];

/// Zeros at every point of a vector of so many numbers.
pub(super) fn no_points(numbers: usize) -> Points {
    vec![[[0.0; 4]; POINTS]; chunks_of(numbers)]
}

/// Weighted sum of the vectors at the points.
#[inline(always)]
pub(super) fn combined(weights: &[f64; POINTS], points: &PointsOfChunk) -> Chunk {
    let mut sum = [0.0; 4];
    for (weight, point) in weights.iter().zip(points) {
        add_scaled(&mut sum, *weight, point);
    }
    sum
}

/// Weights of the values at the points in their polynomial at a part of the step.
pub(super) fn weights(part: f64) -> [f64; POINTS] {
    let mut weights = [0.0; POINTS];
    for (weight, row) in weights.iter_mut().zip(&NODES.power) {
        for term in row.iter().rev() {
            *weight = *weight * part + term;
        }
    }
    weights
}

/// Numbers that the points alone decide; parts of a step count from its start.
pub(super) struct Nodes {
    /// Parts of the step, the points of Lobatto's quadrature: they leave the smallest error of a
    /// polynomial that is integrated over the step.
    pub part: [f64; POINTS],
    /// Coefficients of 1, τ, τ², … in the polynomial that is one at a point and zero at the others.
    pub power: [[f64; POINTS]; POINTS],
    /// `m! times` the coefficients of the powers of (τ − c_r)/(c_{r+1} − c_r) in the same polynomials,
    /// for every interval r between points.
    pub local: [[[f64; POINTS]; POINTS]; POINTS - 1],
    /// Value at the spare point less that of the polynomial through the others.
    pub spare: [f64; POINTS],
    /// Coefficients of the three highest Legendre polynomials in the polynomial through the values.
    pub modes: [[f64; POINTS]; 3],
    /// Values of P_n − P_{n−2}, which the polynomial through Lobatto points one fewer lacks of the highest of these, P_n.
    pub left_out: [f64; POINTS],
}

/// The points.
pub(super) static NODES: LazyLock<Nodes> = LazyLock::new(Nodes::new);

impl Nodes {
    fn new() -> Self {
        let part = lobatto();
        let power: [[f64; POINTS]; POINTS] = std::array::from_fn(|j| lagrange(&part, j));
        let local = std::array::from_fn(|r| {
            let length = part[r + 1] - part[r];
            power.map(|power| derivatives(&power, part[r], length))
        });
        Self {
            part,
            power,
            local,
            spare: spare(&part, &power),
            modes: std::array::from_fn(|index| mode(&part, POINTS - 3 + index)),
            left_out: part.map(|part| {
                let value = |degree| legendre(degree, 2.0 * part - 1.0).0;
                value(POINTS - 1) - value(POINTS - 3)
            }),
        }
    }
}

/// Ends and extremes of the Legendre polynomial, by Newton's method.
fn lobatto() -> [f64; POINTS] {
    let degree = (POINTS - 1) as f64;
    std::array::from_fn(|index| {
        if index == 0 || index + 1 == POINTS {
            return if index == 0 { 0.0 } else { 1.0 };
        }
        let mut x = -(std::f64::consts::PI * index as f64 / degree).cos();
        for _ in 0..50 {
            let (value, before) = legendre(POINTS - 1, x);
            // zeros of (1 − x²) P′ = n (P_{n−1} − x P_n), whose slope is −n (n + 1) P_n
            x += (before - x * value) / ((degree + 1.0) * value);
        }
        0.5 * (1.0 + x)
    })
}

/// Factors of the values in the coefficient of a Legendre polynomial, by Lobatto's quadrature.
fn mode(part: &[f64; POINTS], degree: usize) -> [f64; POINTS] {
    let highest = (POINTS - 1) as f64;
    // the quadrature of the square of the highest polynomial is not exact
    let square = if degree == POINTS - 1 {
        2.0 / highest
    } else {
        2.0 / (2 * degree + 1) as f64
    };
    part.map(|part| {
        let x = 2.0 * part - 1.0;
        let weight = 2.0 / (highest * (highest + 1.0) * legendre(POINTS - 1, x).0.powi(2));
        weight * legendre(degree, x).0 / square
    })
}

/// P_n and P_{n−1} of the highest degree n.
fn legendre(highest: usize, x: f64) -> (f64, f64) {
    let (mut before, mut value) = (1.0, x);
    for degree in 2..=highest {
        let n = degree as f64;
        (before, value) = (
            value,
            ((2.0 * n - 1.0) * x * value - (n - 1.0) * before) / n,
        );
    }
    (value, before)
}

/// Coefficients of the polynomial that is one at point `one` and zero at the others.
fn lagrange(part: &[f64; POINTS], one: usize) -> [f64; POINTS] {
    let mut product = [0.0; POINTS];
    product[0] = 1.0;
    for (index, zero) in part.iter().enumerate() {
        if index == one {
            continue;
        }
        let distance = part[one] - zero;
        for power in (0..POINTS).rev() {
            let lower = if power > 0 { product[power - 1] } else { 0.0 };
            product[power] = (lower - zero * product[power]) / distance;
        }
    }
    product
}

/// Derivatives, at an origin, of a polynomial by its coefficients, where `unit` is one.
fn derivatives(power: &[f64; POINTS], origin: f64, unit: f64) -> [f64; POINTS] {
    let mut derivatives = *power;
    for low in 0..POINTS {
        for index in (low..POINTS - 1).rev() {
            derivatives[index] += origin * derivatives[index + 1];
        }
    }
    let mut factor = 1.0;
    for (index, derivative) in derivatives.iter_mut().enumerate() {
        *derivative *= factor;
        factor *= (index + 1) as f64 * unit;
    }
    derivatives
}

/// Factors of the values in: value at the spare point less that of the polynomial through the others, which is the
/// highest coefficient times a product of distances.
fn spare(part: &[f64; POINTS], power: &[[f64; POINTS]; POINTS]) -> [f64; POINTS] {
    let others = (0..POINTS).filter(|&point| point != SPARE);
    let product: f64 = others.map(|point| part[SPARE] - part[point]).product();
    power.map(|row| row[POINTS - 1] * product)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The points of Lobatto's rule of seven: 0.4688… and 0.8302… of half the step from its middle.
    #[test]
    fn points_are_those_of_lobatto() {
        let expected = [-1.0, -0.830_223_896_278_567, -0.468_848_793_470_714_2, 0.0];
        for (found, expected) in NODES.part.iter().zip(expected) {
            assert!((2.0 * found - 1.0 - expected).abs() < 1e-15, "{found}");
        }
    }

    /// P₆ − P₄ vanishes at both ends, and its Legendre coefficients are −1, 0 and 1.
    #[test]
    fn one_point_fewer_leaves_out_legendre_polynomials() {
        let values = NODES.left_out.map(|value| [value; 4]);
        let coefficients = NODES.modes.map(|mode| combined(&mode, &values)[0]);
        for (found, expected) in coefficients.iter().zip([-1.0, 0.0, 1.0]) {
            assert!((found - expected).abs() < 1e-14, "{coefficients:?}");
        }
        assert!(NODES.left_out[0].abs() < 1e-14 && NODES.left_out[POINTS - 1].abs() < 1e-14);
    }

    /// A polynomial of the points' degree is met everywhere, and its next lower one is not.
    #[test]
    fn polynomials_through_the_points_are_exact_up_to_their_degree() {
        let value = |x: f64, degree: i32| [(x - 0.3).powi(degree); 4];
        let points = |degree| NODES.part.map(|part| value(part, degree));
        for degree in 0..POINTS as i32 {
            let ahead = combined(&weights(1.7), &points(degree))[0] - value(1.7, degree)[0];
            assert!(ahead.abs() < 1e-11, "{degree}: {ahead:e}");
            let spare = combined(&NODES.spare, &points(degree))[0].abs();
            assert_eq!(
                spare > 1e-4,
                degree == POINTS as i32 - 1,
                "{degree}: {spare:e}"
            );
        }
    }
}
