//! What a method promises to one that walks: which to begin with, and which to try.

use super::cost::{WAYS, Way};
use super::selector::{EVEN, Mark, Outlook, Selector};

/// Part of what is left of the run that a trial may cost that nothing is expected of, before its first step.
const BLIND_BEGINNING: f64 = 0.04;
/// Part of what Verner's pair is expected to cost that the Nyström pair may cost before its first step.
const SHORT_BEGINNING: f64 = 0.3;
/// Gain that a trial must promise, in what its beginning costs.
const WORTH: f64 = 1.5;
/// How much cheaper than it was found to be the exponential method may be by now, and how much cheaper one
/// explicit pair may be than the other, and the Nyström pair than both.
const HOPE: f64 = 0.6;
const OTHER_PAIR: f64 = 0.8;
pub(super) const NYSTROM_PAIR: f64 = 0.7;
/// Cost of the Nyström pair once the start has died away, in that of Verner's pair before, and what the latter may
/// then cost at least.
const SETTLED_NYSTROM: f64 = 0.55;
const SETTLED_VERNER: f64 = 0.35;
/// Cost of a pair then, in that of before.
const SETTLED_PAIR: f64 = 0.6;
/// How much cheaper than settled motion was found to be by it the exponential method may be.
const DISPROVED: f64 = 0.1;
/// How much cheaper than it was found to be an explicit pair cannot be by now, after the other one and after
/// the exponential method, which may have had its turn for long; the latter with every failure by half.
const NO_HOPE: [f64; 2] = [0.1, 0.45];
/// Evaluations by which a trial of a pair is dearer than one that needs no trial: a Nyström pair finds states
/// within its first steps by steps of their own.
pub(super) const PAIR_EVALUATIONS: f64 = 100.0;
const NYSTROM_EVALUATIONS: f64 = 350.0;

impl Selector {
    /// The method to begin with, where Verner's pair is expected to cost so much per simulated time while the
    /// start dies away, which is kept where another one is to be better.
    pub(super) fn first(&mut self, pair: f64, outlook: &Outlook) -> Way {
        let by_pair = pair * outlook.left;
        let beginning = self.beginning(Way::Exponential, outlook);
        let expected = outlook.exponential * outlook.left + beginning;
        let serves_nystrom = self.is_smooth(outlook)
            && self.beginning(Way::Dprkn8, outlook) < SHORT_BEGINNING * by_pair;
        let is_best = outlook.exponential <= SETTLED_NYSTROM * pair;
        let way = if serves_nystrom && !is_best {
            Way::Dprkn8
        } else if expected < by_pair {
            Way::Exponential
        } else {
            return Way::Verner76;
        };
        self.rates[Way::Verner76 as usize] = pair;
        self.assumed = true;
        way
    }

    /// Cost per simulated time that the exponential method is expected to have; no number where nothing is
    /// known.
    pub(super) fn expected(&self, outlook: &Outlook) -> f64 {
        let known = self.rates[Way::Exponential as usize];
        if self.disproved && known.is_finite() {
            outlook.exponential.max(self.exponential_hope() * known)
        } else {
            outlook.exponential
        }
    }

    /// What a method costs before its first step.
    pub(super) fn beginning(&self, way: Way, outlook: &Outlook) -> f64 {
        match way {
            Way::Exponential if self.linear_part => outlook.prices.step_size,
            Way::Exponential => outlook.prices.first_steps(),
            Way::Dprkn8 => NYSTROM_EVALUATIONS * outlook.prices.evaluation[way as usize],
            _ => PAIR_EVALUATIONS * outlook.prices.evaluation[way as usize],
        }
    }

    /// The method that promises most, where any is worth a trial.
    pub(super) fn candidate(&self, here: Mark, outlook: &Outlook) -> Option<Way> {
        if here.spent < self.next_trial {
            return None;
        }
        let others = WAYS.into_iter().filter(|&way| way != self.way);
        let promises = others.map(|way| (self.promise(way, outlook), way));
        let best = promises.max_by(|(a, _), (b, _)| a.total_cmp(b))?;
        (best.0 > 0.0).then_some(best.1)
    }

    /// What a method is hoped to save of the rest of the run; nothing where it is not worth a trial.
    fn promise(&self, way: Way, outlook: &Outlook) -> f64 {
        let mut own = self.rates[self.way as usize];
        if self.way == Way::Exponential && !outlook.decayed && !self.disproved {
            // it is not what it will be
            own = own.min(outlook.exponential.max(0.0));
        } else if way == Way::Exponential && !outlook.decayed {
            own *= SETTLED_PAIR;
        }
        if self.way == Way::Exponential {
            own *= EVEN;
        }
        let beginning = self.beginning(way, outlook);
        // where there is a Nyström pair for what the exponential method does, it is the better one
        let is_second =
            self.way == Way::Exponential && way != Way::Dprkn8 && self.is_smooth(outlook);
        // where surfaces are crossed, steps that land on them are the better ones
        let runs_into_contacts = match way {
            Way::Exponential => outlook.contacts_change || outlook.rings,
            Way::Dprkn8 => outlook.goes_over_surfaces(),
            Way::Verner76 | Way::Dop853 => false,
        };
        if is_second || runs_into_contacts {
            return 0.0;
        }
        let hoped = self.hoped(way, outlook);
        let expected =
            way == Way::Exponential && self.expected(outlook).max(hoped.unwrap_or(0.0)) < own;
        if !expected && beginning >= BLIND_BEGINNING * own * outlook.left {
            return 0.0;
        }
        // a motion that has not settled leaves the exponential method little to save
        let left = if way == Way::Exponential {
            outlook.settled
        } else {
            outlook.left
        };
        let saved = (own - hoped.unwrap_or(HOPE * own)) * left;
        if saved > WORTH * beginning {
            saved
        } else {
            0.0
        }
    }

