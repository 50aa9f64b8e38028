//! Axes: their ends, and the ticks with what is written there.

use std::ops::Range;

use plotters::coord::ranged1d::{DefaultFormatting, KeyPointHint};
use plotters::prelude::Ranged;

/// Most steps between the ends of an axis.
const STEPS: f64 = 6.0;
/// Most steps along an axis whose ends are not round.
const STEPS_INSIDE: f64 = 9.0;
/// Most ticks of a logarithmic axis.
const MOST_DECADES: usize = 9;
/// Decades that are shown below the strongest line of a spectrum.
const DECADES_BELOW: i32 = 6;
/// Room for the numbers and the name of an axis to the left, px.
pub(super) const LEFT_ROOM: u32 = 82;
/// Room for those of an axis below, px.
const ROOM_BELOW: u32 = 54;
/// Width of a letter, px: about that of the font of whoever shows the figure.
pub(super) const LETTER: u32 = 7;

/// An axis of a panel; of a logarithmic one, ends and ticks are decimal logarithms.
#[derive(Debug, Clone, Default, PartialEq)]
pub(crate) struct Axis {
    /// Quantity and unit; none where another panel shows them.
    pub name: String,
    /// The values at its ends.
    pub ends: [f64; 2],
    ticks: Vec<(f64, String)>,
    pub logarithmic: bool,
}

impl Axis {
    /// An axis of a range, with round ticks inside it.
    pub fn over(name: impl Into<String>, range: Range<f64>) -> Self {
        let near = 1e-9 * (range.end - range.start);
        let mut ticks = ticks(range.start, range.end, STEPS_INSIDE);
        ticks.retain(|tick| (range.start - near..=range.end + near).contains(tick));
        Self::linear(name, [range.start, range.end], &ticks)
    }

    /// An axis between ticks that are given, its ends the first and the last.
    pub fn ticked(name: impl Into<String>, ticks: &[f64]) -> Self {
        let ends = [ticks.first(), ticks.last()].map(|end| end.copied().unwrap_or(0.0));
        Self::linear(name, ends, ticks)
    }

    /// An axis that holds values between round ends.
    pub fn spanning(name: impl Into<String>, values: impl IntoIterator<Item = f64>) -> Self {
        let ticks = match ends(values) {
            Some([low, high]) => round_ticks(low, high),
            None => vec![0.0, 1.0],
        };
        Self::ticked(name, &ticks)
    }

    /// An axis that holds values with a margin; a constant gets a visible neighbourhood.
    pub fn around(name: impl Into<String>, values: impl IntoIterator<Item = f64>) -> Self {
        Self::over(name, padded(values))
    }

    /// From 0 to 1 without ticks, in the room of an axis that has a name.
    pub(super) fn blank() -> Self {
        Self::linear(" ", [0.0, 1.0], &[])
    }

    /// A full turn in degrees.
    pub fn azimuth() -> Self {
        let ticks: Vec<_> = (0..=8).map(|step| 45.0 * f64::from(step)).collect();
        Self::ticked("azimuth φ in deg", &ticks)
    }

    /// Names from above to below, one a unit of length, the first between 0 and 1.
    pub fn names(names: impl IntoIterator<Item = String>) -> Self {
        let names = names.into_iter().enumerate();
        let ticks: Vec<_> = names
            .map(|(index, name)| (index as f64 + 0.5, name))
            .collect();
        Self {
            ends: [ticks.len().max(1) as f64, 0.0],
            ticks,
            ..Self::default()
        }
    }

    /// A logarithmic axis of positive values: whole decades, or steps of 1, 2, 5 where they span few.
    pub fn logarithmic(name: impl Into<String>, values: impl IntoIterator<Item = f64>) -> Self {
        let logarithms = values
            .into_iter()
            .filter(|value| *value > 0.0)
            .map(f64::log10);
        let ticks = match ends(logarithms) {
            None => vec![0.0, 1.0],
            Some([low, high]) if high - low < 1.6 => fine_decades(low, high),
            Some([low, high]) => decades(low, high),
        };
        Self::of_logarithms(name, [ticks[0], ticks[ticks.len() - 1]], &ticks)
    }

