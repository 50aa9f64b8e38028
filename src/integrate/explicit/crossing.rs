//! Surfaces at which the derivative is not smooth: seen in a trial step, and landed on.
//!
//! A step over the surface of a contact has an error of order 2.5, and its estimate may be blind to it.
//! So a trial that crosses a surface is given up where what the surface adds counts; the next one ends
//! on the surface, and the one after it begins there, each in a variable in which it is smooth.

use super::aim::Aim;
use super::landing::{Landing, crossing_time, insert};
use super::tableau::Pair;
use super::walk::Walk;
use crate::integrate::course::Course;
use crate::integrate::look::Look;
use crate::integrate::{Sides, System};

/// Error of a step over its size and what a surface adds over a short part at its end, over that part:
/// ∫ x^(3/2), for none of it need be seen.
const CROSSED_AT_END: f64 = 0.4;
/// Error that is let pass, over the tolerance: from here on a landing costs less than the short steps
/// that the same error takes without it.
const LET_PASS: f64 = 0.75;
/// The same where a step was to end on the surface.
const BESIDE: f64 = 0.1;
/// Error of a trial, in units of the state, from which on it says nothing of surfaces.
const WILD: f64 = 1e-2;
/// Crossings within this part of a trial are one.
const TOGETHER: f64 = 1e-3;
/// Part of a trial within which its ends are as good as a landing.
const AT_END: f64 = 1e-6;

/// Numbers that hold a set of surfaces, 32 each.
const PARTS: usize = 4;
/// Numbers of [`Crossing::numbers`].
pub(super) const NUMBERS: usize = 3 * PARTS + 4;

/// Where a walk stands between the surfaces.
#[derive(Debug, Clone, Copy)]
pub(super) struct Crossing<const N: usize> {
    /// Sides at the end of the latest step.
    sides: Sides,
    /// Whether it ended on a surface that adds to the derivative from there on.
    pub fresh: bool,
    /// The next landing, where it is known.
    pub planned: Option<Landing>,
    /// Sizes that steps from a surface, and those to one, may have, s.
    pub sizes: [f64; 2],
    /// The latest look around on the way, and that at the end of the trial.
    looked: Look<N>,
    ahead: Look<N>,
    /// Whether there was one at the end of the trial.
    seen: bool,
}

impl<const N: usize> Crossing<N> {
    pub const NEW: Self = Self {
        sides: 0,
        fresh: false,
        planned: None,
        sizes: [f64::INFINITY; 2],
        looked: Look::NONE,
        ahead: Look::NONE,
        seen: false,
    };

    /// Sides at the end of the latest step.
    pub fn sides(&self) -> Sides {
        self.sides
    }

    /// What the steps to come depend on, as numbers; another look finds the rest.
    pub fn numbers(&self) -> impl Iterator<Item = f64> + use<N> {
        let none = Landing {
            time: f64::INFINITY,
            surfaces: 0,
            sides: 0,
        };
        let planned = self.planned.unwrap_or(none);
        let [from, to] = self.sizes;
        let sets = [self.sides, planned.surfaces, planned.sides].map(parts_of);
        let fresh = f64::from(u8::from(self.fresh));
        [fresh, planned.time, from, to]
            .into_iter()
            .chain(sets.into_iter().flatten())
    }

    /// From numbers as by [`Crossing::numbers`]; none of any others.
    pub fn restored(numbers: &[f64]) -> Option<Self> {
        let ([fresh, time, from, to], sets) = numbers.split_first_chunk()?;
        let (sets, []) = sets.as_chunks::<PARTS>() else {
            return None;
        };
        let [sides, surfaces, planned] = <&[[f64; PARTS]; 3]>::try_from(sets).ok()?.map(set_of);
        Some(Self {
            sides,
            fresh: *fresh != 0.0,
            planned: time.is_finite().then_some(Landing {
                time: *time,
                surfaces,
                sides: planned,
            }),
            sizes: [*from, *to],
            ..Self::NEW
        })
    }
}

impl<const N: usize> Walk<N> {
    fn look<S: System<N>>(
        &self,
        course: &Course<'_, S, N>,
        time: f64,
        deviation: &[f64; N],
    ) -> Look<N> {
        Look::around(course.system, time, self.state(course, deviation))
    }

    /// Looks around at the start of the walk.
    pub(super) fn look_around<S: System<N>>(&mut self, course: &Course<'_, S, N>) {
        self.crossing.looked = self.look(course, self.time, &self.from);
        self.crossing.sides = self.crossing.looked.sides;
    }

    /// Whether the end of the trial is nearer to the latest look than any surface was.
    fn is_clear<S: System<N>>(&self, course: &Course<'_, S, N>, aim: &Aim) -> bool {
        let state = self.state(course, &self.to);
        let looked = &self.crossing.looked;
        looked.is_clear(course.system, aim.end, &state)
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
        if off.is_nan() || off > WILD || self.is_clear(course, aim) {
            return None;
        }
        let ahead = self.look(course, aim.end, &self.to);
        self.crossing.ahead = ahead;
        self.crossing.seen = true;
        let changed = ahead.sides ^ self.crossing.sides;
        if each(changed).any(|surface| self.spoils::<P, S>(course, aim, surface)) {
            return self.locate::<P, S>(course, changed, ahead.sides);
        }
        None
    }

