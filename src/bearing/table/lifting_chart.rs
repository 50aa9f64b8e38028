//! Coordinates in which the law of a ball is smooth across lift-off.

use fearless_simd::{Simd, SimdBase, SimdFloat};

use super::chart::{ChartSlopes, Coordinates, Span};
use super::polynomial::{chebyshev_coefficients, powers_of_chebyshev};
use crate::bearing::Lanes;

/// Coefficients of the line of lift-off.
const LIFT_TERMS: usize = 6;

/// From the place of the inner groove centre to the root of how far it is past lift-off.
///
/// ```text
/// p = |A1|   τ = (p − p_m)/p_h   u = (A2 − c)² − M(τ)   v = √max(u, 0)   f = v²
/// ```
///
/// `u = 0`, with M in m² a polynomial, is the line on which a ball lifts off: close to a circle about a
/// place `c` on the radial axis, where a ball that is thrown outwards rests. A dry contact's force is
/// analytic in v up to v = 0, whatever holds the ball across the line of contact: there the forces are
/// powers of √δ.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(in crate::bearing) struct LiftingChart {
    pub(super) span: Span,
    centre: f64,
    lift: [f64; LIFT_TERMS],
}

impl Coordinates for LiftingChart {
    #[inline(always)]
    fn coordinates<S: Simd>(&self, axial: Lanes<S>, radial: Lanes<S>) -> [Lanes<S>; 4] {
        let along = self.span.along(axial);
        let height = radial - self.centre;
        let square = along * along;
        let [c0, c1, c2, c3, c4, c5] = self.lift;
        // a sum of few steps, each of which would wait for the one before
        let low = (c0 + c1 * along) + square * (c2 + c3 * along);
        let lift = low + square * square * (c4 + c5 * along);
        let past_lift = (height * height - lift).max(Lanes::splat(axial.witness(), 0.0));
        [along, past_lift.sqrt(), past_lift, past_lift]
    }
}

impl LiftingChart {
    /// Chart over |A1| in `span`, from radial distances at which balls lift off at the Lobatto nodes
    /// of the span.
    pub(super) fn new(span: [f64; 2], nodes: &[f64], lift_off: &[f64]) -> Self {
        let (first, last) = (0, nodes.len() - 1);
        let (p, a) = (
            [nodes[first], nodes[last]],
            [lift_off[first], lift_off[last]],
        );
        // both ends at the same distance of c
        let centre =
            (p[0] * p[0] + a[0] * a[0] - p[1] * p[1] - a[1] * a[1]) / (2.0 * (a[0] - a[1]));
        let centre = if centre.is_finite() { centre } else { 0.0 };
        let squares: Vec<f64> = lift_off.iter().map(|a| (a - centre).powi(2)).collect();
        Self {
            span: Span::new(span),
            centre,
            lift: powers_of_chebyshev(&chebyshev_coefficients(&squares)),
        }
    }

    /// M(τ), m².
    fn lift(&self, along: f64) -> f64 {
        self.lift.iter().rev().fold(0.0, |sum, c| sum * along + c)
    }

    /// u of a single place, m².
    pub(super) fn past_lift(&self, axial: f64, radial: f64) -> f64 {
        (radial - self.centre).powi(2) - self.lift(self.span.along_of(axial))
    }

    /// Distance of a place from the line of lift-off, m.
    pub(super) fn distance_past_lift(&self, axial: f64, radial: f64) -> f64 {
        let past_lift = self.past_lift(axial, radial);
        let distance = axial.hypot(radial - self.centre);
        // the difference of the distances from c, of which u is that of the squares
        past_lift / (distance + (distance * distance - past_lift).sqrt())
    }

    /// Share of the radial direction in that from c to a place.
    pub(super) fn steepness(&self, axial: f64, radial: f64) -> f64 {
        (radial - self.centre) / axial.hypot(radial - self.centre)
    }

    /// Slopes at a place; none in front of lift-off.
    pub(super) fn slopes(&self, axial: f64, radial: f64) -> [ChartSlopes; 2] {
        let along = self.span.along_of(axial);
        let mut lift_rate = 0.0;
        for power in (1..LIFT_TERMS).rev() {
            lift_rate = lift_rate * along + power as f64 * self.lift[power];
        }
        let past_lift = self.past_lift(axial, radial).max(0.0);
        let side = if past_lift > 0.0 { 1.0 } else { 0.0 };
        let rates = [
            -lift_rate * self.span.rate() * side,
            2.0 * (radial - self.centre) * side,
        ];
        let slopes = ChartSlopes {
            factor: rates,
            // f dv = v²/(2 v) du
            root: rates.map(|rate| 0.5 * past_lift.sqrt() * rate),
            along: past_lift * self.span.rate(),
        };
        [slopes; 2]
    }

    /// A2 of a place at τ and v; not a number where there is none.
    pub(super) fn radial(&self, along: f64, root: f64) -> f64 {
        self.centre + (self.lift(along) + root * root).sqrt()
    }
}
