//! What a run has cost, what is ahead of it, and the choice that follows.

use super::cost::{Prices, WAYS, Way};
use super::selector::{Mark, Outlook};
use super::walk::AutoWalk;
use crate::integrate::Linearised;
use crate::integrate::course::Course;

/// Evaluations of the exponential method per radian of what drives a settled motion, at a tolerance.
const EVALUATIONS_PER_RADIAN: f64 = 20.0;
const AT_TOLERANCE: f64 = 1e-8;
/// Root of the tolerance that they fall with.
const ROOT: f64 = -1.0 / 7.0;
/// Step sizes that a break adds to those of the exponential method: up to it and after it.
const SIZES_PER_BREAK: f64 = 2.0;
/// Mean decay times of the modes after which what is left of the start costs the exponential method little.
const DECAYS: f64 = 2.0;
/// The same in radians of their oscillation where they hardly decay: the method takes them exactly.
const RADIANS: f64 = 50.0;
/// Mean decay times of the modes after which next to nothing is left of the start.
const DECAYED: f64 = 4.0;
/// Breaks that are looked ahead to.
const BREAKS: u32 = 8;

impl<const N: usize> AutoWalk<N> {
    /// Goes over to another method where the latest step leads to it.
    pub(super) fn choose<S: Linearised<N>>(&mut self, course: &Course<'_, S, N>) {
        if self.selector.is_waiting(self.counters().steps) {
            return;
        }
        let prices = self.prices(course);
        let (here, before) = (self.mark(&prices), self.selector);
        let mut selector = before;
        let left = course.end - here.time;
        let way = selector.look(here, left, || self.outlook(course, prices));
        self.selector = selector;
        // what was crossed in a window is of no account after it
        self.contacts_change &= !before.open || selector.window == before.window;
        if let Some(way) = way {
            self.change(here, way);
        }
    }

    /// Leaves a stretch of the Nyström pair that comes to a surface.
    pub(super) fn turn_back<S: Linearised<N>>(&mut self, course: &Course<'_, S, N>) {
        let prices = self.prices(course);
        let (here, outlook) = (self.mark(&prices), self.outlook(course, prices));
        let way = self.selector.turn_back(here, &outlook);
        self.change(here, way);
        self.contacts_change = true;
    }

    /// Lets the explicit pair go on that always can, and the present method never again.
    pub(super) fn give_up_method<S: Linearised<N>>(&mut self, course: &Course<'_, S, N>) {
        let prices = self.prices(course);
        let here = self.mark(&prices);
        self.selector.rule_out(self.selector.way);
        self.change(here, Way::Verner76);
    }

    /// What is ahead of the run.
    fn outlook<S: Linearised<N>>(&self, course: &Course<'_, S, N>, prices: Prices) -> Outlook {
        let time = self.time();
        Outlook {
            prices,
            left: course.end - time,
            settled: course.end - time.max(self.settled_from[0]),
            decayed: time > self.settled_from[1],
            exponential: if self.contacts_change {
                f64::NAN
            } else {
                let samples =
                    prices.sample[Way::Exponential as usize] / self.exponential.interval();
                settled_cost(course, time, &prices) + samples
            },
            contacts_change: self.contacts_change,
        }
    }

    /// Prices for the system; as it is asked for them, also whether a Nyström pair serves it.
    fn prices<S: Linearised<N>>(&mut self, course: &Course<'_, S, N>) -> Prices {
        if let Some(prices) = self.prices {
            return prices;
        }
        if course.system.velocity_slopes().is_err() {
            self.selector.rule_out(Way::Dprkn8);
        }
        let prices = Prices::new(course.system.effort(), N);
        self.prices = Some(prices);
        self.settled_from = settled_from(course);
        prices
    }

    /// How far the run has come.
    fn mark(&self, prices: &Prices) -> Mark {
        Mark {
            time: self.time(),
            spent: self.spent(prices),
            steps: self.counters().steps,
        }
    }

    /// Cost of all that was done, s.
    fn spent(&self, prices: &Prices) -> f64 {
        let [linear_parts, sizes] = self.exponential.preparations().map(|count| count as f64);
        let walks = WAYS.map(|way| {
            let (work, number) = (self.work(way), way as usize);
            let samples = self.covered_by(way) / self.exponential.interval();
            work.evaluations as f64 * prices.evaluation[number]
                + samples * prices.sample[number]
                + samples.min(work.steps as f64) * prices.first_sample[number]
        });
        walks.iter().sum::<f64>() + linear_parts * prices.linear_part + sizes * prices.step_size
    }
}

/// When a motion has settled by and large, by the mean decay and frequency of its modes at the origin, and
/// when next to nothing is left of its start, s.
fn settled_from<S: Linearised<N>, const N: usize>(course: &Course<'_, S, N>) -> [f64; 2] {
    let (slopes, _) = course.system.linearisation(0.0, &course.scaling.origin);
    let decay = -slopes.trace() / N as f64;
    // Σ λ² = tr J²
    let square = -slopes.component_mul(&slopes.transpose()).sum() / N as f64;
    if decay <= 0.0 {
        return [0.0, f64::INFINITY];
    }
    let by_decay = DECAYS / decay;
    let settled = if square > 0.0 {
        by_decay.min(RADIANS / square.sqrt())
    } else {
        by_decay
    };
    [settled, DECAYED / decay]
}

/// Cost per simulated time that the exponential method is expected to have once the motion has settled,
/// without samples.
fn settled_cost<S: Linearised<N>, const N: usize>(
    course: &Course<'_, S, N>,
    time: f64,
    prices: &Prices,
) -> f64 {
    let finer = (course.settings.tolerance / AT_TOLERANCE).powf(ROOT);
    let evaluations = EVALUATIONS_PER_RADIAN * finer * course.system.pace(time, course.end);
    let sizes = SIZES_PER_BREAK * breaks_per_time(course, time);
    evaluations * prices.evaluation[Way::Exponential as usize] + sizes * prices.step_size
}

/// How often the system breaks from a time on, 1/s.
fn breaks_per_time<S: Linearised<N>, const N: usize>(course: &Course<'_, S, N>, from: f64) -> f64 {
    let (mut time, mut count) = (from, 0);
    while count < BREAKS {
        let next = course.system.next_break(time + course.slack);
        if next >= course.end {
            return f64::from(count) / (course.end - from);
        }
        (time, count) = (next, count + 1);
    }
    f64::from(count) / (time - from)
}
