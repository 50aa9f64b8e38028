//! Floquet multipliers: by what a small distance from a motion that repeats is multiplied in a period.

use nalgebra::{Complex, DMatrix};
use serde::Serialize;

use super::Circle;
use crate::keys;

/// Multipliers of a motion.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[serde(untagged)]
pub enum Multipliers {
    /// Of a motion that repeats, the largest first: it is stable where all stand inside the unit circle.
    Periodic(#[serde(serialize_with = "keys::complex")] Vec<Complex<f64>>),
    /// Magnitudes of those of a motion with two frequencies, the largest first; their arguments have no
    /// meaning of their own, because a neighbouring motion may turn with the second phase.
    Torus(#[serde(serialize_with = "keys::magnitudes")] Vec<f64>),
}

impl Multipliers {
    /// Largest magnitude.
    pub fn largest(&self) -> f64 {
        match self {
            Self::Periodic(all) => all.first().map_or(0.0, |first| first.norm()),
            Self::Torus(all) => all.first().copied().unwrap_or(0.0),
        }
    }

    /// Whether neighbouring motions come closer.
    pub fn is_stable(&self) -> bool {
        self.largest() < 1.0
    }

    /// How far each is from the nearest of others, with the round-off of an eigenvalue.
    pub fn distances(&self, others: &Self) -> Vec<f64> {
        let (own, others) = (self.values(), others.values());
        let round_off = f64::EPSILON * self.largest();
        let nearest = |value: &Complex<f64>| {
            let distances = others.iter().map(|other| (value - other).norm());
            distances.fold(f64::INFINITY, f64::min) + round_off
        };
        own.iter().map(nearest).collect()
    }

    /// The multipliers as complex numbers; magnitudes where arguments have no meaning.
    pub fn values(&self) -> Vec<Complex<f64>> {
        match self {
            Self::Periodic(all) => all.clone(),
            Self::Torus(all) => all.iter().map(|size| Complex::new(*size, 0.0)).collect(),
        }
    }
}

/// Multipliers of a motion from the slopes of the map in its states.
///
/// Of a single state they are the eigenvalues of its slopes A. On a closed curve they are those of
/// `v(φ) → A(φ − ρ) v(φ − ρ)`; each appears once for every harmonic of the curve, turned but of the same
/// magnitude as far as the harmonics resolve it, and the middle one of these copies is taken.
pub fn multipliers(circle: &Circle, slopes: &[DMatrix<f64>]) -> Multipliers {
    match slopes {
        [only] => Multipliers::Periodic(sorted(only)),
        all => Multipliers::Torus(magnitudes(circle, all)),
    }
}

fn sorted(matrix: &DMatrix<f64>) -> Vec<Complex<f64>> {
    let mut values: Vec<Complex<f64>> = matrix.complex_eigenvalues().iter().copied().collect();
    // a pair stands together, its upper half first
    values.sort_by(|a, b| {
        let size = b.norm().total_cmp(&a.norm());
        let close = (a.norm() - b.norm()).abs() <= 1e-12 * a.norm();
        if close { b.im.total_cmp(&a.im) } else { size }
    });
    values
}

fn magnitudes(circle: &Circle, slopes: &[DMatrix<f64>]) -> Vec<f64> {
    let (count, size) = (slopes.len(), slopes[0].nrows());
    let back = circle.back();
    let whole = DMatrix::from_fn(size * count, size * count, |row, column| {
        let (place, from) = (row / size, column / size);
        back[(place, from)] * slopes[from][(row % size, column % size)]
    });
    let mut all: Vec<f64> = whole
        .complex_eigenvalues()
        .iter()
        .map(|value| value.norm())
        .collect();
    all.sort_by(|a, b| b.total_cmp(a));
    all.chunks(count)
        .map(|copies| copies[copies.len() / 2])
        .collect()
}
