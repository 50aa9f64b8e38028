//! Ticks: round places along an axis, with what is written there. The page's script finds them by the same rules.

use super::Axis;
use super::axis::round_step;
use crate::numerics::digits::to_digits;

/// A place on an axis, of a logarithmic one the logarithm, and its text.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Tick {
    pub at: f64,
    pub text: String,
}

/// About `most` ticks between two places of an axis; of names all.
pub(super) fn ticks(axis: &Axis, [from, to]: [f64; 2], most: usize) -> Vec<Tick> {
    let (low, high, most) = (from.min(to), from.max(to), most.max(1) as f64);
    let span = high - low;
    if span <= 0.0 || !span.is_finite() {
        return Vec::new();
    }
    if !axis.texts.is_empty() {
        let texts = axis.texts.iter().enumerate();
        return texts
            .map(|(index, text)| tick(index as f64 + 0.5, text.clone()))
            .collect();
    }
    if !axis.logarithmic {
        let rough = span / most;
        if axis.label.unit == "deg" && rough > 20.0 {
            let step = if rough <= 45.0 {
                45.0
            } else {
                90.0 * (rough / 90.0).ceil()
            };
            return even(low, high, step);
        }
        let found = even(low, high, round_step(rough));
        // one number tells no scale
        return match found.len() {
            0 | 1 => even(low, high, round_step(0.5 * rough)),
            _ => found,
        };
    }
    let parts = [1.0, 2.0, 5.0].map(f64::log10);
    let decades = low.floor() as i32..=high.floor() as i32;
    let fine = decades.flat_map(|decade| parts.map(|part| f64::from(decade) + part));
    let fine: Vec<f64> = fine
        .filter(|at| (low - 1e-9..=high + 1e-9).contains(at))
        .collect();
    if span < 2.0 && fine.len() >= 2 && fine.len() as f64 <= most {
        return fine
            .into_iter()
            .map(|at| tick(at, number(10f64.powf(at))))
            .collect();
    }
    if span >= 1.0 {
        let step = (span / most).ceil();
        let decades = even(low, high, step).into_iter();
        return decades.map(|Tick { at, .. }| tick(at, power(at))).collect();
    }
    let [low, high] = [low, high].map(|end| 10f64.powf(end));
    let values = even(low, high, round_step((high - low) / most)).into_iter();
    values
        .map(|Tick { at, text }| tick(at.log10(), text))
        .collect()
}

fn tick(at: f64, text: String) -> Tick {
    Tick { at, text }
}

/// Multiples of a step between two ends.
fn even(low: f64, high: f64, step: f64) -> Vec<Tick> {
    let first = (low / step - 1e-9).ceil() as i64;
    let last = (high / step + 1e-9).floor() as i64;
    let texts = (first..=last).map(|count| {
        let at = count as f64 * step;
        tick(at, decimal(at, step, low.abs().max(high.abs())))
    });
    texts.collect()
}

/// Values from here on are written without powers of ten, however close they are.
const PLAIN: f64 = 0.1;

/// A multiple of a step with as many digits as tell it from the next one.
fn decimal(value: f64, step: f64, largest: f64) -> String {
    let digits = |value: f64| (value.log10() + 1e-9).floor() as i32;
    if value == 0.0 {
        return "0".to_owned();
    }
    if largest < 1e6 && (step >= 1e-4 * 0.999 || largest >= PLAIN) {
        let decimals = (-digits(step)).max(0) as usize;
        return format!("{value:.decimals$}");
    }
    let decimals = (digits(value.abs()) - digits(step)).clamp(0, 12) as usize;
    format!("{value:.decimals$e}")
}

/// `0.5`, `2e-5`.
fn number(value: f64) -> String {
    let rounded = to_digits(value, 4);
    match (1e-2..1e4).contains(&rounded) {
        true => rounded.to_string(),
        false => format!("{rounded:e}"),
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

    fn texts(axis: &Axis, most: usize) -> Vec<String> {
        let ticks = ticks(axis, axis.ends, most).into_iter();
        ticks.map(|tick| tick.text).collect()
    }

    #[test]
    fn ticks_are_round_and_tell_each_other_apart() {
        assert_eq!(
            texts(&Axis::over("", -0.07..0.21), 6),
            ["-0.05", "0", "0.05", "0.10", "0.15", "0.20"]
        );
        assert_eq!(
            texts(&Axis::over("", 1.94e8..2.06e8), 4),
            ["1.95e8", "2.00e8", "2.05e8"]
        );
        assert_eq!(
            texts(&Axis::around("", [14.0, 14.0]), 4),
            ["13.5", "14.0", "14.5"]
        );
        assert_eq!(
            texts(&Axis::over("", 14.0..14.000_002), 2),
            ["14.000000", "14.000001", "14.000002"]
        );
        assert_eq!(
            texts(&Axis::azimuth(), 9),
            ["0", "45", "90", "135", "180", "225", "270", "315", "360"]
        );
    }

    #[test]
    fn logarithmic_ticks_are_decades_or_where_there_are_few_finer() {
        let wide = Axis::of_logarithms("", -7.0..1.0);
        assert_eq!(texts(&wide, 4), ["10⁻⁶", "10⁻⁴", "10⁻²", "10⁰"]);
        assert_eq!(
            texts(&Axis::logarithmic("", [3.0, 40.0]), 6),
            ["2", "5", "10", "20", "50"]
        );
        assert_eq!(
            texts(&Axis::of_logarithms("", 0.31..0.39), 4),
            ["2.2", "2.4"]
        );
    }
}
