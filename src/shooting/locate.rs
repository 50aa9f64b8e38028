//! Where a motion changes its kind between two points of a branch.

use super::continuation::{Continuer, Node, is_interrupted};
use super::newton::ShootingError;
use super::{Branch, Crossing, Special, SpecialKind, Unrefined};
use crate::integrate::root::Bracket;

/// Points looked at to find where a motion changes its kind.
const MOST_LOCATIONS: usize = 16;
/// A motion changes its kind where the number that says so is this small,
const LOCATED: f64 = 1e-6;
/// and where it does not fall below this, it jumps and has no such place.
const CONTINUOUS: f64 = 1e-2;

/// Number of multipliers outside the unit circle. Where it stays, a number that jumps means nothing: a pair
/// outside became two real ones there, or the reverse.
fn outside(node: &Node) -> usize {
    let all = node.point.multipliers.values();
    all.iter().filter(|value| value.norm() >= 1.0).count()
}

impl Continuer<'_> {
    /// Finds where the motion changes its kind between two neighbouring points.
    pub fn locate_all(
        &mut self,
        before: &Node,
        after: &Node,
        length: f64,
        branch: &mut Branch,
    ) -> Result<(), ShootingError> {
        for kind in Crossing::between(&before.crossing(), &after.crossing()) {
            let found = self.locate(before, after, length, kind)?;
            let (left, after_points) = (found.crossing().of_kind(kind).abs(), branch.points.len());
            if left < CONTINUOUS {
                branch.specials.push(Special {
                    kind,
                    point: found.point,
                    after: after_points,
                });
            } else if kind == SpecialKind::Fold || outside(before) != outside(after) {
                branch.unrefined.push(Unrefined {
                    kind,
                    between: [before.point.parameter, after.point.parameter],
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
        let value = |node: &Node| node.crossing().of_kind(kind);
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
            let guess = &before.place + &before.tangent * at;
            let found = match self.corrected(guess, &before.tangent, &after.slopes) {
                Err(error) if is_interrupted(&error) => return Err(error),
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
