//! When samples were taken.

use std::sync::Arc;

/// Largest distance of a time from those of an even rate, in steps: so much is lost where times are rounded.
const EVEN: f64 = 0.05;
/// Part of a step up to which times may be written coarsely and still count as even.
const COARSEST: f64 = 0.25;
/// Round-off in the last decimal up to which decimals of times are distinguished.
const ROUND_OFF: f64 = 0.1;

/// Steps from which on a step is a gap, and from which on a gap need be no whole number of them.
const GAP: f64 = 1.5;
const LONG_GAP: f64 = 50.0;
/// Part of the steps that may be shorter than those without a gap, and the longest of these, by the shortest of the others.
const SHORTER: usize = 20;
const UNIT: f64 = 1.25;
/// Rounds in which a step is refined by whole numbers of it.
const ROUNDS: usize = 3;

/// Samples at an even rate but for gaps.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Gaps {
    /// Samples a second, Hz.
    pub rate: f64,
    /// Gaps in order: the sample behind each, counted from 0, and how many samples are missing before it.
    pub gaps: Vec<(usize, f64)>,
}

impl Gaps {
    /// The gaps of times in s that lie on a grid, however many of its places are empty; none where they lie on no grid, or have no gap.
    /// Its step is the shortest one, made exact by all that are whole numbers of it.
    pub fn find(times: &[f64]) -> Option<Self> {
        let steps: Vec<f64> = times.windows(2).map(|pair| pair[1] - pair[0]).collect();
        let mut sorted = steps.clone();
        sorted.sort_by(f64::total_cmp);
        let shortest = *sorted.get(sorted.len() / SHORTER)?;
        let is_unit = |length: &f64| *length <= UNIT * shortest;
        let units = sorted.partition_point(is_unit);
        let mut step = sorted[..units].iter().sum::<f64>() / units as f64;
        for _ in 0..ROUNDS {
            let whole = sorted
                .iter()
                .take_while(|length| **length <= LONG_GAP * step);
            let [time, count] = whole.fold([0.0, 0.0], |[time, count], length| {
                [time + length, count + (length / step).round()]
            });
            step = time / count;
        }
        let off = 2.0 * f64::max(EVEN, resolution(times, step) / step);
        let gaps = (1..)
            .zip(&steps)
            .map(|(behind, length)| (behind, length / step));
        let gaps = gaps.filter(|(_, length)| *length > GAP);
        let gaps = gaps.map(|(behind, length)| {
            let is_gap = length > LONG_GAP || (length - length.round()).abs() <= off;
            is_gap.then(|| (behind, length.round() - 1.0))
        });
        let gaps: Vec<_> = gaps.collect::<Option<_>>()?;
        if gaps.is_empty() {
            return None;
        }
        let starts = [0]
            .into_iter()
            .chain(gaps.iter().map(|(behind, _)| *behind));
        let ends = gaps.iter().map(|(behind, _)| *behind);
        let mut parts = starts.zip(ends.chain([times.len()]));
        let is_even = |(start, end): (usize, usize)| {
            let part = times[start..end].iter().enumerate();
            let mut beside = part.map(|(index, time)| time - times[start] - index as f64 * step);
            beside.all(|beside| beside.abs() <= off * step)
        };
        let rate = 1.0 / step;
        parts.all(is_even).then_some(Self { rate, gaps })
    }

    /// The longest gap.
    pub fn longest(&self) -> Option<(usize, f64)> {
        let gaps = self.gaps.iter().copied();
        gaps.max_by(|a, b| a.1.total_cmp(&b.1))
    }

    /// Number of samples that are missing.
    pub fn missing(&self) -> f64 {
        self.gaps.iter().map(|(_, missing)| missing).sum()
    }

    /// Values with NaN where samples are missing.
    pub fn filled(&self, values: &[f64]) -> Vec<f64> {
        let (mut filled, mut from) = (Vec::new(), 0);
        for &(behind, missing) in &self.gaps {
            let behind = behind.min(values.len());
            filled.extend_from_slice(&values[from..behind]);
            filled.resize(filled.len() + missing as usize, f64::NAN);
            from = behind;
        }
        filled.extend_from_slice(&values[from..]);
        filled
    }
}

/// When the samples of a channel were taken.
#[derive(Debug, Clone, PartialEq, Default)]
pub enum Sampling {
    /// The file does not say it.
    #[default]
    Unknown,
    /// At an even rate.
    Even {
        /// Samples a second, Hz.
        rate: f64,
        /// Time of the first, s.
        start: f64,
    },
    /// At these times, s, which rise unevenly.
    Times(Arc<[f64]>),
    /// At times that do not rise at this sample, counted from 1.
    Unordered(usize),
}

