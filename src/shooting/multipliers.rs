//! Floquet multipliers: by what a small distance from a motion that repeats is multiplied in a period; and what
//! happens to the motion where one of them leaves the unit circle.

use std::fmt;

use nalgebra::{Complex, DMatrix};
use serde::Serialize;

use super::{Circle, reduction};
use crate::keys;

/// Multipliers of a motion.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[serde(untagged)]
pub enum Multipliers {
    /// Of a motion that repeats, the largest first: it is stable where all lie inside the unit circle.
    Periodic(#[serde(serialize_with = "keys::complex")] Vec<Complex<f64>>),
    /// Those of a motion with two frequencies, the largest first. Their arguments have no meaning of their own, because a
    /// neighbouring motion may turn with the second phase, and are judged by errors alone.
    Torus(#[serde(serialize_with = "keys::magnitudes")] Vec<Complex<f64>>),
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

    /// Stability where each multiplier is known to an error, which holds within a factor of 3.
    pub fn stability(&self, errors: &[f64]) -> Stability {
        let beyond = |(value, error): (&Complex<f64>, &f64)| (value.norm() - 1.0) / (3.0 * error);
        let values = self.values();
        let furthest = values.iter().zip(errors).map(beyond);
        match furthest.fold(f64::NEG_INFINITY, f64::max) {
            errors if errors > 1.0 => Stability::Unstable(self.instability()),
            errors if errors >= -1.0 => Stability::Neutral,
            _ => Stability::Stable,
        }
    }

    /// How a motion that is not stable lost its stability, by the multiplier furthest outside.
    fn instability(&self) -> SpecialKind {
        match self {
            Self::Torus(_) => SpecialKind::TorusStability,
            Self::Periodic(all) => match all.first() {
                Some(first) if first.im.abs() > REAL * first.norm() => SpecialKind::NeimarkSacker,
                Some(first) if first.re < 0.0 => SpecialKind::PeriodDoubling,
                _ => SpecialKind::Fold,
            },
        }
    }

    /// How far each is from its partner among others, both taken in pairs, the nearest first; and the round-off of them. Those on a
    /// closed curve count with their arguments, too: the change of a magnitude alone may be small by chance.
    pub fn distances(&self, others: &Self, round_off: f64) -> Vec<f64> {
        let [own, others] = [self, others].map(|either| match either {
            Self::Periodic(all) | Self::Torus(all) => all,
        });
        let mut pairs: Vec<(f64, usize, usize)> = Vec::new();
        for (index, value) in own.iter().enumerate() {
            let distances = others.iter().map(|other| (value - other).norm());
            pairs.extend(
                distances
                    .enumerate()
                    .map(|(other, apart)| (apart, index, other)),
            );
        }
        pairs.sort_by(|a, b| a.0.total_cmp(&b.0));
        let mut found = vec![None; own.len()];
        let mut taken = vec![false; others.len()];
        for (apart, index, other) in pairs {
            if found[index].is_none() && !taken[other] {
                found[index] = Some(apart + round_off);
                taken[other] = true;
            }
        }
        let unpaired = f64::INFINITY;
        found
            .into_iter()
            .map(|apart| apart.unwrap_or(unpaired))
            .collect()
    }

    /// The multipliers as complex numbers; magnitudes where arguments have no meaning.
    pub fn values(&self) -> Vec<Complex<f64>> {
        match self {
            Self::Periodic(all) => all.clone(),
            Self::Torus(all) => all.iter().map(|value| value.norm().into()).collect(),
        }
    }
}

/// Whether neighbouring motions come closer to a motion that repeats.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Stability {
    /// They do: a long run settles to the motion.
    Stable,
    /// They neither come closer nor go away, as far as the errors of the multipliers tell: as without damping.
    Neutral,
    /// They go away, and this is how the motion lost its stability.
    Unstable(SpecialKind),
}

/// Multipliers of a motion from the slopes of the map in its states.
///
/// Of a single state they are the eigenvalues of its slopes A. On a closed curve they are those of
/// `v(φ) → A(φ − ρ) v(φ − ρ)`, by coordinates in which A is constant or, where none are found, by the whole operator.
pub fn multipliers(circle: &Circle, slopes: &[DMatrix<f64>]) -> Multipliers {
    match slopes {
        [only] => Multipliers::Periodic(sorted(only)),
        all => Multipliers::Torus(on_curve(circle, all)),
    }
}

fn sorted(matrix: &DMatrix<f64>) -> Vec<Complex<f64>> {
    by_magnitude(matrix.complex_eigenvalues().iter().copied().collect())
}

/// Magnitudes that differ by less than this part count as one.
const SAME_MAGNITUDE: f64 = 1e-12;

/// The largest first; of one magnitude those with the larger imaginary part, so that the upper half of a pair comes before the
/// lower.
fn by_magnitude(mut values: Vec<Complex<f64>>) -> Vec<Complex<f64>> {
    values.sort_by(|a, b| b.norm().total_cmp(&a.norm()));
    // "nearly the same" is no order to sort by: from 1 to 2 and from 2 to 3 it may hold, and from 1 to 3 not
    let near =
        |a: &Complex<f64>, b: &Complex<f64>| a.norm() - b.norm() <= SAME_MAGNITUDE * a.norm();
    for alike in values.chunk_by_mut(near) {
        alike.sort_by(|a, b| b.im.total_cmp(&a.im));
    }
    values
}

/// Multipliers on a closed curve, the largest first; without arguments where no coordinates are found.
fn on_curve(circle: &Circle, slopes: &[DMatrix<f64>]) -> Vec<Complex<f64>> {
    let Some(mut all) = reduction::multipliers(circle, slopes) else {
        let magnitudes = magnitudes_of_copies(circle, slopes);
        return magnitudes.into_iter().map(Complex::from).collect();
    };
    all.sort_by(|a, b| b.norm().total_cmp(&a.norm()));
    all
}

/// Magnitudes of the multipliers by the operator over all nodes: each appears once for every harmonic of the curve, turned
/// but of the same magnitude as far as the harmonics resolve it, and the middle one of these copies is taken.
pub(super) fn magnitudes_of_copies(circle: &Circle, slopes: &[DMatrix<f64>]) -> Vec<f64> {
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
/// Least distance of a multiplier from the unit circle that tells on which side of it a motion of a branch lies.
const RESOLVED: f64 = 1e-6;

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
    pub fn from_multipliers(multipliers: &Multipliers, turning: f64) -> Self {
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
    pub fn value(&self, kind: SpecialKind) -> f64 {
        self.0[kind as usize]
    }

    /// What may happen between two motions of a branch.
    pub fn between(before: &Self, after: &Self) -> Vec<SpecialKind> {
        // a zero at a point itself belongs to one of its two sides; numbers that stay near zero, as those of undamped
        // vibrations, change their sign by their errors only
        let changes = |kind: &SpecialKind| {
            let [before, after] = [before, after].map(|point| point.value(*kind));
            let resolved = *kind == SpecialKind::Fold || before.abs().max(after.abs()) > RESOLVED;
            resolved && (before < 0.0) != (after < 0.0)
        };
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
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Forty numbers on the unit circle, as near to it as round-off brings those of an undamped shaft.
    #[test]
    fn multipliers_of_nearly_one_magnitude_have_an_order() {
        let on_circle = |k: u32| {
            let magnitude = 1.0 + 0.4e-12 * f64::from(k * 7 % 40);
            let upper = Complex::from_polar(magnitude, 0.1 + 0.13 * f64::from(k / 2));
            if k.is_multiple_of(2) {
                upper
            } else {
                upper.conj()
            }
        };
        let inside = [Complex::new(0.3, -0.2), Complex::new(0.3, 0.2)];
        let all: Vec<_> = (0..40).map(on_circle).chain(inside).collect();
        let found = by_magnitude(all.clone());
        assert_eq!(found.len(), all.len());
        assert!(all.iter().all(|value| found.contains(value)));
        let magnitudes = found.windows(2).map(|pair| pair[1].norm() - pair[0].norm());
        assert!(magnitudes.fold(0.0, f64::max) < 40.0 * SAME_MAGNITUDE);
        assert_eq!(found[40..], [inside[1], inside[0]]);
    }
}
