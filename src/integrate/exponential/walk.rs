//! Steps of the method, one after the other, and the states at samples within them.

use super::dense::Cursor;
use super::kept::Propagators;
use super::linear::{LinearPart, Place};
use super::mean::Mean;
use super::nodes::{NODES, POINTS, Points, combined, weights};
use super::plan::Leg;
use super::renewal::{Renewal, USUAL_SWEEPS};
use super::sweeps::{self, Ending, Trial, slow_part};
use crate::integrate::course::Course;
use crate::integrate::{Counters, IntegrateError, Linearised, Scaling};

/// Power of the size that the error estimate falls with.
const ERROR_POWER: f64 = POINTS as f64;
/// Safety of the next size, and the least and largest change of it.
const SAFETY: f64 = 0.8;
const SHRINK: f64 = 0.2;
const GROW: f64 = 8.0;
/// Least error that counts: growth is limited anyway.
const LEAST_ERROR: f64 = 1e-12;
/// Ratio of a step to the one before up to which the polynomial of that one is carried on into it: beyond, as
/// behind a step that was cut next to a sample, it is round-off by powers of the ratio, and sweeps that begin
/// so far off seem to meet faster than they do.
const MOST_AHEAD: f64 = 16.0;
/// Steps after which the fall of the change from sweep to sweep is measured again.
const RATE_HOLDS: f64 = 8.0;

/// The latest step, and how to go on. States are kept as deviations from the scaling's origin.
#[derive(Debug, Clone)]
pub(in crate::integrate) struct Walk<const N: usize> {
    /// Interval of the samples, s.
    interval: f64,
    /// Start and end of the latest step, s.
    pub(super) start: f64,
    pub(super) time: f64,
    /// Size of the latest step, s, and how many intervals of samples it lasted, zero if no whole number.
    pub(super) size: f64,
    pub(super) intervals: f64,
    /// Size that the error would allow the next step, s.
    pub(super) wish: f64,
    /// Next break, s: no step reaches over it.
    pub(super) limit: f64,
    pub(super) leg: Leg,
    /// The start and the end of the latest step.
    pub(super) from: Place<N>,
    pub(super) to: Place<N>,
    /// The mean of the ends of the latest steps.
    pub(super) mean: Mean<N>,
    /// Coordinates of the slow part at the points of the latest step, and that step's size; with a size of zero only
    /// its value at the end is known.
    pub(super) slow: Points<N>,
    pub(super) slow_size: f64,
    pub(super) linear: LinearPart<N>,
    /// Whether the linear part is that of the start of the step.
    pub(super) fresh: bool,
    /// Fall of the change from sweep to sweep, steps since it was measured, and the size of that step, s.
    pub(super) rate: f64,
    pub(super) since_rate: f64,
    pub(super) rate_size: f64,
    /// When a better linear part pays.
    pub(super) renewal: Renewal,
    /// Whether the latest trial was rejected.
    pub(super) rejected: bool,
    /// Whether a trial since the latest good step was not finite.
    fault: bool,
    pub(super) counters: Counters,
    pub(super) propagators: Propagators<N>,
    /// Weights that carry the polynomial on into a step whose size is in a ratio to the latest one's.
    ahead: [[f64; POINTS]; POINTS],
    ahead_ratio: f64,
    /// The latest sample within the step.
    cursor: Option<Cursor<N>>,
}

impl<const N: usize> Walk<N> {
    /// At a time, s, in a deviation from the origin, on a grid of samples, after so much work; a size of zero lets the
    /// first step find its own.
    pub fn new(
        [time, interval]: [f64; 2],
        deviation: [f64; N],
        size: f64,
        counters: Counters,
    ) -> Self {
        let linear = LinearPart::none();
        let place = linear.place(deviation);
        Self {
            interval,
            start: time,
            time,
            size: 0.0,
            intervals: 0.0,
            wish: size,
            limit: time,
            leg: Leg::ENDED,
            from: place,
            to: place,
            mean: Mean::of(deviation),
            slow: [[0.0; N]; POINTS],
            slow_size: 0.0,
            linear,
            fresh: false,
            rate: 1.0,
            since_rate: 0.0,
            rate_size: 0.0,
            // the first step takes a linear part
            renewal: Renewal::NONE,
            rejected: false,
            fault: false,
            counters,
            propagators: Propagators::new(),
            ahead: [[0.0; POINTS]; POINTS],
            ahead_ratio: 0.0,
            cursor: None,
        }
    }

