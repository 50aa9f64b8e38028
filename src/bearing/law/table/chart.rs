//! Where the balls may come, and coordinates in which their law is smooth there.

use super::cells::{lobatto, power_weights, weighted};
use super::compile::TableError;
use crate::bearing::number::Number;
use crate::numerics::root::bisection;

/// Load at which a ball counts as lifted off, of the one that the tolerance refers to.
const LIFTED_SHARE: f64 = 1e-14;
/// How far around the region lift-off is looked for, over the distance of the groove centres.
const REACH: f64 = 0.25;
/// Steepness along the line of lift-off below which the line is no function of |A1|.
const FLATTEST: f64 = 0.3;
/// Least range of u, over the square of the distance of the groove centres.
const LEAST_RANGE: f64 = 2e-3;
/// Coefficients of the line of lift-off.
const LIFT_TERMS: usize = 6;

/// From the position of the inner groove centre to the root of how far it is past lift-off.
///
/// ```text
/// τ = (|A1| − p_m)/p_h   u = (A2 − c)² − M(τ)   v = √max(u, 0)
/// ```
///
/// `u = 0`, with M in m² a polynomial, is the line on which a ball lifts off: close to a circle about a
/// position `c` on the radial axis, where a ball that is thrown outwards rests. A dry contact's force is
/// analytic in v up to v = 0, whatever holds the ball across the line of contact: there the forces are
/// powers of √δ. Where no such line is near, the line is a circle about the outer groove centre that is
/// nearer than the region.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Chart {
    middle: f64,
    inverse_half: f64,
    centre: f64,
    lift: [f64; LIFT_TERMS],
}

impl Chart {
    /// Chart of the positions of a folded region under a law with loads of a ball by |A1| and A2, N; `reference` is the
    /// load that the tolerance refers to.
    pub(super) fn new(
        region: &BallRegion,
        mut load: impl FnMut(f64, f64) -> f64,
        reference: f64,
    ) -> Result<Self, TableError> {
        let lifted = LIFTED_SHARE * reference;
        let axial = nodes_along(region);
        let lowest = region.radial[0];
        if lowest > 0.0 && axial.iter().all(|&axial| load(axial, lowest) > lifted) {
            return Ok(Self::before(region, &axial));
        }
        let radial = axial.map(|axial| lift_off(|radial| load(axial, radial) - lifted, region));
        if radial.iter().any(Option::is_none) {
            return Err(TableError::LiftOff);
        }
        let chart = Self::through(&axial, &radial.map(Option::unwrap_or_default));
        let steep = chart.is_steep(&axial);
        steep.then_some(chart).ok_or(TableError::LiftOff)
    }

    /// A circle about the outer groove centre, as far before the region as this is deep.
    fn before(region: &BallRegion, axial: &[f64; LIFT_TERMS]) -> Self {
        let ([start, end], [low, high]) = (region.axial, region.radial);
        let (nearest, farthest) = (start.hypot(low), end.hypot(high));
        let radius = (2.0 * nearest - farthest).max(0.0);
        Self {
            middle: 0.5 * (start + end),
            inverse_half: 2.0 / (end - start),
            centre: 0.0,
            lift: coefficients(&axial.map(|axial| radius * radius - axial * axial)),
        }
    }

    /// The line of lift-off through A2 at the nodes of |A1|.
    fn through(axial: &[f64; LIFT_TERMS], radial: &[f64; LIFT_TERMS]) -> Self {
        let last = LIFT_TERMS - 1;
        let (p, a) = ([axial[0], axial[last]], [radial[0], radial[last]]);
        // both ends at the same distance of c
        let centre =
            (p[0] * p[0] + a[0] * a[0] - p[1] * p[1] - a[1] * a[1]) / (2.0 * (a[0] - a[1]));
        let centre = if centre.is_finite() { centre } else { 0.0 };
        Self {
            middle: 0.5 * (p[0] + p[1]),
            inverse_half: 2.0 / (p[1] - p[0]),
            centre,
            lift: coefficients(&radial.map(|radial| (radial - centre).powi(2))),
        }
    }

