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

use super::map::{jacobian, residual};
use super::multipliers::multipliers;
use super::newton::{ShootingError, solve};
use super::{Crossing, Family, Multipliers, Slopes, SpecialKind};

/// Corrections of a point before its step is halved.
const MOST_CORRECTIONS: usize = 10;
/// Slopes are renewed, so many times at most, where a correction shrinks by less than this.
const MOST_RENEWALS: usize = 2;
const SLOW: f64 = 0.3;
/// Corrections of so many tolerances that stay as they are count as the error of the integration.
const NOISE: f64 = 100.0;
/// A motion of doubled period has come to its end where it is nearer than this part of its widest to one
/// of half the period, and cannot be followed further.
const VANISHING: f64 = 0.1;
/// Corrections up to which the next step grows.
const FEW_CORRECTIONS: usize = 4;
const GROW: f64 = 1.5;
/// Least cosine between the tangents of neighbouring points.
const STRAIGHT: f64 = 0.85;
/// Difference of the parameter over which the map is looked at, as a part of the whole stretch.
const PARAMETER_STEP: f64 = 1e-5;
/// Points looked at to find where a motion changes its kind.
const MOST_LOCATIONS: usize = 16;
/// A motion changes its kind where the number that says so is this small,
const LOCATED: f64 = 1e-6;
/// and where it does not fall below this, it jumps and means nothing.
const CONTINUOUS: f64 = 1e-2;

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

/// Where a branch begins.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum Start<'a> {
    /// Near these states at the parameter 0, towards 1.
    AtFrom(DVector<f64>),
    /// A distance beside a motion, in a direction of its states.
    Beside(&'a BranchPoint, DVector<f64>, f64),
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
    let start = Start::Beside(doubling, direction, plan.step);
    follow_from(family, start, plan, watch)
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

/// A point with what it takes to go on.
#[derive(Clone)]
struct Node {
    point: BranchPoint,
    /// States and parameter.
    place: DVector<f64>,
    tangent: DVector<f64>,
    /// Slopes of what is missing by states and parameter.
    slopes: DMatrix<f64>,
    /// What is missing after half the period.
    half: Option<DVector<f64>>,
    corrections: usize,
}

impl Node {
    fn crossing(&self) -> Crossing {
        let turning = self.tangent[self.tangent.len() - 1];
        Crossing::of(&self.point.multipliers, turning)
    }
}

struct Walk<'a> {
    family: &'a mut dyn Family,
    plan: &'a Continuation,
}

