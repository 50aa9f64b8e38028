//! Life that a history of loads consumes.

use std::f64::consts::TAU;

use serde::{Serialize, Serializer};

use crate::bearing::{BallLoads, Bearing, ModifiedLife, RatingLife};
use crate::rotor::Sample;

/// Seconds of an hour.
const HOUR: f64 = 3600.0;

/// Life that a bearing consumes along a history of loads, by Miner's rule.
///
/// ```text
/// D = ∫ dψ/(2π) / L10r(ψ)   L = n/D   with n = ∫ dψ/(2π) revolutions
/// ```
///
/// L10r is the basic reference rating life of ISO/TS 16281 under the ball loads of an instant,
/// [`crate::bearing::reference_rating_life`], as if that load stood still while one ring turns;
/// the integral is a trapezoid over the samples in shaft angle. A load that turns with that ring,
/// as that of an unbalance, swaps the exponents 3 and 10/3 of the races in ISO/TS 16281, which is
/// not done here.
///
/// Source: ISO/TS 16281:2008; M. A. Miner, *J. Applied Mechanics* 12 (1945) A159–A164.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
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

    /// That life in hours at the mean speed of the history.
    pub fn hours(&self) -> Option<f64> {
        (self.share > 0.0).then(|| self.time / self.share / HOUR)
    }
}

impl Serialize for ConsumedLife {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_map([
            ("time_s", Some(self.time)),
            ("revolutions", Some(self.revolutions)),
            ("consumed_share", Some(self.share)),
            ("life_Mrev", self.rating_life()),
            ("life_h", self.hours()),
        ])
    }
}

/// Life consumed over the whole run and without its start.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[non_exhaustive]
pub struct LifeHistory {
    /// From the first sample to the last.
    pub whole_run: ConsumedLife,
    /// From the first sample after the settle time on.
    pub after_settle: ConsumedLife,
    /// L_nm of ISO/TS 16281 at the mean speed after the settle time, by the life L10r there, and what it rests on; none where
    /// neither lubricant nor reliability is given.
    pub modified: Option<ModifiedLife>,
}

/// Adds up the life consumed by one bearing.
#[derive(Debug)]
pub(super) struct LifeSums {
    bearing: Bearing,
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

impl LifeSums {
    /// None of a bearing without a dynamic load rating.
    pub fn new(bearing: &Bearing, settle: f64) -> Option<Self> {
        Some(Self {
            bearing: *bearing,
            rating: bearing.rating_life()?,
            settle,
            before: None,
            whole_run: ConsumedLife::default(),
            after_settle: ConsumedLife::default(),
        })
    }

    /// Takes a sample and the loads of its balls.
    pub fn take(&mut self, sample: &Sample, balls: &BallLoads) {
        let now = Rate {
            time: sample.time,
            angle: sample.angle,
            consumption: self.rating.consumption(balls.rated_loads()),
        };
        let Some(before) = self.before.replace(now) else {
            return;
        };
        let consumed = ConsumedLife::between(before, now);
        self.whole_run.add(consumed);
        if before.time >= self.settle {
            self.after_settle.add(consumed);
        }
    }

    fn modified(&self) -> Option<ModifiedLife> {
        let history = match self.after_settle.rating_life() {
            Some(_) => self.after_settle,
            None => self.whole_run,
        };
        let speed = history.revolutions * TAU / history.time;
        self.bearing.modified_life(history.rating_life()?, speed)
    }

    /// None where the shaft never turned.
    pub fn finish(self) -> Option<LifeHistory> {
        (self.whole_run.revolutions > 0.0).then_some(LifeHistory {
            whole_run: self.whole_run,
            after_settle: self.after_settle,
            modified: self.modified(),
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
            ..Sample::default()
        }
    }

    /// D = n₁/L₁ + n₂/L₂, whatever the speeds.
    #[test]
    fn two_levels_add_up_to_miners_sum() {
        let bearing = catalogue::find("6305").expect("an entry").bearing();
        let bearing = bearing.expect("a bearing");
        let rating = bearing.dynamic_rating.expect("a rating");
        let life = |load| {
            let loads = [[load; 2]; 7].into_iter();
            reference_rating_life(&bearing.geometry, rating, loads)
        };
        let balls = |load: f64| BallLoads {
            load: [vec![load; 7], vec![load; 7]],
            ..BallLoads::default()
        };
        let mut sums = LifeSums::new(&bearing, 0.0).expect("a rating");
        // 30 revolutions in 3 s, then, after a jump, 10 in 4 s
        for (load, from, to) in [
            (400.0, [0.0, 0.0], [3.0, 30.0]),
            (900.0, [3.0, 30.0], [7.0, 40.0]),
        ] {
            for part in [0.0, 0.25, 0.7, 1.0] {
                let [time, turns] = [0, 1].map(|k| from[k] + part * (to[k] - from[k]));
                sums.take(&sample(time, TAU * turns), &balls(load));
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
