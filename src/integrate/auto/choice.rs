//! What a run has cost, what is ahead of it, and the choice that follows.

use super::beforehand::Beforehand;
use super::cost::{Prices, WAYS, Way};
use super::selector::{Mark, Outlook};
use super::walk::AutoWalk;
use crate::integrate::Linearised;
use crate::integrate::course::Course;

/// Tolerance from which on Dormand and Prince's pair takes fewer evaluations than Verner's.
const FINE: f64 = 1e-10;

impl<const N: usize> AutoWalk<N> {
    /// Goes over to another method where the latest step leads to it.
    pub(super) fn choose<S: Linearised<N>>(&mut self, course: &Course<'_, S, N>) {
        if self.beforehand.is_none() && self.time() == 0.0 {
            self.begin(course);
        }
        if self.selector.is_waiting(self.steps()) {
            return;
        }
        let known = self.beforehand(course);
        let (here, before) = (self.mark(&known.prices), self.selector);
        let mut selector = before;
        let left = course.end - here.time;
        let way = selector.look(here, left, || self.outlook(course, &known));
        self.selector = selector;
        // what was crossed in a window is of no account after it
        self.contacts_change &= !before.open || selector.window == before.window;
        if let Some(way) = way {
            self.change(here, way);
        }
    }

    /// Begins with another method than Verner's pair where that is expected to be the cheaper one.
    fn begin<S: Linearised<N>>(&mut self, course: &Course<'_, S, N>) {
        let known = self.beforehand(course);
        let (here, outlook) = (self.mark(&known.prices), self.outlook(course, &known));
        let tolerance = course.settings.tolerance;
        let way = self.selector.first(known.pair(tolerance), &outlook);
        if way != self.selector.way {
            self.explicit_size = known.pair_step(tolerance);
            self.change(here, way);
        }
    }

    /// Lets the explicit pair go on that always can, and the present method never again.
    pub(super) fn give_up_method<S: Linearised<N>>(&mut self, course: &Course<'_, S, N>) {
        let prices = self.beforehand(course).prices;
        let here = self.mark(&prices);
        self.selector.rule_out(self.selector.way);
        self.change(here, Way::Verner76);
    }

    /// What is ahead of the run.
    fn outlook<S: Linearised<N>>(&self, course: &Course<'_, S, N>, known: &Beforehand) -> Outlook {
        let time = self.time();
        Outlook {
            prices: known.prices,
            left: course.end - time,
            settled: course.end - time.max(known.settled),
            decayed: time > known.decayed,
            exponential: if self.contacts_change {
                f64::NAN
            } else {
                known.exponential(course, time)
            },
            crossings: known.crossings,
            contacts_change: self.contacts_change,
            rings: known.rings(time),
            bounces: known.bounces,
        }
    }

    /// What is known beforehand; as it is asked for, also which pairs are out of the question.
    fn beforehand<S: Linearised<N>>(&mut self, course: &Course<'_, S, N>) -> Beforehand {
        if let Some(known) = self.beforehand {
            return known;
        }
        if course.system.velocity_slopes().is_err() {
            self.selector.rule_out(Way::Dprkn8);
        }
        if course.settings.tolerance > FINE {
            self.selector.rule_out(Way::Dop853);
        }
        let known = Beforehand::of(course);
        self.beforehand = Some(known);
        known
    }

    /// How far the run has come.
    fn mark(&self, prices: &Prices) -> Mark {
        Mark {
            time: self.time(),
            spent: self.spent(prices),
            steps: self.steps(),
        }
    }

    /// Cost of all that was done, s.
    fn spent(&self, prices: &Prices) -> f64 {
        let [linear_parts, sizes] = self.exponential.preparations().map(|count| count as f64);
        let evaluations =
            WAYS.map(|way| self.work(way).evaluations as f64 * prices.evaluation[way as usize]);
        let steps = self.work(Way::Dprkn8).steps as f64;
        let samples = self.covered_by(Way::Dprkn8) / self.exponential.interval();
        evaluations.iter().sum::<f64>()
            + samples * prices.nystrom_sample
            + samples.min(steps) * prices.nystrom_first_sample
            + linear_parts * prices.linear_part
            + sizes * prices.step_size
    }
}
