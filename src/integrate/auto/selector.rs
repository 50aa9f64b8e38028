//! When to try which method, and which to keep: numbers alone.

use super::cost::{Prices, WAYS, Way};

/// Steps before a window, while a method finds its step size, and steps of a window at least.
const FIRST_STEPS: u64 = 5;
const LEAST_STEPS: u64 = 10;
/// Length of a window as a part of what the whole run is expected to cost, and of the very first one.
const WINDOW_PART: f64 = 0.01;
const FIRST_PART: f64 = 0.001;
/// Weight of the latest window in the cost of a method that is not on trial.
const LATEST: f64 = 0.5;
/// Part of what is left of the run that a trial may cost, and of what it is expected to save.
const BLIND: f64 = 0.02;
const PATIENCE: f64 = 0.06;
/// Gain that a trial must promise, in what its beginning costs.
const WORTH: f64 = 1.5;
/// A trial that failed is paid off by so many times its loss before the next.
const PAID_OFF: f64 = 20.0;
/// The same where a method is expected to become cheaper than it was, and its growth with every failure.
const SOON: f64 = 3.0;
/// How much cheaper than it was found to be the exponential method may be by now, and how much cheaper one
/// explicit pair may be than the other, and the Nyström pair than both.
const HOPE: f64 = 0.6;
const OTHER_PAIR: f64 = 0.8;
const NYSTROM_PAIR: f64 = 0.7;
/// How much cheaper than it was found to be an explicit pair cannot be by now, after the other one and after
/// the exponential method, which may have had its turn for long; the latter with every failure by half.
const NO_HOPE: [f64; 2] = [0.1, 0.45];
/// Evaluations by which a trial of a pair is dearer than one that needs no trial.
const PAIR_EVALUATIONS: f64 = 100.0;

/// How far a run has come.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Mark {
    /// s.
    pub time: f64,
    /// Cost of all that was done, s.
    pub spent: f64,
    pub steps: u64,
}

/// What is known and planned.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Selector {
    /// The method that walks.
    pub way: Way,
    /// The method that it is on trial against.
    pub against: Option<Way>,
    /// Where it took over, and where the window began that its cost is taken over.
    pub began: Mark,
    pub window: Mark,
    /// Whether the window is open: the step size has been found.
    pub open: bool,
    /// Cost per simulated time, by method; infinite where it is not known.
    pub rates: [f64; WAYS.len()],
    /// Cost of the run from which on another trial may be made.
    pub next_trial: f64,
    /// Trials of the exponential method that failed since the latest that did not, and of the pairs.
    pub failures: [f64; 2],
    /// Whether the exponential method has a linear part from an earlier stretch.
    pub linear_part: bool,
    /// Whether its cost is that of settled motion, found on a trial that was not won: what was expected of
    /// it is then no longer believed.
    pub disproved: bool,
}

/// What a selector decides by, besides what it has seen.
#[derive(Debug, Clone, Copy)]
pub(super) struct Outlook {
    pub prices: Prices,
    /// Simulated time that is left, s, and that which is left once the motion has settled.
    pub left: f64,
    pub settled: f64,
    /// Whether next to nothing is left of the start.
    pub decayed: bool,
    /// Cost per simulated time that the exponential method is expected to have; no number where nothing
    /// is known.
    pub exponential: f64,
    /// Whether surfaces were crossed of late: not for methods that step over them.
    pub contacts_change: bool,
}

impl Selector {
    /// Begins with a method at time 0.
    pub fn new(way: Way) -> Self {
        let start = Mark {
            time: 0.0,
            spent: 0.0,
            steps: 0,
        };
        Self {
            way,
            against: None,
            began: start,
            window: start,
            open: false,
            rates: [f64::INFINITY; WAYS.len()],
            next_trial: 0.0,
            failures: [0.0; 2],
            linear_part: false,
            disproved: false,
        }
    }

    /// Whether a run that has come so far is not to be looked at yet.
    pub fn is_waiting(&self, steps: u64) -> bool {
        let enough = if self.open { LEAST_STEPS } else { FIRST_STEPS };
        self.against.is_none() && steps - self.window.steps < enough
    }

