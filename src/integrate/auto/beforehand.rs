//! What is known of a run before its first step: prices, and what is to be expected of the methods.

use std::f64::consts::TAU;

use super::blows::Blows;
use super::cost::{Prices, Way};
use super::rest::Rest;
use crate::integrate::Linearised;
use crate::integrate::course::Course;

/// Evaluations of the exponential method per radian of what drives a settled motion, at a tolerance.
const EXPONENTIAL_PER_RADIAN: f64 = 20.0;
const EXPONENTIAL_TOLERANCE: f64 = 1e-8;
/// Evaluations of Verner's pair per radian of the mean frequency of the modes, while the start dies away, at a
/// tolerance, and of the exponential method for every crossing of a surface.
const PAIR_PER_RADIAN: f64 = 19.0;
const EXPONENTIAL_PER_CROSSING: f64 = 250.0;
const PAIR_TOLERANCE: f64 = 1e-6;
/// Cost of the exponential method while the motion rings with a blow, in that of Verner's pair.
const EXPONENTIAL_RINGING: f64 = 3.0;
/// Part of the time that a motion rings with blows from which on this is much.
const RINGING: f64 = 0.3;
/// Evaluations of Verner's pair in the mean decay time of the modes, to stay stable: the fastest of them decays
/// twice as fast at least where this counts.
const PAIR_PER_DECAY: f64 = 4.8;
/// Root of the tolerance that all of them fall with.
const ROOT: f64 = -1.0 / 7.0;
/// Evaluations of a step of Verner's pair.
const VERNER_EVALUATIONS: f64 = 10.0;
/// Step sizes that a break adds to those of the exponential method: up to it and after it.
const SIZES_PER_BREAK: f64 = 2.0;
/// Mean decay times of the modes after which what is left of the start costs the exponential method little.
const DECAYS: f64 = 2.0;
/// The same in radians of their oscillation where they hardly decay: the method takes them exactly.
const RADIANS: f64 = 50.0;
/// Mean decay times of the modes after which next to nothing is left of the start.
const DECAYED: f64 = 6.0;
/// Breaks that are looked ahead to.
const BREAKS: u32 = 8;
/// Turns of what drives the motion over which a state at rest is looked at.
const TURNS: f64 = 2.0;

/// What is known beforehand.
#[derive(Debug, Clone, Copy)]
pub(super) struct Beforehand {
    pub prices: Prices,
    /// When the motion has settled by and large, and when next to nothing is left of its start, s.
    pub settled: f64,
    pub decayed: f64,
    /// How often surfaces go over a state at rest, 1/s.
    pub crossings: f64,
    /// Whether blows come to contacts of which some are open at rest.
    pub bounces: bool,
    /// Mean frequency of the modes at the origin, without their damping, rad/s, and mean rate of their decay, 1/s.
    frequency: f64,
    decay: f64,
    /// Evaluations of the exponential method per radian of shaft and loads, the more where the passing of the balls
    /// is faster, and per time for the surfaces that are crossed.
    exponential_per_radian: f64,
    exponential_for_crossings: f64,
    blows: Blows,
}

impl Beforehand {
    /// Of the run that a course goes over.
    pub fn of<S: Linearised<N>, const N: usize>(course: &Course<'_, S, N>) -> Self {
        let (slopes, _) = course.system.linearisation(0.0, &course.scaling.origin);
        let decay = -slopes.trace() / N as f64;
        // Σ λ² = tr J²; of a mode it is 2 (2 d² − ω²)
        let square = -slopes.component_mul(&slopes.transpose()).sum() / N as f64;
        let frequency = (square + 2.0 * decay * decay).max(0.0).sqrt();
        let [settled, decayed] = if decay > 0.0 {
            [(DECAYS / decay).min(RADIANS / frequency), DECAYED / decay]
        } else {
            [0.0, f64::INFINITY]
        };
        let pace = course.system.pace(0.0, course.end);
        let blows = Blows::ahead(course, &slopes, frequency, decayed);
        let rest = Rest::over((TURNS * TAU / pace).min(course.end), course);
        let finer = |at: f64| (course.settings.tolerance / at).powf(ROOT);
        Self {
            prices: Prices::new(course.system.effort(), N),
            settled,
            decayed,
            crossings: rest.crossings,
            bounces: blows.part > 0.0 && course.system.clearance(&course.scaling.origin) <= 0.0,
            frequency,
            decay,
            exponential_per_radian: EXPONENTIAL_PER_RADIAN
                * finer(EXPONENTIAL_TOLERANCE)
                * (rest.frequency / pace).max(1.0),
            exponential_for_crossings: EXPONENTIAL_PER_CROSSING
                * finer(PAIR_TOLERANCE)
                * rest.crossings,
            blows,
        }
    }

    /// Cost per simulated time that Verner's pair is expected to have while the start dies away.
    pub fn pair(&self, tolerance: f64) -> f64 {
        let finer = (tolerance / PAIR_TOLERANCE).powf(ROOT);
        let accurate = PAIR_PER_RADIAN * finer * self.frequency;
        let stable = PAIR_PER_DECAY * self.decay;
        accurate.max(stable) * self.prices.evaluation[Way::Verner76 as usize]
    }

    /// Size of its steps there, s.
    pub fn pair_step(&self, tolerance: f64) -> f64 {
        let price = self.prices.evaluation[Way::Verner76 as usize];
        VERNER_EVALUATIONS * price / self.pair(tolerance)
    }

    /// Whether the motion is to ring with blows for much of the time from a time on, s.
    pub fn rings(&self, time: f64) -> bool {
        time < self.blows.end && self.blows.part > RINGING
    }

    /// Cost per simulated time that the exponential method is expected to have from a time on, s, once the
    /// motion has settled; no number where nothing is known.
    pub fn exponential<S: Linearised<N>, const N: usize>(
        &self,
        course: &Course<'_, S, N>,
        time: f64,
    ) -> f64 {
        let smooth = self.exponential_per_radian * course.system.pace(time, course.end);
        let ringing = if time < self.blows.end {
            EXPONENTIAL_RINGING * self.blows.part * self.pair(course.settings.tolerance)
        } else {
            0.0
        };
        let sizes = SIZES_PER_BREAK * breaks_per_time(course, time);
        let evaluation = self.prices.evaluation[Way::Exponential as usize];
        (smooth + self.exponential_for_crossings) * evaluation
            + sizes * self.prices.step_size
            + ringing
    }
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