    /// Whether the line of lift-off has a direction to A2 = ∞ everywhere.
    fn is_steep(&self, axial: &[f64; LIFT_TERMS]) -> bool {
        axial.iter().all(|&axial| {
            let height = self.lift(self.along(axial)).sqrt();
            height / axial.hypot(height) >= FLATTEST
        })
    }

    /// τ of |A1|.
    #[inline(always)]
    fn along<T: Number>(&self, axial: T) -> T {
        (axial - self.middle) * self.inverse_half
    }

    /// M(τ), m²: a sum of few steps, each of which would wait for the one before.
    #[inline(always)]
    fn lift<T: Number>(&self, along: T) -> T {
        let square = along * along;
        let [c0, c1, c2, c3, c4, c5] = self.lift;
        let low = (along * c1 + c0) + square * (along * c3 + c2);
        low + square * square * (along * c5 + c4)
    }

    /// u of a position (|A1|, A2), m².
    #[inline(always)]
    fn past_lift<T: Number>(&self, axial: T, radial: T) -> T {
        let height = radial - self.centre;
        height * height - self.lift(self.along(axial))
    }

    /// τ, v and u of positions (|A1|, A2).
    #[inline(always)]
    pub(super) fn coordinates<T: Number>(&self, axial: T, radial: T) -> [T; 3] {
        let along = self.along(axial);
        let past_lift = self.past_lift(axial, radial).positive();
        [along, past_lift.sqrt(), past_lift]
    }

    /// The position (|A1|, A2) at τ and v; not a number where there is none.
    pub(super) fn position(&self, along: f64, root: f64) -> [f64; 2] {
        [
            self.middle + along / self.inverse_half,
            self.centre + (self.lift(along) + root * root).sqrt(),
        ]
    }

    /// Least and greatest v of a folded region.
    pub(super) fn roots(&self, region: &BallRegion) -> [f64; 2] {
        let nodes = nodes_along(region);
        let distance = region.axial[1].hypot(region.radial[1]);
        let past_lift = |radial: f64| {
            nodes
                .into_iter()
                .map(move |axial| self.past_lift(axial, radial))
        };
        let least = past_lift(region.radial[0])
            .fold(f64::INFINITY, f64::min)
            .max(0.0);
        let range = LEAST_RANGE * distance * distance;
        let most = past_lift(region.radial[1]).fold(least + range, f64::max);
        [least.sqrt(), most.sqrt()]
    }

    /// dτ/d|A1|, and ∂u/∂|A1| and ∂u/∂A2; these are zero in front of lift-off.
    pub(super) fn slopes(&self, axial: f64, radial: f64) -> (f64, [f64; 2]) {
        let along = self.along(axial);
        let powers = self.lift.iter().enumerate().skip(1).rev();
        let lift_rate = powers.fold(0.0, |sum, (power, c)| sum * along + power as f64 * c);
        let rates = [-lift_rate * self.inverse_half, 2.0 * (radial - self.centre)];
        let lifted = self.past_lift(axial, radial) <= 0.0;
        (self.inverse_half, if lifted { [0.0; 2] } else { rates })
    }

    /// Distance of positions (A1, A2) past the line of lift-off, m.
    #[inline(always)]
    pub(super) fn distance_past_lift<T: Number>(&self, axial: T, radial: T) -> T {
        let height = radial - self.centre;
        let [axial_square, height_square] = [axial * axial, height * height];
        let lift = self.lift(self.along(axial_square.sqrt()));
        let distance = (axial_square + height_square).sqrt();
        let distance_at_lift = (axial_square + lift).sqrt();
        // the difference of the distances from c, of which u is that of the squares
        (height_square - lift) / (distance + distance_at_lift)
    }
}