    /// How far both ends of the trial are past a surface.
    fn ends_past<S: System<N>>(
        &self,
        course: &Course<'_, S, N>,
        aim: &Aim,
        surface: u32,
    ) -> [f64; 2] {
        let past = |time: f64, deviation: &[f64; N]| {
            course
                .system
                .past(surface, time, &self.state(course, deviation))
        };
        [past(self.start, &self.from), past(aim.end, &self.to)]
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
            return self.misses(course, aim, surface);
        }
        let [from, to] = self.ends_past(course, aim, surface);
        let (past, apart) = (from.max(to), (from - to).abs());
        let anywhere = P::CROSSED * self.weight(course, aim.end, surface, apart);
        let at_end = CROSSED_AT_END * past / apart * self.weight(course, aim.end, surface, past);
        anywhere.min(at_end) > LET_PASS
    }

    /// Whether a step that was to end on a surface ends so far from it that it counts.
    fn misses<S: System<N>>(&self, course: &Course<'_, S, N>, aim: &Aim, surface: u32) -> bool {
        let [from, to] = self.ends_past(course, aim, surface);
        let part = to.abs() / (from - to).abs();
        let weight = self.weight(course, aim.end, surface, to.abs());
        CROSSED_AT_END * part * weight > BESIDE
    }

    /// Change of the state over the step by what a surface adds at a distance, over the tolerance.
    fn weight<S: System<N>>(
        &self,
        course: &Course<'_, S, N>,
        time: f64,
        surface: u32,
        distance: f64,
    ) -> f64 {
        let added = course.system.added(surface, time, distance);
        course.norm(&self.from, &added) * self.size
    }

    /// When the trial crosses surfaces towards `sides`: the first two landings.
    fn locate<P: Pair, S: System<N>>(
        &mut self,
        course: &Course<'_, S, N>,
        surfaces: Sides,
        sides: Sides,
    ) -> Option<[Option<Landing>; 2]> {
        self.evaluate_end::<P, S>(course);
        let by_quintic = course.system.is_second_order() && self.substitution.is_none();
        if !by_quintic {
            self.extended = const { P::LAST + 1 >= P::STAGES };
            self.extend::<P, S>(course);
        }
        let mut found = [None; 2];
        for surface in each(surfaces) {
            let past = |time: f64| {
                let deviation = if by_quintic {
                    self.by_quintic(time, P::LAST)
                } else {
                    self.by_stages::<P>(time)
                };
                let state = self.state(course, &deviation);
                course.system.past(surface, time, &state)
            };
            let margin = AT_END * self.size;
            let inside = self.start + margin..self.start + self.size - margin;
            let time = crossing_time(past, [self.start, self.start + self.size]);
            if let Some(time) = time.filter(|time| inside.contains(time)) {
                let surfaces = 1 << surface;
                let landing = Landing {
                    time,
                    surfaces,
                    sides: sides & surfaces,
                };
                insert(&mut found, landing, TOGETHER * self.size);
            }
        }
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
    }

    /// Takes note of a step that was to end on a surface.
    fn arrive_at<S: System<N>>(
        &mut self,
        course: &Course<'_, S, N>,
        aim: &Aim,
        surface: u32,
        side: Sides,
    ) {
        let surfaces = 1 << surface;
        let [from, to] = self.ends_past(course, aim, surface);
        let left = self.size * to / (from - to);
        let time = self.time + left;
        let near = AT_END * self.next_size;
        if self.misses(course, aim, surface) && left > near && left < self.size {
            // not quite there: a short step more
            let landing = Landing {
                time,
                surfaces,
                sides: side,
            };
            self.crossing.planned = Some(landing).filter(|landing| landing.time < self.limit);
        } else {
            // round-off must not bring it back
            let crossing = &mut self.crossing;
            crossing.sides = (crossing.sides & !surfaces) | side;
            crossing.looked.sides = crossing.sides;
            crossing.looked.nearest = 0.0;
            crossing.fresh |= side != 0;
        }
    }
}

/// Surfaces of a set.
fn each(mut surfaces: Sides) -> impl Iterator<Item = u32> {
    std::iter::from_fn(move || {
        let surface = surfaces.trailing_zeros();
        (surfaces != 0).then(|| {
            surfaces &= surfaces - 1;
            surface
        })
    })
}

fn parts_of(set: Sides) -> [f64; PARTS] {
    std::array::from_fn(|part| f64::from((set >> (32 * part)) as u32))
}

fn set_of(parts: [f64; PARTS]) -> Sides {
    let part = |(index, part): (usize, &f64)| Sides::from(*part as u32) << (32 * index);
    parts.iter().enumerate().map(part).sum()
}
