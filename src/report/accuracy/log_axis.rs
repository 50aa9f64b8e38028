//! Logarithmic axes: plotted is the logarithm, written at the ticks is the value.

use std::ops::Range;

use plotters::coord::ranged1d::{DefaultFormatting, KeyPointHint};
use plotters::prelude::Ranged;

/// Most ticks of an axis.
const MOST_TICKS: usize = 9;

/// Decimal logarithms from one tick to another.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct LogAxis {
    /// Its ends.
    pub range: Range<f64>,
    ticks: Vec<f64>,
}

impl LogAxis {
    /// The axis of positive values: whole decades, or steps of 1, 2, 5 where they span few.
    pub fn of(values: impl Iterator<Item = f64>) -> Self {
        let (low, high) = values
            .filter(|value| *value > 0.0 && value.is_finite())
            .map(f64::log10)
            .fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), value| {
                (low.min(value), high.max(value))
            });
        if low > high {
            return Self::over(&[0.0, 1.0]);
        }
        if high - low < 1.6 {
            return Self::fine(low, high);
        }
        let (first, last) = (low.floor() as i32, high.ceil() as i32);
        let step = ((last - first) as usize).div_ceil(MOST_TICKS - 1).max(1) as i32;
        let count = ((last - first) as usize).div_ceil(step as usize) as i32;
        let ticks: Vec<f64> = (0..=count)
            .map(|tick| f64::from(first + tick * step))
            .collect();
        Self::over(&ticks)
    }

    /// Steps of 1, 2, 5 around the values.
    fn fine(low: f64, high: f64) -> Self {
        let (first, last) = (low.floor() as i32, high.ceil() as i32 + 1);
        let steps = (first..=last)
            .flat_map(|decade| [1.0_f64, 2.0, 5.0].map(|step| step.log10() + f64::from(decade)));
        let all: Vec<f64> = steps.collect();
        let begin = all.partition_point(|tick| *tick <= low).saturating_sub(1);
        let end = all.partition_point(|tick| *tick < high).max(begin + 1);
        Self::over(&all[begin..=end.min(all.len() - 1)])
    }

    fn over(ticks: &[f64]) -> Self {
        Self {
            range: ticks[0]..ticks[ticks.len() - 1],
            ticks: ticks.to_vec(),
        }
    }

    /// Number of ticks.
    pub fn count(&self) -> usize {
        self.ticks.len()
    }

    /// Where a value stands; at the lower end where it has no logarithm.
    pub fn place(&self, value: f64) -> f64 {
        if value > 0.0 {
            value.log10().clamp(self.range.start, self.range.end)
        } else {
            self.range.start
        }
    }
}

/// The value at a tick.
pub(super) fn tick_name(tick: &f64) -> String {
    let value = 10f64.powf(*tick);
    // by round-off 10^tick is not quite what was meant
    let value: f64 = format!("{value:.3e}").parse().unwrap_or(value);
    if (1e-2..1e4).contains(&value) {
        format!("{value}")
    } else {
        format!("{value:e}")
    }
}

impl Ranged for LogAxis {
    type FormatOption = DefaultFormatting;
    type ValueType = f64;

    fn map(&self, value: &f64, pixels: (i32, i32)) -> i32 {
        let part = (value - self.range.start) / (self.range.end - self.range.start);
        pixels.0 + (part * f64::from(pixels.1 - pixels.0)).round() as i32
    }

    fn key_points<Hint: KeyPointHint>(&self, _: Hint) -> Vec<f64> {
        self.ticks.clone()
    }

    fn range(&self) -> Range<f64> {
        self.range.clone()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ticks_are_decades_that_hold_all_values() {
        let axis = LogAxis::of([3e-7, 0.0, 2.0].into_iter());
        assert_eq!(axis.range, -7.0..1.0);
        assert_eq!(axis.count(), 9);
        let wide = LogAxis::of([1e-14, 1.0].into_iter());
        assert!(wide.count() <= MOST_TICKS && wide.range == (-14.0..0.0));
    }

    #[test]
    fn few_decades_have_finer_ticks() {
        let axis = LogAxis::of([3.0, 40.0].into_iter());
        let names: Vec<String> = axis.ticks.iter().map(tick_name).collect();
        assert_eq!(names, ["2", "5", "10", "20", "50"]);
        assert_eq!(LogAxis::of([7.0].into_iter()).count(), 2);
    }

    #[test]
    fn what_has_no_logarithm_stands_at_the_lower_end() {
        let axis = LogAxis::of([1e-3, 1.0].into_iter());
        assert_eq!(axis.place(0.0), -3.0);
    }
}