impl Sampling {
    /// The sampling of times in s: even where none is further than a twentieth of a step from an even rate, or than they are written.
    pub fn from_times(times: &[f64]) -> Self {
        let [start, .., end] = *times else {
            return Self::Unknown;
        };
        // a time that is not a number, or infinite, does not rise
        let rises = |pair: &[f64]| pair[0] < pair[1] && (pair[1] - start).is_finite();
        if let Some(before) = times.windows(2).position(|pair| !rises(pair)) {
            return Self::Unordered(before + 2);
        }
        let steps = (times.len() - 1) as f64;
        let (step, rate) = ((end - start) / steps, steps / (end - start));
        let is_even = |most: f64| {
            let beside = |(index, time)| time - start - index as f64 * step;
            let mut beside = times.iter().enumerate().map(beside);
            beside.all(|beside| beside.abs() <= most)
        };
        match is_even(EVEN * step) || is_even(resolution(times, step)) {
            true => Self::Even { rate, start },
            false => Self::Times(times.into()),
        }
    }

    /// Samples a second, Hz, if they are even.
    pub fn rate(&self) -> Option<f64> {
        match self {
            Self::Even { rate, .. } => Some(*rate),
            _ => None,
        }
    }

    /// How long so many samples are, s: from the first to the last and a step behind it.
    pub fn duration(&self, samples: usize) -> Option<f64> {
        match self {
            Self::Unknown | Self::Unordered(_) => None,
            Self::Even { rate, .. } => Some(samples as f64 / rate),
            Self::Times(times) => {
                let length = times.last()? - times.first()?;
                let mean = || length / (times.len() - 1) as f64;
                Some(length + Gaps::find(times).map_or_else(mean, |gaps| 1.0 / gaps.rate))
            }
        }
    }
}

/// How exactly times are written, s: the last digit of a double or of a decimal number; zero where that is more than a quarter of a step.
fn resolution(times: &[f64], step: f64) -> f64 {
    let largest = times
        .iter()
        .fold(0.0, |most, time| f64::max(most, time.abs()));
    let binary = largest.next_up() - largest;
    let round_off = |scale: f64| 2.0 * f64::EPSILON * largest * scale;
    let is_whole = |scale: f64| {
        let mut scaled = times.iter().map(|time| time * scale);
        scaled.all(|time| (time - time.round()).abs() <= 1e-3 + round_off(scale))
    };
    let scales = (0..).map(|decimals| 10f64.powi(decimals));
    let mut scales = scales.take_while(|scale| round_off(*scale) < ROUND_OFF);
    let decimal = scales
        .find(|scale| is_whole(*scale))
        .map_or(0.0, |scale| 1.0 / scale);
    let written = binary.max(decimal);
    if written <= COARSEST * step {
        written
    } else {
        0.0
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn gaps_are_told_from_uneven_times() {
        let times = |gap: f64| -> Vec<f64> {
            let late = |n: usize| if n < 120 { 0.0 } else { gap };
            (0..200).map(|n| 1e-3 * (n as f64 + late(n))).collect()
        };
        let gaps = Gaps::find(&times(25.0)).expect("a gap");
        assert!((gaps.rate - 1000.0).abs() < 1e-6, "{gaps:?}");
        assert_eq!(gaps.gaps, [(120, 25.0)]);
        let filled = gaps.filled(&[1.0; 200]);
        let missing = filled.iter().enumerate().filter(|(_, it)| it.is_nan());
        assert!(missing.map(|(place, _)| place).eq(120..145));
        assert_eq!(filled.len(), 225);
        // a short one that is no whole number of steps is none, a long one is
        assert_eq!(Gaps::find(&times(2.4)), None);
        assert_eq!(Gaps::find(&times(800.4)).expect("a gap").missing(), 800.0);
        let part: Vec<f64> = (0..2000).filter(|n| n % 7 < 2).map(f64::from).collect();
        let gaps = Gaps::find(&part).expect("two of seven");
        assert_eq!((gaps.rate, gaps.missing()), (1.0, 1425.0));
        let uneven: Vec<f64> = (0..200).map(|n| f64::from(n * n)).collect();
        assert_eq!(Gaps::find(&uneven), None);
        assert_eq!(Gaps::find(&[0.0, 1.0, 1.0]), None);
        assert_eq!(Gaps::find(&[]), None);
    }

    #[test]
    fn times_are_even_as_exactly_as_they_are_written() {
        let rate = |step: f64, written: fn(f64) -> f64| {
            let times: Vec<f64> = (0..20_000).map(|n| written(f64::from(n) * step)).collect();
            Sampling::from_times(&times).rate()
        };
        // seconds since 1970 at 1 MHz, microseconds at 204.8 kHz
        let epoch = rate(1e-6, |time| 1_704_067_200.0 + time).expect("even");
        assert!((epoch / 1e6 - 1.0).abs() < 1e-4, "{epoch}");
        let micro = rate(1.0 / 204_800.0, |time| (time * 1e6).round() / 1e6);
        assert!((micro.expect("even") / 204_800.0 - 1.0).abs() < 1e-4);
        // a step of 1.5 s in whole seconds may be anything
        assert_eq!(rate(1.5, f64::round), None);
        assert_eq!(rate(1e-3, |time| time + 1e-4 * (1e6 * time).sin()), None);
    }
}
