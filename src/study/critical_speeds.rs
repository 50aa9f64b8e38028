//! Critical speeds: where a natural frequency crosses an order.

use std::f64::consts::TAU;

use serde::Serialize;

use super::campbell::{Branch, CampbellError, Reduced};
use crate::keys;
use crate::numerics::root::Bracket;
use crate::rotor::{Mode, Whirl};

/// A speed at which a natural frequency is a multiple of the shaft's frequency.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[non_exhaustive]
pub struct CriticalSpeed {
    /// The multiple.
    pub order: f64,
    /// The branch, from 0.
    #[serde(serialize_with = "keys::from_one")]
    pub branch: usize,
    /// The speed, rad/s.
    #[serde(rename = "speed_rad_s")]
    pub speed: f64,
    /// Frequency of the damped vibration there, Hz: order × speed/2π.
    #[serde(rename = "frequency_Hz")]
    pub frequency: f64,
    /// Damping ratio there.
    pub damping_ratio: f64,
    /// How the shaft goes round there.
    pub whirl: Whirl,
    /// How much more it goes round with the rotation than against it, −1 … 1.
    pub forward_share: f64,
    /// Of a shaft that bends: relative difference of the frequency there from that with more modes of bending in each
    /// plane: twice as many as the pass of a run that measures the error of the reduction.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub reduction_error: Option<f64>,
}

impl CriticalSpeed {
    /// Relative error of its frequency: of the search for the crossing, or that of the reduction where it is larger.
    pub(crate) fn error(&self) -> f64 {
        let sought = self.order * self.speed / TAU;
        let missed = (self.frequency / sought - 1.0).abs();
        missed.max(self.reduction_error.unwrap_or(0.0))
    }
}

/// Part of the speed to which a crossing is found.
pub(super) const FOUND: f64 = 1e-12;

/// Trials of a search.
pub(super) const MOST_TRIALS: usize = 80;

/// All crossings of branches and some orders between the speeds, by speed.
pub(super) fn critical_speeds(
    shaft: &Reduced<'_>,
    speeds: &[f64],
    branches: &[Branch],
    orders: &[f64],
) -> Result<Vec<CriticalSpeed>, CampbellError> {
    let mut found = Vec::new();
    for (index, branch) in branches.iter().enumerate() {
        for (pair, ends) in branch.modes.windows(2).zip(speeds.windows(2)) {
            let (Some(low), Some(high)) = (&pair[0], &pair[1]) else {
                continue;
            };
            for &order in orders {
                let ends = [(ends[0], low), (ends[1], high)];
                found.extend(crossing(shaft, ends, order, index)?);
            }
        }
    }
    found.sort_by(|a: &CriticalSpeed, b| a.speed.total_cmp(&b.speed));
    Ok(found)
}

/// The crossing of a branch and an order between two speeds at which its mode is known, if there is one. Between them
/// its mode is that most like both.
pub(super) fn crossing(
    shaft: &Reduced<'_>,
    [(from, low), (to, high)]: [(f64, &Mode); 2],
    order: f64,
    branch: usize,
) -> Result<Option<CriticalSpeed>, CampbellError> {
    // f(ω) − order ω/2π, Hz
    let distance = |mode: &Mode, speed: f64| mode.damped_frequency() - order * speed / TAU;
    let likeness = |mode: &Mode| low.assurance(mode) + high.assurance(mode);
    let values = [distance(low, from), distance(high, to)];
    let Some(mut bracket) = Bracket::new([from, to], values) else {
        return Ok(None);
    };
    let mut found: Option<CriticalSpeed> = None;
    for _ in 0..MOST_TRIALS {
        let speed = bracket.guess();
        let modes = shaft.modes(speed)?.into_iter();
        let most_alike = modes.max_by(|a, b| likeness(a).total_cmp(&likeness(b)));
        let Some(mode) = most_alike else { break };
        let value = distance(&mode, speed);
        bracket.narrow(speed, value);
        let before = found.replace(CriticalSpeed {
            order,
            branch,
            speed,
            frequency: mode.damped_frequency(),
            damping_ratio: mode.damping_ratio(),
            whirl: mode.whirl(),
            forward_share: mode.forward_share(),
            reduction_error: None,
        });
        let moved = before.map_or(f64::INFINITY, |before| (speed - before.speed).abs());
        if value == 0.0 || moved.min(bracket.length()) < FOUND * speed {
            break;
        }
    }
    Ok(found)
}
