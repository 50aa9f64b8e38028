//! Whether it pays to make runs side by side: found out once for many neighbours.

use std::collections::BTreeMap;
use std::sync::{Arc, Mutex, OnceLock, PoisonError};

/// Runs in a row that follow one pilot.
const FOLLOWERS: u64 = 256;
/// Pilots that are remembered: more than there are among runs that are under way.
const REMEMBERED: usize = 64;

/// What pilots have found. Which run is the pilot of another follows from their numbers alone, so that every
/// part of a study decides as the whole does.
#[derive(Debug, Default)]
pub struct Pilots {
    found: Mutex<BTreeMap<u64, Arc<OnceLock<bool>>>>,
}

impl Pilots {
    /// What the pilot of a run has found; `find` finds it out, of the run of a number, for the first who asks.
    pub(super) fn of(&self, number: u64, runs: u64, find: impl FnOnce(u64) -> bool) -> bool {
        let stretch = number / FOLLOWERS;
        let cell = {
            let mut found = self.found.lock().unwrap_or_else(PoisonError::into_inner);
            let cell = Arc::clone(found.entry(stretch).or_default());
            if found.len() > REMEMBERED {
                // stretches are begun in ascending order
                found.pop_first();
            }
            cell
        };
        let middle = stretch * FOLLOWERS + FOLLOWERS / 2;
        let last = runs.saturating_sub(1).max(stretch * FOLLOWERS);
        *cell.get_or_init(|| find(middle.min(last)))
    }
}

#[cfg(test)]
mod tests {
    use std::cell::Cell;

    use super::*;

    #[test]
    fn every_stretch_has_one_pilot_from_its_middle() {
        let (pilots, asked) = (Pilots::default(), Cell::new(0));
        let find = |number| {
            asked.set(asked.get() + 1);
            number == 128
        };
        for number in 0..600 {
            assert_eq!(pilots.of(number, 600, find), number < 256, "{number}");
        }
        assert_eq!(asked.get(), 3);
    }

    #[test]
    fn a_last_stretch_that_is_short_has_its_last_run() {
        let pilots = Pilots::default();
        assert!(pilots.of(10, 30, |number| number == 29));
        assert!(pilots.of(256, 257, |number| number == 256));
    }

    #[test]
    fn what_is_remembered_does_not_grow() {
        let pilots = Pilots::default();
        for number in 0..100_000 {
            pilots.of(number, 100_000, |_| true);
        }
        assert!(pilots.found.lock().expect("no panic").len() <= REMEMBERED);
    }
}
