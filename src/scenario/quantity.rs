//! A number with its unit, as people write it: `"5 kg"`.

use std::borrow::Cow;
use std::marker::PhantomData;

use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};
use serde::{Deserialize, Serialize};

pub(super) use super::dimension::Measure;
pub(super) use super::dimension::measure::*;
use super::dimension::{Dimension, Unit};

/// Why a text is not a quantity of the dimension asked for.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub(super) enum QuantityError {
    #[error("`{text}` does not start with a number")]
    NoNumber { text: String },
    #[error("`{text}` has a decimal comma; the decimal sign is a point")]
    DecimalComma { text: String },
    #[error("`{text}` has no unit")]
    NoUnit { text: String },
    #[error("`{text}` is not a finite number")]
    NotFinite { text: String },
    #[error("`{unit}` is not a unit")]
    UnknownUnit { unit: String },
    #[error("`{text}` is {}", found.with_article())]
    WrongDimension { text: String, found: Dimension },
}

/// A parsed quantity.
#[derive(Debug, Clone, Copy)]
pub(super) struct Parsed {
    /// Value in SI units.
    pub si: f64,
    /// The unit it was written in.
    pub unit: &'static Unit,
}

/// Reads a number and a unit of the given dimension.
pub(super) fn parse(text: &str, dimension: Dimension) -> Result<Parsed, QuantityError> {
    let owned = || text.trim().to_owned();
    let (number, rest) = split_number(text.trim());
    let Ok(number) = number.parse::<f64>() else {
        let word = text.trim().trim_start_matches(['+', '-']);
        return Err(
            match word.get(..3).map(str::to_ascii_lowercase).as_deref() {
                Some("nan" | "inf") => QuantityError::NotFinite { text: owned() },
                _ => QuantityError::NoNumber { text: owned() },
            },
        );
    };
    if rest.is_empty() {
        return Err(QuantityError::NoUnit { text: owned() });
    }
    if rest.starts_with(',') {
        return Err(QuantityError::DecimalComma { text: owned() });
    }
    let spelling = normalise(rest);
    let Some(unit) = dimension.unit(&spelling) else {
        let mut all = Dimension::ALL.iter();
        let owner = all.find(|(each, ..)| each.unit(&spelling).is_some());
        return Err(match owner {
            Some((found, ..)) => QuantityError::WrongDimension {
                text: owned(),
                found: *found,
            },
            None => QuantityError::UnknownUnit {
                unit: rest.trim().to_owned(),
            },
        });
    };
    let si = unit.si(number);
    if si.is_finite() {
        Ok(Parsed { si, unit })
    } else {
        Err(QuantityError::NotFinite { text: owned() })
    }
}

/// Splits after the longest prefix of the form `[+-] digits [. digits] [e [+-] digits]`.
fn split_number(text: &str) -> (&str, &str) {
    let bytes = text.as_bytes();
    let digits = |from: usize| {
        bytes[from..]
            .iter()
            .take_while(|b| b.is_ascii_digit())
            .count()
    };
    let at = |place: usize, set: &[u8]| bytes.get(place).is_some_and(|b| set.contains(b));

    let mut end = usize::from(at(0, b"+-"));
    end += digits(end);
    if at(end, b".") {
        end += 1 + digits(end + 1);
    }
    if at(end, b"eE") {
        let mantissa = end;
        let first = end + 1 + usize::from(at(end + 1, b"+-"));
        let exponent = digits(first.min(bytes.len()));
        end = if exponent > 0 {
            first + exponent
        } else {
            mantissa
        };
    }
    let (number, rest) = text.split_at(end);
    (number, rest.trim_start())
}

/// One spelling for all ways to write a unit: `N·m²`, `N*m**2` and `N m^2` are the same.
fn normalise(unit: &str) -> String {
    let plain = unit
        .replace(['µ', 'μ'], "u")
        .replace('°', "deg")
        .replace("**", "^")
        .replace("^(3/2)", "^1.5")
        .replace('²', "^2")
        .replace('³', "^3");
    let mut product = String::with_capacity(plain.len());
    let mut previous = ' ';
    for character in plain.chars() {
        let is_dot = character == '.' && !previous.is_ascii_digit();
        let separates = is_dot || matches!(character, '*' | '·' | '⋅') || character.is_whitespace();
        product.push(if separates { ' ' } else { character });
        previous = character;
    }
    let words: Vec<_> = product.split_whitespace().collect();
    words.join(" ").replace(" /", "/").replace("/ ", "/")
}

