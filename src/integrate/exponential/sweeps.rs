//! A trial step: sweeps over its points until the slow part there is that of the states there.

use super::linear::{LinearPart, Place};
use super::nodes::{NODES, POINTS, Points, SPARE, combined};
use super::propagator::Propagator;
use crate::integrate::System;
use crate::integrate::course::Course;

/// Error allowed in one step, as a part of the error aimed at over the run: measured.
const LOCAL_PART: f64 = 0.05;
/// The same where damping is over long before the step is: what the polynomial misses is then followed at once.
const STIFF_PART: f64 = 0.03;
/// Product of a step's size and the fastest damping from which on it is.
const STIFF: f64 = 10.0;
/// The loosest tolerance that is gone by. Beyond it sweeps under strong damping of the contacts meet where
/// the motion is not, and what follows costs more than it saves.
const LOOSEST: f64 = 1e-2;
/// Part of it that sweeps which are not made may leave.
const REST: f64 = 0.03;
/// Most sweeps of a trial.
pub(super) const MOST: u32 = 6;
/// Fall of the change from sweep to sweep that is not worth another.
const SLOWEST: f64 = 0.7;
/// Least fall that is believed, and factor of the caution where it is an earlier step's.
const LEAST_RATE: f64 = 1e-3;
/// Part of the fall so far below which it is not believed: what falls fast goes first, and what is left
/// falls more slowly.
const LASTING: f64 = 0.7;
const CAUTION: f64 = 3.0;

/// A trial step that is under way.
pub(super) struct Trial<'a, S, const N: usize> {
    pub course: &'a Course<'a, S, N>,
    pub linear: &'a LinearPart<N>,
    pub operator: &'a Propagator<N>,
    pub start: f64,
    pub size: f64,
    /// Time that no evaluation reaches, s.
    pub limit: f64,
    pub from: &'a Place<N>,
    /// Coordinates of the slow part at the points: known at the first, guessed at the others.
    pub slow: Points<N>,
    pub to: Place<N>,
    /// Deviations at the points between, as the latest sweep had them.
    pub states: Points<N>,
    /// Reciprocals of the errors allowed.
    inverse: [f64; N],
    /// Fall of the change from sweep to sweep: of an earlier step, then of this one; one where none is
    /// known.
    pub rate: f64,
    pub sweeps: u32,
}

/// How the sweeps ended.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Ending {
    /// They met; the error over what is allowed.
    Met(f64),
    /// They do not meet, or too slowly.
    Apart,
    NotFinite,
}

impl<'a, S: System<N>, const N: usize> Trial<'a, S, N> {
    /// A trial from a guess.
    pub fn new(
        course: &'a Course<'a, S, N>,
        linear: &'a LinearPart<N>,
        operator: &'a Propagator<N>,
        [start, size, limit]: [f64; 3],
        from: &'a Place<N>,
        slow: Points<N>,
        rate: f64,
    ) -> Self {
        let end = operator.coordinates(POINTS - 1, &from.coordinates, &slow);
        let to = Place {
            coordinates: end,
            deviation: linear.deviation(&end),
        };
        let part = if linear.damping * size > STIFF {
            STIFF_PART
        } else {
            LOCAL_PART
        };
        let allowed = part * course.settings.tolerance.min(LOOSEST);
        let scale = &course.scaling.scale;
        Self {
            course,
            linear,
            operator,
            start,
            size,
            limit,
            from,
            slow,
            to,
            states: [[0.0; N]; POINTS],
            inverse: std::array::from_fn(|i| {
                let most = from.deviation[i].abs().max(to.deviation[i].abs());
                (allowed * (scale[i] + most)).recip()
            }),
            rate,
            sweeps: 0,
        }
    }

    /// Sweeps until the rest is small.
    pub fn run(&mut self) -> Ending {
        let mut before = f64::INFINITY;
        while self.sweeps < MOST {
            let change = self.sweep();
            if !change.is_finite() {
                return Ending::NotFinite;
            }
            let rest = if self.sweeps == 1 {
                rest(change, CAUTION * self.rate)
            } else {
                let lasting = if self.rate < 1.0 {
                    LASTING * self.rate
                } else {
                    LEAST_RATE
                };
                self.rate = (change / before).max(LEAST_RATE).max(lasting);
                rest(change, self.rate)
            };
            if rest <= REST {
                return Ending::Met(rest + self.error());
            }
            if self.sweeps > 1 && self.rate > SLOWEST {
                return Ending::Apart;
            }
            before = change;
        }
        Ending::Apart
    }