    /// Deviation at the end of the latest step.
    pub fn deviation(&self) -> [f64; N] {
        self.to.deviation
    }

    /// End of the latest step, s.
    pub fn time(&self) -> f64 {
        self.time
    }

    /// Size that the error would allow the next step, s; zero before the first.
    pub fn step_size(&self) -> f64 {
        self.wish
    }

    /// Scaled state at the end of the latest step.
    pub fn scaled(&self, scaling: &Scaling<N>) -> [f64; N] {
        std::array::from_fn(|i| self.to.deviation[i] / scaling.scale[i])
    }

    /// Work done so far.
    pub fn counters(&self) -> Counters {
        self.counters
    }

    /// State at a sample that is neither before the start of the latest step nor after its end.
    pub fn state_within<S>(&mut self, course: &Course<'_, S, N>, time: f64) -> [f64; N] {
        let deviation = if time >= self.time {
            self.to.deviation
        } else {
            self.within(time)
        };
        course.state(&deviation)
    }

    /// Deviation at a sample within the latest step.
    fn within(&mut self, time: f64) -> [f64; N] {
        let index = ((time - self.start) / self.interval).round();
        let phi = self.propagators.samples(&self.linear, self.interval);
        let cursor = match &mut self.cursor {
            Some(cursor) if cursor.index() <= index => cursor,
            before => {
                let intervals = [self.interval, self.intervals];
                let start = self.from.coordinates;
                before.insert(Cursor::new(start, &self.slow, intervals, phi, &self.linear))
            }
        };
        cursor.go_to(index, phi, &self.linear)
    }

    /// Takes a step.
    ///
    /// # Errors
    /// Why the walk ends here.
    pub fn step<S: Linearised<N>>(
        &mut self,
        course: &Course<'_, S, N>,
    ) -> Result<(), IntegrateError> {
        self.begin(course);
        loop {
            course.check(self.start, self.wish, &self.counters, self.fault)?;
            self.plan();
            let ends = [self.start, self.start + self.size];
            course.check_progress(ends, self.size, self.fault)?;
            let (ending, sweeps) = self.trial(course);
            match ending {
                Ending::Met(error) if error <= 1.0 => {
                    self.accept(error, sweeps);
                    return Ok(());
                }
                Ending::Met(error) => {
                    self.renewal.count_rejected(sweeps, 1);
                    self.reject(SAFETY * error.powf(-1.0 / ERROR_POWER));
                }
                Ending::Apart => {
                    self.renewal.count_rejected(sweeps, sweeps::MOST);
                    self.bring_together(course);
                }
                Ending::NotFinite => {
                    self.renewal.count_rejected(sweeps, 1);
                    self.fault = true;
                    self.reject(SHRINK);
                }
            }
        }
    }

    /// Makes the end of the latest step the start of the next.
    fn begin<S: Linearised<N>>(&mut self, course: &Course<'_, S, N>) {
        self.start = self.time;
        self.from = self.to;
        self.cursor = None;
        let behind_break = self.time >= self.limit;
        if behind_break {
            self.limit = course.system.next_break(self.time + course.slack);
            self.mean = Mean::of(self.from.deviation);
        }
        if self.renewal.pays() {
            self.renew(course);
        } else if behind_break {
            self.forget(course);
        }
        if self.wish <= 0.0 {
            // a moment that changes its sign as the shaft starts is over at once: nothing is missed
            self.wish = course.scaling.time.min(1.0 / self.linear.norm);
        }
    }

    /// Takes the linear part anew, about where the motion was of late.
    fn renew<S: Linearised<N>>(&mut self, course: &Course<'_, S, N>) {
        let state = course.state(&self.mean.deviation);
        let (slopes, _) = course.system.linearisation(self.start, &state);
        self.linear = LinearPart::new(slopes.data.0, self.linear.level);
        self.from = self.linear.place(self.from.deviation);
        (self.fresh, self.rate) = (true, 1.0);
        self.renewal.renew();
        self.propagators.clear();
        self.forget(course);
    }

