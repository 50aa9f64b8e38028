//! Values of a scenario as they stand on a command line: speeds, times, methods, tolerances.

use std::sync::LazyLock;

use serde_json::Value;

use super::dimension::Dimension;
use super::quantity::parse;
use super::schema;
use super::walk::{choices, nearest};
use crate::study::accuracy::NamedMethod;

/// Why a text is not the value that is asked for, in words.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error("{0}")]
pub struct ArgumentError(String);

/// A quantity in SI units, zero or positive.
fn quantity(
    text: &str,
    dimension: Dimension,
    advice: &str,
    negative: fn(f64) -> String,
) -> Result<f64, ArgumentError> {
    match parse(text, dimension) {
        Ok(parsed) if parsed.si < 0.0 => Err(ArgumentError(negative(parsed.si))),
        Ok(parsed) => Ok(parsed.si),
        Err(error) => Err(ArgumentError(format!("{error}; {advice}"))),
    }
}

/// A speed with its unit in rad/s, zero or positive.
///
/// # Errors
/// [`ArgumentError`] says what is wrong with the text.
///
/// ```
/// assert_eq!(jeffcott::scenario::speed("500 rad/s").unwrap(), 500.0);
/// assert!(jeffcott::scenario::speed("500").is_err());
/// ```
pub fn speed(text: &str) -> Result<f64, ArgumentError> {
    let advice = "write a speed with its unit, as in \"3000 rpm\" or \"500 rad/s\"";
    quantity(text, Dimension::AngularSpeed, advice, |speed| {
        format!("a speed of {speed} rad/s is negative: the shaft turns about +Z")
    })
}

/// Seconds of a time with its unit, zero or positive.
///
/// # Errors
/// [`ArgumentError`] says what is wrong with the text.
///
/// ```
/// assert_eq!(jeffcott::scenario::time("250 ms").unwrap(), 0.25);
/// assert!(jeffcott::scenario::time("0.25").is_err());
/// ```
pub fn time(text: &str) -> Result<f64, ArgumentError> {
    let advice = "write a time with its unit, as in \"0.25 s\"";
    quantity(text, Dimension::Time, advice, |time| {
        format!("a time of {time} s is before the start")
    })
}

/// All methods that a scenario can name.
///
/// ```
/// let names = jeffcott::scenario::methods();
/// assert!(names.iter().any(|named| named.name == "dop853"));
/// ```
pub fn methods() -> &'static [NamedMethod] {
    static METHODS: LazyLock<Vec<NamedMethod>> = LazyLock::new(|| {
        let words = choices(&integrator()["method"]).into_iter();
        let named = words.filter_map(|word| {
            Some(NamedMethod {
                name: word.to_owned(),
                method: serde_json::from_value(word.into()).ok()?,
            })
        });
        named.collect()
    });
    &METHODS
}

/// The method of a name.
///
/// # Errors
/// [`ArgumentError`] names those that there are.
pub fn method(name: &str) -> Result<NamedMethod, ArgumentError> {
    let name = name.trim();
    let found = methods().iter().find(|named| named.name == name);
    found.cloned().ok_or_else(|| {
        let names: Vec<&str> = methods().iter().map(|named| named.name.as_str()).collect();
        let successor = integrator()["method"]["successors"][name].as_str();
        let hint = match (successor, nearest(name, names.iter().copied())) {
            (Some(successor), _) => format!(" any longer (\"{successor}\" takes its place)"),
            (None, Some(near)) => format!(" (did you mean \"{near}\"?)"),
            (None, None) => String::new(),
        };
        let known = names.join(", ");
        ArgumentError(format!(
            "there is no method \"{name}\"{hint}; there are {known}"
        ))
    })
}

/// A tolerance as a run can be asked to keep to.
///
/// ```
/// assert_eq!(jeffcott::scenario::tolerance("1e-6"), Ok(1e-6));
/// assert!(jeffcott::scenario::tolerance("0").is_err());
/// ```
///
/// # Errors
/// [`ArgumentError`] where it is none.
pub fn tolerance(text: &str) -> Result<f64, ArgumentError> {
    let limits = &integrator()["tolerance"];
    let limit = |key: &str, without: f64| limits[key].as_f64().unwrap_or(without);
    let (least, most) = (limit("minimum", 0.0), limit("maximum", f64::INFINITY));
    let text = text.trim();
    let number = text.parse().ok();
    number
        .filter(|number| (least..=most).contains(number))
        .ok_or_else(|| {
            ArgumentError(format!(
                "a tolerance is a number from {least:e} to {most:e}, not \"{text}\""
            ))
        })
}

/// The keys of `[integrator]` in the schema.
fn integrator() -> &'static Value {
    &schema()["properties"]["integrator"]["properties"]
}