    /// Some decades below the strongest line of a spectrum and a little above it.
    pub fn below(name: impl Into<String>, strongest: f64) -> Self {
        let top = if strongest > 0.0 { strongest } else { 1.0 };
        let first = top.log10().floor() as i32 - DECADES_BELOW + 1;
        let end = (4.0 * top).log10();
        let ticks: Vec<_> = (first..=end.floor() as i32).map(f64::from).collect();
        Self::of_logarithms(name, [ticks[0], end], &ticks)
    }

    fn linear(name: impl Into<String>, ends: [f64; 2], ticks: &[f64]) -> Self {
        let span = ends[1] - ends[0];
        Self {
            name: name.into(),
            ends,
            ticks: ticks
                .iter()
                .map(|tick| (*tick, decimal(*tick, span)))
                .collect(),
            logarithmic: false,
        }
    }

    fn of_logarithms(name: impl Into<String>, ends: [f64; 2], ticks: &[f64]) -> Self {
        let are_decades = ticks.iter().all(|tick| tick.fract() == 0.0);
        let text = if are_decades { power } else { number };
        Self {
            name: name.into(),
            ends,
            ticks: ticks.iter().map(|tick| (*tick, text(*tick))).collect(),
            logarithmic: true,
        }
    }

    /// The names along it, of an axis of names.
    pub(in crate::report) fn texts(&self) -> Option<Vec<&str>> {
        let texts = self.ticks.iter().map(|(_, text)| text.as_str());
        (self.ends[0] > self.ends[1]).then(|| texts.collect())
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

    /// Where a value stands; at the lower end where it has no logarithm.
    pub(super) fn place(&self, value: f64) -> f64 {
        let [low, high] = self.ends;
        match self.logarithmic {
            false => value,
            true if value > 0.0 => value.log10().clamp(low, high),
            true => low,
        }
    }

    /// Whether a value stands on it.
    pub(super) fn holds(&self, value: f64) -> bool {
        let [low, high] = [self.least(), self.most()];
        (low..=high).contains(&value)
    }

    /// Number of ticks.
    pub(super) fn count(&self) -> usize {
        self.ticks.len()
    }

    /// What is written at a tick.
    pub(super) fn text(&self, tick: f64) -> String {
        let found = self.ticks.iter().find(|(place, _)| *place == tick);
        found.map(|(_, text)| text.clone()).unwrap_or_default()
    }

    /// Room below the plot, px.
    pub(super) fn room_below(&self) -> u32 {
        if self.name.is_empty() { 0 } else { ROOM_BELOW }
    }

    /// Room to the left of the plot, px: of names, what the longest needs.
    pub(super) fn room_left(&self) -> u32 {
        if !self.name.is_empty() {
            return LEFT_ROOM;
        }
        let letters = self.ticks.iter().map(|(_, text)| text.chars().count());
        LETTER * letters.max().unwrap_or(0) as u32 + 16
    }
}

impl Ranged for Axis {
    type FormatOption = DefaultFormatting;
    type ValueType = f64;

    fn map(&self, value: &f64, pixels: (i32, i32)) -> i32 {
        let part = (value - self.ends[0]) / (self.ends[1] - self.ends[0]);
        pixels.0 + (part * f64::from(pixels.1 - pixels.0)).round() as i32
    }

    fn key_points<Hint: KeyPointHint>(&self, _: Hint) -> Vec<f64> {
        self.ticks.iter().map(|(place, _)| *place).collect()
    }

