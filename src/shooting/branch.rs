//! Along a branch of motions: continuation by pseudo-arclength.
//!
//! ```text
//! G(u, p) = 0,   ⟨t, (u, p) − (u₀, p₀) − s t⟩ = 0,   ⟨a, b⟩ = Σ a_i b_i/(n U²) + a_p b_p
//! ```
//!
//! with t the tangent at the point before, so that nothing is singular where the branch turns round, and U the size of the
//! motion there.
//!
//! Source: H. B. Keller, *Numerical solution of bifurcation and nonlinear eigenvalue problems* (1977);
//! Seydel, ch. 4.

use nalgebra::{DMatrix, DVector};
use serde::Serialize;

use super::corrector::Continuer;
use super::{Multipliers, ReturnMap, ShootingError, SpecialKind};
use crate::keys;

/// Parts of a step that a motion of doubled period is first sought at.
const FIRST_PARTS: [f64; 4] = [1.0, 0.2, 0.04, 5.0];

/// How far to follow a branch, and in what steps. The parameter runs from 0 to 1.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Continuation {
    /// Relative exactness of every point, in sizes of the motion.
    pub tolerance: f64,
    /// First and longest distance of two points; a unit is the whole range of the parameter.
    pub step: f64,
    /// Least distance.
    pub least_step: f64,
    /// Most points.
    pub points: usize,
}

/// A motion of a branch.
#[derive(Debug, Clone, PartialEq)]
pub struct BranchPoint {
    /// Parameter, 0 … 1.
    pub parameter: f64,
    /// States, scaled.
    pub states: DVector<f64>,
    /// Slopes of the map in every state.
    pub slopes: Vec<DMatrix<f64>>,
    /// Floquet multipliers.
    pub multipliers: Multipliers,
}

/// Where a motion changes its kind.
#[derive(Debug, Clone, PartialEq)]
pub struct Special {
    /// How.
    pub kind: SpecialKind,
    /// The motion there.
    pub point: BranchPoint,
    /// Number of branch points before it.
    pub after: usize,
}

/// Where a motion changes its kind between two points of a branch, and the point could not be found: the
/// multipliers jump there, as where a contact parts all at once.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Unrefined {
    /// What a number that changes its sign speaks for.
    #[serde(serialize_with = "keys::name")]
    pub kind: SpecialKind,
    /// Number of branch points before it.
    #[serde(rename = "after_points")]
    pub after: usize,
    /// Parameters of both points.
    pub between: [f64; 2],
    /// The least that was found of that number, zero at the point itself: how far a multiplier stays from
    /// the unit circle or, at a fold, the branch from turning.
    pub left: f64,
}

/// Why a branch ends.
#[derive(Debug, Clone, PartialEq)]
pub enum BranchEnd {
    /// The parameter reached the end of its range.
    Reached,
    /// The parameter came back to its start.
    CameBack,
    /// The motion of doubled period became that of half the period again.
    Closed,
    /// There were as many points as were asked for.
    Points,
    /// Somebody asked the integration to stop, or it failed, or steps became too small; why.
    Lost(ShootingError),
}

/// Motions along a parameter.
#[derive(Debug, Clone, PartialEq)]
pub struct Branch {
    /// The motions, in their order along the branch.
    pub points: Vec<BranchPoint>,
    /// Where they change their kind.
    pub specials: Vec<Special>,
    /// Where they seem to, without a point that could be found.
    pub unrefined: Vec<Unrefined>,
    /// Why it ends.
    pub end: BranchEnd,
}

impl Branch {
    /// One that ended before its first point.
    pub fn without_points(end: BranchEnd) -> Self {
        Self {
            points: Vec::new(),
            specials: Vec::new(),
            unrefined: Vec::new(),
            end,
        }
    }
}

