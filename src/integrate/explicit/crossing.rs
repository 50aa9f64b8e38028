//! Event surfaces: seen in a trial step, and landed on.
//!
//! A step over a surface, behind which the derivative grows with the power n of the distance, has an error of order
//! n + 1, and its estimate may be blind to it. So a trial that crosses a surface is given up where the force jump counts;
//! the next one ends on the surface, and the one after it begins there. Where n is broken, each of the two is taken in a
//! variable in which the motion is smooth, the `Substitution` of a plan.
//!
//! Every trial asks [`ExplicitStepper::is_spoiled`] whether to land first; a good step calls [`ExplicitStepper::arrive`],
//! which records on which side of every surface it ended.

use super::plan::Plan;
use super::stepper::ExplicitStepper;
use super::verner76::{FACTORS, LAST, error_over_surface};
use crate::integrate::problem::Problem;
use crate::integrate::stepper::Start;
use crate::numerics::root::root;

/// A landing that misses its surface is good up to this error, over the tolerance.
const LANDING_TOLERANCE: f64 = 0.01;
/// A trial with more than this error, in units of the state, tells nothing of where it would cross surfaces.
const UNUSABLE: f64 = 1e-2;

/// Crossings within this part of a trial of each other are one.
const TOGETHER: f64 = 1e-3;
/// A crossing within this part of a trial from either of its ends is as good as a landing.
const AT_END: f64 = 1e-6;
/// Part of the trial to which a crossing is located.
const FOUND: f64 = 1e-9;

/// Error of a step whose last part p, too short for any stage to see, lies past a surface. A jump of the derivative that
/// grows to J there, with the power n of the distance, is missed whole: p h J ∫ x^n dx over 0 … 1, here over p h J.
fn error_at_end(exponent: f64) -> f64 {
    1.0 / (exponent + 1.0)
}

/// Where a step is to end on event surfaces.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Landing {
    /// s.
    pub time: f64,
    /// Whether a force jump of broken power falls to zero there: the step comes from the far side of the surface.
    pub ends: bool,
}

/// When a step is to end on a surface.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Due {
    event: usize,
    /// s.
    time: f64,
}

/// Where the motion is between the event surfaces. There may be thousands of them, of which a trial crosses few: what is
/// kept of those few is in lists.
#[derive(Debug, Clone)]
pub(super) struct Crossings {
    /// Exponent of each surface's force jump.
    exponents: Vec<f64>,
    /// Whether the state at the end of the latest good step is past each surface; after a landing, just beyond it.
    pub past: Vec<bool>,
    /// End of the latest step that crossed a surface, s.
    pub latest: f64,
    /// Whether the latest step landed on a surface past which the derivative grows with a broken power.
    pub fresh: bool,
    /// The landings that are planned, at most at two times.
    due: Vec<Due>,
    /// Sizes that the error allows steps from a surface, and those to one, s.
    pub sizes: [f64; 2],
    /// The surfaces that have the end of the trial and the end of the latest step on different sides.
    changed: Vec<usize>,
    /// The event functions at the start and at the end of the trial.
    ends: [Vec<f64>; 2],
    /// Whether those at the end are of this trial.
    pub is_end_known: bool,
    /// Room for a search.
    pub state: Vec<f64>,
}

impl Crossings {
    /// At the start of a run.
    pub fn new(problem: &Problem<'_>, start: &Start) -> Self {
        let system = problem.system;
        let (events, states) = (system.event_count(), system.states());
        let (mut state, mut values) = (vec![0.0; states], vec![0.0; events]);
        problem.write_state(&start.deviation, &mut state);
        system.events(start.time, &state, &mut values);
        Self {
            exponents: (0..events)
                .map(|event| system.event_exponent(event))
                .collect(),
            past: values
                .iter()
                .map(|value| value.is_sign_positive())
                .collect(),
            latest: f64::NEG_INFINITY,
            fresh: false,
            due: Vec::new(),
            sizes: [f64::INFINITY; 2],
            changed: Vec::new(),
            ends: [values.clone(), values],
            is_end_known: false,
            state,
        }
    }

    /// The earliest landing that is planned.
    pub fn next_landing(&self) -> Option<Landing> {
        let times = self.due.iter().map(|due| due.time);
        let time = times.reduce(f64::min)?;
        let ends =
            |due: &Due| due.time == time && self.past[due.event] && self.is_broken(due.event);
        Some(Landing {
            time,
            ends: self.due.iter().any(ends),
        })
    }

