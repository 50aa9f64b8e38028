//! How far a table reaches, and in what coordinates.

use super::chart::Chart;
use super::counted::Counted;
use super::lifting_chart::LiftingChart;
use super::loaded_chart::LoadedChart;
use super::report::TableError;
use crate::bearing::BallLaw;

/// How far around the region lift-off is looked for, over the distance of the groove centres; so far
/// below the region balls carry nothing.
const LIFTED_REACH: f64 = 0.25;
/// Steepness along the line of lift-off below which the line is no function of |A1|.
const FLATTEST: f64 = 0.3;

/// Coordinates and how far they reach.
pub(super) struct Limits {
    pub(super) chart: Chart,
    /// v at both ends.
    pub(super) roots: [f64; 2],
    /// Least A2, m.
    pub(super) lowest: f64,
}

impl Limits {
    /// Of balls that never lift off.
    pub(super) fn loaded(span: [f64; 2], radial: [f64; 2]) -> Self {
        let (nearest, farthest) = (span[0].hypot(radial[0]), span[1].hypot(radial[1]));
        // nothing of the region is near the circle
        let circle = nearest - 0.5 * (farthest - nearest);
        Self {
            chart: Chart::Loaded(LoadedChart::new(span, circle)),
            roots: [nearest * nearest, farthest * farthest],
            lowest: radial[0],
        }
    }

    /// Of balls that lift off: all that is below the line of lift-off is in reach, too.
    pub(super) fn lifting<L: BallLaw>(
        law: &Counted<'_, L>,
        span: [f64; 2],
        nodes: &[f64],
        radial: [f64; 2],
        lifted: f64,
    ) -> Result<Self, TableError> {
        let distance = span[1].hypot(radial[1]);
        let lift_off = nodes
            .iter()
            .map(|&axial| lift_off(law, axial, radial, distance, lifted))
            .collect::<Option<Vec<f64>>>()
            .ok_or(TableError::LiftOff)?;
        let chart = LiftingChart::new(span, nodes, &lift_off);
        let steep = nodes.iter().zip(&lift_off).any(|(&axial, &radial)| {
            let steepness = chart.steepness(axial, radial);
            steepness.is_nan() || steepness < FLATTEST
        });
        if steep {
            return Err(TableError::LiftOff);
        }
        let farthest = nodes
            .iter()
            .map(|&axial| chart.past_lift(axial, radial[1]))
            .fold(2e-3 * distance * distance, f64::max);
        Ok(Self {
            chart: Chart::Lifting(chart),
            roots: [0.0, farthest.sqrt()],
            lowest: radial[0] - LIFTED_REACH * distance,
        })
    }

    /// v a part 0 … 1 of the way.
    pub(super) fn root(&self, part: f64) -> f64 {
        let [start, end] = self.roots;
        start + (end - start) * part
    }
}

/// A2 at which a ball lifts off at |A1|: where its load falls below `lifted`. None outside a quarter
/// of the distance of the groove centres around the region.
fn lift_off<L: BallLaw>(
    law: &Counted<'_, L>,
    axial: f64,
    [low, high]: [f64; 2],
    distance: f64,
    lifted: f64,
) -> Option<f64> {
    let reach = LIFTED_REACH * distance;
    let (mut low, mut high) = (low - reach, high + reach);
    if !(law.load(axial, low) <= lifted && law.load(axial, high) > lifted) {
        return None;
    }
    while high - low > f64::EPSILON * distance {
        let middle = 0.5 * (low + high);
        if middle <= low || middle >= high {
            break;
        }
        if law.load(axial, middle) > lifted {
            high = middle;
        } else {
            low = middle;
        }
    }
    Some(0.5 * (low + high))
}
