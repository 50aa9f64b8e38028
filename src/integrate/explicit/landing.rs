//! Where steps are to end on surfaces, and the search for it.

use crate::integrate::stride::{Stride, each};
use crate::integrate::{Sides, System};

/// Error that is let pass, over the tolerance: from here on a landing costs less than the short steps that the same
/// error takes without it; at loose tolerances from four times as much on, at fine ones from half as much.
const LET_PASS: f64 = 0.25;
/// Crossings within this part of a trial are one.
const TOGETHER: f64 = 1e-3;
/// Part of a trial within which its ends are as good as a landing.
pub(super) const AT_END: f64 = 1e-6;

/// Part of the way searched to which a crossing is found.
const FOUND: f64 = 1e-9;
/// Trials of a root search.
const MOST_TRIALS: usize = 60;

/// A time to land on.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Landing {
    /// s.
    pub time: f64,
    /// Surfaces that are crossed there.
    pub surfaces: Sides,
    /// Their sides after it.
    pub sides: Sides,
}

impl Landing {
    /// Whether a surface ceases there to add to the derivative.
    pub fn ends(&self) -> bool {
        self.surfaces & !self.sides != 0
    }
}

impl<S: System<N>, const N: usize> Stride<'_, '_, S, N> {
    /// Whether the error of crossing a surface counts, by a method with an error over all surfaces.
    pub(super) fn spoils(&self, surface: u32, crossed: f64) -> bool {
        self.error_over(surface, crossed) > LET_PASS
    }

    /// When a motion crosses surfaces towards `sides`: the first two landings.
    pub(super) fn landings(
        &self,
        surfaces: Sides,
        sides: Sides,
        motion: impl Fn(f64) -> [f64; N],
    ) -> [Option<Landing>; 2] {
        let mut found = [None; 2];
        let [start, end] = [self.times[0], self.times[0] + self.size];
        let margin = AT_END * self.size;
        for surface in each(surfaces) {
            let past = |time: f64| {
                let state = self.course.state(&motion(time));
                self.course.system.past(surface, time, &state)
            };
            let time = crossing_time(past, [start, end], self.ends_past(surface));
            let inside = |time: &f64| (start + margin..end - margin).contains(time);
            if let Some(time) = time.filter(inside) {
                let surfaces = 1 << surface;
                let landing = Landing {
                    time,
                    surfaces,
                    sides: sides & surfaces,
                };
                insert(&mut found, landing, TOGETHER * self.size);
            }
        }
        found
    }
}

/// Keeps the two earliest landings; those that are near each other become one.
fn insert(found: &mut [Option<Landing>; 2], new: Landing, near: f64) {
    for slot in 0..2 {
        match &mut found[slot] {
            Some(old) if (old.time - new.time).abs() < near => {
                old.surfaces |= new.surfaces;
                old.sides |= new.sides;
                return;
            }
            Some(old) if old.time <= new.time => {}
            _ => {
                if slot == 0 {
                    found[1] = found[0];
                }
                found[slot] = Some(new);
                return;
            }
        }
    }
}

/// Root of a continuous function between two times, where it has these values; none where both have one sign.
fn crossing_time(
    past: impl Fn(f64) -> f64,
    [mut low, mut high]: [f64; 2],
    [mut at_low, mut at_high]: [f64; 2],
) -> Option<f64> {
    let near = FOUND * (high - low);
    if (at_low >= 0.0) == (at_high >= 0.0) {
        return None;
    }
    // the Illinois algorithm: an end that stays twice loses half of its weight
    let mut stayed = None;
    for _ in 0..MOST_TRIALS {
        let time = (low * at_high - high * at_low) / (at_high - at_low);
        let time = time.clamp(low, high);
        let value = past(time);
        let beyond = (value >= 0.0) == (at_high >= 0.0);
        let halved = if stayed == Some(beyond) { 0.5 } else { 1.0 };
        if beyond {
            (high, at_high) = (time, value);
            at_low *= halved;
        } else {
            (low, at_low) = (time, value);
            at_high *= halved;
        }
        stayed = Some(beyond);
        if high - low < near || value == 0.0 {
            break;
        }
    }
    Some(if at_low.abs() < at_high.abs() {
        low
    } else {
        high
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_crossing_is_found_to_round_off() {
        let past = |time: f64| (time - 0.3).powi(3) + 0.1 * (time - 0.3);
        let found = crossing_time(past, [0.0, 1.0], [0.0, 1.0].map(past));
        assert!(
            found.is_some_and(|time| (time - 0.3).abs() < 1e-9),
            "{found:?}"
        );
        let apart = crossing_time(|time| time + 1.0, [0.0, 1.0], [1.0, 2.0]);
        assert_eq!(apart, None);
    }

    #[test]
    fn the_two_earliest_landings_are_kept_and_near_ones_are_one() {
        let at = |time: f64, surface: u32| Landing {
            time,
            surfaces: 1 << surface,
            sides: 0,
        };
        let mut found = [None; 2];
        for landing in [at(0.5, 0), at(0.2, 1), at(0.9, 2), at(0.2001, 3)] {
            insert(&mut found, landing, 1e-3);
        }
        let first = Landing {
            surfaces: 0b1010,
            ..at(0.2, 1)
        };
        assert_eq!(found, [Some(first), Some(at(0.5, 0))]);
    }
}