/// Lobatto nodes of |A1|.
fn nodes_along(region: &BallRegion) -> [f64; LIFT_TERMS] {
    let [start, end] = region.axial;
    lobatto().map(|node| 0.5 * (start + end) + 0.5 * (end - start) * node)
}

/// Coefficients of the powers of τ through values at the Lobatto nodes.
fn coefficients(values: &[f64; LIFT_TERMS]) -> [f64; LIFT_TERMS] {
    power_weights(&lobatto()).map(|weights| weighted(&weights, |node| [values[node]])[0])
}

/// A2 at which a ball lifts off: where its load in excess of that of a lifted ball changes its sign. None outside a
/// quarter of the distance of the groove centres around the region.
fn lift_off(mut excess: impl FnMut(f64) -> f64, region: &BallRegion) -> Option<f64> {
    let distance = region.axial[1].hypot(region.radial[1]);
    let [low, high] = region.radial;
    let [low, high] = [low - REACH * distance, high + REACH * distance];
    if !(excess(low) <= 0.0 && excess(high) > 0.0) {
        return None;
    }
    let is_pressed = |radial| excess(radial) > 0.0;
    Some(bisection(is_pressed, [low, high], f64::EPSILON * distance))
}

/// Rectangle of positions (A1, A2) of the inner groove centre, m.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BallRegion {
    /// Least and greatest axial distance A1, m.
    pub axial: [f64; 2],
    /// Least and greatest radial distance A2, m.
    pub radial: [f64; 2],
}

impl BallRegion {
    /// The region with |A1| in place of A1: every law is the same on both sides of A1 = 0.
    pub(super) fn folded(&self) -> Self {
        let [low, high] = self.axial;
        let far = low.abs().max(high.abs());
        let near = if low <= 0.0 && high >= 0.0 {
            0.0
        } else {
            low.abs().min(high.abs())
        };
        Self {
            axial: [near, far],
            radial: self.radial,
        }
    }

    /// Whether a position is inside a folded region; one that is no number is not.
    pub(super) fn contains(&self, axial: f64, radial: f64) -> bool {
        let within = |value: f64, [low, high]: [f64; 2]| (low..=high).contains(&value);
        within(axial.abs(), self.axial) && within(radial, self.radial)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::bearing::{Ball, ForceLaw, HertzLaw, catalogue};

    /// Dry contacts lift off on a circle about the outer groove centre.
    #[test]
    fn the_line_of_lift_off_is_where_the_load_fades() {
        let bearing = catalogue::find("7205C").unwrap().bearing().unwrap();
        let geometry = &bearing.geometry;
        let free = geometry.groove_centre_distance();
        let law = HertzLaw::new(bearing.load_deflection_constant().unwrap(), free);
        let load = |axial, radial| {
            let force = law.force(&Ball::at(axial, radial), 0.0);
            force.axial.hypot(force.radial)
        };
        let around = |middle: f64, half: f64| [middle - half, middle + half];
        let region = BallRegion {
            axial: around(geometry.free_axial() + 1e-5, 1e-5),
            radial: around(geometry.free_radial(), 2e-5),
        };
        let chart = Chart::new(&region, load, 300.0).unwrap();
        for part in 0..50 {
            let axial = region.axial[0] + 2e-5 * f64::from(part) / 49.0;
            for pressed in [-1e-6, 0.0, 1e-5] {
                let distance = free + pressed;
                let radial = (distance * distance - axial * axial).sqrt();
                let off = chart.distance_past_lift(axial, radial) - pressed;
                assert!(off.abs() < 1e-13, "{off:e}");
            }
        }
        // and back
        let [_, most] = chart.roots(&region);
        let [axial, radial] = chart.position(0.3, 0.7 * most);
        assert!((chart.along(axial) - 0.3).abs() < 1e-14);
        assert!((chart.past_lift(axial, radial).sqrt() - 0.7 * most).abs() < 1e-12 * most);
    }
}