    /// Plans landings on the two earliest of some crossings between two times, if any lies between them; whether one does.
    fn plan_first(&mut self, mut crossings: Vec<Due>, [start, end]: [f64; 2]) -> bool {
        let size = end - start;
        let inside = start + AT_END * size..end - AT_END * size;
        crossings.retain(|due| inside.contains(&due.time));
        keep_first_two(&mut crossings, TOGETHER * size);
        let any = !crossings.is_empty();
        if any {
            self.due = crossings;
        }
        any
    }

    /// Forgets all landings.
    pub fn plan_none(&mut self) {
        self.due.clear();
    }

    /// Whether a step is to land on a surface.
    fn is_landing(&self, plan: &Plan, event: usize) -> bool {
        let mut due = self.due.iter();
        due.any(|due| due.event == event && plan.lands_on(due.time))
    }

    /// Whether the exponent of a surface's force jump is broken, as 3/2: no polynomial of the time follows it.
    fn is_broken(&self, event: usize) -> bool {
        self.exponents[event].fract() != 0.0
    }
}

impl ExplicitStepper {
    /// Whether crossing an event surface spoils the trial of an error over the tolerance: landings are then planned.
    pub(super) fn is_spoiled(&mut self, problem: &Problem<'_>, plan: &Plan, error: f64) -> bool {
        let error_in_units = error * problem.settings.tolerance;
        let is_usable = error_in_units <= UNUSABLE;
        if self.crossing.past.is_empty() || !is_usable {
            return false;
        }
        self.find_sides(problem, plan.end);
        if !self.does_any_count(problem, plan) {
            return false;
        }
        // what the interpolant needs, by which crossings are located
        self.evaluate_end(problem);
        self.extend(problem);
        self.plan_landings(problem, plan.size)
    }

    /// Evaluates the event functions where the trial ends, and finds the surfaces that it crosses.
    fn find_sides(&mut self, problem: &Problem<'_>, end: f64) {
        let crossing = &mut self.crossing;
        problem.write_state(&self.to, &mut crossing.state);
        let values = &mut crossing.ends[1];
        problem.system.events(end, &crossing.state, values);
        crossing.is_end_known = true;
        crossing.changed.clear();
        for (event, (value, past)) in values.iter().zip(&crossing.past).enumerate() {
            if value.is_sign_positive() != *past {
                crossing.changed.push(event);
            }
        }
    }

    /// Whether the error of crossing any surface counts.
    fn does_any_count(&mut self, problem: &Problem<'_>, plan: &Plan) -> bool {
        // a landing costs one step more; with n = (end − latest)/size steps from crossing to crossing that is 1/n of the
        // cost, and it pays where passing over the surface adds more than 1/n of the tolerance
        let error_let_pass = plan.size / (plan.end - self.crossing.latest);
        (0..self.crossing.changed.len()).any(|number| {
            let event = self.crossing.changed[number];
            if self.crossing.is_landing(plan, event) {
                self.error_of_miss(problem, plan, event) > LANDING_TOLERANCE
            } else {
                self.is_error_over(problem, plan, event, error_let_pass)
            }
        })
    }

    /// How far both ends of the trial are past a surface.
    fn ends_past(&self, event: usize) -> [f64; 2] {
        self.crossing.ends.each_ref().map(|values| values[event])
    }

    /// Whether the error of crossing a surface somewhere in the trial is more than some, over the tolerance. It is the lesser
    /// of what the quadrature leaves of a jump over the whole trial, wherever it begins, and of all that acts in the part
    /// past the surface.
    fn is_error_over(
        &mut self,
        problem: &Problem<'_>,
        plan: &Plan,
        event: usize,
        most: f64,
    ) -> bool {
        let [from, to] = self.ends_past(event);
        // distances past the surface, and from end to end
        let (past, apart) = (from.max(to), (from - to).abs());
        let exponent = self.crossing.exponents[event];
        let mut change = |distance| self.change_by_jump(problem, plan, event, distance);
        error_over_surface(exponent) * change(apart) > most
            && error_at_end(exponent) * past / apart * change(past) > most
    }

    /// Error of a trial that was to end on a surface, over the tolerance.
    fn error_of_miss(&mut self, problem: &Problem<'_>, plan: &Plan, event: usize) -> f64 {
        let [from, to] = self.ends_past(event);
        let exponent = self.crossing.exponents[event];
        // of this step: what acts in the part between the surface and its end
        let own = error_at_end(exponent) * (to.abs() / (from - to).abs());
        // of the next one: the derivative at its start, with the weight b₁ of the first stage, is that of the wrong side; a
        // broken power is flat there, and does not count
        let next = match self.crossing.is_broken(event) {
            true => 0.0,
            false => FACTORS[LAST][0],
        };
        own.max(next) * self.change_by_jump(problem, plan, event, to.abs())
    }