/// Follows the branch of motions that begins near `guess` at the parameter 0.
///
/// `watch` sees every point.
///
/// # Errors
/// [`ShootingError`] where not even the first motion is found; what happens later ends the branch.
pub fn follow(
    family: &mut dyn ReturnMap,
    guess: DVector<f64>,
    plan: &Continuation,
    watch: &mut dyn FnMut(&BranchPoint),
) -> Result<Branch, ShootingError> {
    let mut continuer = Continuer { family, plan };
    let first = continuer.near(guess)?;
    Ok(continuer.branch(first, watch))
}

/// Follows the branch of doubled period from where a motion has a multiplier −1; `family` is that of
/// twice the period.
///
/// # Errors
/// As [`follow`].
pub fn follow_doubled(
    family: &mut dyn ReturnMap,
    doubling: &BranchPoint,
    plan: &Continuation,
    watch: &mut dyn FnMut(&BranchPoint),
) -> Result<Branch, ShootingError> {
    let direction = turned(doubling).ok_or(ShootingError::Singular)?;
    let mut continuer = Continuer { family, plan };
    let mut last = ShootingError::Singular;
    for part in FIRST_PARTS {
        match continuer.away_from(doubling, direction.clone(), part * plan.step) {
            Ok(first) => return Ok(continuer.branch(first, watch)),
            Err(error) if error.is_interrupted() => return Err(error),
            Err(error) => last = error,
        }
    }
    Err(last)
}

/// The direction that a period turns into its opposite.
fn turned(point: &BranchPoint) -> Option<DVector<f64>> {
    let [slopes] = &point.slopes[..] else {
        return None;
    };
    let shifted = slopes + DMatrix::identity(slopes.nrows(), slopes.nrows());
    let decomposed = shifted.svd(false, true);
    let least = decomposed.singular_values.imin();
    Some(decomposed.v_t?.row(least).transpose())
}

#[cfg(test)]
mod tests {
    use super::super::{Circle, Image, MapError, Slopes};
    use super::*;

    /// A motion at rest whose multiplier goes from −0.5 to −1.5: all at once, as where a contact parts, or
    /// little by little.
    struct Parting {
        circle: Circle,
        multiplier: f64,
        at_once: bool,
    }

    impl ReturnMap for Parting {
        fn size(&self) -> usize {
            1
        }

        fn circle(&self) -> &Circle {
            &self.circle
        }

        fn image(&mut self, states: &DVector<f64>, _slopes: Slopes) -> Result<Image, MapError> {
            Ok(Image {
                end: states * self.multiplier,
                slopes: vec![DMatrix::from_element(1, 1, self.multiplier)],
            })
        }

        fn set(&mut self, parameter: f64) -> Result<(), MapError> {
            self.multiplier = match self.at_once {
                false => -0.5 - parameter,
                true if parameter < 0.512_3 => -0.5,
                true => -1.5,
            };
            Ok(())
        }
    }

    fn followed(at_once: bool) -> Branch {
        let mut family = Parting {
            circle: Circle::point(1.0),
            multiplier: 0.0,
            at_once,
        };
        let plan = Continuation {
            tolerance: 1e-9,
            step: 0.1,
            least_step: 1e-4,
            points: 100,
        };
        follow(&mut family, DVector::zeros(1), &plan, &mut |_| {}).unwrap()
    }

    /// A multiplier that jumps over −1 is −1 at no point: the branch says between which points.
    #[test]
    fn a_jump_of_a_multiplier_is_told_of() {
        let smooth = followed(false);
        assert_eq!((smooth.specials.len(), smooth.unrefined.len()), (1, 0));
        assert!((smooth.specials[0].point.parameter - 0.5).abs() < 1e-6);
        let jump = followed(true);
        assert_eq!((jump.specials.len(), jump.unrefined.len()), (0, 1));
        let found = jump.unrefined[0];
        assert_eq!(found.kind, SpecialKind::PeriodDoubling);
        assert!((found.left - 0.5).abs() < 1e-12, "{found:?}");
        assert!(found.between[0] < 0.512_3 && 0.512_3 < found.between[1]);
    }
}
