//! Predictor and corrector of the continuation along a branch, point by point, and where the motion changes its
//! kind between two of them.

use nalgebra::{DMatrix, DVector};

use super::map::{jacobian, residual};
use super::multipliers::{Crossing, SpecialKind, multipliers};
use super::newton::{ShootingError, solve};
use super::{
    Branch, BranchEnd, BranchPoint, Continuation, Image, ReturnMap, Slopes, Special, Unrefined,
};
use crate::numerics::root::Bracket;

/// Corrections of a point before its step is halved.
const MOST_CORRECTIONS: usize = 16;
/// Slopes are renewed, so many times at most, where a correction shrinks by less than this.
const MOST_RENEWALS: usize = 6;
const SLOW: f64 = 0.3;
/// Corrections of so many tolerances that stay as they are count as the error of the integration.
const NOISE: f64 = 300.0;
/// A motion of doubled period has come to its end where it is nearer than this part of its widest to one
/// of half the period, and cannot be followed further.
const VANISHING: f64 = 0.3;
/// Corrections up to which the next step grows.
const FEW_CORRECTIONS: usize = 4;
const GROW: f64 = 1.5;
/// Least cosine between the tangents of neighbouring points.
const STRAIGHT: f64 = 0.85;
/// Difference of the parameter over which the map is differenced, as a part of the whole range.
const PARAMETER_STEP: f64 = 1e-5;

/// Points tried to find where a motion changes its kind.
const MOST_LOCATIONS: usize = 16;
/// A motion changes its kind where the number that says so is this small,
const LOCATED: f64 = 1e-6;
/// and where it does not fall below this, it jumps and has no such point.
const CONTINUOUS: f64 = 1e-2;

/// A point with what it takes to go on.
#[derive(Clone)]
pub(super) struct Node {
    point: BranchPoint,
    /// States and parameter.
    unknowns: DVector<f64>,
    tangent: DVector<f64>,
    /// Slopes of the residual by states and parameter.
    slopes: DMatrix<f64>,
    /// Residual after half the period.
    half: Option<DVector<f64>>,
    corrections: usize,
}

impl Node {
    fn crossing(&self) -> Crossing {
        let turning = self.tangent[self.tangent.len() - 1];
        Crossing::from_multipliers(&self.point.multipliers, turning)
    }

    /// Number of multipliers outside the unit circle. Where it stays, a number that jumps means nothing: a pair
    /// outside became two real ones there, or the reverse.
    fn outside(&self) -> usize {
        let all = self.point.multipliers.values();
        all.iter().filter(|value| value.norm() >= 1.0).count()
    }
}

/// What follows a branch of a family.
pub(super) struct Continuer<'a> {
    pub family: &'a mut dyn ReturnMap,
    pub plan: &'a Continuation,
}