    /// Looks at a run after a step, with some simulated time left, s; the method that is to go on, where it
    /// is another.
    pub fn look(&mut self, here: Mark, left: f64, outlook: impl Fn() -> Outlook) -> Option<Way> {
        let steps = here.steps - self.window.steps;
        if self.open && steps >= LEAST_STEPS {
            let rate = self.rate_of_window(here, left)?;
            return self.judge(here, rate, &outlook());
        }
        if !self.open && steps >= FIRST_STEPS {
            (self.open, self.window) = (true, here);
        }
        let against = self.against?;
        self.is_dear(here, against, &outlook())
            .then(|| self.fail(here, here, against, &outlook()))
    }

    /// Cost per simulated time of a window, once it is long enough.
    fn rate_of_window(&self, here: Mark, left: f64) -> Option<f64> {
        let spent = here.spent - self.window.spent;
        let rate = spent / (here.time - self.window.time);
        let first = self.rates[Way::Verner76 as usize] == f64::INFINITY;
        let part = if first { FIRST_PART } else { WINDOW_PART };
        (spent >= part * (here.spent + rate * left)).then_some(rate)
    }

    /// Looks at the cost per simulated time of a window.
    fn judge(&mut self, here: Mark, rate: f64, outlook: &Outlook) -> Option<Way> {
        let window = std::mem::replace(&mut self.window, here);
        let Some(against) = self.against else {
            let known = self.rates[self.way as usize];
            let weight = if known.is_finite() { LATEST } else { 1.0 };
            let before = if known.is_finite() { known } else { 0.0 };
            self.rates[self.way as usize] = before + weight * (rate - before);
            let next = self.candidate(here, outlook);
            let left = self.way == Way::Exponential && next.is_some();
            self.disproved |= left && outlook.decayed;
            return next;
        };
        if rate < self.rates[against as usize] {
            self.rates[self.way as usize] = rate;
            self.against = None;
            self.failures[usize::from(self.way != Way::Exponential)] = 0.0;
            self.next_trial = here.spent + PAID_OFF * self.loss(here, against).max(0.0);
            return None;
        }
        if self.falls(against, outlook) && !self.is_dear(here, against, outlook) {
            return None;
        }
        Some(self.fail(window, here, against, outlook))
    }

    /// Another method takes over: on trial, where it is not known to be the better one.
    pub fn change(&mut self, here: Mark, way: Way) {
        let known = self.rates[way as usize] < self.rates[self.way as usize];
        self.against = (!known).then_some(self.way);
        self.linear_part |= way == Way::Exponential;
        (self.began, self.window, self.open) = (here, here, false);
        self.way = way;
    }

    /// Has a method be so dear that it is not tried again.
    pub fn rule_out(&mut self, way: Way) {
        self.rates[way as usize] = f64::MAX;
    }

    /// Leaves a method that cannot go over what is ahead; the method to go on with.
    pub fn turn_back(&mut self, here: Mark, outlook: &Outlook) -> Way {
        if let Some(against) = self.against {
            return self.fail(here, here, against, outlook);
        }
        // as if it had never been: it is no better than the others while this lasts
        self.rates[self.way as usize] = f64::INFINITY;
        let least = PAIR_EVALUATIONS * outlook.prices.evaluation[Way::Verner76 as usize];
        self.next_trial = here.spent + PAID_OFF * least;
        let [verner, dop853] = [Way::Verner76, Way::Dop853].map(|way| self.rates[way as usize]);
        if dop853 < verner {
            Way::Dop853
        } else {
            Way::Verner76
        }
    }

