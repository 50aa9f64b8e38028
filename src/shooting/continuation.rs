//! The continuation along a branch, point by point, and where the motion changes its kind between two of them.

use nalgebra::DVector;

use super::corrector::{Continuer, Node, normalised, parameter_direction, product, unit};
use super::multipliers::{Crossing, SpecialKind};
use super::newton::{ShootingError, solve};
use super::{Branch, BranchEnd, BranchPoint, Special, Unrefined};
use crate::numerics::root::Bracket;

/// A motion of doubled period has come to its end where it is nearer than this part of its widest to one
/// of half the period, and cannot be followed further.
const VANISHING: f64 = 0.3;
/// Corrections up to which the next step grows.
const FEW_CORRECTIONS: usize = 4;
const GROW: f64 = 1.5;
/// Least cosine between the tangents of neighbouring points.
const STRAIGHT: f64 = 0.85;
/// Points tried to find where a motion changes its kind.
const MOST_LOCATIONS: usize = 16;
/// A motion changes its kind where the number that says so is this small.
const LOCATED: f64 = 1e-6;
/// A number that does not fall below this between two points jumps there, and the motion has no point of change.
const CONTINUOUS: f64 = 1e-2;

impl Continuer<'_> {
    /// The first point of a branch, near these states at the parameter 0, towards 1.
    pub fn near(&mut self, guess: DVector<f64>) -> Result<Node, ShootingError> {
        self.family.set(0.0)?;
        let found = solve(self.family, guess, None, self.plan.tolerance)?;
        let unknowns = found.states.push(0.0);
        let towards = parameter_direction(unknowns.len());
        self.node(unknowns, None, &towards, 0)
    }

    /// The first point of a branch, a distance from a motion along a direction of its states.
    pub fn away_from(
        &mut self,
        point: &BranchPoint,
        direction: DVector<f64>,
        distance: f64,
    ) -> Result<Node, ShootingError> {
        let origin = point.states.clone().push(point.parameter);
        let unit = unit(&origin);
        let direction = normalised(direction.push(0.0), unit);
        // where branches meet two directions lead on, and slopes there tell nothing of which
        let guess = &origin + &direction * distance;
        let (slopes, _) = self.slopes_at(&guess)?;
        let mut node = self.corrected(guess, &direction, &slopes)?;
        let away = &node.unknowns - &origin;
        if product(&away, &node.tangent, unit) < 0.0 {
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
        // how the tangent has changed over the latest step, by its length
        let mut bend = DVector::zeros(node.tangent.len());
        loop {
            let width = node.half.as_ref().map(DVector::amax);
            widest = widest.max(width.unwrap_or(0.0));
            branch.points.push(node.point.clone());
            watch(&node.point);
            if branch.points.len() >= self.plan.points {
                return Ok(BranchEnd::Points);
            }
            let vanishes = width.is_some_and(|width| width < VANISHING * widest);
            let (next, length) = match self.next(&node, &bend, &mut step) {
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
            bend = (&next.tangent - &node.tangent) / length;
            node = next;
        }
    }

    /// The next point, near the parabola along the tangent of a point that bends as it did last; and the length of the step
    /// to it.
    fn next(
        &mut self,
        node: &Node,
        bend: &DVector<f64>,
        step: &mut f64,
    ) -> Result<(Node, f64), ShootingError> {
        loop {
            let guess = &node.unknowns + &node.tangent * *step + bend * (0.5 * *step * *step);
            let found = self.corrected(guess, &node.tangent, &node.slopes);
            let length = *step;
            let smallest = length <= self.plan.least_step;
            match found {
                Ok(next) if smallest || cosine(&next, node) > STRAIGHT => {
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

/// Cosine between the tangents at two neighbouring points, in the unit of the second.
fn cosine(next: &Node, node: &Node) -> f64 {
    let unit = unit(&node.unknowns);
    let product = |left, right| product(left, right, unit);
    let lengths = [next, node].map(|node| product(&node.tangent, &node.tangent).sqrt());
    product(&next.tangent, &node.tangent) / (lengths[0] * lengths[1])
}

/// Whether a motion of doubled period went through one of half the period.
fn passed_half(before: &Node, after: &Node) -> bool {
    match (&before.half, &after.half) {
        (Some(before), Some(after)) => before.dot(after) < 0.0,
        _ => false,
    }
}