impl Continuer<'_> {
    /// The first point of a branch, near these states at the parameter 0, towards 1.
    pub fn near(&mut self, guess: DVector<f64>) -> Result<Node, ShootingError> {
        self.family.set(0.0)?;
        let found = solve(self.family, guess, None, self.plan.tolerance)?;
        let unknowns = found.states.push(0.0);
        let towards = parameter_direction(unknowns.len());
        self.node(unknowns, &towards, 0)
    }

    /// The first point of a branch, a distance from a motion along a direction of its states.
    pub fn away_from(
        &mut self,
        point: &BranchPoint,
        direction: DVector<f64>,
        distance: f64,
    ) -> Result<Node, ShootingError> {
        let origin = point.states.clone().push(point.parameter);
        let direction = normalised(direction.push(0.0));
        // where branches meet two directions lead on, and slopes there tell nothing of which
        let guess = &origin + &direction * distance;
        let slopes = self.slopes_at(&guess)?;
        let mut node = self.corrected(guess, &direction, &slopes)?;
        let away = &node.unknowns - &origin;
        if product(&away, &node.tangent) < 0.0 {
            node.tangent.neg_mut();
        }
        Ok(node)
    }

    /// The branch from its first point on.
    pub fn branch(&mut self, first: Node, watch: &mut dyn FnMut(&BranchPoint)) -> Branch {
        let mut branch = Branch::without_points(BranchEnd::Points);
        let end = self.along(first, &mut branch, watch);
        branch.end = end.unwrap_or_else(BranchEnd::Lost);
        branch
    }

    fn along(
        &mut self,
        first: Node,
        branch: &mut Branch,
        watch: &mut dyn FnMut(&BranchPoint),
    ) -> Result<BranchEnd, ShootingError> {
        let mut node = first;
        let (mut step, mut widest) = (self.plan.step, 0.0_f64);
        loop {
            let width = node.half.as_ref().map(DVector::amax);
            widest = widest.max(width.unwrap_or(0.0));
            branch.points.push(node.point.clone());
            watch(&node.point);
            if branch.points.len() >= self.plan.points {
                return Ok(BranchEnd::Points);
            }
            let vanishes = width.is_some_and(|width| width < VANISHING * widest);
            let (next, length) = match self.next(&node, &mut step) {
                Err(error) if vanishes && !error.is_interrupted() => return Ok(BranchEnd::Closed),
                result => result?,
            };
            if passed_half(&node, &next) {
                return Ok(BranchEnd::Closed);
            }
            self.locate_all(&node, &next, length, branch)?;
            let parameter = next.point.parameter;
            if parameter >= 1.0 {
                let last = self.last(&node, &next)?;
                watch(&last);
                branch.points.push(last);
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
            let guess = &node.unknowns + &node.tangent * *step;
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
                Err(error) if smallest || error.is_interrupted() => return Err(error),
                _ => *step = (0.5 * length).max(self.plan.least_step),
            }
        }
    }

    /// Corrects a guess in the plane across a direction, with slopes of about there.
    fn corrected(
        &mut self,
        mut unknowns: DVector<f64>,
        direction: &DVector<f64>,
        slopes: &DMatrix<f64>,
    ) -> Result<Node, ShootingError> {
        let mut factors = bordered(slopes, direction).lu();
        let (mut history, mut before, mut renewals) = (Vec::new(), f64::INFINITY, 0);
        for corrections in 1..=MOST_CORRECTIONS {
            let residual = self.residual(&unknowns)?;
            history.push(residual.amax());
            let correction = factors
                .solve(&residual.push(0.0))
                .ok_or(ShootingError::Singular)?;
            unknowns -= &correction;
            let size = correction.amax();
            let slow = size > SLOW * before;
            let noise = slow && renewals > 0 && size <= NOISE * self.plan.tolerance;
            if size <= self.plan.tolerance || noise {
                return self.node(unknowns, direction, corrections);
            }
            if !size.is_finite() || (slow && renewals == MOST_RENEWALS) {
                break;
            }
            if slow {
                factors = bordered(&self.slopes_at(&unknowns)?, direction).lu();
                renewals += 1;
            }
            before = size;
        }
        Err(ShootingError::NotFound { history })
    }

    fn residual(&mut self, unknowns: &DVector<f64>) -> Result<DVector<f64>, ShootingError> {
        let (states, image) = self.image(unknowns, Slopes::None)?;
        Ok(residual(self.family, &states, &image.end))
    }

    /// States and their image at a parameter.
    fn image(
        &mut self,
        unknowns: &DVector<f64>,
        slopes: Slopes,
    ) -> Result<(DVector<f64>, Image), ShootingError> {
        let count = unknowns.len() - 1;
        let states = unknowns.rows(0, count).into_owned();
        self.family.set(unknowns[count])?;
        let image = self.family.image(&states, slopes)?;
        Ok((states, image))
    }

    fn slopes_at(&mut self, unknowns: &DVector<f64>) -> Result<DMatrix<f64>, ShootingError> {
        let (states, image) = self.image(unknowns, Slopes::All)?;
        self.slopes_from(unknowns, &states, &image)
    }

    /// Slopes of the residual by the states, and by the parameter as a difference.
    fn slopes_from(
        &mut self,
        unknowns: &DVector<f64>,
        states: &DVector<f64>,
        image: &Image,
    ) -> Result<DMatrix<f64>, ShootingError> {
        let by_states = jacobian(self.family, &image.slopes);
        let here = residual(self.family, states, &image.end);
        let mut ahead = unknowns.clone();
        ahead[unknowns.len() - 1] += PARAMETER_STEP;
        let by_parameter = (self.residual(&ahead)? - here) / PARAMETER_STEP;
        let columns = by_states.ncols();
        let mut all = by_states.insert_column(columns, 0.0);
        all.set_column(columns, &by_parameter);
        Ok(all)
    }

    /// Everything about a point of the branch; its tangent goes along `direction`.
    fn node(
        &mut self,
        unknowns: DVector<f64>,
        direction: &DVector<f64>,
        corrections: usize,
    ) -> Result<Node, ShootingError> {
        let (states, image) = self.image(&unknowns, Slopes::All)?;
        let half = self.family.half_return(&states)?;
        let multipliers = multipliers(self.family.circle(), &image.slopes);
        let slopes = self.slopes_from(&unknowns, &states, &image)?;
        let ahead = parameter_direction(unknowns.len());
        let tangent = bordered(&slopes, direction).lu().solve(&ahead);
        let tangent = tangent.ok_or(ShootingError::Singular)?;
        Ok(Node {
            point: BranchPoint {
                parameter: unknowns[unknowns.len() - 1],
                states,
                slopes: image.slopes,
                multipliers,
            },
            unknowns,
            tangent: normalised(tangent),
            slopes,
            half,
            corrections,
        })
    }

    /// The motion at the end of the parameter's range, between two points.
    fn last(&mut self, before: &Node, after: &Node) -> Result<BranchPoint, ShootingError> {
        let (from, to) = (before.point.parameter, after.point.parameter);
        let part = (1.0 - from) / (to - from);
        let mut guess = &before.unknowns + (&after.unknowns - &before.unknowns) * part;
        let last = guess.len() - 1;
        guess[last] = 1.0;
        let direction = parameter_direction(guess.len());
        Ok(self.corrected(guess, &direction, &after.slopes)?.point)
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
            let (left, after_points) = (found.crossing().value(kind).abs(), branch.points.len());
            if left < CONTINUOUS {
                branch.specials.push(Special {
                    kind,
                    point: found.point,
                    after: after_points,
                });
            } else if kind == SpecialKind::Fold || before.outside() != after.outside() {
                branch.unrefined.push(Unrefined {
                    kind,
                    between: [before, after].map(|node| node.point.parameter),
                    left,
                    after: after_points,
                });
            }
        }
        Ok(())
    }

    /// By the regula falsi, along the tangent of the first point.
    fn locate(
        &mut self,
        before: &Node,
        after: &Node,
        length: f64,
        kind: SpecialKind,
    ) -> Result<Node, ShootingError> {
        let value = |node: &Node| node.crossing().value(kind);
        let mut nearest = if value(before).abs() < value(after).abs() {
            before.clone()
        } else {
            after.clone()
        };
        let Some(mut bracket) = Bracket::new([0.0, length], [before, after].map(value)) else {
            return Ok(nearest);
        };
        for _ in 0..MOST_LOCATIONS {
            let at = bracket.guess();
            let guess = &before.unknowns + &before.tangent * at;
            let found = match self.corrected(guess, &before.tangent, &after.slopes) {
                Err(error) if error.is_interrupted() => return Err(error),
                // as near as the neighbouring points are
                Err(_) => break,
                Ok(found) => found,
            };
            let number = value(&found);
            if number.abs() < value(&nearest).abs() {
                nearest = found;
            }
            if number.abs() < LOCATED || bracket.length() < self.plan.tolerance {
                break;
            }
            bracket.narrow(at, number);
        }
        Ok(nearest)
    }
}

/// Whether a motion of doubled period went through one of half the period.
fn passed_half(before: &Node, after: &Node) -> bool {
    match (&before.half, &after.half) {
        (Some(before), Some(after)) => before.dot(after) < 0.0,
        _ => false,
    }
}

/// The direction of the parameter among so many unknowns.
fn parameter_direction(unknowns: usize) -> DVector<f64> {
    let mut direction = DVector::zeros(unknowns);
    direction[unknowns - 1] = 1.0;
    direction
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
