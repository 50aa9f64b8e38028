//! Coordinates in which the law of a ball is smooth, across lift-off, too.

use fearless_simd::Simd;

use super::polynomial::{chebyshev_coefficients, powers_of_chebyshev};
use crate::bearing::Lanes;

/// Coefficients of the line of lift-off.
const LIFT_TERMS: usize = 6;

/// From the place of the inner groove centre to the root of how far it is past lift-off.
///
/// ```text
/// p = |A1|   τ = (p − p_m)/p_h   u = (A2 − c)² − M(τ)   v = √max(u, 0)
/// ```
///
/// `u = 0`, with M in m² a polynomial, is the line on which a ball lifts off: close to a circle about a
/// place `c` on the radial axis, where a ball that is thrown outwards rests. A dry contact's force is
/// analytic in v up to v = 0, whatever holds the ball across the line of contact: there the forces are
/// powers of √δ.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Chart {
    middle: f64,
    inverse_half: f64,
    centre: f64,
    lift: [f64; LIFT_TERMS],
}

/// Slopes of the coordinates of a place.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct ChartSlopes {
    /// ∂u/∂p at constant A2, m.
    pub(super) by_axial: f64,
    /// ∂u/∂A2, m.
    pub(super) by_radial: f64,
}

impl Chart {
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
            middle: 0.5 * (span[0] + span[1]),
            inverse_half: 2.0 / (span[1] - span[0]),
            centre,
            lift: powers_of_chebyshev(&chebyshev_coefficients(&squares)),
        }
    }

    /// Chart over |A1| in `span` whose line `u = 0` is the circle of radius `radius` about the outer
    /// groove centre: where no ball lifts off.
    pub(super) fn concentric(span: [f64; 2], radius: f64) -> Self {
        let (middle, half) = (0.5 * (span[0] + span[1]), 0.5 * (span[1] - span[0]));
        // M = radius² − p²
        let mut lift = [0.0; LIFT_TERMS];
        lift[0] = (radius - middle) * (radius + middle);
        lift[1] = -2.0 * middle * half;
        lift[2] = -half * half;
        Self {
            middle,
            inverse_half: 1.0 / half,
            centre: 0.0,
            lift,
        }
    }

    /// M(τ), m².
    fn lift(&self, along: f64) -> f64 {
        self.lift.iter().rev().fold(0.0, |sum, c| sum * along + c)
    }

    /// τ of |A1|.
    fn along(&self, axial: f64) -> f64 {
        (axial - self.middle) * self.inverse_half
    }

    /// τ and u of places side by side.
    #[inline(always)]
    pub(super) fn coordinates<S: Simd>(&self, axial: Lanes<S>, radial: Lanes<S>) -> [Lanes<S>; 2] {
        let along = (axial - self.middle) * self.inverse_half;
        let height = radial - self.centre;
        let square = along * along;
        let [c0, c1, c2, c3, c4, c5] = self.lift;
        // a sum of few steps, each of which would wait for the one before
        let low = (c0 + c1 * along) + square * (c2 + c3 * along);
        let lift = low + square * square * (c4 + c5 * along);
        [along, height * height - lift]
    }

    /// u of a single place, m².
    pub(super) fn past_lift(&self, axial: f64, radial: f64) -> f64 {
        (radial - self.centre).powi(2) - self.lift(self.along(axial))
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

    /// Slopes of u.
    pub(super) fn slopes(&self, axial: f64, radial: f64) -> ChartSlopes {
        let along = self.along(axial);
        let mut lift_rate = 0.0;
        for power in (1..LIFT_TERMS).rev() {
            lift_rate = lift_rate * along + power as f64 * self.lift[power];
        }
        ChartSlopes {
            by_axial: -lift_rate * self.inverse_half,
            by_radial: 2.0 * (radial - self.centre),
        }
    }

    /// dτ/dp, 1/m.
    pub(super) fn along_rate(&self) -> f64 {
        self.inverse_half
    }

    /// |A1| at τ.
    pub(super) fn axial(&self, along: f64) -> f64 {
        self.middle + along / self.inverse_half
    }

    /// A2 of a place at τ and u; not a number where there is none.
    pub(super) fn radial(&self, along: f64, past_lift: f64) -> f64 {
        self.centre + (self.lift(along) + past_lift).sqrt()
    }
}
