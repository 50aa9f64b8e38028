//! Along a branch of motions: continuation by pseudo-arclength.
//!
//! ```text
//! G(u, p) = 0,   ⟨t, (u, p) − (u₀, p₀) − s t⟩ = 0,   ⟨a, b⟩ = Σ a_i b_i/n + a_p b_p
//! ```
//!
//! with t the tangent at the point before, so that nothing is singular where the branch turns round.
//!
//! Source: H. B. Keller, *Numerical solution of bifurcation and nonlinear eigenvalue problems* (1977);
//! Seydel, ch. 4.

use nalgebra::{DMatrix, DVector};

use super::walk::{Start, Walk, is_interrupted};
use super::{Family, Multipliers, ShootingError, SpecialKind};

/// Parts of a step that a motion of doubled period is first looked for at.
const FIRST_PARTS: [f64; 4] = [1.0, 0.2, 0.04, 5.0];

/// How far to follow a branch, and in what steps. The parameter runs from 0 to 1.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Continuation {
    /// Relative exactness of every point, in sizes of the motion.
    pub tolerance: f64,
    /// First and longest distance of two points; a unit is the whole stretch of the parameter.
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

/// Why a branch ends.
#[derive(Debug, Clone, PartialEq)]
pub enum BranchEnd {
    /// The parameter reached the end of its stretch.
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
    /// Why it ends.
    pub end: BranchEnd,
}

/// Follows the branch of motions that begins near `guess` at the parameter 0.
///
/// `watch` sees every point and says whether to go on.
///
/// # Errors
/// [`ShootingError`] where not even the first motion is found; what happens later ends the branch.
pub fn follow(
    family: &mut dyn Family,
    guess: DVector<f64>,
    plan: &Continuation,
    watch: &mut dyn FnMut(&BranchPoint) -> bool,
) -> Result<Branch, ShootingError> {
    follow_from(family, Start::AtFrom(guess), plan, watch)
}

/// Follows the branch of doubled period from where a motion has a multiplier −1; `family` is that of
/// twice the period.
///
/// # Errors
/// As [`follow`].
pub fn follow_doubled(
    family: &mut dyn Family,
    doubling: &BranchPoint,
    plan: &Continuation,
    watch: &mut dyn FnMut(&BranchPoint) -> bool,
) -> Result<Branch, ShootingError> {
    let direction = turned(doubling).ok_or(ShootingError::Singular)?;
    let mut last = ShootingError::Singular;
    for part in FIRST_PARTS {
        let start = Start::Beside(doubling, direction.clone(), part * plan.step);
        match follow_from(family, start, plan, watch) {
            Err(error) if !is_interrupted(&error) => last = error,
            result => return result,
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

fn follow_from(
    family: &mut dyn Family,
    start: Start<'_>,
    plan: &Continuation,
    watch: &mut dyn FnMut(&BranchPoint) -> bool,
) -> Result<Branch, ShootingError> {
    let mut walk = Walk { family, plan };
    let first = walk.first(start)?;
    let mut branch = Branch {
        points: Vec::new(),
        specials: Vec::new(),
        end: BranchEnd::Points,
    };
    branch.end = match walk.along(first, &mut branch, watch) {
        Ok(end) => end,
        Err(error) => BranchEnd::Lost(error),
    };
    Ok(branch)
}
