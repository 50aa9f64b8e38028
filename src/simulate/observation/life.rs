//! Life that a history of loads consumes.

use std::f64::consts::TAU;

use crate::bearing::{Geometry, LANES, RatingLife, SupportObservation};
use crate::rotor::{Sample, SampleRows};

/// Seconds of an hour.
const HOUR: f64 = 3600.0;

/// Life that a bearing consumes along a history of loads, by Miner's rule.
///
/// ```text
/// D = ∫ dψ/(2π) / L10r(ψ)   L = n/D   with n = ∫ dψ/(2π) revolutions
/// ```
///
/// L10r is the basic reference rating life of ISO/TS 16281 under the ball loads of an instant,
/// [`crate::bearing::reference_rating_life`], as if that load stood still while the inner ring turns;
/// the integral is a trapezoid over the samples in shaft angle. A load that turns with the shaft,
/// as that of an unbalance, swaps the exponents 3 and 10/3 of the races in ISO/TS 16281, which is
/// not done here.
///
/// Source: ISO/TS 16281:2008; M. A. Miner, *J. Applied Mechanics* 12 (1945) A159–A164.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ConsumedLife {
    /// Time span, s.
    pub time: f64,
    /// Revolutions of the shaft in it.
    pub revolutions: f64,
    /// Share D of the bearing's life that it consumed; zero without load.
    pub share: f64,
}

impl ConsumedLife {
    /// Life L10r that the same history, repeated, would reach, 10⁶ revolutions; none without load or
    /// revolutions.
    pub fn rating_life(&self) -> Option<f64> {
        (self.share > 0.0).then(|| 1e-6 * self.revolutions / self.share)
    }

    /// The same in hours at the mean speed of the history.
    pub fn hours(&self) -> Option<f64> {
        (self.share > 0.0).then(|| self.time / self.share / HOUR)
    }
}

/// Life consumed over the whole run and without its start.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LifeHistory {
    /// From the first sample to the last.
    pub whole_run: ConsumedLife,
    /// From the first sample after the settle time on.
    pub after_settle: ConsumedLife,
}

/// Adds up the life consumed by one bearing.
#[derive(Debug)]
pub(super) struct LifeSums {
    rating: RatingLife,
    settle: f64,
    before: Option<Rate>,
    whole_run: ConsumedLife,
    after_settle: ConsumedLife,
}

/// 1/L10r at an instant.
#[derive(Debug, Clone, Copy)]
struct Rate {
    time: f64,
    angle: f64,
    /// Per 10⁶ revolutions.
    consumption: f64,
}

const NOTHING: ConsumedLife = ConsumedLife {
    time: 0.0,
    revolutions: 0.0,
    share: 0.0,
};

impl LifeSums {
    pub fn new(geometry: &Geometry, dynamic_rating: f64, settle: f64) -> Self {
        Self {
            rating: RatingLife::new(geometry, dynamic_rating),
            settle,
            before: None,
            whole_run: NOTHING,
            after_settle: NOTHING,
        }
    }

    /// Takes a sample with the powers of its ball loads, as by [`RatingLife::powers`].
    pub fn take(&mut self, sample: &Sample, powers: [f64; 2]) {
        self.go_on(Rate {
            time: sample.time,
            angle: sample.angle,
            consumption: self.rating.consumption_of(powers),
        });
    }

    /// Takes samples that follow each other, those seen last without the first so many.
    pub fn take_rows(&mut self, rows: &SampleRows, left_out: usize, seen: &SupportObservation) {
        let mut consumptions = [[0.0; LANES]; SampleRows::MOST / LANES];
        let groups = rows.len().div_ceil(LANES);
        seen.consumptions(&self.rating, &mut consumptions[..groups]);
        let consumptions = &consumptions.as_flattened()[..rows.len()];
        let (times, angles) = (rows.times(), rows.angles());
        let rate = |index: usize| Rate {
            time: times[index],
            angle: angles[index],
            consumption: consumptions[index],
        };
        let Some(last) = rows.len().checked_sub(1).filter(|last| left_out <= *last) else {
            return;
        };
        self.go_on(rate(left_out));
        // what begins before the settle time, and what begins after it
        let settled = times.partition_point(|time| *time < self.settle);
        let settled = settled.clamp(left_out, last);
        for (from, to) in [(left_out, settled), (settled, last)] {
            if from < to {
                let time = times[to] - times[from];
                let consumed =
                    ConsumedLife::along(time, &angles[from..=to], &consumptions[from..=to]);
                self.add(times[from], consumed);
            }
        }
        self.before = Some(rate(last));
    }