    /// Ends a trial whose cost is taken from a mark on; the method to go back to.
    fn fail(&mut self, from: Mark, here: Mark, against: Way, outlook: &Outlook) -> Way {
        let from = if from == here { self.began } else { from };
        let rate = (here.spent - from.spent) / (here.time - from.time);
        // it comes here where it is dearer, whatever the window says
        self.rates[self.way as usize] = rate.max(self.rates[against as usize]);
        self.disproved |= self.way == Way::Exponential && outlook.decayed;
        self.against = None;
        let times = if self.falls(against, outlook) {
            SOON.powf(1.0 + self.failures[0]).min(PAID_OFF)
        } else {
            PAID_OFF
        };
        let least = PAIR_EVALUATIONS * outlook.prices.evaluation[Way::Verner76 as usize];
        self.next_trial = here.spent + times * self.loss(here, against).max(least);
        self.failures[usize::from(self.way != Way::Exponential)] += 1.0;
        against
    }

    /// What the present stretch has cost beyond what another method takes for it.
    fn loss(&self, here: Mark, against: Way) -> f64 {
        let rate = self.rates[against as usize];
        here.spent - self.began.spent - rate * (here.time - self.began.time)
    }

    /// Whether the method on trial is expected to come to cost less than the other one.
    fn falls(&self, against: Way, outlook: &Outlook) -> bool {
        self.way == Way::Exponential && self.expected(outlook) < self.rates[against as usize]
    }

    /// Cost per simulated time that the exponential method is expected to have; no number where nothing is
    /// known.
    fn expected(&self, outlook: &Outlook) -> f64 {
        let known = self.rates[Way::Exponential as usize];
        if self.disproved && known.is_finite() {
            outlook.exponential.max(self.exponential_hope() * known)
        } else {
            outlook.exponential
        }
    }

    /// Whether a trial has cost too much to go on.
    fn is_dear(&self, here: Mark, against: Way, outlook: &Outlook) -> bool {
        let other = self.rates[against as usize];
        let saved = if self.falls(against, outlook) {
            (other - self.expected(outlook)) * outlook.left
        } else {
            0.0
        };
        let allowed = self.beginning(self.way, outlook)
            + BLIND * other * outlook.left
            + PATIENCE / (1.0 + 2.0 * self.failures[0]) * saved;
        self.loss(here, against) > allowed
    }

    /// What a method costs before its first step.
    fn beginning(&self, way: Way, outlook: &Outlook) -> f64 {
        match way {
            Way::Exponential if self.linear_part => outlook.prices.step_size,
            Way::Exponential => outlook.prices.first_steps(),
            _ => PAIR_EVALUATIONS * outlook.prices.evaluation[way as usize],
        }
    }

    /// The method that promises most, where any is worth a trial.
    fn candidate(&self, here: Mark, outlook: &Outlook) -> Option<Way> {
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
        let own = self.rates[self.way as usize];
        let beginning = self.beginning(way, outlook);
        if way == Way::Dprkn8 && outlook.contacts_change {
            return 0.0;
        }
        let hoped = self.hoped(way, outlook);
        let expected =
            way == Way::Exponential && self.expected(outlook).max(hoped.unwrap_or(0.0)) < own;
        if !expected && beginning >= BLIND * own * outlook.left {
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

    /// Least cost per simulated time that a method may have by now, where anything is known.
    fn hoped(&self, way: Way, outlook: &Outlook) -> Option<f64> {
        let known = self.rates[way as usize];
        if known == f64::MAX {
            return Some(known);
        }
        let hoped = match way {
            // both fall as a motion settles
            Way::Exponential => (self.exponential_hope() * known).min(self.expected(outlook)),
            _ if known.is_finite() => self.pair_hope() * known,
            Way::Verner76 => OTHER_PAIR * self.rates[Way::Dop853 as usize],
            Way::Dop853 => OTHER_PAIR * self.rates[Way::Verner76 as usize],
            Way::Dprkn8 => NYSTROM_PAIR * self.rates[Way::Verner76 as usize],
        };
        hoped.is_finite().then_some(hoped)
    }

    /// Part of its known cost that the exponential method may have by now: of settled motion it is known ever
    /// better with every failure.
    fn exponential_hope(&self) -> f64 {
        if self.disproved {
            1.0 - (1.0 - HOPE) * 0.5_f64.powf(self.failures[0])
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
            1.0 - after_pair
        }
    }
}
