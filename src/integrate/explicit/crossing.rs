//! Surfaces at which the derivative is not smooth: seen in a trial step, and landed on.
//!
//! A step over the surface of a contact has an error of order 2.5, and its estimate may be blind to it.
//! So a trial that crosses a surface is given up where what the surface adds counts; the next one ends
//! on the surface, and the one after it begins there, each in a variable in which it is smooth.

use super::aim::Aim;
use super::landing::{AT_END, Landing};
use super::tableau::Pair;
use super::walk::Walk;
use crate::integrate::course::Course;
use crate::integrate::look::Look;
use crate::integrate::stride::{Stride, each};
use crate::integrate::{Sides, System};

/// Error that is let pass where a step was to end on the surface, over the tolerance.
const BESIDE: f64 = 0.01;
/// Error of a trial, in units of the state, from which on it says nothing of surfaces.
const WILD: f64 = 1e-2;

/// Where a walk stands between the surfaces.
#[derive(Debug, Clone, Copy)]
pub(super) struct Crossing<const N: usize> {
    /// Sides at the end of the latest step.
    pub sides: Sides,
    /// Time of the latest step at whose end they were others than at its start, s.
    pub latest: f64,
    /// Whether it ended on a surface that adds to the derivative from there on.
    pub fresh: bool,
    /// The next landing, where it is known.
    pub planned: Option<Landing>,
    /// Sizes that steps from a surface, and those to one, may have, s.
    pub sizes: [f64; 2],
    /// The latest look around on the way, and that at the end of the trial.
    pub looked: Look<N>,
    ahead: Look<N>,
    /// Whether there was one at the end of the trial.
    seen: bool,
    /// The look around where the trial was expected to end.
    pub foreseen: Option<Look<N>>,
}

impl<const N: usize> Crossing<N> {
    pub const NEW: Self = Self {
        sides: 0,
        latest: f64::NEG_INFINITY,
        fresh: false,
        planned: None,
        sizes: [f64::INFINITY; 2],
        looked: Look::NONE,
        ahead: Look::NONE,
        seen: false,
        foreseen: None,
    };
}

impl<const N: usize> Walk<N> {
    /// Looks around at the start of the walk.
    pub(super) fn look_around<S: System<N>>(&mut self, course: &Course<'_, S, N>) {
        self.crossing.looked = Look::around(course.system, self.time, course.state(&self.from));
        self.crossing.sides = self.crossing.looked.sides;
    }

    /// Where the trial crosses surfaces that spoil it: the first time, and the next one.
    pub(super) fn crossed<P: Pair, S: System<N>>(
        &mut self,
        course: &Course<'_, S, N>,
        aim: &Aim,
        error: f64,
    ) -> Option<[Option<Landing>; 2]> {
        self.crossing.seen = false;
        // with no number or a wild one there is nothing to see
        let off = error * P::LOCAL_PART * course.settings.tolerance;
        if off.is_nan() || off > WILD {
            return None;
        }
        let state = course.state(&self.to);
        let is_clear = |look: &Look<N>| look.is_clear(course.system, aim.end, &state);
        let ahead = match self.crossing.foreseen {
            Some(foreseen) if is_clear(&foreseen) => foreseen,
            _ if is_clear(&self.crossing.looked) => return None,
            _ => Look::around(course.system, aim.end, state),
        };
        self.crossing.ahead = ahead;
        self.crossing.seen = true;
        let changed = ahead.sides ^ self.crossing.sides;
        if each(changed).any(|surface| self.spoils::<P, S>(course, aim, surface)) {
            return self.locate::<P, S>(course, aim, changed, ahead.sides);
        }
        None
    }

    /// The trial.
    fn stride<'a, 'c, S>(
        &'a self,
        course: &'a Course<'c, S, N>,
        aim: &Aim,
    ) -> Stride<'a, 'c, S, N> {
        self.stride_to(course, aim, &self.to)
    }

