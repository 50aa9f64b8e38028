//! Where steps are to end on surfaces, and the search for it.

use crate::integrate::Sides;

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

/// Keeps the two earliest landings; those that are near each other become one.
pub(super) fn insert(found: &mut [Option<Landing>; 2], new: Landing, near: f64) {
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

/// Root of a continuous function between two times; none where both ends have one sign.
pub(super) fn crossing_time(
    past: impl Fn(f64) -> f64,
    [mut low, mut high]: [f64; 2],
) -> Option<f64> {
    let near = FOUND * (high - low);
    let [mut at_low, mut at_high] = [past(low), past(high)];
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
        let found = crossing_time(past, [0.0, 1.0]);
        assert!(
            found.is_some_and(|time| (time - 0.3).abs() < 1e-9),
            "{found:?}"
        );
        assert_eq!(crossing_time(|time| time + 1.0, [0.0, 1.0]), None);
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