impl Walk<'_> {
    fn first(&mut self, start: Start<'_>) -> Result<Node, ShootingError> {
        match start {
            Start::AtFrom(guess) => {
                self.family.set(0.0)?;
                let found = solve(self.family, guess, self.plan.tolerance)?;
                let place = found.states.push(0.0);
                let mut towards = DVector::zeros(place.len());
                towards[place.len() - 1] = 1.0;
                self.node(place, &towards, 0)
            }
            Start::Beside(point, direction, distance) => {
                let origin = point.states.clone().push(point.parameter);
                let direction = normalised(direction.push(0.0));
                let slopes = self.slopes_at(&origin)?;
                let guess = &origin + &direction * distance;
                let mut node = self.corrected(guess, &direction, &slopes)?;
                let away = &node.place - &origin;
                if product(&away, &node.tangent) < 0.0 {
                    node.tangent.neg_mut();
                }
                Ok(node)
            }
        }
    }

    fn along(
        &mut self,
        first: Node,
        branch: &mut Branch,
        watch: &mut dyn FnMut(&BranchPoint) -> bool,
    ) -> Result<BranchEnd, ShootingError> {
        let mut node = first;
        let (mut step, mut widest) = (self.plan.step, 0.0_f64);
        loop {
            let width = node.half.as_ref().map(DVector::amax);
            widest = widest.max(width.unwrap_or(0.0));
            branch.points.push(node.point.clone());
            if !watch(&node.point) || branch.points.len() >= self.plan.points {
                return Ok(BranchEnd::Points);
            }
            let vanishes = width.is_some_and(|width| width < VANISHING * widest);
            let (next, length) = match self.next(&node, &mut step) {
                Err(error) if vanishes && !is_interrupted(&error) => return Ok(BranchEnd::Closed),
                result => result?,
            };
            let parameter = next.point.parameter;
            if passed_half(&node, &next) {
                return Ok(BranchEnd::Closed);
            }
            self.locate_all(&node, &next, length, branch)?;
            if parameter >= 1.0 {
                let last = self.at_parameter(&node, &next, 1.0)?;
                watch(&last.point);
                branch.points.push(last.point);
                return Ok(BranchEnd::Reached);
            }
            if parameter <= 0.0 {
                branch.points.push(next.point);
                return Ok(BranchEnd::CameBack);
            }
            node = next;
        }
    }

    /// The next point, and the length of the step to it.
    fn next(&mut self, node: &Node, step: &mut f64) -> Result<(Node, f64), ShootingError> {
        loop {
            let guess = &node.place + &node.tangent * *step;
            let found = self.corrected(guess, &node.tangent, &node.slopes);
            let length = *step;
            let smallest = length <= self.plan.least_step;
            match found {
                Ok(next) if smallest || product(&next.tangent, &node.tangent) > STRAIGHT => {
                    if next.corrections <= FEW_CORRECTIONS {
                        *step = (length * GROW).min(self.plan.step);
                    }
                    return Ok((next, length));
                }
                Err(error) if smallest || is_interrupted(&error) => return Err(error),
                _ => *step = (0.5 * length).max(self.plan.least_step),
            }
        }
    }

    /// Corrects a guess in the plane across a direction, with slopes of about there.
    fn corrected(
        &mut self,
        mut place: DVector<f64>,
        direction: &DVector<f64>,
        slopes: &DMatrix<f64>,
    ) -> Result<Node, ShootingError> {
        let mut factors = bordered(slopes, direction).lu();
        let (mut history, mut before, mut renewals) = (Vec::new(), f64::INFINITY, 0);
        for corrections in 1..=MOST_CORRECTIONS {
            let missing = self.missing(&place)?;
            history.push(missing.amax());
            let correction = factors
                .solve(&missing.push(0.0))
                .ok_or(ShootingError::Singular)?;
            place -= &correction;
            let size = correction.amax();
            let slow = size > SLOW * before;
            let noise = slow && renewals > 0 && size <= NOISE * self.plan.tolerance;
            if size <= self.plan.tolerance || noise {
                return self.node(place, direction, corrections);
            }
            if !size.is_finite() || (slow && renewals == MOST_RENEWALS) {
                break;
            }
            if slow {
                factors = bordered(&self.slopes_at(&place)?, direction).lu();
                renewals += 1;
            }
            before = size;
        }
        Err(ShootingError::NotFound { history })
    }

    fn missing(&mut self, place: &DVector<f64>) -> Result<DVector<f64>, ShootingError> {
        let (states, parameter) = parts(place);
        self.family.set(parameter)?;
        let image = self.family.image(&states, Slopes::None)?;
        Ok(residual(self.family, &states, &image.end))
    }

    fn slopes_at(&mut self, place: &DVector<f64>) -> Result<DMatrix<f64>, ShootingError> {
        let (states, parameter) = parts(place);
        self.family.set(parameter)?;
        let image = self.family.image(&states, Slopes::All)?;
        self.slopes_from(place, &states, &image.end, &image.slopes)
    }

    /// Slopes of what is missing by the states, and by the parameter as a difference.
    fn slopes_from(
        &mut self,
        place: &DVector<f64>,
        states: &DVector<f64>,
        end: &DVector<f64>,
        slopes: &[DMatrix<f64>],
    ) -> Result<DMatrix<f64>, ShootingError> {
        let by_states = jacobian(self.family, slopes);
        let here = residual(self.family, states, end);
        let mut beside = place.clone();
        beside[place.len() - 1] += PARAMETER_STEP;
        let by_parameter = (self.missing(&beside)? - here) / PARAMETER_STEP;
        let columns = by_states.ncols();
        let mut all = by_states.insert_column(columns, 0.0);
        all.set_column(columns, &by_parameter);
        Ok(all)
    }

    /// Everything about a point of the branch; its tangent goes along `direction`.
    fn node(
        &mut self,
        place: DVector<f64>,
        direction: &DVector<f64>,
        corrections: usize,
    ) -> Result<Node, ShootingError> {
        let (states, parameter) = parts(&place);
        self.family.set(parameter)?;
        let image = self.family.image(&states, Slopes::All)?;
        let half = self.family.half_return(&states)?;
        let multipliers = multipliers(self.family.circle(), &image.slopes);
        let slopes = self.slopes_from(&place, &states, &image.end, &image.slopes)?;
        let mut ahead = DVector::zeros(place.len());
        ahead[place.len() - 1] = 1.0;
        let tangent = bordered(&slopes, direction)
            .lu()
            .solve(&ahead)
            .ok_or(ShootingError::Singular)?;
        Ok(Node {
            point: BranchPoint {
                parameter,
                states,
                slopes: image.slopes,
                multipliers,
            },
            place,
            tangent: normalised(tangent),
            slopes,
            half,
            corrections,
        })
    }

    /// The motion at a parameter between two points.
    fn at_parameter(
        &mut self,
        before: &Node,
        after: &Node,
        parameter: f64,
    ) -> Result<Node, ShootingError> {
        let (from, to) = (before.point.parameter, after.point.parameter);
        let part = (parameter - from) / (to - from);
        let mut guess = &before.place + (&after.place - &before.place) * part;
        let last = guess.len() - 1;
        guess[last] = parameter;
        let mut direction = DVector::zeros(guess.len());
        direction[last] = 1.0;
        let mut found = self.corrected(guess, &direction, &after.slopes)?;
        if product(&found.tangent, &after.tangent) < 0.0 {
            found.tangent.neg_mut();
        }
        Ok(found)
    }

    /// Finds where the motion changes its kind between two neighbouring points.
    fn locate_all(
        &mut self,
        before: &Node,
        after: &Node,
        length: f64,
        branch: &mut Branch,
    ) -> Result<(), ShootingError> {
        for kind in Crossing::between(&before.crossing(), &after.crossing()) {
            let found = self.locate(before, after, length, kind)?;
            if found.crossing().of_kind(kind).abs() < CONTINUOUS {
                branch.specials.push(Special {
                    kind,
                    point: found.point,
                    after: branch.points.len(),
                });
            }
        }
        Ok(())
    }

    /// By the regula falsi in the form of Illinois, along the tangent of the first point.
    fn locate(
        &mut self,
        before: &Node,
        after: &Node,
        length: f64,
        kind: SpecialKind,
    ) -> Result<Node, ShootingError> {
        let value = |node: &Node| node.crossing().of_kind(kind);
        let (mut low, mut high) = ((0.0, value(before)), (length, value(after)));
        let mut nearest = if low.1.abs() < high.1.abs() {
            before.clone()
        } else {
            after.clone()
        };
        let mut same_side = 0;
        for _ in 0..MOST_LOCATIONS {
            let at = (low.0 * high.1 - high.0 * low.1) / (high.1 - low.1);
            let guess = &before.place + &before.tangent * at;
            let found = self.corrected(guess, &before.tangent, &after.slopes)?;
            let number = value(&found);
            if number.abs() < value(&nearest).abs() {
                nearest = found;
            }
            if number.abs() < LOCATED || (high.0 - low.0) < self.plan.tolerance {
                break;
            }
            if number * high.1 > 0.0 {
                high = (at, number);
                if same_side == 1 {
                    low.1 *= 0.5;
                }
                same_side = 1;
            } else {
                low = (at, number);
                if same_side == -1 {
                    high.1 *= 0.5;
                }
                same_side = -1;
            }
        }
        Ok(nearest)
    }
}