    /// Goes on to an instant.
    fn go_on(&mut self, now: Rate) {
        let Some(before) = self.before.replace(now) else {
            return;
        };
        self.add(before.time, ConsumedLife::between(before, now));
    }

    /// Adds what is consumed from a time on.
    fn add(&mut self, from: f64, consumed: ConsumedLife) {
        self.whole_run.add(consumed);
        if from >= self.settle {
            self.after_settle.add(consumed);
        }
    }

    /// None where the shaft never turned.
    pub fn finish(self) -> Option<LifeHistory> {
        (self.whole_run.revolutions > 0.0).then_some(LifeHistory {
            whole_run: self.whole_run,
            after_settle: self.after_settle,
        })
    }
}

impl ConsumedLife {
    fn between(from: Rate, to: Rate) -> Self {
        // either sense of rotation consumes
        let revolutions = (to.angle - from.angle).abs() / TAU;
        Self {
            time: to.time - from.time,
            revolutions,
            share: 1e-6 * revolutions * 0.5 * (from.consumption + to.consumption),
        }
    }

    /// In so many seconds along instants that follow each other, by the angle of the shaft and the consumption at
    /// each; sums run a few instants side by side.
    fn along(time: f64, angles: &[f64], consumptions: &[f64]) -> Self {
        let (mut turned, mut weighted) = ([0.0; LANES], [0.0; LANES]);
        let ends = angles.windows(2).zip(consumptions.windows(2));
        for (index, (angles, consumptions)) in ends.enumerate() {
            let angle = (angles[1] - angles[0]).abs();
            turned[index % LANES] += angle;
            weighted[index % LANES] += angle * (consumptions[0] + consumptions[1]);
        }
        let [turned, weighted] = [turned, weighted].map(|[a, b, c, d]| (a + b) + (c + d));
        Self {
            time,
            revolutions: turned / TAU,
            share: 1e-6 * 0.5 * (weighted / TAU),
        }
    }

    fn add(&mut self, other: Self) {
        self.time += other.time;
        self.revolutions += other.revolutions;
        self.share += other.share;
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::bearing::{catalogue, reference_rating_life};

    fn sample(time: f64, angle: f64) -> Sample {
        Sample {
            time,
            angle,
            speed: 100.0,
            displacement: [0.0; 5],
            velocity: [0.0; 5],
            force_on_shaft: [0.0; 5],
            largest_ball_load: 0.0,
            balls_loaded: 0,
            energy: None,
            drive: None,
        }
    }

    /// D = n₁/L₁ + n₂/L₂, whatever the speeds.
    #[test]
    fn two_levels_add_up_to_miners_sum() {
        let bearing = catalogue::find("6305").expect("an entry").bearing();
        let bearing = bearing.expect("a bearing");
        let rating = bearing.dynamic_rating.expect("a rating");
        let powers = |load| RatingLife::powers([[load; 2]; 7].into_iter());
        let life =
            |load| reference_rating_life(&bearing.geometry, rating, [[load; 2]; 7].into_iter());
        let mut sums = LifeSums::new(&bearing.geometry, rating, 0.0);
        // 30 revolutions in 3 s, then, after a jump, 10 in 4 s
        for (load, from, to) in [
            (400.0, [0.0, 0.0], [3.0, 30.0]),
            (900.0, [3.0, 30.0], [7.0, 40.0]),
        ] {
            for part in [0.0, 0.25, 0.7, 1.0] {
                let [time, turns] = [0, 1].map(|k| from[k] + part * (to[k] - from[k]));
                sums.take(&sample(time, TAU * turns), powers(load));
            }
        }
        let consumed = sums.finish().expect("a life").whole_run;
        let lives = [400.0, 900.0].map(|load| life(load).expect("a life"));
        let expected = 1e-6 * (30.0 / lives[0] + 10.0 / lives[1]);
        assert!((consumed.share / expected - 1.0).abs() < 1e-13);
        // L = n/D: 40 revolutions, and 7 s
        let life = consumed.rating_life().expect("a life");
        assert!((life / (40e-6 / expected) - 1.0).abs() < 1e-13);
        let hours = consumed.hours().expect("hours");
        assert!((hours / (7.0 / expected / 3600.0) - 1.0).abs() < 1e-13);
    }
}
