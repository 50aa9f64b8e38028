//! When to try which method, and which to keep: numbers alone.

use super::cost::{Prices, WAYS, Way};
use super::promises::{NYSTROM_PAIR, PAIR_EVALUATIONS};

/// Steps before a window, while a method finds its step size, and steps of a window at least.
const FIRST_STEPS: u64 = 7;
const LEAST_STEPS: u64 = 10;
/// Length of a window as a part of what the whole run is expected to cost, and of the very first one.
const WINDOW_PART: f64 = 0.01;
const FIRST_PART: f64 = 0.001;
/// Weight of the latest window in the cost of a method that is not on trial.
const LATEST: f64 = 0.5;
/// Cost of a pair, in that of the exponential method, that is no less: where the latter is not the cheaper one its error
/// is far below the tolerance.
pub(super) const EVEN: f64 = 0.7;
/// The same of one pair in that of another.
const NEARLY: f64 = 0.9;
/// Part of what is left of the run that a trial may cost, and of what it is expected to save.
const BLIND: f64 = 0.02;
const PATIENCE: f64 = 0.06;
/// A trial that failed is paid off by so many times its loss before the next.
const PAID_OFF: f64 = 20.0;
/// The same where a method is expected to become cheaper than it was, and its growth with every failure.
const SOON: f64 = 3.0;

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
    /// Whether the cost of Verner's pair is what is expected of it, before it was seen.
    pub assumed: bool,
    /// Whether the cost of the exponential method is that of settled motion, found on a trial that was not won: what
    /// was expected of it is then no longer believed.
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
    /// How often surfaces are crossed at rest, 1/s.
    pub crossings: f64,
    /// Whether the motion is to ring with blows for much of the time to come.
    pub rings: bool,
    /// Whether blows come to contacts of which some are open at rest.
    pub bounces: bool,
    /// Whether surfaces were crossed of late: not for methods that step over them.
    pub contacts_change: bool,
}

impl Outlook {
    /// Whether the motion is known to go over surfaces, again and again or of late.
    pub fn goes_over_surfaces(&self) -> bool {
        self.contacts_change || self.bounces || self.crossings > 0.0
    }
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
            assumed: false,
            disproved: false,
        }
    }

    /// Whether a run that has come so far is not to be looked at yet.
    pub fn is_waiting(&self, steps: u64) -> bool {
        let since = steps - self.window.steps;
        let waits = if self.open {
            !since.is_multiple_of(LEAST_STEPS) || since == 0
        } else {
            since < FIRST_STEPS
        };
        self.against.is_none() && waits
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
            if known.is_finite() {
                let rate = known + LATEST * (rate - known);
                self.carry_along(rate / known);
                self.rates[self.way as usize] = rate;
            } else {
                self.rates[self.way as usize] = rate;
            }
            let next = self.candidate(here, outlook);
            let left = self.way == Way::Exponential && next.is_some();
            self.disproved |= left && outlook.decayed;
            return next;
        };
        let falls = self.falls(against, outlook);
        let due = if falls { 1.0 } else { self.due(against) };
        if rate < due * self.rates[against as usize] {
            self.against = None;
            self.failures[usize::from(self.way != Way::Exponential)] = 0.0;
            // what was assumed says nothing of what was lost
            let lost = if self.assumed {
                0.0
            } else {
                self.loss(here, against).max(0.0)
            };
            self.next_trial = here.spent + PAID_OFF * lost;
            self.learn(rate);
            return None;
        }
        if falls && !self.is_dear(here, against, outlook) {
            return None;
        }
        Some(self.fail(window, here, against, outlook))
    }

    /// Another method takes over: on trial, where it is not known to be the better one.
    pub fn change(&mut self, here: Mark, way: Way) {
        let known = self.rates[way as usize] < self.rates[self.way as usize];
        self.against = (!known).then_some(self.way);
        self.linear_part |= self.way == Way::Exponential;
        (self.began, self.window, self.open) = (here, here, false);
        self.way = way;
    }

    /// Has a method be so dear that it is not tried again.
    pub fn rule_out(&mut self, way: Way) {
        self.rates[way as usize] = f64::MAX;
    }

    /// Ends a trial whose cost is taken from a mark on; the method to go back to.
    fn fail(&mut self, from: Mark, here: Mark, against: Way, outlook: &Outlook) -> Way {
        let from = if from == here { self.began } else { from };
        let rate = (here.spent - from.spent) / (here.time - from.time);
        // it comes here where it is dearer, whatever the window says
        self.rates[self.way as usize] = rate.max(self.rates[against as usize]);
        // against what was only assumed it has not been seen far beyond the first steps, which are like no others
        let is_settled = outlook.decayed && !self.assumed;
        self.disproved |= self.way == Way::Exponential && is_settled;
        self.against = None;
        let times = if self.falls(against, outlook) {
            SOON.powf(1.0 + self.failures[0]).min(PAID_OFF)
        } else {
            PAID_OFF
        };
        let least = PAIR_EVALUATIONS * outlook.prices.evaluation[Way::Verner76 as usize];
        self.next_trial = here.spent + times * self.loss(here, against).max(least);
        self.failures[usize::from(self.way != Way::Exponential)] += 1.0;
        if against == Way::Verner76 {
            self.assume_no_more();
        }
        against
    }

    /// Forgets what Verner's pair was assumed to cost: it will be seen.
    fn assume_no_more(&mut self) {
        if self.assumed {
            (self.rates[Way::Verner76 as usize], self.assumed) = (f64::INFINITY, false);
        }
    }

    /// Takes the costs of the other explicit pairs to have changed as that of the one that walks.
    fn carry_along(&mut self, factor: f64) {
        if self.way != Way::Exponential {
            for way in [Way::Verner76, Way::Dop853, Way::Dprkn8] {
                let rate = &mut self.rates[way as usize];
                if *rate < f64::MAX {
                    *rate *= factor;
                }
            }
        }
    }

    /// Knows what the method costs that walks.
    fn learn(&mut self, rate: f64) {
        self.rates[self.way as usize] = rate;
        match self.way {
            Way::Verner76 => self.assumed = false,
            Way::Dprkn8 if self.assumed => {
                self.rates[Way::Verner76 as usize] = rate / NYSTROM_PAIR;
            }
            _ => {}
        }
    }

    /// What the present stretch has cost beyond what another method takes for it.
    fn loss(&self, here: Mark, against: Way) -> f64 {
        self.spent_beyond(here, self.rates[against as usize])
    }

    /// The same beyond a cost per simulated time.
    fn spent_beyond(&self, here: Mark, rate: f64) -> f64 {
        here.spent - self.began.spent - rate * (here.time - self.began.time)
    }

    /// Whether the method on trial is expected to come to cost less than the other one.
    fn falls(&self, against: Way, outlook: &Outlook) -> bool {
        self.way == Way::Exponential && self.expected(outlook) < self.rates[against as usize]
    }

    /// Cost of the method on trial, in that of the other one, below which it is the better one.
    fn due(&self, against: Way) -> f64 {
        match (self.way, against) {
            (_, Way::Exponential) => EVEN,
            (Way::Exponential, _) => 1.0 / EVEN,
            // what is about as dear is no better, and errors are spoilt by changing to and fro
            _ => NEARLY,
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
        let due = self.due(against).max(1.0) * other;
        self.spent_beyond(here, due) > allowed
    }
}
