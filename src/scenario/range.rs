//! Limits of a number, as the schema has them.

use serde_json::Value;

/// Limits of a number.
#[derive(Debug, Clone, Copy, Default)]
pub(in crate::scenario) struct Range {
    minimum: Option<f64>,
    above: Option<f64>,
    maximum: Option<f64>,
}

impl Range {
    /// Whether it is of two numbers that stand for something.
    pub fn is_choice(self) -> bool {
        self.minimum.zip(self.maximum) == Some((1.0, 2.0))
    }

    /// Limits of a plain number, or of a quantity in SI units.
    pub fn from_schema(schema: &Value) -> Self {
        let keys = match schema["x-dimension"].is_null() {
            true => ["minimum", "exclusiveMinimum", "maximum"],
            false => ["x-minimum", "x-above", "x-maximum"],
        };
        let [minimum, above, maximum] = keys.map(|key| schema[key].as_f64());
        Self {
            minimum: minimum.filter(|_| above.is_none()),
            above,
            maximum,
        }
    }

    /// Whether the number is inside.
    pub fn contains(&self, number: f64) -> bool {
        self.minimum.is_none_or(|minimum| number >= minimum)
            && self.above.is_none_or(|above| number > above)
            && self.maximum.is_none_or(|maximum| number <= maximum)
    }

    /// A number inside.
    pub fn inside(&self) -> f64 {
        match (self.minimum, self.above, self.maximum) {
            (Some(minimum), ..) => minimum,
            (None, Some(above), Some(maximum)) => 0.5 * (above + maximum),
            (None, Some(above), None) => above + 1.0,
            (None, None, maximum) => maximum.unwrap_or(1.0),
        }
    }

    /// The range in words, each limit converted for the reader.
    pub fn words(&self, convert: impl Fn(f64) -> f64) -> String {
        let limits = [
            ("at least", self.minimum),
            ("above", self.above),
            ("at most", self.maximum),
        ];
        let shown = limits.iter().filter_map(|(words, limit)| {
            let limit = limit.map(&convert)?;
            Some(format!("{words} {}", readable(limit)))
        });
        shown.collect::<Vec<_>>().join(" and ")
    }
}

/// Whole and ordinary numbers plainly, very large and very small ones with an exponent.
pub(super) fn readable(number: f64) -> String {
    let size = number.abs();
    if number == 0.0 || (1e-3..1e6).contains(&size) {
        format!("{number}")
    } else {
        format!("{number:e}")
    }
}