    /// Evaluates the slow part point by point, each with what is known by then; the size of what that
    /// changes at the end.
    fn sweep(&mut self) -> f64 {
        self.sweeps += 1;
        let mut change = [[0.0; N]; POINTS];
        for (point, change) in change.iter_mut().enumerate().skip(1) {
            let coordinates = self
                .operator
                .coordinates(point, &self.from.coordinates, &self.slow);
            let place = Place {
                coordinates,
                deviation: self.linear.deviation(&coordinates),
            };
            let slow = slow_part(self.linear, self.course, self.time_of(point), &place);
            self.states[point] = place.deviation;
            *change = std::array::from_fn(|i| slow[i] - self.slow[point][i]);
            self.slow[point] = slow;
        }
        let moved = self.operator.moved(POINTS - 1, &change);
        let shift = self.linear.deviation(&moved);
        for i in 0..N {
            self.to.coordinates[i] += moved[i];
            self.to.deviation[i] += shift[i];
        }
        self.norm(&shift)
    }

    /// Time of a point, s.
    pub(super) fn time_of(&self, point: usize) -> f64 {
        (self.start + NODES.part[point] * self.size).min(self.limit)
    }

    /// What the highest power of the polynomial does at the end and in the middle of the step, over
    /// what is allowed, as far as it is not better than that.
    fn error(&self) -> f64 {
        let spare = combined(&NODES.spare, &self.slow);
        let effect = |point| self.operator.effect(point, SPARE, &spare);
        let at = |point| self.norm(&self.linear.deviation(&effect(point)));
        self.smoothness() * at(POINTS - 1).max(at(SPARE + 1))
    }

    /// Root mean square over what is allowed.
    pub(super) fn norm(&self, vector: &[f64; N]) -> f64 {
        let squares = vector.iter().zip(&self.inverse);
        let sum: f64 = squares
            .map(|(value, inverse)| (value * inverse).powi(2))
            .sum();
        (sum / N as f64).sqrt()
    }
}

/// What sweeps still to be made would change, from the latest change and the fall from each to the next.
fn rest(change: f64, rate: f64) -> f64 {
    if rate < 1.0 {
        change * rate / (1.0 - rate)
    } else {
        f64::INFINITY
    }
}

/// Coordinates of g = f − J y with y the deviation from the origin, where it has one: the origin's part of J y
/// is in g.
pub(super) fn slow_part<S: System<N>, const N: usize>(
    linear: &LinearPart<N>,
    course: &Course<'_, S, N>,
    time: f64,
    place: &Place<N>,
) -> [f64; N] {
    let state = course.state(&place.deviation);
    let mut rate = [0.0; N];
    course.system.derivative(time, &state, &mut rate);
    linear.slow(&rate, place)
}

#[cfg(test)]
mod tests {
    use std::sync::atomic::AtomicBool;

    use fearless_simd::Level;

    use super::super::kept::Propagators;
    use super::*;
    use crate::integrate::{Method, Scaling, Settings};

    const NATURAL: f64 = 200.0;

    /// q″ = −ω² [q − cos t + 0.01 q³ (2 + sin 2t)]: time enters, and it is not linear.
    struct Hardening;

    impl System<2> for Hardening {
        fn derivative(&self, time: f64, [place, speed]: &[f64; 2], rate: &mut [f64; 2]) {
            let hard = 0.01 * place.powi(3) * (2.0 + (2.0 * time).sin());
            *rate = [*speed, -NATURAL * NATURAL * (place - time.cos() + hard)];
        }
    }

    /// State at a time from one that follows the drive, after so many equal steps.
    fn walked(steps: u32, time: f64) -> [f64; 2] {
        let (stop, scaling) = (AtomicBool::new(false), Scaling::IDENTITY);
        let settings = Settings {
            method: Method::Exponential,
            tolerance: 1.0,
            step_limit: u64::MAX,
        };
        let course = Course {
            system: &Hardening,
            scaling: &scaling,
            settings: &settings,
            stop: &stop,
            end: 100.0,
            slack: 1e-9,
        };
        let square = -1.06 * NATURAL * NATURAL;
        let linear = LinearPart::new([[0.0, square], [1.0, 0.0]], Level::new());
        let (mut propagators, mut from) = (Propagators::new(), linear.place([0.98, 0.0]));
        let size = time / f64::from(steps);
        let operator = propagators.of(&linear, size);
        for step in 0..steps {
            let start = f64::from(step) * size;
            let guess = [slow_part(&linear, &course, start, &from); POINTS];
            let span = [start, size, f64::INFINITY];
            let mut trial = Trial::new(&course, &linear, operator, span, &from, guess, 1.0);
            for _ in 0..40 {
                trial.sweep();
            }
            from = trial.to;
        }
        from.deviation
    }

    /// A free oscillation goes on beside the drive, and the cube of both is in the slow part: at 4 and at
    /// 2 rad of it a step the error falls with order seven at least.
    #[test]
    fn steps_of_the_order_of_the_natural_period_have_order_seven() {
        let truth = walked(1600, 2.0);
        let error = |steps| (walked(steps, 2.0)[0] - truth[0]).abs();
        for steps in [100, 140] {
            let order = (error(steps) / error(2 * steps)).log2();
            println!("{:e} {:e} {order}", error(steps), error(2 * steps));
            assert!(order > 6.5, "{steps} steps: {order}");
        }
    }
}