    /// Whether a Nyström pair serves the system, and no surfaces are in its way.
    fn is_smooth(&self, outlook: &Outlook) -> bool {
        let serves = self.rates[Way::Dprkn8 as usize] != f64::MAX;
        serves && !outlook.goes_over_surfaces()
    }

    /// Least cost per simulated time that a method may have by now, where anything is known.
    fn hoped(&self, way: Way, outlook: &Outlook) -> Option<f64> {
        let known = self.rates[way as usize];
        if known == f64::MAX {
            return Some(known);
        }
        let hoped = match way {
            // it falls as a motion settles
            Way::Exponential if self.expected(outlook).is_finite() => self.expected(outlook),
            Way::Exponential => self.exponential_hope() * known,
            Way::Verner76 if self.assumed && self.way == Way::Exponential => {
                known * if outlook.decayed { SETTLED_VERNER } else { 1.0 }
            }
            _ if known.is_finite() => self.pair_hope() * known,
            Way::Verner76 if self.rates[Way::Dop853 as usize] == f64::MAX => f64::NAN,
            Way::Verner76 => OTHER_PAIR * self.rates[Way::Dop853 as usize],
            Way::Dop853 => OTHER_PAIR * self.rates[Way::Verner76 as usize],
            Way::Dprkn8 if self.assumed && self.way == Way::Exponential => {
                SETTLED_NYSTROM * self.rates[Way::Verner76 as usize]
            }
            Way::Dprkn8 => NYSTROM_PAIR * self.pair_hope() * self.rates[Way::Verner76 as usize],
        };
        hoped.is_finite().then_some(hoped)
    }

    /// Part of its known cost that the exponential method may have by now: of settled motion it is known ever
    /// better with every failure.
    fn exponential_hope(&self) -> f64 {
        if self.disproved {
            1.0 - DISPROVED * 0.5_f64.powf(self.failures[0])
        } else {
            HOPE
        }
    }

    /// How much cheaper than it was found to be an explicit pair may be by now.
    fn pair_hope(&self) -> f64 {
        let [after_pair, after_exponential] = NO_HOPE;
        if self.way == Way::Exponential {
            1.0 - after_exponential * 0.5_f64.powf(self.failures[1])
        } else {
            1.0 - after_pair * 0.7_f64.powf(self.failures[1])
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::cost::Prices;
    use super::*;
    use crate::integrate::Effort;

    /// A second of a smooth motion that costs the exponential method so much per second.
    fn outlook(exponential: f64) -> Outlook {
        let effort = Effort {
            derivative: 50e-9,
            linearisation: 500e-9,
        };
        Outlook {
            prices: Prices::new(effort, 6),
            left: 1.0,
            settled: 0.9,
            decayed: false,
            exponential,
            crossings: 0.0,
            contacts_change: false,
            rings: false,
            bounces: false,
        }
    }

    fn first(exponential: f64, change: impl Fn(&mut Outlook)) -> Way {
        let mut outlook = outlook(exponential);
        change(&mut outlook);
        Selector::new(Way::Verner76).first(10e-3, &outlook)
    }

    #[test]
    fn a_run_begins_with_what_is_expected_to_cost_least() {
        assert_eq!(first(2e-3, |_| {}), Way::Exponential);
        assert_eq!(first(8e-3, |_| {}), Way::Dprkn8);
        assert_eq!(first(12e-3, |_| {}), Way::Dprkn8);
        assert_eq!(first(f64::NAN, |_| {}), Way::Dprkn8);
        // too short for a linear part
        let short = |outlook: &mut Outlook| outlook.left = 5e-3;
        assert_eq!(first(2e-3, short), Way::Verner76);
        // not over surfaces
        let crossed = |outlook: &mut Outlook| outlook.crossings = 100.0;
        assert_eq!(first(8e-3, crossed), Way::Exponential);
        assert_eq!(first(12e-3, crossed), Way::Verner76);
        assert_eq!(
            first(12e-3, |outlook| outlook.bounces = true),
            Way::Verner76
        );
    }

    #[test]
    fn an_exponential_method_as_cheap_as_a_pair_is_kept_for_its_smaller_error() {
        let kept_at = |rate: f64| {
            let mut selector = Selector::new(Way::Verner76);
            let outlook = outlook(12e-3);
            selector.rates[Way::Verner76 as usize] = 10e-3;
            let mark = |time: f64, steps| Mark {
                time,
                spent: rate * time,
                steps,
            };
            selector.change(mark(0.0, 0), Way::Exponential);
            selector.look(mark(0.1, 7), 0.9, || outlook);
            let next = selector.look(mark(0.4, 30), 0.6, || outlook);
            next.is_none() && selector.against.is_none()
        };
        assert!(kept_at(8e-3) && kept_at(13e-3));
        assert!(!kept_at(16e-3));
    }

    #[test]
    fn what_was_assumed_of_a_pair_is_forgotten_once_it_walks() {
        let mut selector = Selector::new(Way::Verner76);
        let outlook = outlook(2e-3);
        let way = selector.first(10e-3, &outlook);
        let start = Mark {
            time: 0.0,
            spent: 0.0,
            steps: 0,
        };
        selector.change(start, way);
        assert_eq!(selector.against, Some(Way::Verner76));
        let dear = Mark {
            time: 1e-3,
            spent: 1.0,
            steps: 3,
        };
        assert_eq!(selector.look(dear, 1.0, || outlook), Some(Way::Verner76));
        assert!(!selector.assumed && selector.rates[0] == f64::INFINITY);
    }
}