fn is_interrupted(error: &ShootingError) -> bool {
    use super::MapError;
    use crate::integrate::IntegrateError;
    matches!(
        error,
        ShootingError::Map(MapError::Integrate(IntegrateError::Interrupted { .. }))
    )
}

/// Whether a motion of doubled period went through one of half the period.
fn passed_half(before: &Node, after: &Node) -> bool {
    match (&before.half, &after.half) {
        (Some(before), Some(after)) => before.dot(after) < 0.0,
        _ => false,
    }
}

/// States and parameter.
fn parts(place: &DVector<f64>) -> (DVector<f64>, f64) {
    let states = place.len() - 1;
    (place.rows(0, states).into_owned(), place[states])
}

/// `⟨a, b⟩`
fn product(left: &DVector<f64>, right: &DVector<f64>) -> f64 {
    let states = left.len() - 1;
    let sum: f64 = (0..states).map(|i| left[i] * right[i]).sum();
    sum / states as f64 + left[states] * right[states]
}

fn normalised(vector: DVector<f64>) -> DVector<f64> {
    let length = product(&vector, &vector).sqrt();
    vector / length
}

/// Slopes with the row of the plane below them.
fn bordered(slopes: &DMatrix<f64>, direction: &DVector<f64>) -> DMatrix<f64> {
    let states = slopes.nrows();
    let mut all = slopes.clone().insert_row(states, 0.0);
    for column in 0..states {
        all[(states, column)] = direction[column] / states as f64;
    }
    all[(states, states)] = direction[states];
    all
}
