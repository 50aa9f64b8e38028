//! Half-sine shocks.

use std::f64::consts::{PI, TAU};

use super::{MainVibration, earliest};
use crate::bearing::Vector5;

/// A half-sine shock, once or again and again.
///
/// ```text
/// P(t) = P̂ sin(π (t − t_0)/T)   for t_0 ≤ t ≤ t_0 + T, else 0
/// ```
///
/// Its impulse is `2 P̂ T/π`. Where it repeats, t_0 steps on by the interval.
///
/// Source: IEC 60068-2-27 (2008), half-sine pulse.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Shock {
    /// Peak P̂, N and N m.
    pub peak: Vector5,
    /// Duration T, s, positive.
    pub duration: f64,
    /// Time t_0 at which the (first) shock begins, s.
    pub start: f64,
    /// Time from the begin of one shock to that of the next, s, at least the duration.
    pub every: Option<f64>,
}

impl Shock {
    /// The load at a time in s.
    #[inline]
    pub fn at(&self, time: f64) -> Vector5 {
        let since = time - self.begin_before(time);
        if (0.0..=self.duration).contains(&since) {
            let sin = (PI * since / self.duration).sin();
            self.peak.map(|peak| peak * sin)
        } else {
            [0.0; 5]
        }
    }

    /// Begin of the latest shock, or of the first where none has begun.
    fn begin_before(&self, time: f64) -> f64 {
        match self.every {
            Some(every) if time > self.start => {
                self.start + every * ((time - self.start) / every).floor()
            }
            _ => self.start,
        }
    }

    /// Angular frequency in rad/s and begin in s; none where it does not act.
    ///
    /// # Errors
    /// What it is, where it does not repeat.
    pub(super) fn repetition(&self) -> Result<Option<(f64, f64)>, &'static str> {
        if self.peak.iter().all(|part| *part == 0.0) {
            return Ok(None);
        }
        let every = self.every.ok_or("a single shock")?;
        Ok(Some((TAU / every, self.start)))
    }

    /// A steady vibration of the same peak and half period.
    pub fn main_vibration(&self) -> MainVibration {
        MainVibration {
            amplitude: self.peak,
            frequency: PI / self.duration,
            order: 0.0,
        }
    }

    /// The next begin or end of a shock after a time, s.
    pub fn next_break(&self, after: f64) -> f64 {
        let begin = self.begin_before(after);
        let every = self.every.unwrap_or(0.0);
        // by round-off the shock that begins at `after` itself may count as the next one
        let begins = [begin, begin + every, begin + 2.0 * every];
        earliest(
            begins
                .into_iter()
                .flat_map(|begin| [begin, begin + self.duration]),
            after,
        )
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_shock_has_its_peak_in_its_middle() {
        let shock = Shock {
            peak: [0.0, -2000.0, 0.0, 0.0, 0.0],
            duration: 4e-3,
            start: 0.1,
            every: None,
        };
        assert!((shock.at(0.102)[1] + 2000.0).abs() < 1e-9);
        assert_eq!(shock.at(0.105)[1], 0.0);
    }
}
