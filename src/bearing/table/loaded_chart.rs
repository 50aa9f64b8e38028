//! Coordinates in which the law of a ball that never lifts off is smooth.

use fearless_simd::{Simd, SimdBase};

use super::chart::{ChartSlopes, Coordinates, Span};
use crate::bearing::Lanes;

/// From the place of the inner groove centre to the square of its distance from the outer one.
///
/// ```text
/// p = |A1|   τ = (p − p_m)/p_h   v = p² + A2²   f_a = 1   f_r = A2
/// ```
///
/// The load of a ball changes little along circles about the outer groove centre, so that a few cells along
/// |A1| are enough: there the axial force is about a multiple of A1, and the radial one of A2, whose bend along
/// |A1| would take more cells. And where no ball lifts off it takes no root to make the force smooth.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(in crate::bearing) struct LoadedChart {
    pub(super) span: Span,
    /// Radius of a circle that all places are outside of, m.
    nearest: f64,
}

impl Coordinates for LoadedChart {
    #[inline(always)]
    fn coordinates<S: Simd>(&self, axial: Lanes<S>, radial: Lanes<S>) -> [Lanes<S>; 4] {
        let square = axial * axial + radial * radial;
        [
            self.span.along(axial),
            square,
            Lanes::splat(axial.witness(), 1.0),
            radial,
        ]
    }
}

impl LoadedChart {
    /// Chart over |A1| in `span` of places outside of a circle of radius `nearest`, in m.
    pub(super) fn new(span: [f64; 2], nearest: f64) -> Self {
        Self {
            span: Span::new(span),
            nearest,
        }
    }

    /// Distance of a place from the circle that all are outside of, m.
    pub(super) fn distance_past_lift(&self, axial: f64, radial: f64) -> f64 {
        axial.hypot(radial) - self.nearest
    }

    /// Slopes at a place.
    pub(super) fn slopes(&self, axial: f64, radial: f64) -> [ChartSlopes; 2] {
        [(1.0, [0.0; 2]), (radial, [0.0, 1.0])].map(|(factor, rates)| ChartSlopes {
            factor: rates,
            root: [2.0 * factor * axial, 2.0 * factor * radial],
            along: factor * self.span.rate(),
        })
    }

    /// A2 of a place at τ and v, m; not a number where there is none.
    pub(super) fn radial(&self, along: f64, square: f64) -> f64 {
        (square - self.span.axial(along).powi(2)).sqrt()
    }
}
