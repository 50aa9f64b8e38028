//! Where natural frequencies meet multiples of the shaft's frequency.

use std::f64::consts::TAU;

use super::{Branch, CampbellError, CampbellQuestion, CriticalSpeed};
use crate::rotor::Mode;

/// Part of the speed to which a crossing is found.
const FOUND: f64 = 1e-12;
/// Trials of a search.
const MOST_TRIALS: usize = 80;

/// All crossings of branches and orders between the speeds, by speed.
pub(super) fn critical_speeds(
    question: &CampbellQuestion,
    speeds: &[f64],
    branches: &[Branch],
) -> Result<Vec<CriticalSpeed>, CampbellError> {
    let mut found = Vec::new();
    for (index, branch) in branches.iter().enumerate() {
        for (pair, ends) in branch.modes.windows(2).zip(speeds.windows(2)) {
            let (Some(low), Some(high)) = (&pair[0], &pair[1]) else {
                continue;
            };
            for &order in &question.orders {
                let crossing = Crossing {
                    question,
                    neighbours: [low, high],
                    order,
                };
                found.extend(crossing.find([ends[0], ends[1]], index)?);
            }
        }
    }
    found.sort_by(|a: &CriticalSpeed, b| a.speed.total_cmp(&b.speed));
    Ok(found)
}

/// A crossing of one branch and one order between two speeds.
struct Crossing<'a> {
    question: &'a CampbellQuestion,
    /// The branch at both speeds.
    neighbours: [&'a Mode; 2],
    order: f64,
}

impl Crossing<'_> {
    /// `f(ω) − order ω/2π`, Hz.
    fn distance(&self, mode: &Mode, speed: f64) -> f64 {
        mode.damped_frequency() - self.order * speed / TAU
    }

    /// The branch at a speed between its neighbours: the mode most like both.
    fn mode(&self, speed: f64) -> Result<Option<Mode>, CampbellError> {
        let [low, high] = self.neighbours;
        let likeness = |mode: &Mode| low.assurance(mode) + high.assurance(mode);
        let modes = self.question.modes(speed)?.into_iter();
        Ok(modes.max_by(|a, b| likeness(a).total_cmp(&likeness(b))))
    }

    /// By the Illinois algorithm: an end that stays twice loses half of its weight.
    fn find(
        &self,
        [mut low, mut high]: [f64; 2],
        branch: usize,
    ) -> Result<Option<CriticalSpeed>, CampbellError> {
        let mut at_low = self.distance(self.neighbours[0], low);
        let mut at_high = self.distance(self.neighbours[1], high);
        if (at_low > 0.0) == (at_high > 0.0) {
            return Ok(None);
        }
        let mut last = None;
        let mut stayed = 0i8;
        for _ in 0..MOST_TRIALS {
            let speed = (low * at_high - high * at_low) / (at_high - at_low);
            let Some(mode) = self.mode(speed)? else { break };
            let distance = self.distance(&mode, speed);
            last = Some(self.told(&mode, speed, branch));
            if distance == 0.0 || high - low < FOUND * high {
                break;
            }
            let upper = (distance > 0.0) == (at_high > 0.0);
            let (end, at_end, other) = if upper {
                (&mut high, &mut at_high, &mut at_low)
            } else {
                (&mut low, &mut at_low, &mut at_high)
            };
            let side = if upper { 1 } else { -1 };
            let moved = (speed - *end).abs();
            (*end, *at_end) = (speed, distance);
            if stayed == side {
                *other *= 0.5;
            }
            stayed = side;
            if moved < FOUND * speed {
                break;
            }
        }
        Ok(last)
    }

    fn told(&self, mode: &Mode, speed: f64, branch: usize) -> CriticalSpeed {
        CriticalSpeed {
            order: self.order,
            branch,
            speed,
            frequency: mode.damped_frequency(),
            damping_ratio: mode.damping_ratio(),
            whirl: mode.whirl(),
            forward_share: mode.forward_share(),
        }
    }
}
