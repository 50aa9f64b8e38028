//! Half-sine shocks at random times.

use std::f64::consts::PI;

use super::{MainVibration, SplitMix64};
use crate::bearing::Vector5;

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
        let ShockStatistics {
            peak,
            least,
            duration,
            rate,
            seed,
        } = *statistics;
        let [gaps, parts] = [0, 1].map(|stream| SplitMix64::new(seed).stream(stream));
        let mut begin = 0.0;
        let shock = |number| {
            begin -= gaps.uniform(number).ln() / rate;
            (begin, least + (1.0 - least) * parts.uniform(number))
        };
        let shocks = (0..).map(shock).take_while(|(begin, _)| *begin < until);
        Self {
            peak,
            duration,
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
        MainVibration {
            amplitude: self.peak,
            frequency: PI / self.duration,
            order: 0.0,
        }
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
