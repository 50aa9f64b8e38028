//! Floquet multipliers: by what a small distance from a motion that repeats is multiplied in a period; and what
//! happens to the motion where one of them leaves the unit circle.

use std::fmt;

use nalgebra::{Complex, DMatrix};
use serde::Serialize;

use super::Circle;
use crate::keys;

/// Multipliers of a motion.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[serde(untagged)]
pub enum Multipliers {
    /// Of a motion that repeats, the largest first: it is stable where all lie inside the unit circle.
    Periodic(#[serde(serialize_with = "keys::complex")] Vec<Complex<f64>>),
    /// Magnitudes of those of a motion with two frequencies, the largest first; their arguments have no
    /// meaning of their own, because a neighbouring motion may turn with the second phase.
    Torus(#[serde(serialize_with = "keys::magnitudes")] Vec<f64>),
}

impl Multipliers {
    /// Largest magnitude.
    pub fn largest(&self) -> f64 {
        self.values().first().map_or(0.0, |first| first.norm())
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
    // a pair is kept together, its upper half first
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
        let (node, from) = (row / size, column / size);
        back[(node, from)] * slopes[from][(row % size, column % size)]
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

/// A multiplier counts as real where its imaginary part is below this part of its magnitude.
const REAL: f64 = 1e-9;

/// What happens to a motion at a value of the parameter.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub enum SpecialKind {
    /// The branch turns round: a multiplier is 1, and two motions meet and vanish.
    Fold,
    /// A multiplier is 1 and the branch does not turn: another one of the same period meets it.
    Branching,
    /// A multiplier is −1: a motion of twice the period begins or ends.
    PeriodDoubling,
    /// A pair of multipliers lies on the unit circle: a second frequency begins or ends.
    NeimarkSacker,
    /// A motion with two frequencies gains or loses its stability.
    TorusStability,
}

/// `fold`, `branching`, `period doubling`, `Neimark-Sacker`, `torus stability`.
impl fmt::Display for SpecialKind {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(match self {
            Self::Fold => "fold",
            Self::Branching => "branching",
            Self::PeriodDoubling => "period doubling",
            Self::NeimarkSacker => "Neimark-Sacker",
            Self::TorusStability => "torus stability",
        })
    }
}

/// Numbers that change their sign where a motion changes its kind, in the order of the kinds: the change of the
/// parameter along the branch, one less the largest real multiplier, one more than the least one, one less the largest
/// magnitude of a pair, and one less the largest magnitude on a torus.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Crossing([f64; 5]);

impl Crossing {
    /// The numbers of a motion whose branch changes the parameter by `turning`.
    pub fn of(multipliers: &Multipliers, turning: f64) -> Self {
        let Multipliers::Periodic(all) = multipliers else {
            return Self([turning, 1.0, 1.0, 1.0, 1.0 - multipliers.largest()]);
        };
        let (mut plus_one, mut minus_one, mut pair) = (1.0_f64, 1.0_f64, 1.0_f64);
        for value in all {
            if value.im.abs() <= REAL * value.norm() {
                plus_one = plus_one.min(1.0 - value.re);
                minus_one = minus_one.min(1.0 + value.re);
            } else {
                pair = pair.min(1.0 - value.norm());
            }
        }
        Self([turning, plus_one, minus_one, pair, 1.0])
    }

    /// The number that belongs to a kind.
    pub fn of_kind(&self, kind: SpecialKind) -> f64 {
        self.0[kind as usize]
    }

    /// What may happen between two motions of a branch.
    pub fn between(before: &Self, after: &Self) -> Vec<SpecialKind> {
        // a zero at a point itself belongs to one of its two sides
        let changes =
            |kind: &SpecialKind| (before.of_kind(*kind) < 0.0) != (after.of_kind(*kind) < 0.0);
        let folds = changes(&SpecialKind::Fold);
        [
            SpecialKind::Fold,
            SpecialKind::Branching,
            SpecialKind::PeriodDoubling,
            SpecialKind::NeimarkSacker,
            SpecialKind::TorusStability,
        ]
        .into_iter()
        // at a fold a multiplier passes 1, and that is all there is to it
        .filter(|kind| changes(kind) && !(folds && *kind == SpecialKind::Branching))
        .collect()
    }

    /// How a motion that is not stable lost its stability, by the multiplier furthest outside.
    pub fn instability(multipliers: &Multipliers) -> Option<SpecialKind> {
        if multipliers.is_stable() {
            return None;
        }
        let Multipliers::Periodic(all) = multipliers else {
            return Some(SpecialKind::TorusStability);
        };
        let first = all.first()?;
        Some(if first.im.abs() > REAL * first.norm() {
            SpecialKind::NeimarkSacker
        } else if first.re < 0.0 {
            SpecialKind::PeriodDoubling
        } else {
            SpecialKind::Fold
        })
    }
}