/// A quantity of dimension `D`, kept as it was written and in SI units.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(try_from = "String", into = "String", bound = "D: Measure + Clone")]
pub(super) struct Quantity<D> {
    text: String,
    si: f64,
    dimension: PhantomData<D>,
}

impl<D> Quantity<D> {
    /// Value in SI units.
    pub fn si(&self) -> f64 {
        self.si
    }
}

/// Value in SI units of a quantity that may be given.
pub(super) fn si<D>(quantity: &Option<Quantity<D>>) -> Option<f64> {
    quantity.as_ref().map(Quantity::si)
}

/// Zero, in the SI unit.
impl<D: Measure> Default for Quantity<D> {
    fn default() -> Self {
        Self {
            text: format!("0 {}", D::DIMENSION.units()[0].symbol),
            si: 0.0,
            dimension: PhantomData,
        }
    }
}

impl<D: Measure> TryFrom<String> for Quantity<D> {
    type Error = QuantityError;

    fn try_from(text: String) -> Result<Self, QuantityError> {
        let si = parse(&text, D::DIMENSION)?.si;
        Ok(Self {
            text,
            si,
            dimension: PhantomData,
        })
    }
}

impl<D> From<Quantity<D>> for String {
    fn from(quantity: Quantity<D>) -> Self {
        quantity.text
    }
}

impl<D: Measure> JsonSchema for Quantity<D> {
    fn inline_schema() -> bool {
        true
    }

    fn schema_name() -> Cow<'static, str> {
        D::DIMENSION.name().into()
    }

    fn json_schema(_: &mut SchemaGenerator) -> Schema {
        let units: Vec<_> = D::DIMENSION
            .units()
            .iter()
            .map(|unit| unit.symbol)
            .collect();
        json_schema!({
            "type": "string",
            "pattern": r"^\s*[+-]?(\d+\.?\d*|\.\d+)([eE][+-]?\d+)?\s*\D.*$",
            "examples": [D::EXAMPLE],
            "x-dimension": D::DIMENSION.name(),
            "x-units": units,
            "x-minimum": -D::LARGEST,
            "x-maximum": D::LARGEST,
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn si(text: &str, dimension: Dimension) -> f64 {
        parse(text, dimension).unwrap().si
    }

    #[test]
    fn powers_of_ten_convert_exactly() {
        assert_eq!(si("5 mm", Dimension::Length), 0.005);
        assert_eq!(si("20 um", Dimension::Length), 20e-6);
        assert_eq!(si("22 1/GPa", Dimension::PressureViscosity), 22e-9);
        assert_eq!(si("207 GPa", Dimension::Pressure), 207e9);
    }

    #[test]
    fn spellings_of_one_unit_agree() {
        for text in ["3 um", "3 µm", "3 μm", "3um", " +3.0e0  um "] {
            assert_eq!(si(text, Dimension::Length), 3e-6, "{text}");
        }
        for text in ["2 kg m^2", "2 kg*m²", "2 kg·m**2", "2 kg.m^2", "2 kg  m^2"] {
            assert_eq!(si(text, Dimension::Inertia), 2.0, "{text}");
        }
        for text in ["1 N/m^1.5", "1 N / m^(3/2)"] {
            assert_eq!(si(text, Dimension::ContactStiffness), 1.0, "{text}");
        }
    }

    #[test]
    fn turning_speeds_are_in_radians() {
        let full = 2.0 * std::f64::consts::PI;
        for text in ["60 rpm", "1 rev/s", "360 deg/s", "60 1/min"] {
            let speed = si(text, Dimension::AngularSpeed);
            assert!((speed - full).abs() < 1e-14, "{text}: {speed}");
        }
    }

    #[test]
    fn what_is_no_quantity_says_why() {
        use QuantityError as E;
        let refusal = |text| parse(text, Dimension::Mass).unwrap_err();
        assert!(matches!(refusal("5"), E::NoUnit { .. }));
        assert!(matches!(refusal("heavy"), E::NoNumber { .. }));
        assert!(matches!(refusal(""), E::NoNumber { .. }));
        assert!(matches!(refusal("+"), E::NoNumber { .. }));
        assert!(matches!(refusal("-inf kg"), E::NotFinite { .. }));
        assert!(matches!(refusal("1e999 kg"), E::NotFinite { .. }));
        assert!(matches!(refusal("5,5 kg"), E::DecimalComma { .. }));
        assert!(matches!(refusal("5 kgs"), E::UnknownUnit { .. }));
        assert!(matches!(refusal("5 mm"), E::WrongDimension { .. }));
    }
}
