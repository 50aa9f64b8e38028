//! The range of a number, read from the schema and put into words.

use serde_json::Value;

/// Limits of a number.
#[derive(Debug, Clone, Copy, Default)]
pub(in crate::scenario) struct Range {
    minimum: Option<f64>,
    above: Option<f64>,
    maximum: Option<f64>,
}

impl Range {
    /// Limits of a plain number.
    pub fn of_number(schema: &Value) -> Self {
        Self {
            minimum: schema["minimum"].as_f64(),
            above: schema["exclusiveMinimum"].as_f64(),
            maximum: schema["maximum"].as_f64(),
        }
    }

    /// Limits of a quantity, in SI units.
    pub fn of_quantity(schema: &Value) -> Self {
        let above = schema["x-above"].as_f64();
        Self {
            minimum: schema["x-minimum"].as_f64().filter(|_| above.is_none()),
            above,
            maximum: schema["x-maximum"].as_f64(),
        }
    }

    /// Whether the number is inside.
    pub fn contains(&self, number: f64) -> bool {
        self.minimum.is_none_or(|minimum| number >= minimum)
            && self.above.is_none_or(|above| number > above)
            && self.maximum.is_none_or(|maximum| number <= maximum)
    }

    /// The range in words, each limit converted for the reader, with the unit.
    pub fn words(&self, convert: impl Fn(f64) -> f64, unit: &str) -> String {
        let unit = if unit.is_empty() {
            String::new()
        } else {
            format!(" {unit}")
        };
        let shown = |limit: f64| readable(convert(limit));
        let lower = match (self.minimum, self.above) {
            (Some(minimum), _) => Some(format!("at least {}", shown(minimum))),
            (None, Some(above)) => Some(format!("above {}", shown(above))),
            (None, None) => None,
        };
        let upper = self
            .maximum
            .map(|maximum| format!("at most {}", shown(maximum)));
        let limits: Vec<_> = lower.into_iter().chain(upper).collect();
        limits.join(" and ") + &unit
    }
}

/// Whole and ordinary numbers plainly, very large and very small ones with an exponent.
fn readable(number: f64) -> String {
    let size = number.abs();
    if number == 0.0 || (1e-3..1e6).contains(&size) {
        format!("{number}")
    } else {
        format!("{number:e}")
    }
}
