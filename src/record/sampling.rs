//! When samples were taken.

use std::sync::Arc;

/// Largest distance of a time from those of an even rate, in steps: so much is lost where times are rounded.
const EVEN: f64 = 0.05;

/// Mean steps from which on a step is a gap, most gaps as a part of all steps, and steps from which on a gap need be no whole number of
/// them.
const GAP: f64 = 1.5;
const MOST_GAPS: f64 = 0.01;
const LONG_GAP: f64 = 50.0;

/// Samples at an even rate but for gaps.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Gaps {
    /// Samples a second, Hz.
    pub rate: f64,
    /// Gaps in order: the sample behind each, counted from 0, and how many samples are missing before it.
    pub gaps: Vec<(usize, f64)>,
}

impl Gaps {
    /// The gaps of times in s that rise at an even rate elsewhere; none where those are uneven, or have no gap.
    pub fn of(times: &[f64]) -> Option<Self> {
        let steps: Vec<f64> = times.windows(2).map(|pair| pair[1] - pair[0]).collect();
        let mut sorted = steps.clone();
        sorted.sort_by(f64::total_cmp);
        let longest = GAP * sorted.get(sorted.len() / 2)?;
        let most = (MOST_GAPS * steps.len() as f64).max(1.0);
        let (even, gaps): (Vec<usize>, Vec<usize>) =
            (0..steps.len()).partition(|place| steps[*place] <= longest);
        if gaps.is_empty() || gaps.len() as f64 > most || even.is_empty() {
            return None;
        }
        let step = even.iter().map(|place| steps[*place]).sum::<f64>() / even.len() as f64;
        let gaps = gaps.iter().map(|place| {
            let length = steps[*place] / step;
            let is_gap = length > LONG_GAP || (length - length.round()).abs() <= 2.0 * EVEN;
            is_gap.then(|| (place + 1, length.round() - 1.0))
        });
        let gaps: Vec<_> = gaps.collect::<Option<_>>()?;
        let starts = [0]
            .into_iter()
            .chain(gaps.iter().map(|(behind, _)| *behind));
        let ends = gaps.iter().map(|(behind, _)| *behind);
        let mut parts = starts.zip(ends.chain([times.len()]));
        let is_even = |(start, end): (usize, usize)| {
            let part = times[start..end].iter().enumerate();
            let mut off = part.map(|(index, time)| time - times[start] - index as f64 * step);
            off.all(|off| off.abs() <= 2.0 * EVEN * step)
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
    /// The sampling of times in s: even where none is further than a twentieth of a step from an even rate.
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
        let is_near = |(index, time): (usize, &f64)| {
            (time - start - index as f64 * step).abs() <= EVEN * step
        };
        match times.iter().enumerate().all(is_near) {
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

    /// Time from the first to the last of so many samples, s.
    pub fn duration(&self, samples: usize) -> Option<f64> {
        match self {
            Self::Unknown | Self::Unordered(_) => None,
            Self::Even { rate, .. } => Some(samples.saturating_sub(1) as f64 / rate),
            Self::Times(times) => Some(times.last()? - times.first()?),
        }
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
        let gaps = Gaps::of(&times(25.0)).expect("a gap");
        assert!((gaps.rate - 1000.0).abs() < 1e-6, "{gaps:?}");
        assert_eq!(gaps.gaps, [(120, 25.0)]);
        let filled = gaps.filled(&[1.0; 200]);
        let missing = filled.iter().enumerate().filter(|(_, it)| it.is_nan());
        assert!(missing.map(|(place, _)| place).eq(120..145));
        assert_eq!(filled.len(), 225);
        // a short one that is no whole number of steps is none, a long one is
        assert_eq!(Gaps::of(&times(2.4)), None);
        assert_eq!(Gaps::of(&times(800.4)).expect("a gap").missing(), 800.0);
        let uneven: Vec<f64> = (0..200).map(|n| f64::from(n * n)).collect();
        assert_eq!(Gaps::of(&uneven), None);
        assert_eq!(Gaps::of(&[0.0, 1.0, 1.0]), None);
        assert_eq!(Gaps::of(&[]), None);
    }
}
