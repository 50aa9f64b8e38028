//! Times at which steps are to end on event surfaces.

use super::crossing::Crossings;
use super::pair::ExplicitPair;
use super::stepper::ExplicitStepper;
use crate::integrate::problem::Problem;
use crate::integrate::root::root;

/// Crossings within this part of a trial are one.
const TOGETHER: f64 = 1e-3;
/// Part of a trial within which its ends are as good as a landing.
pub(super) const AT_END: f64 = 1e-6;
/// Part of the trial to which a crossing is found.
const FOUND: f64 = 1e-9;

/// A step that is to end on event surfaces.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Landing {
    /// s.
    pub time: f64,
    /// Whether a surface ceases there to add to the derivative.
    pub ends: bool,
}

impl Crossings {
    /// The earliest landing that is planned.
    pub fn next_landing(&self) -> Option<Landing> {
        let time = earliest(&self.due, f64::NEG_INFINITY);
        let ends = |(due, past): (&f64, &bool)| *due == time && *past;
        (time < f64::INFINITY).then(|| Landing {
            time,
            ends: self.due.iter().zip(&self.past).any(ends),
        })
    }

    /// No landing is planned any more.
    pub fn forget_landings(&mut self) {
        self.due.fill(f64::INFINITY);
    }
}

impl<P: ExplicitPair> ExplicitStepper<P> {
    /// Plans landings on the surfaces that the trial crosses; whether it does so between its ends.
    pub(super) fn plan_landings(&mut self, problem: &Problem<'_>, size: f64) -> bool {
        let mut found = std::mem::take(&mut self.crossing.found);
        let mut state = std::mem::take(&mut self.crossing.state);
        let mut values = std::mem::take(&mut self.crossing.values);
        let mut deviation = std::mem::take(&mut self.argument);
        let [start, end] = [self.start, self.start + size];
        let inside = start + AT_END * size..end - AT_END * size;
        found.fill(f64::INFINITY);
        for (event, due) in found.iter_mut().enumerate() {
            if !self.crossing.changed[event] {
                continue;
            }
            let value = |time: f64| {
                self.by_stages(time, &mut deviation);
                problem.write_state(&deviation, &mut state);
                problem.system.events(time, &state, &mut values);
                values[event]
            };
            let ends = [0, 1].map(|end| self.crossing.ends[end][event]);
            let time = root(value, [start, end], ends, FOUND * size);
            *due = time
                .filter(|time| inside.contains(time))
                .unwrap_or(f64::INFINITY);
        }
        keep_first_two(&mut found, TOGETHER * size);
        let any = found.iter().any(|due| due.is_finite());
        if any {
            std::mem::swap(&mut found, &mut self.crossing.due);
        }
        (self.crossing.found, self.crossing.state) = (found, state);
        (self.crossing.values, self.argument) = (values, deviation);
        any
    }
}

/// The earliest of some times after one of them.
fn earliest(times: &[f64], after: f64) -> f64 {
    let later = times.iter().copied().filter(|time| *time > after);
    later.fold(f64::INFINITY, f64::min)
}

/// Makes times that are near each other one, and forgets all but the two earliest of these.
fn keep_first_two(times: &mut [f64], near: f64) {
    let mut latest = f64::NEG_INFINITY;
    for _ in 0..2 {
        latest = earliest(times, latest);
        for time in times
            .iter_mut()
            .filter(|time| (latest..latest + near).contains(*time))
        {
            *time = latest;
        }
    }
    for time in times.iter_mut().filter(|time| **time > latest) {
        *time = f64::INFINITY;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_two_earliest_landings_are_kept_and_near_ones_are_one() {
        let mut times = [0.5, f64::INFINITY, 0.2, 0.9, 0.2001];
        keep_first_two(&mut times, 1e-3);
        assert_eq!(times, [0.5, f64::INFINITY, 0.2, f64::INFINITY, 0.2]);
    }
}