    /// A trial that ends in a deviation.
    pub(super) fn stride_to<'a, 'c, S>(
        &'a self,
        course: &'a Course<'c, S, N>,
        aim: &Aim,
        to: &'a [f64; N],
    ) -> Stride<'a, 'c, S, N> {
        Stride {
            course,
            times: [self.start, aim.end],
            deviations: [&self.from, to],
            size: aim.size,
        }
    }

    /// Whether the error of crossing a surface counts.
    fn spoils<P: Pair, S: System<N>>(
        &self,
        course: &Course<'_, S, N>,
        aim: &Aim,
        surface: u32,
    ) -> bool {
        if aim
            .landing
            .is_some_and(|landing| landing.surfaces & (1 << surface) != 0)
        {
            let stride = self.stride(course, aim);
            return misses(&stride, surface, stride.ends_past(surface));
        }
        self.stride(course, aim).spoils(surface, P::CROSSED)
    }

    /// When the trial crosses surfaces towards `sides`: the first two landings.
    fn locate<P: Pair, S: System<N>>(
        &mut self,
        course: &Course<'_, S, N>,
        aim: &Aim,
        surfaces: Sides,
        sides: Sides,
    ) -> Option<[Option<Landing>; 2]> {
        self.evaluate_end::<P, S>(course);
        let by_quintic = course.system.is_second_order() && self.substitution.is_none();
        if !by_quintic {
            self.extended = const { P::LAST + 1 >= P::STAGES };
            self.extend::<P, S>(course);
        }
        let motion = |time: f64| {
            if by_quintic {
                self.by_quintic(time, P::LAST)
            } else {
                self.by_stages::<P>(time)
            }
        };
        let found = self.stride(course, aim).landings(surfaces, sides, motion);
        found[0].map(|_| found)
    }

    /// Takes note of the sides after a good step.
    pub(super) fn arrive<S: System<N>>(
        &mut self,
        course: &Course<'_, S, N>,
        aim: &Aim,
        next: [Option<Landing>; 2],
    ) {
        let crossing = &mut self.crossing;
        let before = crossing.sides;
        crossing.fresh = false;
        crossing.planned = next[0];
        if crossing.seen {
            crossing.looked = crossing.ahead;
            crossing.sides = crossing.ahead.sides;
        }
        if let Some(landing) = aim.landing {
            crossing.planned = next[1];
            for surface in each(landing.surfaces) {
                self.arrive_at(course, aim, surface, landing.sides & (1 << surface));
            }
        }
        if self.crossing.sides != before {
            self.crossing.latest = self.time;
        }
    }

    /// Takes note of a step that was to end on a surface.
    fn arrive_at<S: System<N>>(
        &mut self,
        course: &Course<'_, S, N>,
        aim: &Aim,
        surface: u32,
        side: Sides,
    ) {
        let (surfaces, stride) = (1 << surface, self.stride(course, aim));
        let [from, to] = stride.ends_past(surface);
        let is_over = (to >= 0.0) == (side != 0);
        let left = self.size * to / (from - to);
        let near = AT_END * self.next_size;
        if is_over || (0.0..near).contains(&left) || !misses(&stride, surface, [from, to]) {
            // round-off must not bring it back
            let crossing = &mut self.crossing;
            crossing.sides = (crossing.sides & !surfaces) | side;
            crossing.looked.sides = crossing.sides;
            crossing.looked.nearest = 0.0;
            crossing.fresh |= side != 0;
        } else if (near..self.size).contains(&left) {
            // not quite there: a short step more
            let landing = Landing {
                time: self.time + left,
                surfaces,
                sides: side,
            };
            self.crossing.planned = Some(landing).filter(|landing| landing.time < self.limit);
        }
    }
}

/// Whether a step that was to end on a surface ends so far from it that it counts, by how far its ends are past it.
fn misses<S: System<N>, const N: usize>(
    stride: &Stride<'_, '_, S, N>,
    surface: u32,
    ends: [f64; 2],
) -> bool {
    stride.error_beside(surface, ends) > BESIDE
}
