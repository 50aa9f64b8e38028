//! The methods of integration by the names that scenarios have for them, and tolerances, as they stand on
//! a command line.

use std::sync::LazyLock;

use serde_json::Value;

use crate::scenario::schema;
use crate::scenario::walk::{choices, nearest};
use crate::study::accuracy::NamedMethod;

/// Why a text is no method or no tolerance.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum MethodError {
    /// No method has this name.
    #[error("there is no method \"{name}\"{}; there are {known}", hint(.nearest.as_deref()))]
    Unknown {
        /// Name as given.
        name: String,
        /// The known name that is nearest to it, if any is near.
        nearest: Option<String>,
        /// All names.
        known: String,
    },
    /// No number that a run could be asked to keep to.
    #[error("a tolerance is a number from {least} to {most}, not \"{text}\"")]
    Tolerance {
        /// As given.
        text: String,
        /// Smallest tolerance.
        least: String,
        /// Largest tolerance.
        most: String,
    },
}

fn hint(nearest: Option<&str>) -> String {
    nearest.map_or_else(String::new, |name| format!(" (did you mean \"{name}\"?)"))
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
/// [`MethodError::Unknown`] names those that there are.
pub fn method(name: &str) -> Result<NamedMethod, MethodError> {
    let found = methods().iter().find(|named| named.name == name.trim());
    found.cloned().ok_or_else(|| {
        let names: Vec<&str> = methods().iter().map(|named| named.name.as_str()).collect();
        MethodError::Unknown {
            name: name.trim().to_owned(),
            nearest: nearest(name.trim(), names.iter().copied()).map(str::to_owned),
            known: names.join(", "),
        }
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
/// [`MethodError::Tolerance`] where it is none.
pub fn tolerance(text: &str) -> Result<f64, MethodError> {
    let limits = &integrator()["tolerance"];
    let limit = |key: &str, without: f64| limits[key].as_f64().unwrap_or(without);
    let (least, most) = (limit("minimum", 0.0), limit("maximum", f64::INFINITY));
    let number = text.trim().parse().ok();
    number
        .filter(|number| (least..=most).contains(number))
        .ok_or_else(|| MethodError::Tolerance {
            text: text.trim().to_owned(),
            least: format!("{least:e}"),
            most: format!("{most:e}"),
        })
}

/// The keys of `[integrator]` in the schema.
fn integrator() -> &'static Value {
    &schema()["properties"]["integrator"]["properties"]
}
