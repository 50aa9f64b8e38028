//! Axes: what they are called, and which values they show.

use std::fmt;
use std::ops::Range;

use serde::Serialize;

/// Most steps between round ends of an axis.
const STEPS: f64 = 6.0;
/// What spans less than this part of its size is constant.
const ROUND_OFF: f64 = 1e-9;
/// Room on either side of a constant, in parts of it.
const CONSTANT: f64 = 0.06;
/// Decades that are shown below the strongest line of a spectrum.
const DECADES_BELOW: i32 = 6;

/// A quantity and its unit, none of a pure number: `x in µm`.
#[derive(Debug, Clone, Default, PartialEq, Eq, Serialize)]
pub(crate) struct Label {
    pub quantity: String,
    pub unit: String,
}

impl From<&str> for Label {
    fn from(quantity: &str) -> Self {
        (quantity, "").into()
    }
}

impl From<String> for Label {
    fn from(quantity: String) -> Self {
        (quantity, "").into()
    }
}

impl From<&String> for Label {
    fn from(quantity: &String) -> Self {
        (quantity.as_str(), "").into()
    }
}

impl<Q: Into<String>, U: Into<String>> From<(Q, U)> for Label {
    fn from((quantity, unit): (Q, U)) -> Self {
        Self {
            quantity: quantity.into(),
            unit: unit.into(),
        }
    }
}

impl fmt::Display for Label {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let separator = if self.unit.is_empty() { "" } else { " in " };
        write!(f, "{}{separator}{}", self.quantity, self.unit)
    }
}

/// An axis of a panel; of a logarithmic one, ends and reach are decimal logarithms.
#[derive(Debug, Clone, Default, PartialEq, Serialize)]
pub(crate) struct Axis {
    #[serde(flatten)]
    pub label: Label,
    /// What it shows at first.
    pub ends: [f64; 2],
    /// How far what is drawn over it reaches, if beyond its ends.
    pub reach: Option<[f64; 2]>,
    pub logarithmic: bool,
    /// Names along it, the first between 0 and 1; none of an axis of numbers.
    pub texts: Vec<String>,
}

impl Axis {
    /// An axis of a range.
    pub fn over(label: impl Into<Label>, range: Range<f64>) -> Self {
        Self {
            label: label.into(),
            ends: [range.start, range.end],
            ..Self::default()
        }
    }

    /// An axis that holds values between round ends.
    pub fn spanning(label: impl Into<Label>, values: impl IntoIterator<Item = f64>) -> Self {
        let range = ends(values).map_or(0.0..1.0, |[low, high]| round(low, high));
        Self::over(label, range)
    }

    /// An axis that holds values with a margin; a constant gets a visible neighbourhood.
    pub fn around(label: impl Into<Label>, values: impl IntoIterator<Item = f64>) -> Self {
        Self::over(label, padded(values))
    }

    /// A full turn in degrees.
    pub fn azimuth() -> Self {
        Self::over(("azimuth φ", "deg"), 0.0..360.0)
    }

    /// Names from above to below, one a unit of length, the first between 0 and 1.
    pub fn names(names: impl IntoIterator<Item = String>) -> Self {
        let texts: Vec<_> = names.into_iter().collect();
        Self {
            ends: [texts.len().max(1) as f64, 0.0],
            texts,
            ..Self::default()
        }
    }

    /// A logarithmic axis of positive values: whole decades, or steps of 1, 2, 5 where they span few.
    pub fn logarithmic(label: impl Into<Label>, values: impl IntoIterator<Item = f64>) -> Self {
        let positive = values.into_iter().filter(|value| *value > 0.0);
        let range = match ends(positive.map(f64::log10)) {
            None => 0.0..1.0,
            Some([low, high]) if high - low < 1.6 => fine_decades(low, high),
            Some([low, high]) => low.floor()..high.ceil(),
        };
        Self::of_logarithms(label, range)
    }

    /// Some decades below the strongest line of a spectrum and a little above it.
    pub fn below(label: impl Into<Label>, strongest: f64) -> Self {
        let top = if strongest > 0.0 { strongest } else { 1.0 };
        let first = top.log10().floor() as i32 - DECADES_BELOW + 1;
        Self::of_logarithms(label, f64::from(first)..(4.0 * top).log10())
    }

    /// A logarithmic axis between two decimal logarithms.
    pub fn of_logarithms(label: impl Into<Label>, range: Range<f64>) -> Self {
        Self {
            logarithmic: true,
            ..Self::over(label, range)
        }
    }

    /// Lowest value of it.
    pub fn least(&self) -> f64 {
        self.value(self.ends[0])
    }