    /// Forgets the slow part before the start, which is no guess of what follows.
    fn forget<S: Linearised<N>>(&mut self, course: &Course<'_, S, N>) {
        self.slow_size = 0.0;
        self.slow[POINTS - 1] = slow_part(&self.linear, course, self.start, &self.from);
        self.counters.evaluations += 1;
    }

    /// Chooses the size of the step to come.
    fn plan(&mut self) {
        self.leg = if self.leg.left == 0.0 || self.leg.intervals > 0.0 {
            Leg::new(self.start, self.wish, self.interval, self.limit)
        } else {
            self.leg.adapted(self.wish)
        };
        (self.size, self.intervals) = (self.leg.size, self.leg.intervals);
    }

    /// Tries a step; how it ended, and after how many sweeps.
    fn trial<S: Linearised<N>>(&mut self, course: &Course<'_, S, N>) -> (Ending, u32) {
        let guess = self.guess();
        let span = [self.start, self.size, self.limit.next_down()];
        // a longer step's sweeps fall more slowly: by how much it has to find out by itself
        let rate = if self.since_rate < RATE_HOLDS && self.size <= self.rate_size {
            self.rate
        } else {
            1.0
        };
        let operator = self.propagators.of(&self.linear, self.size);
        let from = &self.from;
        let mut trial = Trial::new(course, &self.linear, operator, span, from, guess, rate);
        let ending = trial.run();
        let Trial {
            slow,
            to,
            rate,
            sweeps,
            ..
        } = trial;
        self.counters.evaluations += u64::from(sweeps) * (POINTS as u64 - 1);
        if matches!(ending, Ending::Met(error) if error <= 1.0) {
            (self.to, self.slow, self.slow_size) = (to, slow, self.size);
        }
        if sweeps > 1 {
            (self.rate, self.rate_size, self.since_rate) = (rate, self.size, 0.0);
        }
        (ending, sweeps)
    }

    /// The slow part at the points of the step to come, by the polynomial of the latest one.
    fn guess(&mut self) -> Points<N> {
        let start = self.slow[POINTS - 1];
        let mut guess = [start; POINTS];
        if self.slow_size == 0.0 {
            return guess;
        }
        let ratio = self.size / self.slow_size;
        if ratio > MOST_AHEAD {
            return guess;
        }
        if ratio != self.ahead_ratio {
            self.ahead_ratio = ratio;
            self.ahead = NODES.part.map(|part| weights(1.0 + ratio * part));
        }
        for (guess, ahead) in guess.iter_mut().zip(&self.ahead).skip(1) {
            *guess = combined(ahead, &self.slow);
        }
        guess
    }

    fn accept(&mut self, error: f64, sweeps: u32) {
        let most = if self.rejected || sweeps > USUAL_SWEEPS + 1 {
            1.0
        } else {
            GROW
        };
        let growth = SAFETY * error.max(LEAST_ERROR).powf(-1.0 / ERROR_POWER);
        let proposed = self.size * growth.clamp(SHRINK, most);
        // a size far below the wish was cut by a break or a sample, and tells little
        self.wish = if self.size < 0.5 * self.wish {
            proposed.max(self.wish)
        } else {
            proposed
        };
        self.mean.take_in(&self.to.deviation);
        self.renewal.count_step(self.size, sweeps);
        self.since_rate += 1.0;
        (self.rejected, self.fault, self.fresh) = (false, false, false);
        self.counters.steps += 1;
        self.leg.left -= 1.0;
        self.time = if self.leg.left == 0.0 {
            self.leg.end
        } else {
            self.start + self.size
        };
    }

    fn reject(&mut self, factor: f64) {
        self.rejected = true;
        self.counters.rejected += 1;
        self.wish = self.size * if factor >= SHRINK { factor } else { SHRINK };
    }

    /// After sweeps that did not meet: a new linear part once it pays, else a shorter step.
    fn bring_together<S: Linearised<N>>(&mut self, course: &Course<'_, S, N>) {
        if self.fresh || !self.renewal.pays() {
            self.reject(0.5);
        } else {
            self.counters.rejected += 1;
            self.rejected = true;
            self.renew(course);
        }
    }
}

#[cfg(test)]
#[path = "walk_tests.rs"]
mod tests;