    fn range(&self) -> Range<f64> {
        self.ends[0]..self.ends[1]
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
    let smallest = if scale > 0.0 { 1e-6 * scale } else { 1.0 };
    let margin = 0.06 * (high - low).max(smallest);
    low - margin..high + margin
}

/// Round numbers that span the values, about five steps apart.
pub(in crate::report) fn round_ticks(low: f64, high: f64) -> Vec<f64> {
    ticks(low, high, STEPS)
}

fn ticks(low: f64, high: f64, steps: f64) -> Vec<f64> {
    let span = if high > low {
        high - low
    } else {
        low.abs().max(1.0)
    };
    let magnitude = 10f64.powf((span / (steps - 1.0)).log10().floor());
    let step = [1.0, 2.0, 5.0, 10.0]
        .map(|factor| factor * magnitude)
        .into_iter()
        .find(|step| span / step <= steps)
        .unwrap_or(span);
    let first = (low / step).floor();
    let last = (high / step).ceil().max(first + 1.0);
    let count = (last - first) as usize;
    (0..=count)
        .map(|tick| (first + tick as f64) * step)
        .collect()
}

/// Logarithms of decades that hold those of all values.
fn decades(low: f64, high: f64) -> Vec<f64> {
    let (first, last) = (low.floor() as i32, high.ceil() as i32);
    let span = (last - first) as usize;
    let step = span.div_ceil(MOST_DECADES - 1).max(1);
    let ticks = (0..=span.div_ceil(step)).map(|tick| first + (tick * step) as i32);
    ticks.map(f64::from).collect()
}

/// Logarithms of steps of 1, 2, 5 around the values.
fn fine_decades(low: f64, high: f64) -> Vec<f64> {
    let (first, last) = (low.floor() as i32, high.ceil() as i32 + 1);
    let steps = (first..=last)
        .flat_map(|decade| [1.0_f64, 2.0, 5.0].map(|step| step.log10() + f64::from(decade)));
    let all: Vec<f64> = steps.collect();
    let begin = all.partition_point(|tick| *tick <= low).saturating_sub(1);
    let end = all.partition_point(|tick| *tick < high).max(begin + 1);
    all[begin..=end.min(all.len() - 1)].to_vec()
}

/// A number with as many decimals as tell the ticks of an axis apart.
fn decimal(value: f64, span: f64) -> String {
    let decimals = (1.0 - span.log10().floor()).clamp(0.0, 12.0) as usize;
    // no minus sign before zeros
    let value = if value.abs() < span * 1e-6 {
        0.0
    } else {
        value
    };
    format!("{value:.decimals$}")
}

/// The number of a logarithm: `0.5`, `2e-5`.
fn number(logarithm: f64) -> String {
    let value = 10f64.powf(logarithm);
    // by round-off it is not quite what was meant
    let value: f64 = format!("{value:.3e}").parse().unwrap_or(value);
    if (1e-2..1e4).contains(&value) {
        format!("{value}")
    } else {
        format!("{value:e}")
    }
}

/// The power of ten of a logarithm: `10⁻³`.
fn power(logarithm: f64) -> String {
    let superscript = |c: char| match c {
        '-' => '⁻',
        '1' => '¹',
        '2' => '²',
        '3' => '³',
        digit => char::from_u32('⁰' as u32 + digit as u32 - '0' as u32).unwrap_or(digit),
    };
    let exponent: String = logarithm.to_string().chars().map(superscript).collect();
    format!("10{exponent}")
}

#[cfg(test)]
mod tests {
    use super::*;

    fn texts(axis: &Axis) -> Vec<&str> {
        axis.ticks.iter().map(|(_, text)| text.as_str()).collect()
    }

    #[test]
    fn ticks_span_the_values() {
        for (low, high) in [(200.0, 1000.0), (0.0, 1e-4), (3.0, 3.0), (-7.0, 2500.0)] {
            let ticks = round_ticks(low, high);
            assert!((2..=9).contains(&ticks.len()), "{ticks:?}");
            assert!(ticks[0] <= low && ticks[ticks.len() - 1] >= high);
        }
    }

    #[test]
    fn ticks_of_logarithms_are_decades_that_hold_all_values() {
        let axis = Axis::logarithmic("", [3e-7, 0.0, 2.0]);
        assert_eq!(axis.ends, [-7.0, 1.0]);
        assert_eq!(texts(&axis)[4..], ["10⁻³", "10⁻²", "10⁻¹", "10⁰", "10¹"]);
        let wide = Axis::logarithmic("", [1e-14, 1.0]);
        assert!(wide.count() <= MOST_DECADES && wide.ends == [-14.0, 0.0]);
    }

    #[test]
    fn few_decades_have_finer_ticks() {
        let axis = Axis::logarithmic("", [3.0, 40.0]);
        assert_eq!(texts(&axis), ["2", "5", "10", "20", "50"]);
        assert_eq!(Axis::logarithmic("", [7.0]).count(), 2);
    }

    #[test]
    fn what_has_no_logarithm_stands_at_the_lower_end() {
        assert_eq!(Axis::logarithmic("", [1e-3, 1.0]).place(0.0), -3.0);
    }
}