    /// Highest value of it.
    pub fn most(&self) -> f64 {
        self.value(self.ends[1])
    }

    fn value(&self, place: f64) -> f64 {
        if self.logarithmic {
            10f64.powf(place)
        } else {
            place
        }
    }

    /// Place of a value; at the lower end where it has no logarithm.
    pub(super) fn place(&self, value: f64) -> f64 {
        match self.logarithmic {
            false => value,
            true if value > 0.0 => value.log10(),
            true => self.ends[0],
        }
    }

    /// Whether a value is within it.
    pub(super) fn holds(&self, value: f64) -> bool {
        let [from, to] = self.ends;
        let near = 1e-9 * (to - from).abs();
        (from.min(to) - near..=from.max(to) + near).contains(&self.place(value))
    }
}

/// Least and largest of the finite values.
pub(in crate::report) fn ends(values: impl IntoIterator<Item = f64>) -> Option<[f64; 2]> {
    let finite = values.into_iter().filter(|value| value.is_finite());
    finite.fold(None, |ends, value| {
        let [low, high] = ends.unwrap_or([value; 2]);
        Some([low.min(value), high.max(value)])
    })
}

/// A range that holds values with a margin, never empty.
pub(in crate::report) fn padded(values: impl IntoIterator<Item = f64>) -> Range<f64> {
    let Some([low, high]) = ends(values) else {
        return -1.0..1.0;
    };
    let scale = low.abs().max(high.abs());
    let margin = match high - low {
        span if span > ROUND_OFF * scale => 0.06 * span,
        _ if scale > 0.0 => CONSTANT * scale,
        _ => 0.06,
    };
    low - margin..high + margin
}

/// Round numbers below and above the values, whole steps apart.
fn round(low: f64, high: f64) -> Range<f64> {
    let span = if high > low {
        high - low
    } else {
        low.abs().max(1.0)
    };
    let step = round_step(span / STEPS);
    let first = (low / step).floor();
    first * step..(high / step).ceil().max(first + 1.0) * step
}

/// The least of 1, 2, 5 times a power of ten that is not below `rough`.
pub(super) fn round_step(rough: f64) -> f64 {
    let power = 10f64.powf(rough.log10().floor());
    let steps = [1.0, 2.0, 5.0].map(|factor| factor * power);
    let found = steps.into_iter().find(|step| *step >= 0.999 * rough);
    found.unwrap_or(10.0 * power)
}

/// Logarithms of 1, 2, 5 times a power of ten below and above the values.
fn fine_decades(low: f64, high: f64) -> Range<f64> {
    let (first, last) = (low.floor() as i32, high.ceil() as i32 + 1);
    let steps = (first..=last)
        .flat_map(|decade| [1.0_f64, 2.0, 5.0].map(|step| step.log10() + f64::from(decade)));
    let all: Vec<f64> = steps.collect();
    let begin = all.partition_point(|tick| *tick <= low).saturating_sub(1);
    let end = all.partition_point(|tick| *tick < high).max(begin + 1);
    all[begin]..all[end.min(all.len() - 1)]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn round_ends_hold_the_values() {
        for (low, high) in [(200.0, 1000.0), (0.0, 1e-4), (3.0, 3.0), (-7.0, 2500.0)] {
            let range = round(low, high);
            assert!(range.start <= low && range.end >= high && range.start < range.end);
        }
    }

    #[test]
    fn a_constant_stands_amid_a_visible_neighbourhood() {
        for constant in [14.0, -3e-7, 14.0 * (1.0 + 1e-13)] {
            let range = padded([constant, constant]);
            let part = (range.end - range.start) / f64::abs(constant);
            assert!(
                range.contains(&constant) && (0.05..0.5).contains(&part),
                "{range:?}"
            );
        }
        // a small change is shown as large as any
        let range = padded([14.0, 14.0 + 1e-7]);
        assert!(range.end - range.start < 2e-7);
    }

    #[test]
    fn ends_of_logarithms_are_decades_that_hold_all_values() {
        assert_eq!(Axis::logarithmic("", [3e-7, 0.0, 2.0]).ends, [-7.0, 1.0]);
        let few = Axis::logarithmic("", [3.0, 40.0]);
        assert!((few.least() - 2.0).abs() < 1e-12 && (few.most() - 50.0).abs() < 1e-12);
    }

    #[test]
    fn what_has_no_logarithm_stands_at_the_lower_end() {
        assert_eq!(Axis::logarithmic("", [1e-3, 1.0]).place(0.0), -3.0);
    }
}