    /// Change of the state, over the tolerance, if the force jump at a distance past the surface acted over the whole trial.
    fn change_by_jump(
        &mut self,
        problem: &Problem<'_>,
        plan: &Plan,
        event: usize,
        distance: f64,
    ) -> f64 {
        let (system, rate) = (problem.system, &mut self.rate);
        system.force_jump(event, plan.end, distance, rate);
        problem.norm(&self.from, rate) * plan.size
    }

    /// Locates where the trial crosses surfaces, and plans landings on the two earliest; whether any lies between the ends
    /// of the trial.
    pub(super) fn plan_landings(&mut self, problem: &Problem<'_>, size: f64) -> bool {
        let mut state = std::mem::take(&mut self.crossing.state);
        let mut deviation = std::mem::take(&mut self.argument);
        let [start, end] = [self.start, self.start + size];
        let mut found = Vec::new();
        for &event in &self.crossing.changed {
            // the event function along the interpolant of the trial
            let value = |time: f64| {
                self.by_stages(time, &mut deviation);
                problem.write_state(&deviation, &mut state);
                problem.system.event(event, time, &state)
            };
            let ends = self.ends_past(event);
            let time = root(value, [start, end], ends, FOUND * size);
            found.extend(time.map(|time| Due { event, time }));
        }
        (self.crossing.state, self.argument) = (state, deviation);
        self.crossing.plan_first(found, [start, end])
    }

    /// Records on which side of every surface a good step ends: where its landing is good, on the far side of it, whatever
    /// the sign of the event function.
    pub(super) fn arrive(&mut self, problem: &Problem<'_>, plan: &Plan) {
        self.crossing.fresh = false;
        if self.crossing.past.is_empty() {
            return;
        }
        if !self.crossing.is_end_known {
            self.find_sides(problem, plan.end);
        }
        let crossing = &mut self.crossing;
        let due = std::mem::take(&mut crossing.due).into_iter();
        let (landings, others): (Vec<_>, Vec<_>) = due.partition(|due| plan.lands_on(due.time));
        // crossed without a landing: none is due any more
        let others = others.into_iter();
        crossing.due = others
            .filter(|due| !crossing.changed.contains(&due.event))
            .collect();
        for &event in &crossing.changed {
            // by the sign, unless it lands
            crossing.past[event] = !crossing.past[event];
            if landings.iter().all(|due| due.event != event) {
                crossing.latest = self.time;
            }
        }
        for Due { event, .. } in landings {
            let crossing = &self.crossing;
            let past_before = crossing.past[event] != crossing.changed.contains(&event);
            self.land(problem, plan, event, !past_before);
            if self.crossing.past[event] != past_before {
                self.crossing.latest = self.time;
            }
        }
        self.crossing.ends.swap(0, 1);
    }

    /// Records how a step ended that was to land on a surface; `past` is the side that it was to reach.
    fn land(&mut self, problem: &Problem<'_>, plan: &Plan, event: usize, past: bool) {
        let misses = self.error_of_miss(problem, plan, event) > LANDING_TOLERANCE;
        let [from, to] = self.ends_past(event);
        let crossing = &mut self.crossing;
        let is_over = (to >= 0.0) == past;
        // time until the surface is reached, if the event function goes on as over the step
        let time_left = self.size * to / (from - to);
        let near = AT_END * self.next_size;
        if is_over || (0.0..near).contains(&time_left) || !misses {
            // the side is set, so that round-off of a state on the surface is no crossing
            crossing.past[event] = past;
            crossing.fresh |= past && crossing.is_broken(event);
        } else if (near..self.size).contains(&time_left) && self.time + time_left < self.limit {
            // a short step more leads there
            crossing.due.push(Due {
                event,
                time: self.time + time_left,
            });
        }
    }
}

/// Makes landings that are near each other one, and forgets all but those at the two earliest times.
fn keep_first_two(landings: &mut Vec<Due>, near: f64) {
    landings.sort_by(|a, b| a.time.total_cmp(&b.time));
    let (mut latest, mut times) = (f64::NEG_INFINITY, 0);
    landings.retain_mut(|due| {
        if due.time >= latest + near {
            latest = due.time;
            times += 1;
        }
        due.time = latest;
        times <= 2
    });
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_two_earliest_landings_are_kept_and_near_ones_are_one() {
        let due = |(event, time)| Due { event, time };
        let mut landings: Vec<_> = [0.5, 0.2, 0.9, 0.2001]
            .into_iter()
            .enumerate()
            .map(due)
            .collect();
        keep_first_two(&mut landings, 1e-3);
        assert_eq!(landings, [(1, 0.2), (3, 0.2), (0, 0.5)].map(due));
    }
}
