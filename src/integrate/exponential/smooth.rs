//! How much better a step is than its estimate of the error says.

use super::nodes::{NODES, POINTS, combined};
use super::sweeps::Trial;
use crate::integrate::System;

/// Part of the distance of the nearest surface that may be moved without a look at it: between points
/// the way is longer.
const SAFE: f64 = 0.7;
/// Factor of what the fall of the coefficients promises: measured.
const CAUTION: f64 = 2.0;

impl<S: System<N>, const N: usize> Trial<'_, S, N> {
    /// Factor of the error estimate, which is that of the polynomial without its highest power.
    ///
    /// Where the slow part is smooth its Legendre coefficients fall by about the same factor from one to
    /// the next, and what the polynomial leaves out is smaller than what the estimate sees by two of
    /// them. Where a surface is crossed they fall slowly, and no faster than seen. A part that is nearly
    /// odd about the middle of the step has next to no even coefficients: there the fall is not seen.
    pub(super) fn smoothness(&self) -> f64 {
        let [before, middle, highest] = NODES
            .modes
            .map(|mode| self.norm(&self.linear.deviation(&combined(&mode, &self.slow))));
        let squares = [before, middle, highest].map(|mode| mode * mode);
        let fall = (squares[1] + squares[2]) / (squares[0] + squares[1]);
        let factor = CAUTION * fall.max(highest / before.max(middle));
        // no number where the slow part is constant
        if factor < 1.0 && !self.crosses() {
            factor
        } else {
            1.0
        }
    }

    /// Whether the points of the step do not all lie on the same sides of the surfaces.
    fn crosses(&self) -> bool {
        let (system, start) = (self.course.system, self.course.state(&self.from.deviation));
        let clearance = SAFE * system.clearance(&start);
        let is_clear = |point| {
            let state = self.course.state(self.at(point));
            system.shift([&start, &state]) < clearance
        };
        if clearance > 0.0 && (1..POINTS).all(is_clear) {
            return false;
        }
        let around = system.surroundings(self.start, &start);
        if around.nearest == f64::INFINITY {
            return false;
        }
        (1..POINTS).any(|point| {
            let time = self.time_of(point);
            let state = self.course.state(self.at(point));
            let moved = system.approach([self.start, time], [&start, &state]);
            moved >= SAFE * around.nearest
                && system.surroundings(time, &state).sides != around.sides
        })
    }

    /// Deviation at a point after the first, as the latest sweep had it.
    fn at(&self, point: usize) -> &[f64; N] {
        if point + 1 == POINTS {
            &self.to.deviation
        } else {
            &self.states[point]
        }
    }
}
