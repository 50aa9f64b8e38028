//! Half-sine shocks, at fixed intervals or at random times.

use std::f64::consts::{PI, TAU};

use super::{MainVibration, SplitMix64};
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
        MainVibration::at(PI / self.duration, self.peak)
    }

    /// The next begin or end of a shock after a time, s.
    pub fn next_break(&self, after: f64) -> f64 {
        let begin = self.begin_before(after);
        let every = self.every.unwrap_or(0.0);
        // by round-off the shock that begins at `after` itself may count as the next one
        let begins = [begin, begin + every, begin + 2.0 * every];
        let jumps = begins.map(|begin| [begin, begin + self.duration]);
        let later = jumps.into_iter().flatten().filter(|time| *time > after);
        later.fold(f64::INFINITY, f64::min)
    }
}

/// How random shocks are distributed.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ShockStatistics {
    /// Peak of the largest shock, N and N m.
    pub peak: Vector5,
    /// Peak of the smallest shock over that of the largest, 0 … 1; in between, all are as likely.
    pub least: f64,
    /// Duration T of each, s, positive.
    pub duration: f64,
    /// Mean number of shocks a second, positive.
    pub rate: f64,
    /// Seed: the same one gives the same shocks.
    pub seed: u64,
}

/// Shocks that come independently of each other (a Poisson process), fixed by a seed.
///
/// ```text
/// P(t) = Σ_k p_k P̂ sin(π (t − t_k)/T)   over the shocks with t_k ≤ t ≤ t_k + T
/// t_(k+1) = t_k − ln(u)/λ,   p_k = least + (1 − least) u',   u, u' uniform in 0 … 1
/// ```
///
/// Source: Parzen, *Stochastic Processes* (1962): the gaps of a Poisson process are exponential.
#[derive(Debug, Clone, PartialEq)]
pub struct RandomShocks {
    peak: Vector5,
    duration: f64,
    /// Begin in s and part p_k of the peak, by begin.
    pub(crate) shocks: Vec<(f64, f64)>,
}

impl RandomShocks {
    /// The shocks that begin before `until` in s.
    pub fn new(statistics: &ShockStatistics, until: f64) -> Self {
        let random = SplitMix64::new(statistics.seed);
        let [gaps, parts] = [0, 1].map(|stream| random.stream(stream));
        let (least, mut begin) = (statistics.least, 0.0);
        let shock = |number| {
            begin -= gaps.uniform(number).ln() / statistics.rate;
            (begin, least + (1.0 - least) * parts.uniform(number))
        };
        let shocks = (0..).map(shock).take_while(|(begin, _)| *begin < until);
        Self {
            peak: statistics.peak,
            duration: statistics.duration,
            shocks: shocks.collect(),
        }
    }

    /// The load at a time in s.
    #[inline]
    pub fn at(&self, time: f64) -> Vector5 {
        let begun = self.shocks.partition_point(|(begin, _)| *begin <= time);
        let latest = self.shocks[..begun].iter().rev();
        let acting = latest.take_while(|(begin, _)| time - begin <= self.duration);
        let sum: f64 = acting
            .map(|(begin, part)| part * (PI * (time - begin) / self.duration).sin())
            .sum();
        self.peak.map(|peak| peak * sum)
    }

    /// A steady vibration of the largest peak and the half period of a shock.
    pub fn main_vibration(&self) -> MainVibration {
        MainVibration::at(PI / self.duration, self.peak)
    }

    /// The next begin or end of a shock after a time, s.
    pub fn next_break(&self, after: f64) -> f64 {
        let first_after = |shift: f64| {
            let passed = self
                .shocks
                .partition_point(|(begin, _)| begin + shift <= after);
            let next = self.shocks.get(passed);
            next.map_or(f64::INFINITY, |(begin, _)| begin + shift)
        };
        first_after(0.0).min(first_after(self.duration))
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
