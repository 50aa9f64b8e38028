//! Coordinates in which the law of a ball is smooth.

use fearless_simd::Simd;

use super::lifting_chart::LiftingChart;
use super::loaded_chart::LoadedChart;
use crate::bearing::Lanes;

/// Coordinates of the places of a table.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(in crate::bearing) enum Chart {
    /// Of balls that never lift off.
    Loaded(LoadedChart),
    /// Across lift-off.
    Lifting(LiftingChart),
}

/// How balls side by side are found on a chart.
pub(in crate::bearing) trait Coordinates {
    /// τ and v of places (|A1|, A2), and what the polynomials are to be multiplied by: those of the axial force
    /// and the couple, and those of the radial force.
    fn coordinates<S: Simd>(&self, axial: Lanes<S>, radial: Lanes<S>) -> [Lanes<S>; 4];
}

/// Evaluates an expression for the chart inside.
macro_rules! with_chart {
    ($any:expr, $chart:ident => $value:expr) => {
        match $any {
            Chart::Loaded($chart) => $value,
            Chart::Lifting($chart) => $value,
        }
    };
}
pub(super) use with_chart;

/// Derivatives that carry the slopes of a polynomial H(x, t) over to those of the force F = f(v) H.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct ChartSlopes {
    /// ∂f/∂A1 at constant A2, of |A1|, and ∂f/∂A2.
    pub(super) factor: [f64; 2],
    /// f ∂v/∂|A1| and f ∂v/∂A2.
    pub(super) root: [f64; 2],
    /// f dτ/d|A1|.
    pub(super) along: f64,
}

impl Chart {
    /// |A1| at τ, m.
    pub(super) fn axial(&self, along: f64) -> f64 {
        with_chart!(self, chart => chart.span.axial(along))
    }

    /// A2 of a place at τ and v, m; not a number where there is none.
    pub(super) fn radial(&self, along: f64, root: f64) -> f64 {
        with_chart!(self, chart => chart.radial(along, root))
    }

    /// What the polynomials of axial force, radial force and couple are to be multiplied by at τ and v.
    pub(super) fn factors(&self, along: f64, root: f64) -> [f64; 3] {
        match self {
            Self::Loaded(chart) => [1.0, chart.radial(along, root), 1.0],
            Self::Lifting(_) => [root * root; 3],
        }
    }

    /// Slopes of the axial force and the couple, and of the radial force, at a place (|A1|, A2).
    pub(super) fn slopes(&self, axial: f64, radial: f64) -> [ChartSlopes; 2] {
        with_chart!(self, chart => chart.slopes(axial, radial))
    }

    /// Distance of a place from the line of lift-off, m; where no ball lifts off, from a line on which all
    /// bear more than nothing.
    pub(super) fn distance_past_lift(&self, axial: f64, radial: f64) -> f64 {
        with_chart!(self, chart => chart.distance_past_lift(axial, radial))
    }
}

/// The map of |A1| onto τ = −1 … 1.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Span {
    middle: f64,
    inverse_half: f64,
}

impl Span {
    /// Of |A1| from `start` to `end`, m.
    pub(super) fn new([start, end]: [f64; 2]) -> Self {
        Self {
            middle: 0.5 * (start + end),
            inverse_half: 2.0 / (end - start),
        }
    }

    /// τ of places side by side.
    #[inline(always)]
    pub(super) fn along<S: Simd>(&self, axial: Lanes<S>) -> Lanes<S> {
        (axial - self.middle) * self.inverse_half
    }

    /// τ of a single place.
    pub(super) fn along_of(&self, axial: f64) -> f64 {
        (axial - self.middle) * self.inverse_half
    }

    /// dτ/d|A1|, 1/m.
    pub(super) fn rate(&self) -> f64 {
        self.inverse_half
    }

    /// |A1| at τ, m.
    pub(super) fn axial(&self, along: f64) -> f64 {
        self.middle + along / self.inverse_half
    }
}
