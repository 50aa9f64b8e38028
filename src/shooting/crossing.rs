//! How a motion loses its stability along a parameter.

use std::fmt;

use super::Multipliers;

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
    /// A pair of multipliers stands on the unit circle: a second frequency begins or ends.
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
    pub fn cause(multipliers: &Multipliers) -> Option<SpecialKind> {
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
